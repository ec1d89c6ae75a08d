// Bounds of structural errors: the exercises of the source proven, and no linkage below the bound.

#include <cmath>
#include <random>

#include "synthesis/mechanism/four_bar/function.h"
#include "synthesis/proof/function_bound.h"
#include "synthesis/verify/proofs/proof_checks.h"
#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

TEST(FunctionBound, ProvesTheExercisesOfTheSource) {
    for (const char* file : {"power.toml", "tangent.toml", "reciprocal.toml"}) {
        const Solved s = solved(shipped(file, "function"));
        ASSERT_EQ(s.result.status, Status::solved) << file;
        EXPECT_TRUE(s.result.search.complete()) << file;
        ASSERT_TRUE(s.result.search.bound);
        EXPECT_GE(*s.result.search.bound, s.result.best->objective * (1 - 1.1e-6)) << file;
        EXPECT_LE(*s.result.search.bound, s.result.best->objective) << file;
    }
}

TEST(FunctionBound, ProvesARamOfGivenScales) {
    const Solved s = solved(R"toml(schema = 1
mechanism = "slider-crank"
[dimensions]
crank  = { min = 10, max = 300 }
rod    = { min = 10, max = 900 }
offset = { min = -300, max = 300 }
[function]
expression = "x^2"
x      = [1, 3]
input  = { start = 165, range = 80 }
output = { start = 68, range = 60 }
[objective]
minimize = "function-max"
)toml");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(s.result.search.complete());
}

/// With a link held short the least error of the problem is not that of all linkages.
TEST(FunctionBound, LeavesAGapWhereARangeIsActive) {
    std::string text = shipped("power.toml", "function");
    text.replace(text.find("max = 100 }", text.find("\ncoupler ")), 11, "max = 12 }");
    const Solved s = solved(text);
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_FALSE(s.result.search.complete());
    EXPECT_LT(*s.result.search.bound, s.result.best->objective * (1 - 1e-3));
    nlohmann::ordered_json json = document(s.problem, s.result);
    EXPECT_TRUE(all_passed(check_proof(json)));
    // Above what linkages without the limit reach.
    json["search"]["bound"] = s.result.best->objective * (1 - 1e-4);
    EXPECT_FALSE(all_passed(check_proof(json)));
}

/// The error of random linkages at the places that the bound looks at is not below it, whatever their scales.
TEST(FunctionBound, IsNeverAboveALinkageOfTheBox) {
    const Solved s = solved(shipped("logarithm.toml", "function"));
    const FunctionBound bound(s.problem, s.result.best->design);
    std::mt19937_64 random(3);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(0, 1);
    const std::size_t scales = s.problem.mechanism->input->start;
    int tight = 0;
    for (int i = 0; i < 3000; ++i) {
        Design design = s.result.best->design;
        const double change = std::pow(10, -1 - 4 * unit(random));
        for (const std::size_t k : {std::size_t{1}, std::size_t{2}, std::size_t{3}, scales, scales + 2})
            design.dimensions[k] *= 1 + change * normal(random);
        const auto error = quantity_value(
            s.problem, static_cast<std::size_t>(find_quantity(*s.problem.mechanism, "function-max")), design);
        if (!error) continue;
        Box box;
        for (std::size_t k = 0; k < Box::most; ++k)
            box.middle[k] = design.dimensions[scales + k];
        box.half[0] = change * unit(random);
        box.half[2] = change * unit(random);
        const double least = bound(box).least;
        EXPECT_LE(least, *error * (1 + 1e-9));
        tight += least > 0;
    }
    EXPECT_GT(tight, 100);
}

}  // namespace

}  // namespace mechwright
