#pragma once
/// \file
/// Random linkages of each class, and motions for them.

#include <numbers>
#include <vector>

#include "synthesis/mechanism/mechanism.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {

/// Linkages of a class, with lengths from 0.1 to 10.
inline std::vector<FourBar<double>> random_linkages(FourBarClass kind, std::size_t count, std::uint64_t seed) {
    Random random(seed);
    const auto length = [&] { return random.log_between(0.1, 10); };
    std::vector<FourBar<double>> found;
    while (found.size() < count) {
        const FourBar<double> m{length(), length(), length(), length()};
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
    return {assembly, family, nullptr, nullptr, true, 0, 2 * std::numbers::pi};
}

inline Motion limited(double from, double to, std::size_t assembly = 0) {
    return {assembly, 2, nullptr, nullptr, false, from, to};
}

}  // namespace mechwright::test
