// Designs a crank-rocker of 60 deg swing and time ratio 1.2, prints its links, and fails unless it is solved and
// verified.
#include <mechwright/synthesis/problem/by_name.h>
#include <mechwright/synthesis/program/quantity_value.h>
#include <mechwright/synthesis/solve/solve.h>

#include <cstdio>
#include <numbers>

int main() {
    constexpr double degree = std::numbers::pi / 180;
    mechwright::Problem problem = mechwright::problem_of("four-bar");
    fix(problem, "ground", 100);
    design_within(problem, "crank", 5, 60);
    design_within(problem, "coupler", 20, 300);
    design_within(problem, "rocker", 20, 300);
    require_equal(problem, "time-ratio", 1.2);
    require_equal(problem, "swing", 60 * degree);
    maximize(problem, "transmission-angle-worst");
    if (!why_not_whole(problem).empty()) return 1;

    const mechwright::Result result = solve(problem, {});
    if (result.status != mechwright::Status::solved || !result.verified()) return 1;
    const mechwright::Design& design = result.best->design;
    for (const char* name : {"crank", "coupler", "rocker"})
        std::printf("%-8s %.4f\n", name, *value_named(problem, design, name));
    std::printf("worst transmission angle %.4f deg\n",
                *value_named(problem, design, "transmission-angle-worst") / degree);
    return 0;
}
