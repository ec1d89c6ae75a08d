// What cannot jump where segments of a cam's motion meet is not in the program; what can is one row, with a limit on
// either side.

#include <cmath>
#include <numbers>

#include "tests/known_optima/solved.h"
#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

/// Half a cycloid, constant velocity, half a cosine to the top, and a return: velocities can jump at both ends of the
/// constant one, accelerations at the top alone.
Problem composed_motion(const std::string& limit) {
    const std::string shipped_limit = "max      = 1e-09";
    std::string text = shipped("composed-motion.toml", "cam");
    for (std::size_t at = 0; (at = text.find(shipped_limit, at)) != std::string::npos; ++at)
        text.replace(at, shipped_limit.size(), limit);
    return problem_of(text);
}

std::vector<Row> rows_of(const Program& program, const std::string& name) {
    std::vector<Row> rows = program.rows;
    std::erase_if(rows, [&](const Row& row) { return row.name != name; });
    return rows;
}

TEST(Jumps, AreOneRowForEachPlaceWhereTheyCanBe) {
    const Problem problem = composed_motion("max = 2");
    const Program program = build_program(problem, variants(problem).front());
    const std::vector<Row> velocity = rows_of(program, "velocity-jump");
    ASSERT_EQ(velocity.size(), 2);
    EXPECT_EQ(rows_of(program, "acceleration-jump").size(), 1);

    // At the ends of the constant velocity, against its derivations: 2 h / b after a half cycloid, h / b, and
    // pi/2 h / b before a half cosine. Rows are in parts of their limit.
    Eigen::VectorXd x = start_point(program, 3, 1, 50);
    ProgramValues at;
    evaluate(program, x, false, at);
    const Design design = design_at(program, x);
    const auto dimension = [&](const std::string& name) {
        for (std::size_t i = 0; i < problem.mechanism->dimensions.size(); ++i)
            if (problem.mechanism->dimensions[i].name == name) return design.dimensions[i];
        return std::nan("");
    };
    const auto mean = [&](const std::string& k) { return dimension("lift-" + k) / dimension("angle-" + k); };
    std::vector<double> values;
    for (std::size_t i = 0; i < program.rows.size(); ++i)
        if (program.rows[i].name == "velocity-jump") values.push_back(at.rows[static_cast<Eigen::Index>(i)]);
    EXPECT_NEAR(values[0], (mean("2") - 2 * mean("1")) / 2, 1e-13);
    EXPECT_NEAR(values[1], (0.5 * std::numbers::pi * mean("3") - mean("2")) / 2, 1e-13);
    for (const Row& row : velocity) {
        EXPECT_EQ(row.upper, 1);
        EXPECT_EQ(row.lower, -1);
    }
}

// In parts of the limit a jump of one would count a milliard times as much as anything else. What the row's limit and
// the tolerance allow together is the limit.
TEST(Jumps, WithATinyLimitAreInPartsOfTheTolerance) {
    const Problem problem = composed_motion("max = 1e-09");
    const Program program = build_program(problem, variants(problem).front());
    for (const Row& row : rows_of(program, "velocity-jump")) {
        EXPECT_EQ(row.lower, -row.upper);
        const double limit = 1e-9 / program.length;
        const double allowed = (row.upper + problem.solver.tolerance) / row.form.outputs.front().factor;
        EXPECT_NEAR(allowed / limit, 1, 1e-12);
        EXPECT_LT(row.form.outputs.front().factor, 1e3);
    }
}

TEST(Jumps, ThatMustBeNoneAreEquations) {
    const Problem problem = composed_motion("equal = 0");
    const Program program = build_program(problem, variants(problem).front());
    ASSERT_EQ(rows_of(program, "velocity-jump").size(), 2);
    for (const Row& row : rows_of(program, "velocity-jump"))
        EXPECT_TRUE(row.equality());
}

TEST(Jumps, DifferentiateExactly) { expect_exact_derivatives(composed_motion("max = 2")); }

}  // namespace

}  // namespace mechwright::testing
