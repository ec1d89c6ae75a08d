#pragma once
/// \file
/// The problems that come with the program.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/problem.h"

namespace mechwright::bench {

struct ShippedProblem {
    std::string name;  ///< its file below the folder, without the ending: "path/case-2"
    Problem problem;
};

/// All of them below a folder, by name. Left out: studies, and files that are not valid problems.
std::vector<ShippedProblem> shipped_problems(const std::filesystem::path& folder);

/// One of them; nothing where there is none of this name, or it is not valid.
std::optional<Problem> shipped_problem(const std::filesystem::path& folder, std::string_view name);

}  // namespace mechwright::bench
