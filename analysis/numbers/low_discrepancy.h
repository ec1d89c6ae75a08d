#pragma once
/// \file
/// Points that fill a cube evenly: the additive recurrence of Roberts' R sequence, x_k = frac(shift + k alpha), with
/// alpha_j the powers of the root of x^(d+1) = x + 1. In 64-bit integers it is exact, needs no state, and any point is
/// found from its number.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace mechwright {

/// A well-mixed function of a 64-bit number (the finaliser of SplitMix64).
constexpr std::uint64_t mixed(std::uint64_t z) {
    z += 0x9e3779b97f4a7c15;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
}

class LowDiscrepancy {
public:
    /// Sequences with different seeds or streams are shifted against each other.
    LowDiscrepancy(std::size_t dimension, std::uint64_t seed, std::uint64_t stream) {
        double root = 1.5;
        for (int i = 0; i < 64; ++i)
            root = std::pow(1 + root, 1 / (static_cast<double>(dimension) + 1));
        for (std::size_t j = 0; j < dimension; ++j) {
            step_.push_back(static_cast<std::uint64_t>(std::ldexp(std::pow(root, -1.0 - static_cast<double>(j)), 64)));
            shift_.push_back(mixed(mixed(mixed(seed) ^ stream) ^ j));
        }
    }

    /// Coordinate j of point k, in (0, 1).
    double operator()(std::uint64_t k, std::size_t j) const {
        const std::uint64_t x = shift_[j] + k * step_[j];
        return std::ldexp(static_cast<double>(x >> 11) + 0.5, -53);
    }

private:
    std::vector<std::uint64_t> step_;
    std::vector<std::uint64_t> shift_;
};

}  // namespace mechwright
