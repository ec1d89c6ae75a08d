#pragma once
/// \file
/// Searches without derivatives for a linkage, as others do it: they see the error of a design, and nothing else.

#include <cstdint>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace mechwright::bench {

/// What is to be least over a box: a value at each point, large where there is none.
struct BoxedError {
    std::vector<double> lower, upper;
    std::function<double(const std::vector<double>&)> at;
};

struct PeerOfLinkages {
    std::string_view name;
    /// The least error after so many evaluations.
    double (*least)(const BoxedError&, std::uint64_t seed, long evaluations);
};

/// Particle swarms as pylinkage 0.9 has them by default, and differential evolution of pagmo 2.18, ten individuals for
/// each variable, begun again where it has converged.
std::span<const PeerOfLinkages> peers_of_linkages();

}  // namespace mechwright::bench
