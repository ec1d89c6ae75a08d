// Derivatives of programs: quick-return drives.

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

constexpr const char* slider_crank_head = R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 10, max = 40 }
rod = { min = 60, max = 160 }
offset = { min = -15, max = 15 }
)";
constexpr const char* shaper_head = R"(schema = 1
mechanism = "crank-shaper"
[dimensions]
centre-distance = { min = 90, max = 120 }
crank = { min = 30, max = 60 }
lever = { min = 150, max = 200 }
rod = { min = 100, max = 200 }
ram-distance = { min = 150, max = 190 }
)";
constexpr const char* whitworth_head = R"(schema = 1
mechanism = "whitworth"
[dimensions]
centre-distance = { min = 30, max = 60 }
crank = { min = 80, max = 120 }
arm = { min = 40, max = 60 }
rod = { min = 90, max = 200 }
slide-angle = { min = 40, max = 140 }
)";
constexpr const char* drag_link_head = R"(schema = 1
mechanism = "drag-link"
[dimensions]
ground = { min = 25, max = 35 }
crank = { min = 60, max = 80 }
coupler = { min = 60, max = 80 }
follower = { min = 60, max = 80 }
arm = { min = 40, max = 60 }
arm-angle = { min = -40, max = 40 }
rod = { min = 100, max = 200 }
slide-angle = { min = 20, max = 80 }
slide-offset = { min = -15, max = 15 }
)";
constexpr const char* ram_quantities = R"([[require]]
quantity = "transmission-angle-min"
min = 20
[[require]]
quantity = "transmission-angle-max"
max = 150
[[require]]
quantity = "ram-speed-max"
max = 90
[[require]]
quantity = "ram-acceleration-max"
max = 200
[[require]]
quantity = "stroke"
max = 100
[[require]]
quantity = "link-ratio"
max = 8
)";
constexpr const char* stroke_quantities = R"([quick-return]
working-share = 0.7
[[require]]
quantity = "time-ratio"
max = 1.3
[[require]]
quantity = "ram-speed-min-working"
min = 10
[[require]]
quantity = "speed-variation"
max = 0.5
[[objective]]
maximize = "transmission-angle-worst"
[[objective]]
minimize = "total-length"
weight = 0.3
)";

TEST(Derivatives, OfDrivesWithEveryQuantity) {
    for (const char* drive : {slider_crank_head, shaper_head, whitworth_head, drag_link_head})
        expect_exact_derivatives(problem_of(std::string(drive) + ram_quantities + stroke_quantities));
}

TEST(Derivatives, OfDrivesOverALimitedMotion) {
    for (const char* drive : {slider_crank_head, shaper_head, whitworth_head, drag_link_head})
        expect_exact_derivatives(
            problem_of(std::string(drive) + ram_quantities + "[motion]\ncrank_range = [30, 200]\n"));
}

TEST(Derivatives, OfThePathOfARodsPoint) {
    expect_exact_derivatives(problem_of(std::string(slider_crank_head) + placement + R"([path]
points = [[0, 0], [3, 8], [9, 12], [18, 9], [25, 2]]
timing = "free"
[objective]
minimize = "path-sse"
)"));
}

}  // namespace

}  // namespace mechwright::testing
