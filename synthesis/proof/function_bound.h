#pragma once
/// \file
/// A lower bound on the greatest structural error over all linkages.
///
/// The loop equation of a four-bar (Freudenstein) and of a slider-crank is linear in three constants: at each place of
/// the range a row of four known numbers, for input and output, is orthogonal to (k1, k2, k3, -1). So the determinant
/// of the rows of any four places vanishes. A linkage whose error is at most e has its outputs within e of those asked
/// for: where the determinant does not vanish for any such outputs, there is no such linkage. At a minimax optimum with
/// given scales the determinant of its four alternating extremes first vanishes when all four errors are the optimum's
/// own (de la Vallee Poussin's bound for the nonlinear family of linkages); with free scales the sets of four among its
/// extremes bound it in turn, and branch and bound runs over the scales.

#include <array>
#include <string>
#include <vector>

#include "analysis/numbers/interval.h"
#include "synthesis/program/result.h"
#include "synthesis/proof/branch_and_bound.h"

namespace mechwright {

struct FunctionBound {
    /// `best` is the design whose error is to be undercut; only for problems that `why_not` has nothing against.
    FunctionBound(const Problem& problem, const Design& best);

    /// Why a problem is not that of the least greatest error of a function; empty if it is.
    static std::string why_not(const Problem& problem);

    /// The greatest error of the design, in radians or lengths.
    double error() const { return error_; }

    /// Boxes that hold all scales; one, without extension, where all scales are given.
    std::vector<Box> boxes() const;

    /// The bound of the greatest error over a box of scales: a part of `error`, or 0.
    BoxBound operator()(const Box& box) const;

private:
    static constexpr std::size_t places = 4;
    using Errors = std::array<Interval, places>;
    bool excluded(const Box& box, const std::array<std::size_t, places>& at, double error) const;
    bool excluded_for(const Box& box, const std::array<std::size_t, places>& at, const Errors& errors, int depth) const;

    LoopRow<Interval> (*loop_row_)(const Interval& input, const Interval& output);
    double error_;
    std::vector<Vector<double>> points_;                   ///< (share, part)
    std::vector<std::array<std::size_t, places>> chosen_;  ///< of the points
    Box scales_;
};

}  // namespace mechwright
