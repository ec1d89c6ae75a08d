#pragma once
/// \file
/// Where local searches start: low-discrepancy candidates in the ranges of the design variables that meet the
/// conditions of motion, with placement, size and coupler point fitted to a target path where they are free.

#include <Eigen/Core>
#include <cstdint>

#include "synthesis/search/draws.h"

namespace mechwright {

/// How many candidates are screened for each start of a search from many.
int start_candidates(const Problem& problem);

struct Start {
    Eigen::VectorXd x;
    bool preferred = false;  ///< the preferred values
    double merit = 0;        ///< less is better; infinite where the mechanism does not assemble
    DrawCounts counts{};     ///< what it was chosen from
};

/// Start number `index` of a program, a function of (seed, index) alone: the best of `candidates` screened points.
/// Index 0 begins with the preferred values (or the middles of the ranges), or those that are asked to.
Start screened_start(const Program& program, std::uint64_t seed, int index, int candidates, bool with_preferred);
inline Start screened_start(const Program& program, std::uint64_t seed, int index, int candidates) {
    return screened_start(program, seed, index, candidates, index == 0);
}

/// The point of it alone.
Eigen::VectorXd start_point(const Program& program, std::uint64_t seed, int index, int candidates);

}  // namespace mechwright
