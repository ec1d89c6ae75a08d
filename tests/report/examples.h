#pragma once
/// \file
/// Problems and results for the tests of reports, made by hand.

#include <gtest/gtest.h>

#include <string>

#include "synthesis/problem/reader.h"
#include "synthesis/program/result.h"

namespace mechwright::testing {

inline Problem problem_of(const std::string& text) {
    ReadProblem read = parse_problem(text, "example.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.problem;
}

inline const char* const crank_rocker_text = R"(
schema    = 1
title     = "Crank-rocker of 60 deg swing"
mechanism = "four-bar"

[dimensions]
ground  = 100
crank   = { min = 5, max = 60 }
coupler = { min = 20, max = 300 }
rocker  = { min = 20, max = 81.8 }
tilt    = 30

[[require]]
quantity = "swing"
equal    = 60

[[require]]
quantity = "transmission-angle-worst"
min = 30
max = 80

[objective]
maximize = "transmission-angle-worst"
)";

/// ground 100, crank 40, coupler 92.4, rocker 81.8 turned by 30 degrees: a crank-rocker, whose swing is 61.4 degrees.
inline Solution crank_rocker_solution() {
    Solution solution;
    solution.design.dimensions = {100, 40, 92.4, 81.8, 0, 0, 0, 0, 30 * 3.141592653589793 / 180};
    solution.objective = 39.7103;
    solution.violation = 0.02;
    return solution;
}

inline const char* const path_text = R"(
schema    = 1
mechanism = "four-bar"

[dimensions]
ground  = 100
crank   = 40
coupler = 90
rocker  = 80
point-along  = 20
point-across = 5

[path]
points  = [[30, 30], [10, 50], [-20, 30]]
weights = [1, 2, 3]
)";

inline Solution path_solution() {
    Solution solution;
    solution.design.dimensions = {100, 40, 90, 80, 20, 5, 0, 0, 0, 0};
    solution.design.path_angles = {0.5, 1.5, 2.5};
    solution.feasible = true;
    return solution;
}

inline Result result_of(Status status, const Solution& best) {
    Result result;
    result.status = status;
    result.best = best;
    result.verification = {{"assembles over the whole motion", true, "least margin 14.4"}, {"swing", true, "60"}};
    result.search.method = "search";
    result.search.starts = 32;
    result.search.local_optima = 3;
    result.search.hits = 20;
    result.search.missed_chance = 0.015;
    result.search.evaluations = 1234;
    result.search.seconds = 0.25;
    return result;
}

}  // namespace mechwright::testing
