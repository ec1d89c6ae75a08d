// Programs of a linkage with several paths and poses, with quantities of all and of each.

#include <gtest/gtest.h>

#include <string>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

const std::string links_and_quantities = linkage_head + R"([[objective]]
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
    expect_exact_derivatives(problem_of(links_and_quantities + upper + pin + plate));
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
