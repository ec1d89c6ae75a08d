#pragma once
/// \file
/// Which numbers of a problem say the dyad that ends on its output: those that are to be found from accuracy points,
/// and those that are given or searched.

#include <string>
#include <vector>

#include "synthesis/exact/output_dyads/output_dyad.h"
#include "synthesis/problem/problem.h"

namespace mechwright {

/// Dimensions by their numbers. As many accuracy points as there are numbers found from them: the place of the lever's
/// pivot (two), that of the inner pin on the lever, or its length and the output at the start (two), the rod's length;
/// of a slide its offset, the output at the start, the rod's length.
struct DyadPlan {
    OutputDyad dyad;
    bool start_is_found = false;        ///< the start of the output
    std::vector<std::size_t> found;     ///< dimensions of the linkage
    std::vector<std::size_t> searched;  ///< all others with ranges: without any there are finitely many dyads
    std::string why_not;                ///< why nothing can be found; empty if it can
};

/// How the accuracy points of a problem say the dyad of its linkage. Of more numbers than points some are searched: of
/// the pivot first, then the start of the output, then of the inner pin.
DyadPlan dyad_plan(const Problem& problem);

}  // namespace mechwright
