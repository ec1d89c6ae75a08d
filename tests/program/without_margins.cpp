// A program without what keeps a linkage closed over its motion: the same variables, objective and path, and no rows
// but those that the problem asks for.

#include "synthesis/program/without_margins.h"

#include <gtest/gtest.h>

#include "synthesis/problem/reader.h"
#include "synthesis/search/starts.h"

namespace mechwright {

namespace {

Problem shipped_linkage(const std::string& name) {
    ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/linkage/" + name);
    EXPECT_TRUE(read.messages.empty());
    return std::move(read.problem);
}

TEST(WithoutMargins, AsksForThePathAlone) {
    const Problem problem = shipped_linkage("six-bar-timed-points.toml");
    const Program program = build_program(problem, variants(problem).front());
    ASSERT_TRUE(has_margins_of_motion(program));
    const Program path = without_margins(program);
    EXPECT_FALSE(has_margins_of_motion(path));
    EXPECT_TRUE(path.blocks.empty());
    EXPECT_EQ(path.size(), program.size());
    const Eigen::VectorXd x = start_point(program, 1, 0, 20);
    ProgramValues with, without;
    evaluate(program, x, true, with);
    evaluate(path, x, true, without);
    EXPECT_EQ(with.objective, without.objective);
    EXPECT_EQ(with.gradient, without.gradient);
    EXPECT_LT(without.rows.size(), with.rows.size());
}

TEST(WithoutMargins, KeepsWhatIsRequired) {
    const Problem problem = shipped_linkage("dwell-six-bar.toml");
    const Program program = build_program(problem, variants(problem).front());
    const Program asked = without_margins(program);
    const auto required = [](const Program& p) {
        return std::count_if(p.rows.begin(), p.rows.end(), [](const Row& row) { return row.requirement; });
    };
    EXPECT_GT(required(program), 0);
    EXPECT_EQ(required(asked), required(program));
    EXPECT_LT(asked.rows.size(), program.rows.size());
}

/// Conditions on dimensions cost nothing, and stay.
TEST(WithoutMargins, LeavesFixedKindsAlone) {
    ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/path/yu2-compact.toml");
    for (const Variant& variant : variants(read.problem))
        EXPECT_FALSE(has_margins_of_motion(build_program(read.problem, variant)));
}

}  // namespace

}  // namespace mechwright
