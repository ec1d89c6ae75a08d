#pragma once
/// \file
/// A dwell: a signal along the stretch, or the full turn, over which a quantity `NAME.deviation` says how far it is off
/// its middle value. Where it is extreme, and how it changes with the dimensions at given inputs.

#include <span>
#include <vector>

#include "synthesis/mechanism/quantity.h"

namespace mechwright {

/// Inputs of the master are radians or lengths, values in the quantity's unit.
struct DwellExtreme {
    double input;
    double value;
};
struct DwellExtremeAgain {
    Digits50 input;
    Digits50 value;
};

/// Whether a quantity is how far a signal is off its middle value.
bool is_of_dwell(const Quantity& quantity);

/// Every extreme of the signal in order along the stretch, its ends among them where it is no full turn. None where the
/// linkage does not close over all of it, or ends of the motion inside of it follow from the dimensions.
std::vector<DwellExtreme> dwell_extremes(const Quantity& quantity, const Motion& motion,
                                         std::span<const double> dimensions);

/// The ends of the stretch as inputs of the motion; the second may lie in the next cycle.
Vector<double> dwell_stretch(const Quantity& quantity, const Motion& motion);

/// The signal at inputs all along the stretch, each a component, in the order of the inputs.
Quantity dwell_samples(const Quantity& quantity);

/// The signal at one input of the motion, as a quantity with derivatives.
Quantity dwell_at(const Quantity& quantity, double input);

/// The extremes again in fifty digits: from the equations of the joints, between many samples of the motion.
std::vector<DwellExtremeAgain> dwell_extremes_again(const Quantity& quantity, const Motion& motion,
                                                    std::span<const Digits50> dimensions);

/// The signal at inputs of the motion in fifty digits; not numbers where the linkage does not close.
std::vector<Digits50> dwell_again(const Quantity& quantity, const Motion& motion, std::span<const Digits50> dimensions,
                                  std::span<const double> inputs);

}  // namespace mechwright
