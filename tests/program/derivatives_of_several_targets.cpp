// Programs of a linkage with several paths and poses, with quantities of all and of each.

#include <gtest/gtest.h>

#include <string>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

constexpr const char* links_and_quantities = R"(schema = 1
mechanism = "linkage"
[dimensions]
ground = { min = 1, max = 10 }
crank = { min = 0.5, max = 10 }
coupler = { min = 1, max = 10 }
rocker = { min = 1, max = 10 }
along = { min = -10, max = 10 }
across = { min = -10, max = 10 }
[placement]
origin-x = { min = -10, max = 10 }
tilt = { min = 0, max = 360 }
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["along", "across"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[[objective]]
minimize = "path-rms"
[[objective]]
minimize = "upper.path-rms"
weight = 2
[[objective]]
minimize = "pin.path-sse"
weight = 0.3
[[objective]]
minimize = "plate.pose-max"
[[require]]
quantity = "plate.pose-rms"
max = 3
[[require]]
quantity = "upper.path-max"
max = 4
[[require]]
quantity = "upper.path-sse"
max = 9
)";

constexpr const char* upper = R"([[path]]
name = "upper"
point = "P"
points = [[5, 4], [4, 5], [2.5, 5]]
weights = [1, 2, 3]
)";
constexpr const char* pin = R"([[path]]
name = "pin"
weight = 0.5
point = "C"
points = [[6, 3], [5.5, 4]]
)";
constexpr const char* plate = R"([poses]
name = "plate"
weight = 3
point = "P"
link = "coupler"
body-angle = { min = 0, max = 360 }
length = 2
poses = [[5, 4, 20], [4, 4], [3, 4, 50]]
)";

}  // namespace

TEST(DerivativesOfSeveralTargets, AreExactWithoutTiming) {
    expect_exact_derivatives(problem_of(std::string(links_and_quantities) + upper + pin + plate));
}

TEST(DerivativesOfSeveralTargets, AreExactAtPrescribedCrankAngles) {
    const std::string timing = "timing = \"prescribed\"\n";
    expect_exact_derivatives(problem_of(links_and_quantities + (upper + timing) +
                                        "crank_angles = [0, 20, 40]\ncrank-start = { min = 0, max = 90 }\n" + pin +
                                        timing + "crank_angles = [0, 30]\n" + plate + timing +
                                        "crank_angles = [0, 20, 50]\ncrank-start = { min = 20, max = 100 }\n"));
}

TEST(DerivativesOfSeveralTargets, AreExactWhereCurvesCount) {
    const std::string timing = "timing = \"none\"\n";
    std::string text = links_and_quantities;
    // Poses are met in their order: without them.
    text.replace(text.find("plate.pose-max"), 14, "pin.path-max");
    text.replace(text.find("plate.pose-rms"), 14, "pin.path-rms");
    expect_exact_derivatives(problem_of(text + (upper + timing) + pin + timing));
}

}  // namespace mechwright::testing
