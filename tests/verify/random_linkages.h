#pragma once
/// \file
/// Random linkages for the tests of verification; the same for the same seed everywhere.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright::testing {

struct Random {
    std::mt19937_64 bits;

    explicit Random(std::uint64_t seed) : bits(seed) {}
    double between(double low, double high) {
        return low + (high - low) * (static_cast<double>(bits() >> 11) * 0x1p-53);
    }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    FourBar<double> linkage(double low, double high) {
        const double ground = log_between(low, high), crank = log_between(low, high);
        return {ground, crank, log_between(low, high), log_between(low, high)};
    }
};

/// Linkages of a class, with lengths from 0.1 to 10.
inline std::vector<FourBar<double>> random_linkages(FourBarClass kind, int count, std::uint64_t seed) {
    Random random(seed);
    std::vector<FourBar<double>> found;
    while (found.size() < static_cast<std::size_t>(count)) {
        const FourBar<double> m = random.linkage(0.1, 10);
        if (classify(m).kind == kind) found.push_back(m);
    }
    return found;
}

inline std::vector<Digits50> dimensions_of(const FourBar<double>& m) {
    std::vector<Digits50> dimensions{m.ground, m.crank, m.coupler, m.rocker};
    dimensions.resize(10);
    return dimensions;
}

inline Motion full_turn(std::size_t family, std::size_t assembly = 0) {
    return {assembly, family, true, 0, 2 * std::numbers::pi};
}

inline Motion limited(double from, double to, std::size_t assembly = 0) { return {assembly, 2, false, from, to}; }

}  // namespace mechwright::testing
