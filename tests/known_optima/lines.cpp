// Straight stretches of a coupler path: the lambda linkages, and what a minimax optimum must look like.

#include <cmath>

#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

std::string lambda(double range) {
    std::string text = shipped("lambda-120.toml", "line");
    const auto replace = [&](const std::string& old, const std::string& now) {
        text.replace(text.find(old), old.size(), now);
    };
    replace("start = 120", "start = " + std::to_string(180 - range / 2));
    replace("range = 120", "range = " + std::to_string(range));
    return text;
}

/// Half the width of the narrowest band parallel to the ground link that holds a lambda linkage's stretch, by a scan of
/// the closed form of its point: the pin, plus twice the coupler.
double scanned_half_band(double ground, double coupler, double from, double range) {
    double least = 1e300, greatest = -1e300;
    for (int i = 0; i <= 20000; ++i) {
        const double angle = from + range * i / 20000.0;
        const double dx = ground - std::cos(angle), dy = -std::sin(angle);
        const double d = std::hypot(dx, dy);
        const double turn = std::atan2(dy, dx) + std::acos(d / (2 * coupler));
        const double y = std::sin(angle) + 2 * coupler * std::sin(turn);
        least = std::min(least, y);
        greatest = std::max(greatest, y);
    }
    return 0.5 * (greatest - least);
}

struct Lambda {
    double range;
    double ground, coupler, half_band, stroke;  ///< as printed, in cranks
};

class KnownLambdas : public ::testing::TestWithParam<Lambda> {};

TEST_P(KnownLambdas, AreFoundToEveryDigit) {
    const Lambda& known = GetParam();
    const Solved s = solved(lambda(known.range));
    ASSERT_EQ(s.result.status, Status::solved);
    const double ground = s.dimension("ground"), coupler = s.dimension("coupler");
    EXPECT_NEAR(ground, known.ground, 5e-6);
    EXPECT_NEAR(coupler, known.coupler, 5e-6);
    // Chebyshev's condition. Of a band of 3e-9 the position of the optimum has half the digits of double.
    EXPECT_NEAR(coupler, (3 * ground - 1) / 2, 1e-10);
    EXPECT_NEAR(s.result.best->objective / known.half_band, 1, known.range < 30 ? 1.7e-3 : 3e-4);
    EXPECT_NEAR(s.value("line-length"), known.stroke, 5.1e-6);
    const auto json = document(s.problem, s.result);
    EXPECT_EQ(json["line"]["alternating"], 7);
    EXPECT_EQ(s.dimension("rocker"), coupler);
    EXPECT_EQ(s.dimension("point-along"), 2 * coupler);
    EXPECT_NEAR(scanned_half_band(ground, coupler, (180 - known.range / 2) * degree, known.range * degree) /
                    s.result.best->objective,
                1, 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Table, KnownLambdas,
                         ::testing::Values(Lambda{20, 2.98860, 3.98290, 2.99e-9, 0.60268},
                                           Lambda{60, 2.89908, 3.84862, 2.216e-6, 1.76267},
                                           Lambda{100, 2.72872, 3.59308, 4.901e-5, 2.79160},
                                           Lambda{120, 2.61803, 3.42705, 1.496e-4, 3.23391},
                                           Lambda{160, 2.35842, 3.03763, 8.901e-4, 3.93941},
                                           Lambda{180, 2.21525, 2.82288, 1.871e-3, 4.19321}),
                         [](const auto& test) { return std::to_string(static_cast<int>(test.param.range)); });

TEST(Lines, OfTheTextbookHaveItsHalfBand) {
    std::string text = lambda(180);
    text.replace(text.find("ground      = { min = 1, max = 10 }"), 35, "ground = 2");
    text.replace(text.find("coupler     = { min = 1, max = 10 }"), 35, "coupler = 2.5");
    const Solved s = solved(text);
    EXPECT_NEAR(s.result.best->objective, 4.877e-3, 5e-7);
    EXPECT_NEAR(s.value("line-length"), 4, 1e-5);
}

TEST(Lines, BySlsqpAndByIpoptAgree) {
    const double here = solved(lambda(120)).result.best->objective;
    EXPECT_NEAR(solved(lambda(120), "ipopt").result.best->objective / here, 1, 1e-8);
}

TEST(Lines, OfAFreeStretchMeetTheirRequirements) {
    const Solved s = solved(shipped("stroke-100.toml", "line"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_GE(s.value("line-length"), 100 * (1 - 1e-9));
    EXPECT_GE(s.value("transmission-angle-worst"), 40 * degree * (1 - 1e-9));
    EXPECT_LT(s.result.best->objective, 0.02);
}

/// A rod's point traces a line exactly where the slider-crank is in line and crank and rod are equal.
TEST(Lines, OfARodAreExactWhereTheyCanBe) {
    const Solved s = solved(R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = 50
rod = { min = 50, max = 60 }
offset = 0
point-along = { min = -60, max = -20 }
[line]
start = 20
range = 50
[objective]
minimize = "line-deviation"
)");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 0, 1e-7);
}

/// The crank pin moves on a circle about the crank pivot: known without a search.
TEST(Arcs, OfTheCrankPinAreExact) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 40
coupler = 90
rocker = 80
origin-x = 7
origin-y = -3
[arc]
start = 20
range = 100
[objective]
minimize = "arc-deviation"
)");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 0, 1e-9);
    EXPECT_NEAR(s.dimension("arc-x"), 7, 1e-8);
    EXPECT_NEAR(s.dimension("arc-y"), -3, 1e-8);
    EXPECT_NEAR(s.dimension("arc-radius"), 40, 1e-8);
    EXPECT_NEAR(s.value("arc-angle") / degree, 100, 1e-8);
}

/// The other end of a link of the arc's radius stays within the deviation of the arc's centre.
TEST(Arcs, MakeALinkDwell) {
    const Solved s = solved(shipped("dwell.toml", "line"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_LT(s.result.best->objective, 0.2);
    const Mechanism& mechanism = *s.problem.mechanism;
    const Design& d = s.result.best->design;
    double greatest = 0;
    for (int i = 0; i <= 20000; ++i) {
        const double angle = s.dimension("input-start") + s.dimension("input-range") * i / 20000.0;
        PathMiss miss{};
        mechanism.point->miss(mechanism.form(d.assembly), d.dimensions, angle,
                              {s.dimension("arc-x"), s.dimension("arc-y")}, miss);
        greatest = std::max(greatest, std::abs(std::hypot(miss.miss.x, miss.miss.y) - s.dimension("arc-radius")));
    }
    EXPECT_NEAR(greatest / s.result.best->objective, 1, 1e-6);
}

}  // namespace

}  // namespace mechwright
