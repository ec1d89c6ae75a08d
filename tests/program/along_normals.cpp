// A path with a limit on its distances, in terms of what is missed along normals.

#include <cmath>
#include <random>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

Problem problem_with_limit(const std::string& limit, const std::string& timing = "timing = \"free\"") {
    return problem_of(std::string(head) + placement + "[path]\npoints = [[20, 20], [21, 26], [22, 30], [24, 33]]\n" +
                      timing + R"(
[[require]]
quantity = "path-max"
max = )" + limit + R"(
[objective]
maximize = "transmission-angle-worst"
)");
}

struct Case {
    Program program, along_normals;
    Eigen::VectorXd x;
};

/// The first variant whose start assembles.
std::optional<Case> case_of(const Problem& problem) {
    for (const Variant& variant : variants(problem)) {
        const Program program = build_program(problem, variant);
        const Eigen::VectorXd x = start_point(program, 3, 1, 50);
        if (auto changed = met_along_normals(program, x)) return Case{program, *std::move(changed), x};
    }
    return std::nullopt;
}

TEST(AlongNormals, DifferentiatesExactly) {
    const Problem problem = problem_with_limit("0.001");
    const auto c = case_of(problem);
    ASSERT_TRUE(c.has_value());
    EXPECT_TRUE(has_exact_derivatives(c->along_normals, c->x));
}

TEST(AlongNormals, HasTheMissesOfThePathAsItsRows) {
    const Problem problem = problem_with_limit("0.001");
    const auto c = case_of(problem);
    ASSERT_TRUE(c.has_value());
    ASSERT_EQ(c->program.size(), c->along_normals.size());
    ProgramValues with_squares, with_misses;
    evaluate(c->program, c->x, false, with_squares);
    evaluate(c->along_normals, c->x, false, with_misses);
    const double limit = 0.001 / c->program.length - 1.5e-14;  // room for rounding
    const std::size_t points = c->program.targets.size();
    const auto first = static_cast<Eigen::Index>(c->along_normals.rows.size() - 2 * points);
    std::size_t compared = 0;
    for (std::size_t r = 0; r < c->program.rows.size(); ++r) {
        if (c->program.rows[r].name != "path-max") continue;
        const Eigen::Index k = first + 2 * static_cast<Eigen::Index>(compared++);
        const double square = std::pow(with_misses.rows[k], 2) + std::pow(with_misses.rows[k + 1], 2);
        EXPECT_NEAR(with_squares.rows[static_cast<Eigen::Index>(r)] * limit * limit / square, 1, 1e-12);
        EXPECT_TRUE(c->along_normals.rows[static_cast<std::size_t>(k)].equality());
        EXPECT_NEAR(c->along_normals.rows[static_cast<std::size_t>(k) + 1].upper / limit, 1, 1e-12);
    }
    EXPECT_EQ(compared, points);
    for (const Row& row : c->along_normals.rows)
        EXPECT_NE(row.name, "path-max");
}

TEST(AlongNormals, MissesAlongTheCurveChangeWithTheCrankAngle) {
    const Problem problem = problem_with_limit("0.001");
    const auto c = case_of(problem);
    ASSERT_TRUE(c.has_value());
    ProgramValues values;
    evaluate(c->along_normals, c->x, true, values);
    const auto first = static_cast<Eigen::Index>(c->along_normals.rows.size() - 2 * c->program.targets.size());
    for (std::size_t i = 0; i < c->program.targets.size(); ++i) {
        const auto angle = static_cast<Eigen::Index>(c->program.first_path_angle + i);
        const Eigen::Index row = first + 2 * static_cast<Eigen::Index>(i);
        EXPECT_GT(values.jacobian(row, angle), 0);
        EXPECT_NEAR(values.jacobian(row + 1, angle), 0, 1e-14 * values.jacobian(row, angle));
    }
}

TEST(AlongNormals, IsForLimitsOfAnySizeOnUntimedPaths) {
    EXPECT_TRUE(case_of(problem_with_limit("5")).has_value());
    EXPECT_TRUE(case_of(problem_with_limit("0")).has_value());
    EXPECT_FALSE(case_of(problem_with_limit("0.001", "timing = \"prescribed\"\ncrank_angles = [0, 20, 40, 60]")));
}

}  // namespace

}  // namespace mechwright::testing
