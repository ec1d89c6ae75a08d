#pragma once
/// \file
/// The programs of a problem with a path, and how least squares go through them.

#include <vector>

#include "synthesis/local/local.h"

namespace mechwright {

struct PathPrograms {
    std::vector<Program> all;              ///< of every variant
    std::vector<Program> free_of_margins;  ///< of each, for the first steps; none where margins cost little
    std::vector<std::size_t> fitted_as;    ///< of each: the one of the widest family, which fits its starts

    /// Those of a problem, which must outlive them.
    explicit PathPrograms(const Problem& problem);

    bool skip_margins() const { return !free_of_margins.empty(); }

    /// A few steps from a start. What keeps a linkage closed over its motion is looked at later.
    LocalOutcome short_search(std::size_t program, const Eigen::VectorXd& start, const LocalLimits& few) const;

    /// A search by least squares: first without what keeps a linkage closed over its motion, which is nearly always
    /// met where it ends, then with it.
    LocalOutcome long_search(std::size_t program, const Eigen::VectorXd& start, const LocalLimits& whole) const;
};

}  // namespace mechwright
