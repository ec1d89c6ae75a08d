// Dwells that are to be as still as can be: their extremes in closed form, what the number of these shows, and that a
// document which says otherwise does not pass.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/verify/verify.h"
#include "tests/known_optima/solved.h"

namespace mechwright {
namespace {

using testing::Solved;
using testing::solved;
using Json = nlohmann::ordered_json;

/// Two cranks, the second of which turns twice as fast: cos t - r cos 2t + 5 about t = 0, a parabola of cos t. From 300
/// to 60 deg it stands still best where 1 and 1/2 are as low: r = 1/3, highest at cos t = 3/4, 1/48 off its middle.
std::string two_cranks(const std::string& limit, const std::string& range = "{ min = 0.05, max = 0.6 }") {
    return fmt::format(R"toml(schema = 1
mechanism = "linkage"
[dimensions]
first = 1
second = {}
[links]
frame = {{ A = [0, 0], E = [5, 0] }}
first = {{ A = [0, 0], B = ["first", 0] }}
second = {{ E = [0, 0], D = ["second", 0] }}
[[drive]]
link = "first"
[[drive]]
link = "second"
ratio = 2
phase = 180
[signals]
slow = {{ x = "B" }}
fast = {{ x = "D" }}
both = {{ sum = {{ slow = 1, fast = 1 }} }}
{}
[objective]
minimize = "both.deviation(300, 60)"
)toml",
                       range, limit);
}

Check check_named(const Json& document, const std::string& beginning) {
    for (const Check& check : verify(document))
        if (check.name.starts_with(beginning)) return check;
    return {"none", false, "there is no such check"};
}
Check of_extremes(const Json& document) { return check_named(document, "extremes of both.deviation(300, 60)"); }
Check of_balance(const Json& document) { return check_named(document, "alternation shows that no design near"); }

TEST(Dwells, ExtremesAndTheirAlternationAreThoseOfTheClosedForm) {
    const Solved s = solved(two_cranks(""));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.dimension("second"), 1.0 / 3, 1e-12);
    const Json json = document(s.problem, s.result);
    ASSERT_EQ(json["dwells"].size(), 1u);
    const Json& dwell = json["dwells"][0];
    const double high = 180 / std::numbers::pi * std::acos(0.75);
    const double inputs[] = {300, 360 - high, 360, 360 + high, 420};
    ASSERT_EQ(dwell["extremes"].size(), std::size(inputs));
    for (std::size_t i = 0; i < std::size(inputs); ++i) {
        EXPECT_NEAR(dwell["extremes"][i]["input"].get<double>(), inputs[i], 1e-9);
        EXPECT_NEAR(dwell["extremes"][i]["off"].get<double>(), (i % 2 ? 1 : -1) / 48.0, 1e-14);
        EXPECT_NEAR(dwell["extremes"][i]["value"].get<double>(), 5.6875 + (i % 2 ? 1 : -1) / 48.0, 1e-14);
    }
    EXPECT_NEAR(dwell["middle"].get<double>(), 5.6875, 1e-14);
    EXPECT_EQ(dwell["alternating"], 5);
    EXPECT_EQ(dwell["free"], 2);  // the second crank and the middle
    EXPECT_EQ(dwell["held"], 0);
    EXPECT_EQ(dwell["balanced"], true);
    EXPECT_TRUE(of_extremes(json).passed) << of_extremes(json).detail;
    EXPECT_TRUE(of_balance(json).passed) << of_balance(json).detail;
}

// The second crank held at 0.3, whatever holds it, two extremes are enough.
TEST(Dwells, LimitsThatHoldTakeTheirPartOfTheBalance) {
    for (const std::string& text : {two_cranks("", "{ min = 0.05, max = 0.3 }"),
                                    two_cranks("[[require]]\nquantity = \"fast.greatest\"\nmax = 5.3\n"),
                                    two_cranks("[[require]]\nquantity = \"fast.least\"\nequal = 4.7\n")}) {
        const Solved s = solved(text);
        ASSERT_EQ(s.result.status, Status::solved);
        const Json json = document(s.problem, s.result);
        const Json& dwell = json["dwells"][0];
        EXPECT_EQ(dwell["alternating"], 3);
        EXPECT_EQ(dwell["free"], 2);
        EXPECT_EQ(dwell["held"], 1);
        EXPECT_EQ(dwell["balanced"], true);
        EXPECT_TRUE(all_passed(verify(json)));
    }
}

// A design that something else shapes is stated to be balanced by nothing, and may not be stated to be.
TEST(Dwells, WhatIsNoLeastDeviationIsNotCalledOne) {
    const Solved s = solved(two_cranks("[[require]]\nquantity = \"fast.greatest\"\nequal = 5.2\n"));
    ASSERT_EQ(s.result.status, Status::solved);
    Json json = document(s.problem, s.result);
    EXPECT_EQ(json["dwells"][0]["balanced"], true);  // an equality pulls either way
    json["requirements"] = Json::array();
    json["dwells"][0]["held"] = 0;
    EXPECT_TRUE(of_extremes(json).passed) << of_extremes(json).detail;
    EXPECT_FALSE(of_balance(json).passed);
    json["dwells"][0]["balanced"] = false;
    EXPECT_TRUE(of_extremes(json).passed);
    EXPECT_EQ(of_balance(json).name, "none");
}

TEST(Dwells, WhatIsStatedOtherwiseIsFound) {
    const Solved s = solved(two_cranks(""));
    ASSERT_EQ(s.result.status, Status::solved);
    const Json right = document(s.problem, s.result);
    const auto spoilt = [&](const auto& spoil) {
        Json json = right;
        spoil(json["dwells"][0]);
        return of_extremes(json);
    };
    EXPECT_FALSE(spoilt([](Json& d) { d["alternating"] = 4; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["free"] = 1; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["held"] = 1; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["middle"] = 5.6876; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["extremes"][1]["input"] = 318.7; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["extremes"][1]["value"] = 5.7; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["extremes"][1]["off"] = -1 / 48.0; }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["extremes"].erase(2); }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { std::swap(d["extremes"][0], d["extremes"][2]); }).passed);
    EXPECT_FALSE(spoilt([](Json& d) { d["extremes"] = "none"; }).passed);
    Json of_nothing = right;
    of_nothing["dwells"][0]["quantity"] = "slow.deviation(300, 60)";
    EXPECT_FALSE(all_passed(verify(of_nothing)));
    of_nothing["dwells"] = 1;
    EXPECT_FALSE(all_passed(verify(of_nothing)));
}

}  // namespace
}  // namespace mechwright
