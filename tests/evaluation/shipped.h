#pragma once
/// \file
/// Every program that the shipped problems make, with points to evaluate it at.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"
#include "synthesis/search/starts.h"

namespace mechwright::testing {

/// Those of the built-in kinds: a linkage of its own takes many times as long to evaluate, and has its own tests, as
/// have rooms and regions.
inline std::vector<std::string> shipped_files() {
    std::vector<std::string> files;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(MECHWRIGHT_SOURCE_DIR "/problems"))
        if (entry.path().extension() == ".toml" && entry.path().parent_path().filename() != "linkage")
            files.push_back(entry.path().string());
    std::sort(files.begin(), files.end());
    return files;
}

/// "path/case-1".
inline std::string short_name(const std::string& file) {
    const std::filesystem::path path(file);
    return path.parent_path().filename().string() + "/" + path.stem().string();
}

/// Points as a search would begin from, at which the mechanism assembles.
inline std::vector<Eigen::VectorXd> points_of(const Program& program, int count) {
    std::vector<Eigen::VectorXd> points;
    ProgramValues values;
    for (int k = 1; k <= 4 * count && static_cast<int>(points.size()) < count; ++k) {
        const Eigen::VectorXd x = start_point(program, 3, k, 20);
        evaluate(program, x, true, values);
        if (values.assembled) points.push_back(x);
    }
    return points;
}

/// Calls use(name, program, points) for every variant of every shipped problem that has points.
template <class Use>
void for_each_program(int points_each, const Use& use) {
    for (const std::string& file : shipped_files()) {
        const ReadProblem read = read_problem(file);
        if (!read.problem.mechanism->made_from.empty()) continue;
        for (const Message& m : read.messages)
            if (!m.warning) ADD_FAILURE() << to_string(m);
        for (const Variant& variant : variants(read.problem)) {
            const Program program = build_program(read.problem, variant);
            const auto points = points_of(program, points_each);
            if (!points.empty()) use(short_name(file) + ": " + name_of(read.problem, variant), program, points);
        }
    }
}

}  // namespace mechwright::testing
