// Designs a crank-rocker of 60 deg swing and time ratio 1.2, and a six-bar of given links whose output shall swing by
// 40 deg; prints their dimensions, and fails unless they are solved and verified.
#include <mechwright/synthesis/problem/by_name.h>
#include <mechwright/synthesis/problem/reader.h>
#include <mechwright/synthesis/program/quantity_value.h>
#include <mechwright/synthesis/solve/solve.h>

#include <cstdio>
#include <nlohmann/json.hpp>
#include <numbers>

namespace {

constexpr double degree = std::numbers::pi / 180;

/// Solves a problem, and prints some of what its design has; false unless that is verified.
bool solved(const mechwright::Problem& problem, std::initializer_list<const char*> names) {
    const mechwright::Result result = solve(problem, {});
    if (result.status != mechwright::Status::solved || !result.verified()) return false;
    for (const char* name : names)
        std::printf("%-8s %.4f\n", name, *value_named(problem, result.best->design, name));
    return true;
}

/// Two four-bars in a row, the second on an arm of the first one's rocker: any linkage is taken as a file says it.
mechwright::ReadProblem six_bar() {
    return mechwright::take_problem({{"schema", 1},
                                     {"mechanism", "linkage"},
                                     {"dimensions", {{"arm", {{"min", 10}, {"max", 60}}}}},
                                     {"links",
                                      {{"frame", {{"A", {0, 0}}, {"D", {100, 0}}, {"F", {200, 0}}}},
                                       {"crank", {{"A", {0, 0}}, {"B", {30, 0}}}},
                                       {"coupler", {{"B", {0, 0}}, {"C", {95, 0}}}},
                                       {"rocker", {{"D", {0, 0}}, {"C", {70, 0}}, {"Q", {"arm", 0}}}},
                                       {"rod", {{"Q", {0, 0}}, {"E", {100, 0}}}},
                                       {"output", {{"F", {0, 0}}, {"E", {60, 0}}}}}},
                                     {"drive", {{"link", "crank"}}},
                                     {"signals", {{"swing", {{"angle", "output"}}}}},
                                     {"require", {{{"quantity", "swing.range"}, {"equal", 40}}}}},
                                    "six-bar");
}

}  // namespace

int main() {
    mechwright::Problem problem = mechwright::problem_of("four-bar");
    fix(problem, "ground", 100);
    design_within(problem, "crank", 5, 60);
    design_within(problem, "coupler", 20, 300);
    design_within(problem, "rocker", 20, 300);
    require_equal(problem, "time-ratio", 1.2);
    require_equal(problem, "swing", 60 * degree);
    maximize(problem, "transmission-angle-worst");
    if (!why_not_whole(problem).empty()) return 1;

    if (!solved(problem, {"crank", "coupler", "rocker"})) return 1;

    const mechwright::ReadProblem read = six_bar();
    return read.ok() && solved(read.problem, {"arm"}) ? 0 : 1;
}
