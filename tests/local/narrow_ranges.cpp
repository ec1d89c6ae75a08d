// Ranges of every width, down to a few doubles, handed to Ipopt: the process lives on, and what is found lies in them.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "synthesis/local/local.h"
#include "tests/evaluation/shipped.h"
#include "tests/known_optima/solved.h"
#include "tests/long_form.h"

namespace mechwright {

namespace {

/// Widths from a few doubles to all of a range.
struct RandomWidths {
    std::mt19937_64 numbers{23};

    double between(double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(numbers);
    }
    bool one_in(int n) { return numbers() % static_cast<std::uint64_t>(n) == 0; }

    /// A range around `value`, somewhere in it or at one of its ends.
    template <class Limited>
    void narrow(Limited& limited, double value) {
        const double width = std::pow(10.0, between(-16.5, 0)) * std::abs(value);
        const double below = one_in(3) ? 0 : one_in(2) ? 1 : between(0, 1);
        limited.lower = value - below * width;
        limited.upper = std::max(limited.lower, value + (1 - below) * width);
    }
};

Program with_narrow_ranges(Program program, const Eigen::VectorXd& x, RandomWidths& widths) {
    ProgramValues values;
    evaluate(program, x, false, values);
    bool any = false;
    for (std::size_t i = 0; i < program.dimension_variables || !any; ++i) {
        if (i >= program.size()) break;
        if (!(any = widths.one_in(4) || any)) continue;
        widths.narrow(program.variables[i], x[static_cast<Eigen::Index>(i)]);
    }
    for (std::size_t r = 0; r < program.rows.size(); ++r)
        if (widths.one_in(3)) widths.narrow(program.rows[r], values.rows[static_cast<Eigen::Index>(r)]);
    return program;
}

/// What Ipopt 3.11.9 does with a first slack of zero ends the process: nothing is left to report then.
TEST(NarrowRanges, DoNotEndTheProcess) {
    RandomWidths widths;
    long runs = 0;
    testing::for_each_program(1, [&](const std::string& name, const Program& whole, const auto& points) {
        for (int k = 0; k < cases_to_try(1, 3); ++k, ++runs) {
            const Program program = with_narrow_ranges(whole, points.front(), widths);
            LocalLimits limits;
            limits.most_evaluations = 8;
            limits.near_optimum = runs % 3 != 0;
            const LocalOutcome end = ipopt(program, points.front(), limits);
            for (Eigen::Index i = 0; i < end.x.size(); ++i) {
                const Variable& v = program.variables[static_cast<std::size_t>(i)];
                const double rounding = 1e-7 * std::max(1.0, std::abs(end.x[i]));  // Ipopt moves bounds by that
                EXPECT_GE(end.x[i], v.lower - rounding) << name << " " << v.name;
                EXPECT_LE(end.x[i], v.upper + rounding) << name << " " << v.name;
            }
        }
    });
    EXPECT_GT(runs, cases_to_try(100, 300));
}

/// A design in a narrow range is that of the range's middle, and found to its last digits.
TEST(NarrowRanges, AreSolvedAsWideOnesAre) {
    for (const char* most : {"36", "35.01", "35.000001", "35.0000000000001", "35.00000000000001"}) {
        std::string text = testing::shipped("drag-link-velocity-ratio.toml");
        const std::string wide = "rocker  = { min = 35, max = 150 }";
        const std::size_t at = text.find(wide);
        ASSERT_NE(at, std::string::npos) << text;
        text.replace(at, wide.size(), std::string("rocker = { min = 35, max = ") + most + " }");
        const testing::Solved found = testing::solved(text);
        const testing::Solved expected = testing::solved(text, "slsqp");
        ASSERT_EQ(found.result.status, Status::solved) << most;
        EXPECT_NEAR(found.result.best->objective, expected.result.best->objective, 1e-7) << most;
    }
}

}  // namespace

}  // namespace mechwright
