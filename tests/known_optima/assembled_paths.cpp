// Paths and poses whose best fit by least squares alone comes apart between its targets: the answer stays assembled,
// and is the same however the task is placed, turned and scaled in the drawing.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/program/standing/validity.h"
#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::Solved;
using testing::solved;

const std::string links = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 1, max = 60 }
crank = { min = 1, max = 60 }
coupler = { min = 1, max = 60 }
rocker = { min = 1, max = 60 }
point-along = { min = -60, max = 60 }
point-across = { min = -60, max = 60 }
origin-x = { min = -60, max = 60 }
origin-y = { min = -60, max = 60 }
tilt = { min = 0, max = 360 }
)";

/// The diagonal from crank pin to rocker pivot lies between the difference and the sum of coupler and rocker at many
/// crank angles of the stretch: plain geometry.
bool stays_assembled(const Solved& s) {
    const auto [least, greatest] =
        std::minmax_element(s.result.best->design.path_angles.begin(), s.result.best->design.path_angles.end());
    const double ground = s.dimension("ground"), crank = s.dimension("crank");
    const double coupler = s.dimension("coupler"), rocker = s.dimension("rocker");
    constexpr int steps = 20000;
    for (int i = 0; i <= steps; ++i) {
        const double angle = *least + (*greatest - *least) * i / steps;
        const double diagonal = std::hypot(ground - crank * std::cos(angle), crank * std::sin(angle));
        if (diagonal > coupler + rocker || diagonal < std::abs(coupler - rocker)) return false;
    }
    return true;
}

/// Fourteen points of an oval, 360 / 14 deg apart.
TEST(AssembledPaths, AnOvalByTimedPoints) {
    const Solved s = solved(links + R"(crank-start = { min = 0, max = 360 }
assembly = "either"
[path]
points = [[3.8733, 0.0], [3.3294, 1.6999], [2.3478, 3.0632], [1.0303, 3.8197], [-0.552, 3.8197], [-2.2297, 3.0632],
    [-3.6605, 1.6999], [-4.4042, 0.0], [-4.1283, -1.6999], [-2.8131, -3.0632], [-0.8116, -3.8197], [1.29, -3.8197],
    [2.9313, -3.0632], [3.7973, -1.6999]]
timing = "prescribed"
crank_angles = [0.0, 25.714285714, 51.428571429, 77.142857143, 102.857142857, 128.571428571, 154.285714286, 180.0,
    205.714285714, 231.428571429, 257.142857143, 282.857142857, 308.571428571, 334.285714286]
[objective]
minimize = "path-rms"
)");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(stays_assembled(s));
    EXPECT_NEAR(s.result.best->objective, 0.188852, 1e-6);
}

/// An oval that a slider-crank would come closest to with rod and crank of one length, where it may fold at two of the
/// points: the search stays beside that.
TEST(AssembledPaths, AnOvalBesideAChangePoint) {
    const Solved s = solved(R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 1, max = 60 }
rod = { min = 1, max = 60 }
offset = { min = -60, max = 60 }
point-along = { min = -60, max = 60 }
point-across = { min = -60, max = 60 }
origin-x = { min = -60, max = 60 }
origin-y = { min = -60, max = 60 }
tilt = { min = 0, max = 360 }
crank-start = { min = 0, max = 360 }
[path]
points = [[6.1039, 0.0], [5.1423, 2.9935], [2.659, 5.1849], [-0.3929, 5.987], [-3.052, 5.1849], [-4.7494, 2.9935],
    [-5.3181, 0.0], [-4.7494, -2.9935], [-3.052, -5.1849], [-0.3929, -5.987], [2.659, -5.1849], [5.1423, -2.9935]]
timing = "prescribed"
crank_angles = [0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330]
[objective]
minimize = "path-rms"
)");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.result.best->objective, 0.1646927, 1e-6);
}

TEST(AssembledPaths, SixPosesOfABody) {
    const Solved s = solved(links + R"(body-angle = { min = 0, max = 360 }
assembly = "either"
[poses]
poses = [[0, 0, 308.873], [1.48, -0.533, 326.438], [5.692, 0.541, 329.965], [10.226, 1.12, 335.942],
    [13.15, -0.155, 339.682], [15.106, -2.036, 350.23]]
length = 10
[objective]
minimize = "pose-rms"
)");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_TRUE(stays_assembled(s));
    EXPECT_LE(s.result.best->objective, 0.2381);
}

/// Seven freely timed points and a given crank pivot, everything `size` times as great and turned by so many degrees.
std::string free_points(double size, double turned) {
    const std::vector<Vector<double>> points{
        {6.97496861278684, 5.740698042871137},    {7.320286989591026, 2.433227466783708},
        {8.134148386179936, -0.696591871389602},  {7.830578910077258, -2.8085838613057357},
        {8.367007936916155, -3.8631560231272974}, {10.321118480746636, -4.007426435639609},
        {11.130787911497645, -3.2515998199594853}};
    const auto placed = [&](const Vector<double>& p) {
        const double c = size * std::cos(turned * degree), s = size * std::sin(turned * degree);
        return Vector<double>{c * p.x - s * p.y, s * p.x + c * p.y};
    };
    const auto range = [&](const char* name, double min, double max) {
        return fmt::format("{} = {{ min = {}, max = {} }}\n", name, min * size, max * size);
    };
    const Vector<double> pivot = placed({3, -2});
    std::string text = "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nassembly = \"either\"\n";
    text += range("ground", 2, 40) + range("crank", 1, 40) + range("coupler", 2, 40) + range("rocker", 2, 40);
    text += range("point-along", -40, 40) + range("point-across", -40, 40);
    text += fmt::format("origin-x = {}\norigin-y = {}\ntilt = {{ min = 0, max = 360 }}\n", pivot.x, pivot.y);
    text += "[path]\ntiming = \"free\"\npoints = [";
    for (const Vector<double>& p : points)
        text += fmt::format("[{}, {}],", placed(p).x, placed(p).y);
    return text + "]\n[objective]\nminimize = \"path-rms\"\n";
}

TEST(AssembledPaths, TheSameHoweverTheTaskIsScaledAndTurned) {
    for (const auto& [size, turned] : {std::pair{1.0, 0.0}, {1000.0, 0.0}, {0.037, 77.0}}) {
        const Solved s = solved(free_points(size, turned));
        EXPECT_EQ(s.result.status, Status::solved) << size;
        EXPECT_TRUE(stays_assembled(s)) << size;
        EXPECT_NEAR(s.result.best->objective / size, 0.0235766, 1e-7) << size;
    }
}

/// A design that meets its timed points and comes apart between them has a margin that says so, and is not feasible.
TEST(AssembledPaths, ADesignThatComesApartIsNamed) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 4
crank = 3
coupler = 3.5
rocker = 2
point-along = 1
crank-start = 0
[path]
points = [[3, 0], [3, 1]]
timing = "prescribed"
crank_angles = [-30, 30]
[[require]]
quantity = "path-max"
max = 100
)");
    ASSERT_TRUE(s.result.best);
    const std::vector<ValidityMargin> margins = validity_margins(s.problem, s.result.best->design);
    const auto broken = std::find_if(margins.begin(), margins.end(), [](const auto& m) { return m.margin < 0; });
    ASSERT_NE(broken, margins.end());
    EXPECT_EQ(broken->name, "it stays assembled from the first target to the last");
    EXPECT_FALSE(s.result.best->feasible);
    EXPECT_EQ(s.result.status, Status::infeasible);
}

}  // namespace

}  // namespace mechwright
