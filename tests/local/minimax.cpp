// Madsen's method: the same optimum from all around it, at which the gradient is balanced.

#include <cmath>

#include "synthesis/local/local.h"
#include "tests/known_optima/solved.h"
#include "tests/long_form.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

struct Valley {
    const char* folder;
    const char* name;
};

/// The program of a problem's design, in units of its objective, and the point of the design in it.
struct Optimum {
    Solved solved;
    Program program;
    Eigen::VectorXd x;
};

Optimum optimum_of(const Valley& valley) {
    Optimum o{solved(shipped(std::string(valley.name) + ".toml", valley.folder)), {}, {}};
    for (const Variant& variant : variants(o.solved.problem)) {
        if (variant.assembly != o.solved.result.best->design.assembly) continue;
        const Program program = build_program(o.solved.problem, variant);
        Eigen::VectorXd x = point_of(program, o.solved.result.best->design);
        ProgramValues values;
        evaluate(program, x, false, values);
        if (violation(program, x, values) > LocalOutcome::feasible_below) continue;
        o.program = magnified(program, std::abs(values.objective));
        settle_epigraphs(o.program, x);
        o.x = std::move(x);
        break;
    }
    return o;
}

class Valleys : public ::testing::TestWithParam<Valley> {};

TEST_P(Valleys, LeadToTheOptimumFromAllAround) {
    const Optimum o = optimum_of(GetParam());
    ASSERT_GT(o.x.size(), 0);
    ASSERT_TRUE(asks_for_one_worst(o.program));
    EXPECT_LT(unbalanced_part(o.program, o.x), 1e-6);
    for (const double away : {1e-5, 1e-4, 1e-3})
        for (const int period : {2, 3}) {
            if (away == 1e-4 && !in_long_form()) continue;
            Eigen::VectorXd start = o.x;
            for (Eigen::Index i = 0; i < start.size(); ++i)
                start[i] += (i % period == 0 ? away : -away) * (std::abs(start[i]) + away);
            LocalLimits limits;
            limits.most_evaluations = 4000;
            const LocalOutcome found = minimax(o.program, start, limits);
            EXPECT_NEAR(std::abs(found.objective), 1, 1e-8) << away << " " << period;
            EXPECT_LT(found.violation, LocalOutcome::feasible_below);
            EXPECT_LT(found.evaluations, 4000);
            // What it says of its end is what stands there.
            ProgramValues values;
            evaluate(o.program, found.x, false, values);
            EXPECT_EQ(values.objective, found.objective);
        }
}

INSTANTIATE_TEST_SUITE_P(Shipped, Valleys,
                         ::testing::Values(Valley{"line", "dwell"}, Valley{"line", "lambda-120"},
                                           Valley{"line", "stroke-100"}, Valley{"function", "samples"},
                                           Valley{"function", "logarithm-compact"}, Valley{"path", "line-minimax"}),
                         [](const auto& test) {
                             std::string name = test.param.name;
                             std::erase(name, '-');
                             return name;
                         });

TEST(OneWorst, IsNotWhatSumsAndClosedObjectivesAskFor) {
    const auto asks = [](const std::string& text) {
        const ReadProblem read = parse_problem(text, "a.toml");
        EXPECT_TRUE(read.ok());
        return asks_for_one_worst(build_program(read.problem, variants(read.problem).front()));
    };
    EXPECT_FALSE(asks(shipped("case-4.toml", "path")));
    EXPECT_FALSE(asks(shipped("power-rms.toml", "function")));
    EXPECT_TRUE(asks(shipped("best-transmission.toml")));
}

/// Of an objective that nothing holds up: what a Newton step would gain.
TEST(UnbalancedPart, WithoutConstraintsIsTheRootOfTheGainToCome) {
    const Solved s = solved(shipped("case-3.toml", "path"));
    for (const Variant& variant : variants(s.problem)) {
        if (variant.assembly != s.result.best->design.assembly) continue;
        const Program program = build_program(s.problem, variant);
        Eigen::VectorXd x = point_of(program, s.result.best->design);
        ProgramValues values;
        evaluate(program, x, false, values);
        if (violation(program, x, values) > LocalOutcome::feasible_below) continue;
        const double least = values.objective;
        EXPECT_LT(unbalanced_part(program, x), 1e-6);
        x[1] *= 1 + 1e-5;
        evaluate(program, x, false, values);
        LocalOutcome from;
        from.consider(program, x, values);
        const double gain = (values.objective - least) / least;
        EXPECT_GT(gain, 0);
        EXPECT_NEAR(unbalanced_part(program, x) / std::sqrt(2 * gain), 1, 1e-2);
        return;
    }
    FAIL() << "no program holds the design";
}

}  // namespace

}  // namespace mechwright
