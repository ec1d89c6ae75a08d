#pragma once
/// \file
/// Random four-bars for tests, the same in every run: built from the shortest link and the three margins by which the
/// links turn fully, so that change points can be approached as closely as one likes.

#include <cmath>
#include <cstdint>
#include <numbers>

#include "analysis/four_bar.h"

namespace mechwright::test {

/// Numbers that are the same everywhere (SplitMix64).
class Random {
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    double between(double low, double high) {
        state_ += 0x9e3779b97f4a7c15;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return low + (high - low) * static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
    }
    double log_between(double low, double high) { return std::exp(between(std::log(low), std::log(high))); }
    double angle() { return between(0, 2 * std::numbers::pi); }
    bool coin() { return between(0, 1) < 0.5; }
    Assembly assembly() { return coin() ? Assembly::open : Assembly::crossed; }

private:
    std::uint64_t state_;
};

/// The crank-rocker of crank `shortest` whose three margins are p (ground longest), q (coupler), s (rocker longest).
inline FourBar<double> crank_rocker(double shortest, double p, double q, double s) {
    // p = c + r - g - k, q = g + r - k - c, s = g + c - k - r
    return {shortest + (q + s) / 2, shortest, shortest + (p + s) / 2, shortest + (p + q) / 2};
}

/// The same with the ground link as the shortest: a double crank.
inline FourBar<double> double_crank(double shortest, double p, double q, double s) {
    return {shortest, shortest + (q + s) / 2, shortest + (p + s) / 2, shortest + (p + q) / 2};
}

/// A linkage that turns fully, its margins between `least` and 1 (log-uniform) for a shortest link of 0.05 to 1.
inline FourBar<double> turning_linkage(Random& random, double least) {
    const double shortest = random.log_between(0.05, 1);
    const double p = random.log_between(least, 1), q = random.log_between(least, 1), s = random.log_between(least, 1);
    return random.coin() ? crank_rocker(shortest, p, q, s) : double_crank(shortest, p, q, s);
}

}  // namespace mechwright::test
