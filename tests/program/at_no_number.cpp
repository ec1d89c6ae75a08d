// Solvers step to points that are no numbers: there nothing assembles.

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

void expect_nothing_assembles(const std::string& text) {
    const Problem problem = problem_of(text);
    int programs = 0;
    for (const Variant& variant : variants(problem)) {
        const Program program = build_program(problem, variant);
        const auto size = static_cast<Eigen::Index>(program.size());
        ProgramValues at;
        evaluate(program, Eigen::VectorXd::Constant(size, std::numeric_limits<double>::quiet_NaN()), true, at);
        EXPECT_FALSE(at.assembled) << text;
        ++programs;
    }
    EXPECT_GT(programs, 0);
}

constexpr const char* four_bar = R"(
schema = 1
mechanism = "four-bar"
[dimensions]
ground = 2.477
crank = { min = 1, max = 3 }
coupler = 3.502
rocker = 1.555
point-along = 3.183
point-across = -4.17
[objective]
minimize = "path-rms"
[path]
points = [[1, 1], [2, 2], [0, 3]]
)";

}  // namespace

TEST(AtNoNumber, NoPathIsFollowedInAnyOrder) {
    expect_nothing_assembles(std::string(four_bar) + "timing = \"none\"\n");
}

TEST(AtNoNumber, NoPathIsFollowedInItsOrder) {
    expect_nothing_assembles(std::string(four_bar) + "timing = \"free\"\n");
}

TEST(AtNoNumber, NoStretchCoversSeveralTargets) {
    expect_nothing_assembles(linkage_head + R"(
[[path]]
name = "guided"
point = "P"
points = [[5, 4], [4, 5], [2.5, 5]]
[[path]]
name = "pin"
point = "C"
points = [[6, 3], [5.5, 4]]
[objective]
minimize = "path-rms"
)");
}

}  // namespace mechwright::testing
