// Where a shipped problem's program has a value and a gradient, it has a Hessian.

#include "synthesis/bench/shipped.h"
#include "tests/long_form.h"
#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

/// Whether the Hessian at a point is there, if the gradient is.
::testing::AssertionResult has_hessian(const Program& program, const Eigen::VectorXd& x) {
    ProgramValues values;
    evaluate(program, x, true, values);
    if (!values.assembled) return ::testing::AssertionSuccess();
    const Eigen::VectorXd multipliers = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(program.rows.size()));
    LagrangianHessian hessian;
    lagrangian_hessian(program, x, 1, multipliers, hessian);
    if (hessian.value.allFinite()) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << "not a number in " << name_of(*program.problem, program.variant);
}

TEST(Hessians, OfShippedProblemsAreFiniteAtTheirStarts) {
    for (const bench::ShippedProblem& shipped : bench::shipped_problems(MECHWRIGHT_SOURCE_DIR "/problems"))
        for (const Variant& variant : variants(shipped.problem)) {
            if (shipped.name.starts_with("linkage/")) continue;  // tested where they are; each takes seconds
            const Program program = build_program(shipped.problem, variant);
            for (int start = 0; start < cases_to_try(1, 4); ++start)
                EXPECT_TRUE(has_hessian(program, start_point(program, 1, start, 8))) << shipped.name;
        }
}

}  // namespace

}  // namespace mechwright::testing
