#pragma once
/// \file
/// How right a number is: against the same number in fifty digits.

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::bench {

/// |value - exact|, formed in fifty digits.
inline double error_of(double value, const Digits50& exact) {
    return static_cast<double>(abs(Digits50(value) - exact));
}

/// Decimal digits that a relative error leaves of a double: -log10 of it, from 0 to 16. NaN leaves none.
inline double digits_left(double relative_error) {
    constexpr double most = 16;
    if (!(relative_error < 1)) return 0;
    return relative_error > 0 ? std::min(-std::log10(relative_error), most) : most;
}

/// Decimal digits that a double has right; of its error, where the exact number is 0.
inline double digits_kept(double value, const Digits50& exact) {
    const double size = std::abs(static_cast<double>(exact));
    return digits_left(error_of(value, exact) / (size > 0 ? size : 1));
}

}  // namespace mechwright::bench
