#pragma once
/// \file
/// From a problem to a result: picks the method, runs it, re-evaluates and verifies what it found.

#include <string_view>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/program/run_options.h"

namespace mechwright {

/// Solves, then verifies. Never throws for anything a problem file can contain; a proof whose certificate does not hold
/// is a defect of the program, std::logic_error.
Result solve(const Problem& problem, const RunOptions& options);

struct MethodDescription {
    std::string_view name;
    std::string_view meaning;
};

/// All methods of the program, "auto" first.
std::vector<MethodDescription> all_methods();

/// Why a method cannot be used for a problem; empty if it can.
std::string why_not_applicable(std::string_view method, const Problem& problem);

}  // namespace mechwright
