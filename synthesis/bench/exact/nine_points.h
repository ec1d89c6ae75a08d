#pragma once
/// \file
/// Problem 3 of Wampler, Morgan and Sommese (1992): nine points whose 1442 cognate triplets are all found by following
/// paths, in several ways.

#include <string_view>
#include <vector>

#include "synthesis/exact/homotopy/guidance_solutions.h"

namespace mechwright::bench {

inline constexpr std::size_t nine_point_paths = 1442;

struct NinePoints {
    std::vector<homotopy::GuidedPlace> places;
    homotopy::GuidanceTarget target;
    const homotopy::StartSystem* start;
};

NinePoints nine_points();

/// How its paths are followed, on one core: side by side in lanes, or one by one.
struct PathsBy {
    std::string_view name;
    std::vector<homotopy::GuidancePath> (*follow)(const NinePoints&, const homotopy::TrackingOptions&);
};

/// The ways that this processor has, the slowest first; the last is the program's.
std::vector<PathsBy> ways_to_follow();

/// Options for a step whose predicted error is so great, relative.
homotopy::TrackingOptions with_tolerance(double prediction_error);

/// What became of the paths. Ends that agree are of paths that have jumped to others.
struct Ends {
    double steps = 0;  ///< of a path, on average
    std::size_t reached = 0;
    std::size_t distinct = 0;
};

Ends ends_of(const NinePoints& points, const std::vector<homotopy::GuidancePath>& paths);

}  // namespace mechwright::bench
