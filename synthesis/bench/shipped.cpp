#include "synthesis/bench/shipped.h"

#include <algorithm>

#include "synthesis/problem/reader.h"

namespace mechwright::bench {

std::vector<ShippedProblem> shipped_problems(const std::filesystem::path& folder) {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        if (entry.path().extension() == ".toml")
            names.push_back(entry.path().lexically_relative(folder).replace_extension().generic_string());
    std::sort(names.begin(), names.end());
    std::vector<ShippedProblem> problems;
    for (const std::string& name : names) {
        auto problem = shipped_problem(folder, name);
        if (problem && !problem->study) problems.push_back({name, *std::move(problem)});
    }
    return problems;
}

std::optional<Problem> shipped_problem(const std::filesystem::path& folder, std::string_view name) {
    ReadProblem read = read_problem((folder / name).string() + ".toml");
    if (!read.ok()) return std::nullopt;
    return std::move(read.problem);
}

}  // namespace mechwright::bench
