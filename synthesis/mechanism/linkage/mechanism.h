#pragma once
/// \file
/// A mechanism made of a linkage that a file describes.

#include <span>
#include <string>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// As Mechanism::motion. Of several motions the one that holds LinkageModel::at, else the widest, the first of these.
Motion motion_of_linkage(Form form, std::span<const double> dimensions, const double* crank_range);

/// Whether nothing ends the motion of a slide that drives a linkage, as far as it is looked at.
bool is_endless(Form form, std::span<const double> dimensions);

/// What a quantity is that a file names; of a signal by its index in the model.
struct NamedMeasure {
    std::string name;
    LinkageMeasure value{};
};

/// A quantity in fifty digits, from poses of the joints' equations (loop.h).
Digits50 measure_linkage_again(const Motion& motion, std::span<const Digits50> dimensions);

/// Least, greatest and range of every signal from `first` on, and those of the quantities asked for that these are not;
/// they read the first `dimensions` of the mechanism, of which the model's numbers are sums.
std::vector<Quantity> quantities_of_signals(const LinkageModel& model, std::size_t dimensions, std::size_t first,
                                            std::span<const NamedMeasure> asked);

/// A mechanism with these dimensions, of which the model's numbers are sums, and with these
/// quantities beside those that every linkage has, and least, greatest and range of every signal. The order of its
/// structure is closed.
Mechanism linkage_mechanism(LinkageModel model, std::vector<Dimension> dimensions,
                            std::span<const NamedMeasure> quantities);

}  // namespace mechwright
