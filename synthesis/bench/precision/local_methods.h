#pragma once
/// \file
/// The local methods of the program, each from the same starts and with the same choice of tolerances.

#include <string_view>
#include <vector>

#include "synthesis/bench/known_optimum.h"
#include "synthesis/local/local.h"

namespace mechwright::bench {

/// A local method as a program is searched with it.
struct LocalCandidate {
    std::string_view name;
    bool (*applies)(const Problem&);
    LocalOutcome (*run)(const Program&, const Eigen::VectorXd& start, const LocalLimits&);
};

std::vector<LocalCandidate> local_candidates();

/// A program and where a search of it starts.
struct Start {
    const Program* program;
    Eigen::VectorXd x;
};

/// The first so many starts of the multistart over a problem's programs.
std::vector<Start> first_starts(const Problem& problem, const std::vector<Program>& programs, int count);

}  // namespace mechwright::bench
