#pragma once
/// \file
/// Global searches for one problem, ours and others', and what they reach with how much work.

#include <cstdint>
#include <string_view>
#include <vector>

#include "synthesis/bench/known_optimum.h"

namespace mechwright::bench {

/// What a search has computed.
struct Work {
    long values = 0;       ///< of objective and constraints alone
    long derivatives = 0;  ///< of both with their gradients
    long hessians = 0;
};

/// The best merit reached after some work.
struct Mark {
    double merit;
    Work work;
};

/// What all searches of a problem are measured by.
struct Arena {
    const Problem* problem;
    KnownOptimum known;
    double user_units = 1;  ///< the file's objective times this is that of the program
    long budget = 0;        ///< values that a search without derivatives may ask for

    /// Objective and ten times the greatest violation; large where the mechanism does not assemble. The variables that
    /// bound the worst of something are set to it.
    double merit(Eigen::VectorXd x) const;
    double merit(const Solution& solution) const;
};

/// Nothing where the problem has no known optimum.
std::optional<Arena> arena_of(const Problem& problem, long budget, const RunOptions& options);

/// A point drawn evenly from the ranges of the variables.
Eigen::VectorXd random_point(const Program& program, std::uint64_t& state);

struct GlobalSearch {
    std::string_view name;
    bool (*applies)(const Problem&);
    std::vector<Mark> (*run)(const Arena& arena, std::uint64_t seed);
};

/// Ours first.
std::vector<GlobalSearch> global_searches();

}  // namespace mechwright::bench
