#pragma once
/// \file
/// The points of a study, numbered from 0, and the strands in which they are solved. Any point is found from its number
/// alone.

#include <cstdint>
#include <vector>

#include "synthesis/problem/study/varied_problem.h"

namespace mechwright {

/// How many points a study has: of a grid all combinations, of one-at-a-time the file's own values and then those of
/// each axis, of a random design or of tolerances as many as were asked for.
std::uint64_t point_count(const Study& study);

/// The values of all axes at a point. In a grid the last axis varies fastest.
std::vector<AxisValue> point_values(const Study& study, std::uint64_t point);

/// Points that are solved one after the other by one worker: the unit of work.
struct Strand {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
    bool neighbours = false;  ///< each point differs from the one before by one step of a range
};

/// Strands hold the points in order. How they are cut depends on the study alone.
std::uint64_t strand_count(const Study& study);
Strand strand_at(const Study& study, std::uint64_t number);

}  // namespace mechwright
