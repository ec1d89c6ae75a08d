#pragma once
/// \file
/// The search for coupler paths: candidates screened in lanes, Levenberg and Marquardt's method from the best of them
/// and from starts near those that it ended at, and sequential quadratic programming from the best ends of all. Paths
/// in any order that need no more than that are searched by whole curves (curve/curve_search.h).

#include "synthesis/search/multistart.h"

namespace mechwright {

/// Why a problem is not one for this search; empty if it is.
std::string why_no_path_search(const Problem& problem);

/// Searches in rounds, each by itself, until the points are met exactly, or the best design has been hit often enough,
/// or the rounds are used up; there are more of them the more starts the problem asks for. Of linkages it takes several
/// times as many hits and rounds where the best design all but meets the points: then some design is likely to meet
/// them. The result is the same for any number of jobs.
Multistart path_search(const Problem& problem, const RunOptions& options,
                       std::chrono::steady_clock::time_point deadline);

/// Searches besides, of a linkage whose point is, or can be, on the coupler of a four-bar among its links: they begin
/// at four-bars that follow the path by themselves, with the other links drawn on them (trials_about_parts.h), and take
/// no more than about `budget` evaluations until the best are polished. Nothing where there is no such part, or least
/// squares do not lead to the objective. The result is the same for any number of jobs.
Multistart path_search_about_parts(const Problem& problem, const RunOptions& options,
                                   std::chrono::steady_clock::time_point deadline, long budget);

}  // namespace mechwright
