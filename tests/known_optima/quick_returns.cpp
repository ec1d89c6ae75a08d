// Quick returns whose optimum is known from a closed form or from a brute-force scan that is written here, by formulas
// of its own; every method must find it.

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/quick_return.h"
#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

std::string quick_return(const std::string& name) { return shipped(name, "quick-return"); }

/// The best transmission angle (deg) of a slider-crank with this time ratio: for each crank over rod the offset that
/// gives the ratio, by bisection; the best crank by golden section.
double best_transmission_by_scan(double ratio) {
    const double wanted = std::numbers::pi * (ratio - 1) / (ratio + 1);
    const auto transmission = [&](double crank) {
        double low = 0, high = 1 - crank;  // rod 1
        for (int i = 0; i < 200; ++i) {
            const double e = 0.5 * (low + high);
            (std::asin(e / (1 - crank)) - std::asin(e / (1 + crank)) < wanted ? low : high) = e;
        }
        return std::acos(crank + low);
    };
    double left = 1e-6, right = 1 - 1e-6, best = 0;
    for (int i = 1; i < 2000; ++i) {
        const double crank = left + (right - left) * i / 2000;
        if (transmission(crank) > transmission(best == 0 ? left : best)) best = crank;
    }
    left = best - 1e-3;
    right = best + 1e-3;
    constexpr double golden = 0.61803398874989485;
    while (right - left > 1e-9) {
        const double a = right - golden * (right - left), b = left + golden * (right - left);
        (transmission(a) < transmission(b) ? left : right) = transmission(a) < transmission(b) ? a : b;
    }
    return transmission(0.5 * (left + right)) / degree;
}

std::string slider_crank_problem(double ratio) {
    return "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = { min = 1, max = 200 }\n"
           "rod = { min = 1, max = 2000 }\noffset = { min = -600, max = 600 }\n"
           "[[require]]\nquantity = \"stroke\"\nequal = 100\n[[require]]\nquantity = \"time-ratio\"\nequal = " +
           std::to_string(ratio) + "\n[objective]\nmaximize = \"transmission-angle-worst\"\n";
}

class EveryDriveMethod : public ::testing::TestWithParam<std::string> {};

TEST_P(EveryDriveMethod, FindsTheSliderCrankThatAScanFinds) {
    for (const double ratio : {1.05, 1.1, 1.2, 1.35, 1.5, 2.0, 2.5}) {
        const Solved s = solved(slider_crank_problem(ratio), GetParam());
        ASSERT_EQ(s.result.status, Status::solved) << ratio;
        EXPECT_NEAR(s.value("transmission-angle-worst") / degree, best_transmission_by_scan(ratio), 1e-8) << ratio;
        EXPECT_NEAR(s.value("stroke"), 100, 1e-10) << ratio;
        EXPECT_NEAR(s.value("time-ratio"), ratio, 1e-11) << ratio;
    }
}

TEST_P(EveryDriveMethod, FindsCrankAndCentreDistanceForTheRatio) {
    for (const double ratio : {1.2, 1.5, 1.6, 2.0, 2.5, 3.0}) {
        const double k = std::cos(std::numbers::pi / (1 + ratio));
        const std::string require = "[[require]]\nquantity = \"time-ratio\"\nequal = " + std::to_string(ratio) +
                                    "\n[[require]]\nquantity = \"stroke\"\nequal = 100\n"
                                    "[objective]\nmaximize = \"transmission-angle-worst\"\n";
        const Solved shaper = solved(
            "schema = 1\nmechanism = \"crank-shaper\"\n[dimensions]\ncentre-distance = 200\n"
            "crank = { min = 10, max = 199 }\nlever = { min = 20, max = 800 }\nrod = { min = 50, max = 400 }\n"
            "ram-distance = { min = 10, max = 800 }\n" +
                require,
            GetParam());
        ASSERT_EQ(shaper.result.status, Status::solved) << ratio;
        EXPECT_NEAR(shaper.dimension("crank") / 200, k, 1e-12) << ratio;
        EXPECT_NEAR(shaper.dimension("lever"), 50 / k, 1e-9) << ratio;
        EXPECT_NEAR(shaper.dimension("rod"), 400, 1e-9) << ratio;
        const double slope = 0.5 * (50 / k) * (1 - std::sin(std::numbers::pi / (1 + ratio))) / 400;
        EXPECT_NEAR(shaper.value("transmission-angle-worst"), std::acos(slope), 1e-9) << ratio;
        const Solved whitworth = solved(
            "schema = 1\nmechanism = \"whitworth\"\n[dimensions]\ncentre-distance = 50\n"
            "crank = { min = 51, max = 900 }\narm = { min = 10, max = 200 }\nrod = { min = 60, max = 400 }\n"
            "slide-angle = 90\n" +
                require,
            GetParam());
        ASSERT_EQ(whitworth.result.status, Status::solved) << ratio;
        EXPECT_NEAR(50 / whitworth.dimension("crank"), k, 1e-12) << ratio;
        EXPECT_NEAR(whitworth.dimension("arm"), 50, 1e-9) << ratio;
        EXPECT_NEAR(whitworth.value("transmission-angle-worst"), std::acos(50.0 / 400), 1e-9) << ratio;
    }
}

