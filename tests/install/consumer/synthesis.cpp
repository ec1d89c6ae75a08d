// Solves a problem and prints the result document; fails unless the design is solved and verified.
#include <iostream>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"

constexpr const char* problem_text = R"(
schema    = 1
title     = "Crank-rocker with 60 deg swing and time ratio 1.2"
mechanism = "four-bar"

[dimensions]
ground  = 100
crank   = { min = 5, max = 60 }
coupler = { min = 20, max = 300 }
rocker  = { min = 20, max = 300 }

[[require]]
quantity = "time-ratio"
equal    = 1.2

[[require]]
quantity = "swing"
equal    = 60

[objective]
maximize = "transmission-angle-worst"
)";

int main() {
    const auto read = mechwright::parse_problem(problem_text, "crank-rocker.toml");
    for (const auto& message : read.messages)
        std::cerr << mechwright::to_string(message) << '\n';
    if (!read.ok()) return 1;
    const auto result = mechwright::solve(read.problem, {});
    std::cout << mechwright::document(read.problem, result).dump(2) << '\n';
    return result.status == mechwright::Status::solved && result.verified() ? 0 : 1;
}
