#pragma once
/// \file
/// How others search for a curve through a shape's points, each on one thread and until its evaluations are used up.

#include <cstdint>
#include <span>
#include <string_view>

#include "synthesis/bench/curves/shapes.h"

namespace mechwright::bench {

struct PeerRun {
    double rms;  ///< of the distances to the whole curve, mm; infinite where nothing was found
    double evaluations;
    double seconds;
};

struct PeerMethod {
    std::string_view name;
    bool closed_only;  ///< it compares closed curves
    PeerRun (*run)(const Shape&, std::uint64_t seed, long evaluations);
};

/// Differential evolution and CMA-ES of pagmo 2.18 on the error of the whole curve; differential evolution on elliptic
/// Fourier descriptors, as four-bar-rs 7.0.5 does it; the program's own multistart of sequential quadratic programming,
/// which takes the evaluations that it takes; and the program's default.
std::span<const PeerMethod> peer_methods();

}  // namespace mechwright::bench
