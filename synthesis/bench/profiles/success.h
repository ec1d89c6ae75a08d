#pragma once
/// \file
/// Successes of runs that end by chance.

#include <algorithm>
#include <cmath>

namespace mechwright::bench {

struct Interval95 {
    double lower;
    double upper;
};

/// Wilson's interval of a rate of which so many of so many were seen (E. B. Wilson, "Probable inference, the law of
/// succession, and statistical inference", 1927).
inline Interval95 wilson(double successes, double runs) {
    constexpr double z = 1.959963984540054;
    const double rate = successes / runs, weight = z * z / runs;
    const double middle = (rate + weight / 2) / (1 + weight);
    const double half = z / (1 + weight) * std::sqrt(rate * (1 - rate) / runs + weight / (4 * runs));
    return {std::max(0.0, middle - half), std::min(1.0, middle + half)};
}

}  // namespace mechwright::bench