TEST_P(EveryDriveMethod, ShowsTheBestThatCanBeHadWhereTheLimitIsOutOfReach) {
    const Solved s = solved(quick_return("slider-crank-not-reachable.toml"), GetParam());
    EXPECT_EQ(s.result.status, Status::infeasible);
    EXPECT_NEAR(s.value("transmission-angle-worst") / degree, best_transmission_by_scan(1.5), 1e-7);
    EXPECT_TRUE(s.result.search.complete());
}

INSTANTIATE_TEST_SUITE_P(QuickReturns, EveryDriveMethod, ::testing::Values("closed-form", "slsqp", "ipopt"),
                         [](const auto& method) {
                             return method.param == "closed-form" ? "closed_form" : method.param;
                         });

/// Time ratio, speed and speed variation have many values each, of which the greatest counts: there are more ways to
/// choose one of each than programs that are searched.
TEST(QuickReturns, MayHaveManyLimitsOnGreatestValues) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = { min = 10, max = 200 }\n"
        "rod = { min = 20, max = 800 }\noffset = { min = 0, max = 400 }\n"
        "[[require]]\nquantity = \"time-ratio\"\nequal = 1.2\n[[require]]\nquantity = \"ram-speed-max\"\nmin = 117\n"
        "[[require]]\nquantity = \"speed-variation\"\nmin = 0.28\n"
        "[objective]\nmaximize = \"transmission-angle-worst\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.value("transmission-angle-worst") / degree, best_transmission_by_scan(1.2), 1e-7);
}

TEST(QuickReturns, NoSliderCrankHasATimeRatioOfMoreThanThree) {
    const Solved s = solved(slider_crank_problem(3.001), "auto");
    EXPECT_EQ(s.result.status, Status::infeasible);
    EXPECT_TRUE(s.result.search.complete());
    EXPECT_FALSE(s.result.best.has_value());
    EXPECT_NE(s.result.note.find("less than 3"), std::string::npos) << s.result.note;
}

TEST(QuickReturns, TheShaperLosesItsRatioWithItsStroke) {
    for (const auto& [name, stroke, ratio] : {std::tuple{"shaper-stroke-75.toml", 75.0, 1.272926},
                                              {"shaper-stroke-100.toml", 100.0, 1.383396},
                                              {"shaper-stroke-150.toml", 150.0, 1.648006},
                                              {"shaper-stroke-200.toml", 200.0, 2.0}}) {
        const Solved s = solved(quick_return(name));
        ASSERT_EQ(s.result.status, Status::solved) << name;
        EXPECT_NEAR(s.value("stroke"), stroke, 1e-9) << name;
        EXPECT_NEAR(s.value("time-ratio"), ratio, 5.1e-7) << name;
        EXPECT_NEAR(s.dimension("crank"), 0.75 * stroke, 1e-9) << name;
    }
}

TEST(QuickReturns, TheWhitworthDriveOfExercise26) {
    const Solved s = solved(quick_return("whitworth.toml"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_EQ(s.result.search.method, "closed-form");
    EXPECT_NEAR(s.dimension("crank"), 180, 1e-10);
    EXPECT_NEAR(s.dimension("arm"), 96, 1e-12);
}

}  // namespace

}  // namespace mechwright
