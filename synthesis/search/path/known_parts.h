#pragma once
/// \file
/// Starts for linkages whose guided point lies, or can come to lie, on the coupler of a four-bar among their links
/// (mechanism/linkage/targets/guiding_part.h): that four-bar alone is searched for first.

#include <chrono>
#include <vector>

#include "synthesis/program/run_options.h"
#include "synthesis/search/drawn_starts.h"

namespace mechwright {

/// Whether a problem is that of one path that such a linkage follows.
bool has_guiding_part(const Problem& problem);

/// What is known of good designs of each program: the best four-bars for the path, and their cognates with the same
/// crank angles, put into its linkage; nothing where it has no such part. Finding them takes no more than about
/// `budget`, which are added to `evaluations`. `programs` are those of all variants of `problem`. The same
/// for any number of jobs.
std::vector<std::vector<KnownPart>> known_parts(const Problem& problem, const std::vector<Program>& programs,
                                                const RunOptions& options,
                                                std::chrono::steady_clock::time_point deadline, long budget,
                                                long& evaluations);

}  // namespace mechwright
