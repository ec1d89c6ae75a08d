#pragma once
/// \file
/// What a mechanism's drawing is made from.

#include <memory>
#include <string_view>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// A fully dimensioned mechanism with its motion. Lengths in the problem's unit, angles in radians.
struct MovingDesign {
    std::shared_ptr<const Mechanism> mechanism;
    Motion motion;  ///< refers to the mechanism's model and to the function of whoever made it
    std::vector<double> dimensions;
    bool guides_point = false;  ///< a point is asked to follow something
    bool guides_body = false;

    /// The value of a dimension, 0 where the mechanism has none of this name.
    double operator[](std::string_view dimension) const;
    /// Whether it moves at all.
    bool assembles() const { return motion.from <= motion.to; }
};

/// The first and the last crank angle of a motion that is no full turn.
std::vector<double> ends_of(const Motion& motion);

}  // namespace mechwright
