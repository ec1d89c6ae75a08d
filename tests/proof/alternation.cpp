// Alternation, the proof of the least error near a design: it is derived again from the document alone, and does not
// hold where something else than the error shaped the design.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"

namespace mechwright {
namespace {

using testing::Solved;
using testing::solved;

/// The check of the extremes that a document states.
template <class Json>
Check check_of_extremes(const Json& json) {
    for (const Check& check : verify(json))
        if (check.name == "extremes of the error are as stated") return check;
    return {"none", false, {}};
}

// Near a singular position the error depends so weakly on one dimension that rounding decides whether it is free:
// doubles and fifty digits may count differently by that one.
TEST(Alternation, AllowsForADimensionThatRoundingMakesFree) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 50
crank = { min = 1, max = 1000 }
coupler = { min = 1, max = 1000 }
rocker = { min = 1, max = 1000 }
assembly = "either"
[function]
expression = "x^3"
x = [1.5345296994353936, 4.183943776055379]
input = { start = 180.1764100214961, range = -63.867150388308566 }
output = { start = 143.71399306621518, range = 49.00106932855538 }
[objective]
minimize = "function-max"
)");
    ASSERT_EQ(s.result.status, Status::solved);
    for (const Check& check : verify(document(s.problem, s.result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

// The least deviation of a linkage of limited size alternates as often as one without limits. Its document without the
// limits claims that no linkage near is better, which a smaller line disproves.
// A parallelogram turns its input into the same output: of rounding alone there are no extremes to compare.
TEST(Alternation, ErrorsThatAreRoundingHaveToBeStatedSo) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 5
crank = 3
coupler = 5
rocker = 3
assembly = "open"
[function]
expression = "x"
x = [0, 1]
input = { start = 30, range = 60 }
output = { start = 30, range = 60 }
[objective]
minimize = "function-max"
)");
    ASSERT_EQ(s.result.status, Status::solved);
    auto json = document(s.problem, s.result);
    const auto of_extremes = [&] { return check_of_extremes(json); };
    EXPECT_TRUE(of_extremes().passed) << of_extremes().detail;
    EXPECT_EQ(of_extremes().detail, "the error is nothing but rounding");
    json["function"]["extremes"][0]["error"] = 1e-9;
    EXPECT_FALSE(of_extremes().passed);
    json["function"]["extremes"] = "none";
    EXPECT_FALSE(of_extremes().passed);
}

// Where an error passes half a turn it goes on from minus half a turn: two sides of one place, neither of which is more
// an extreme than the other.
TEST(Alternation, HalfATurnOfErrorIsOneExtremeOfEitherSign) {
    const Solved s = solved(R"file(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 6
crank = 4.68344959
coupler = 7.07427496
rocker = 2.8088018
[function]
expression = "tan(x * pi / 180)"
x = [0, 45]
input = { start = 225, range = 89.9 }
output = { start = 270, range = 90 }
[objective]
minimize = "function-max"
)file");
    auto json = document(s.problem, s.result);
    const auto of_extremes = [&] { return check_of_extremes(json); };
    ASSERT_EQ(json["function"]["extremes"].size(), 3u);
    EXPECT_NEAR(std::abs(json["function"]["extremes"][1]["error"].get<double>()), 180, 1e-9);
    EXPECT_TRUE(of_extremes().passed) << of_extremes().detail;
    json["function"]["extremes"][1]["error"] = -json["function"]["extremes"][1]["error"].get<double>();
    EXPECT_TRUE(of_extremes().passed) << of_extremes().detail;
    json["function"]["extremes"][1]["error"] = 179;
    EXPECT_FALSE(of_extremes().passed);
}

// Just before half a turn the sign of an error shows by no more than a millionth of it.
TEST(Alternation, ErrorsThatPassHalfATurnAreExtremeWhereTheyDo) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 5
crank = 50.96987185759087
coupler = 100
rocker = 62.22641361333512
[function]
expression = "x^1.5"
x = [1, 4]
input = { start = 210, range = 90 }
output = { start = 270, range = 90 }
[objective]
minimize = "function-max"
)");
    auto json = document(s.problem, s.result);
    ASSERT_EQ(json["function"]["extremes"].size(), 4u);
    const Check extremes = check_of_extremes(json);
    EXPECT_TRUE(extremes.passed) << extremes.detail;
    json["function"]["extremes"].erase(2);
    EXPECT_FALSE(check_of_extremes(json).passed);
}

