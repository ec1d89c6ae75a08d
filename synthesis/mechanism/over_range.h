#pragma once
/// \file
/// A motion over a given range of crank angles.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The motion over the range, radians.
inline Motion over_range(Motion motion, const Vector<Digits50>& range) {
    motion.full_turn = false;
    motion.from = range.x.convert_to<double>();
    motion.to = range.y.convert_to<double>();
    return motion;
}

}  // namespace mechwright
