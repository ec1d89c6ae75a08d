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

/// Decimal digits that a double has right: -log10 of its relative error (of its error, where the exact number is 0),
/// from 0 to 16. NaN has none.
inline double digits_kept(double value, const Digits50& exact) {
    constexpr double most = 16;
    const double size = std::abs(static_cast<double>(exact));
    const double error = error_of(value, exact) / (size > 0 ? size : 1);
    if (!(error < 1)) return 0;
    return error > 0 ? std::min(-std::log10(error), most) : most;
}

}  // namespace mechwright::bench
