// Programs of problems with a range of use: what is asked over it depends on the crank angles of its ends.

#include <gtest/gtest.h>

#include <string>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

const std::string four_bar_of_use = uneven_head + placement;

constexpr const char* use = R"([motion]
from = "first-target"
to = "last-target"
before = 5
after = 10
)";

constexpr const char* over_four_bars = R"([[require]]
quantity = "transmission-angle-worst"
min = 30
[[require]]
quantity = "velocity-ratio-max"
max = 2
[[require]]
quantity = "velocity-ratio-min"
min = -2
[objective]
maximize = "transmission-angle-min"
)";

constexpr const char* poses = R"([poses]
poses = [[10, 35, 10], [5, 38, 20], [-2, 38, 35]]
)";

}  // namespace

TEST(DerivativesOfUse, AreExactWithoutTimingEitherWayRound) {
    expect_exact_derivatives(
        problem_of(four_bar_of_use + "body-angle = { min = 0, max = 360 }\n" + use + over_four_bars + poses));
}

TEST(DerivativesOfUse, AreExactWithTiming) {
    for (const char* angles : {"[0, 20, 50]", "[50, 20, 0]"})
        expect_exact_derivatives(problem_of(four_bar_of_use + "crank-start = { min = 0, max = 360 }\n" + use +
                                            over_four_bars +
                                            "[path]\ntiming = \"prescribed\"\npoints = [[10, 35], [5, 38], [-2, 38]]\n"
                                            "crank_angles = " +
                                            angles + "\n"));
}

TEST(DerivativesOfUse, AreExactBesideTheWholeMotion) {
    expect_exact_derivatives(problem_of(four_bar_of_use + "body-angle = { min = 0, max = 360 }\n" + use + poses +
                                        "[[require]]\nquantity = \"transmission-angle-worst.whole\"\nmin = 20\n"
                                        "[objective]\nmaximize = \"transmission-angle-worst\"\n"));
}

TEST(DerivativesOfUse, AreExactOfASliderCrank) {
    expect_exact_derivatives(problem_of(R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 5, max = 15 }
rod = { min = 30, max = 60 }
offset = { min = -5, max = 5 }
point-along = { min = 0, max = 30 }
point-across = { min = -10, max = 10 }
tilt = { min = 0, max = 360 }
[path]
points = [[10, 5], [5, 9], [-2, 9]]
[[require]]
quantity = "stroke"
max = 20
[[require]]
quantity = "ram-speed-max"
max = 12
[[require]]
quantity = "ram-acceleration-max"
max = 15
[[require]]
quantity = "transmission-angle-max"
max = 89
[objective]
maximize = "transmission-angle-worst"
)" + std::string(use)));
}

TEST(DerivativesOfUse, AreExactOfALinkageWithSeveralTargets) {
    expect_exact_derivatives(problem_of(linkage_head + R"([signals]
swing = { angle = "rocker" }
[[path]]
name = "upper"
point = "P"
points = [[5, 4], [4, 5], [2.5, 5]]
[[path]]
name = "pin"
point = "C"
points = [[6, 3], [5.5, 4]]
[[require]]
quantity = "swing.range"
max = 60
[[require]]
quantity = "swing.speed.greatest"
max = 2
[objective]
maximize = "transmission-angle-worst"
)" + std::string(use)));
}

}  // namespace mechwright::testing
