// What is asked of legs: the step, its height, how far the foot is off the ground while it comes back, and how far
// everything else keeps off it.

#include <algorithm>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "tests/mechanism/linkage_scans.h"

namespace mechwright::linkage_scans {

namespace {

/// Jansen's leg 84 above the ground, on which its foot T stands from 300 to 90 deg or so.
TEST(LinkageLegs, AreAskedForByHeightsAndTheGround) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/linkage/jansen-leg.toml");
    const std::string leg{std::istreambuf_iterator<char>(in), {}};
    const std::string text = leg + R"toml(
[placement]
origin-y = 84.1
[[region]]
name = "ground"
keep = "in"
of = ["upper", "lower", "lower-rod", "U"]
half-plane = { through = [0, 0], direction = 0 }
margin = 10
[[require]]
quantity = "height.least"
min = 0
[[require]]
quantity = "height.least(140, 240)"
min = 5
[[require]]
quantity = "height.range"
min = 20
)toml";
    const AnalysedRoom found = analysed_room(text);
    const std::vector<std::string> points{"T", "W", "U", "V", "O", "X", "Y"};
    constexpr int steps = 36000;
    const ScannedRoom scan(found.design, points, steps);
    ASSERT_EQ(scan.poses.size(), steps + 1u);
    double least = 1e9, greatest = -1e9, swinging = 1e9, others = 1e9;
    for (std::size_t i = 0; i < scan.poses.size(); ++i) {
        const Places& pose = scan.poses[i];
        least = std::min(least, pose[0].y);
        greatest = std::max(greatest, pose[0].y);
        if (i >= 14000 && i <= 24000) swinging = std::min(swinging, pose[0].y);
        for (std::size_t k = 1; k < pose.size(); ++k)
            others = std::min(others, pose[k].y);
    }
    EXPECT_NEAR(value_in(found.document, "height.least"), least, 1e-6);
    EXPECT_NEAR(value_in(found.document, "height.range"), greatest - least, 1e-6);
    EXPECT_NEAR(value_in(found.document, "height.least(140, 240)"), swinging, 1e-6);
    EXPECT_NEAR(value_in(found.document, "ground.margin"), others, 1e-6);
    EXPECT_GT(swinging, 5);
    expect_verified(found.document);
}

}  // namespace

}  // namespace mechwright::linkage_scans
