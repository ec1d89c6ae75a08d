#pragma once
/// \file
/// Every four-bar whose coupler point passes through nine given points, in their order.

#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// Why a problem is not one of nine points; empty if it is.
std::string why_no_nine_points(const Problem& problem);

struct ExactDesigns {
    std::vector<Solution> designs;         ///< without a defect that shows at the points, best first
    std::vector<ExcludedDesign> excluded;  ///< with one
    SolutionCounts counts;
    bool complete = false;  ///< every solution is accounted for
};

/// All real solutions, each with its cognates and either fixed pivot as that of the crank, sized and placed as the
/// points say. Precondition: why_no_nine_points is empty.
ExactDesigns nine_point_designs(const Problem& problem, int jobs);

}  // namespace mechwright
