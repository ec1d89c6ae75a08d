#pragma once
/// \file
/// All four-bars through nine points.

#include <cstddef>
#include <vector>

#include "synthesis/exact/homotopy/nine_point_start.h"

namespace mechwright::homotopy {

/// One member of every orbit that was found, and what became of all paths that were followed.
struct NinePointSolutions {
    std::vector<NinePointValues> solutions;  ///< regular and distinct
    std::size_t tracked = 0;                 ///< paths
    std::size_t at_infinity = 0;             ///< ended at linkages that are infinitely large
    std::size_t singular = 0;                ///< ended where solutions meet, or at families of them
    std::size_t lost = 0;                    ///< neither: how they end is not known

    /// Whether every path is accounted for.
    bool complete() const { return lost == 0 && solutions.size() + at_infinity + singular == tracked; }
};

/// Follows all solutions of the start system to the target; what double does not suffice for, and paths that end at the
/// same place, again in extended precision and by shorter steps, then by another way. The same for any number of jobs.
NinePointSolutions solve_nine_points(const NinePointStart& start, const NinePointParameters& target, int jobs);

/// The parameters of nine real points, moved and scaled: the first one comes to lie in the origin.
struct NinePointTarget {
    NinePointParameters parameters;
    Complex<double> origin;  ///< the first point
    double size = 1;         ///< a length of 1 in the parameters
};

NinePointTarget nine_point_target(const std::array<Complex<double>, 9>& points);

/// Whether the conjugates of a solution are those of its numbers, but for rounding: then it is a four-bar.
bool is_real(const NinePointValues& solution);

}  // namespace mechwright::homotopy
