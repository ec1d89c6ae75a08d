#pragma once
/// \file
/// Solves problem texts and shipped files for the tests of known optima.

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/proof.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"

namespace mechwright::testing {

struct Solved {
    Problem problem;
    Result result;

    double value(std::string_view quantity) const {
        const int index = find_quantity(*problem.mechanism, quantity);
        return quantity_value(problem, static_cast<std::size_t>(index), result.best->design).value();
    }
    double dimension(std::string_view name) const {
        return result.best->design.dimensions[static_cast<std::size_t>(find_dimension(*problem.mechanism, name))];
    }
};

/// Searches from at most so many starts unless a test is run in its long form: what is known has to be found by fewer.
constexpr int few_starts = 4;

inline Solved solved(const std::string& text, const std::string& method = "auto", std::uint64_t seed = 1, int jobs = 2,
                     int starts = few_starts) {
    ReadProblem read = parse_problem(text, MECHWRIGHT_SOURCE_DIR "/problems/path/problem-of-a-test.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m);
    Solved s{std::move(read.problem), {}};
    s.problem.solver.method = method;
    s.problem.solver.seed = seed;
    s.problem.solver.starts = std::min(s.problem.solver.starts, cases_to_try(starts, s.problem.solver.starts));
    if (text.find("time_limit") == std::string::npos) s.problem.solver.time_limit = 600;  // no machine is too busy
    RunOptions options;
    options.jobs = jobs;
    s.result = solve(s.problem, options);
    return s;
}

inline std::string shipped(const std::string& name, const std::string& folder = "four-bar") {
    std::ifstream file(MECHWRIGHT_SOURCE_DIR "/problems/" + folder + "/" + name);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace mechwright::testing
