#pragma once
/// \file
/// Four-bars among the links of a linkage on whose couplers its guided point lies, or comes to lie where pins are
/// brought together: what follows a path as a four-bar alone is then known to be followed by the linkage.

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// A pin whose place on a link becomes that of another pin of the link.
struct PinOnPin {
    std::size_t link;
    std::size_t pin;
    std::size_t onto;
};

/// The links and pins that are the four-bar; pins that are brought together stand for each other.
struct GuidingPart {
    struct Arm {
        std::size_t link;  ///< frame, crank, coupler, rocker
        std::size_t from;  ///< pins of it: crank pivot, crank pivot, crank pin, rocker pivot
        std::size_t to;    ///< rocker pivot, crank pin, rocker pin, rocker pin
    };
    std::array<Arm, 4> arms;
    std::size_t point;             ///< a pin of the coupler
    std::size_t choice;            ///< of the order's sides the one on which the rocker pin is
    std::int8_t open;              ///< that side where it is to the left of the line from crank pin to rocker pivot
    std::vector<PinOnPin> joined;  ///< as few as it takes

    const Arm& coupler() const { return arms[2]; }
};

/// A four-bar with its coupler point in the drawing, as the kind of mechanism that it is has its dimensions: lengths of
/// frame, crank, coupler, rocker; the point along and across; origin x and y, tilt.
using PartDimensions = std::array<double, 9>;

/// That kind of mechanism.
std::shared_ptr<const Mechanism> kind_of_part();

/// All such parts of a linkage that a crank on the frame drives, for the first of its guided points; those with the
/// fewest pins brought together first. None where its drive or its lengths have a scale of their own.
std::vector<GuidingPart> guiding_parts(const LinkageModel& model);

/// The least and the greatest that dimensions of the part can be, from those of the linkage, wide where it does not
/// show at a glance.
struct PartRanges {
    PartDimensions least;
    PartDimensions greatest;
};
PartRanges ranges_of_part(const LinkageModel& model, const GuidingPart& part, std::span<const double> least,
                          std::span<const double> greatest);

/// Dimensions of a linkage of which a part is a given four-bar.
struct PlacedPart {
    std::vector<double> dimensions;
    std::vector<bool> chosen;  ///< which of them were chosen for that
    double crank_angle = 0;    ///< what the linkage's is more than the part's
};

/// Sets dimensions so that a part is that four-bar; those that are not `free`, or not of the part, stay as they are.
/// Nothing where one that is not free would have to change.
std::optional<PlacedPart> with_part(const LinkageModel& model, const GuidingPart& part, const PartDimensions& four,
                                    const std::vector<bool>& free, std::vector<double> dimensions);

/// The other four-bar whose point follows the same path at the same crank angles (Roberts and Chebyshev,
/// analysis/four_bar/cognates.h); it is closed on the other side, and keeps the rocker's pivot.
PartDimensions cognate_of_part(const PartDimensions& four);

}  // namespace mechwright