// The same four-bar as a linkage, whose signals count on beyond half a turn from where the range begins.
TEST(Alternation, ErrorsOfSignalsGoOnBeyondHalfATurn) {
    const std::string expression = "expression = \"x^1.5\"\nx = [1, 4]\n", samples = "samples = [[1, 1], [4, 8]]\n";
    for (const std::string& asked : {expression, samples}) {
        const Solved s = solved(R"(schema = 1
mechanism = "linkage"
[dimensions]
crank = 50.96987185759087
[links]
frame = { A = [0, 0], D = [5, 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = [100, 0] }
rocker = { D = [0, 0], C = [62.22641361333512, 0] }
[drive]
link = "crank"
[assembly]
C = { side = "left", from = "B", to = "D" }
[signals]
swing = { angle = "rocker" }
[objective]
minimize = "function-max"
[function]
signal = "swing"
input = { start = 210, range = 90 }
output = { start = 270, range = 90 }
)" + asked);
        auto json = document(s.problem, s.result);
        auto& last = json["function"]["extremes"].back()["error"];
        EXPECT_NEAR(last.get<double>(), -360 + 166.5193643586096, 1e-9);
        EXPECT_TRUE(check_of_extremes(json).passed) << check_of_extremes(json).detail;
        last = 100;
        EXPECT_FALSE(check_of_extremes(json).passed);
    }
}

// A parallelogram whose error ends at half a turn: what it changes by is not the turn by which it is counted back.
TEST(Alternation, CountsFreeDimensionsAtHalfATurn) {
    const Solved s = solved(R"file(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 3
crank = { min = 2.5, max = 4.7 }
coupler = { min = 1, max = 60 }
rocker = { min = 1, max = 60 }
[function]
expression = "tan(x * pi / 180)"
x = [0, 45]
input = { start = 225, range = 90 }
output = { start = 270, range = 90 }
[objective]
minimize = "link-ratio"
)file");
    const auto json = document(s.problem, s.result);
    ASSERT_NEAR(std::abs(json["function"]["extremes"].back()["error"].get<double>()), 180, 1e-9);
    EXPECT_EQ(json["function"]["free"], 2);
    const Check extremes = check_of_extremes(json);
    EXPECT_TRUE(extremes.passed) << extremes.detail;
}

TEST(Alternation, ShowsNothingOfADesignThatItsLimitsShaped) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground      = { min = 20, max = 400 }
crank       = { min = 10, max = 100 }
coupler     = { min = 20, max = 400 }
rocker      = { of = "coupler" }
point-along = { of = "coupler", times = 2 }
[line]
start     = { min = 60, max = 180 }
range     = { min = 60, max = 240 }
full_turn = true
[[require]]
quantity = "line-length"
equal    = 100
[[require]]
quantity = "total-length"
max      = 400
[objective]
minimize = "line-deviation"
[solver]
starts = 8
)");
    ASSERT_EQ(s.result.status, Status::solved);
    auto json = document(s.problem, s.result);
    ASSERT_GT(json["line"]["alternating"].get<int>(), json["line"]["free"].get<int>());
    ASSERT_TRUE(all_passed(verify(json)));
    json["requirements"] = nlohmann::ordered_json::array();
    const auto checks = verify(json);
    const auto balance = std::find_if(checks.begin(), checks.end(),
                                      [](const Check& c) { return c.name.starts_with("alternation shows"); });
    ASSERT_NE(balance, checks.end());
    EXPECT_FALSE(balance->passed) << balance->detail;
}

}  // namespace
}  // namespace mechwright
