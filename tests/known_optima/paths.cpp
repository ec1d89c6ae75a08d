// Coupler paths whose answer is known without a search: those that a linkage meets exactly, and what any answer must
// hold to. Cases of the literature whose best answer is only ever found stand in pinned/.

#include <cctype>
#include <cmath>
#include <numbers>

#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

TEST(Paths, CaseOneIsMetExactlyAndInOrder) {
    const Solved s = solved(shipped("case-1.toml", "path"));
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_LE(s.value("path-sse"), 1e-24);
    const auto& angles = s.result.best->design.path_angles;
    const double direction = angles.back() > angles.front() ? 1 : -1;
    for (std::size_t i = 1; i < angles.size(); ++i)
        EXPECT_GT(direction * (angles[i] - angles[i - 1]), 0);
}

/// Without an objective, too, points of a given linkage are met where it passes them, before and after a full turn.
TEST(Paths, OfAGivenLinkageAreMetFromEverySeed) {
    const std::string text =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = 40\ncoupler = 90\nrocker = 80\n"
        "point-along = 20\npoint-across = 5\nassembly = \"open\"\n[motion]\nfrom = \"first-target\"\nto = "
        "\"last-target\"\n[path]\npoints = [[38.94831, 6.88977], [42.62152, 13.41512], [46.46387, 23.01128]]\n";
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Solved s = solved(text, "auto", seed);
        EXPECT_LT(s.value("path-rms"), 1e-5) << seed;
        const auto& angles = s.result.best->design.path_angles;
        EXPECT_NEAR(angles[2] - angles[0], 25 * degree, 1e-6) << seed;
    }
}

/// Each point of a path without timing counts by the nearest point of the whole curve.
/// Links whose lengths are nearly given, as where a machine is rebuilt: the best known of the wide ranges is among
/// them.
TEST(Paths, OfLengthsInNarrowRangesAreFound) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = { min = 47.5, max = 50 }\n"
        "crank = { min = 0, max = 50 }\ncoupler = { min = 3.34, max = 3.68 }\nrocker = { min = 34.8, max = 50 }\n"
        "point-along = { min = 0, max = 50 }\npoint-across = { min = 4.72, max = 8.75 }\n"
        "origin-x = { min = -50, max = 50 }\norigin-y = { min = -9, max = -8.2 }\ntilt = { min = 0, max = 360 }\n"
        "assembly = \"either\"\n[path]\npoints = [[0, 0], [1.9098, 5.8779], [6.9098, 9.5106], [13.09, 9.5106], "
        "[18.09, 5.8779], [20, 0]]\ntiming = \"prescribed\"\ncrank_angles = [30, 60, 90, 120, 150, 180]\n"
        "[objective]\nminimize = \"path-sse\"\n"
        "[[require]]\nquantity = \"grashof-margin\"\nmin = 0.05\nmax = 1\n"
        "[[require]]\nquantity = \"transmission-angle-min\"\nequal = 36.68906230623069\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.value("path-sse"), 1.79823, 1e-5);  // of trade-off/case-4-margin, which is found in wide ranges
}

TEST(Paths, WithoutTimingCountByTheNearestPoints) {
    const Solved s = solved(shipped("yu1.toml", "path"));
    const Design& design = s.result.best->design;
    for (std::size_t i = 0; i < s.problem.path->points.size(); ++i) {
        double nearest = 1e9;
        for (int k = 0; k < 3600; ++k) {
            PathMiss miss{};
            s.problem.mechanism->point->miss(s.problem.mechanism->form(design.assembly), design.dimensions,
                                             k * 2 * std::numbers::pi / 3600, s.problem.path->points[i], miss);
            nearest = std::min(nearest, std::hypot(miss.miss.x, miss.miss.y));
        }
        PathMiss at{};
        s.problem.mechanism->point->miss(s.problem.mechanism->form(design.assembly), design.dimensions,
                                         design.path_angles[i], s.problem.path->points[i], at);
        EXPECT_LE(std::hypot(at.miss.x, at.miss.y), nearest * (1 + 1e-12));
        // A scan in steps of up to 0.2 can miss the nearest point by half of one.
        EXPECT_LE(nearest, std::hypot(std::hypot(at.miss.x, at.miss.y), 0.1));
    }
}

/// The same numbers, to the last bit, however many threads share the starts.
TEST(Paths, ResultsDoNotDependOnTheNumberOfJobs) {
    const Solved one = solved(shipped("case-3.toml", "path"), "auto", 5, 1);
    for (const int jobs : {2, 7}) {
        const Solved other = solved(shipped("case-3.toml", "path"), "auto", 5, jobs);
        EXPECT_EQ(one.result.best->design.dimensions, other.result.best->design.dimensions);
        EXPECT_EQ(one.result.best->objective, other.result.best->objective);
        EXPECT_EQ(one.result.search.evaluations, other.result.search.evaluations);
        EXPECT_EQ(one.result.alternatives.size(), other.result.alternatives.size());
    }
}

/// Least squares does not look at the order, and would meet these points of a linkage exactly; the design that is shown
/// has to keep it, and nothing may be called proven that is not exact.
TEST(Paths, APathOutOfOrderIsNotProven) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 25
coupler = { min = 60, max = 120 }
rocker = { min = 60, max = 120 }
point-along = { min = 0, max = 90 }
point-across = { min = -20, max = 20 }
[path]
# Every thirty degrees of the linkage in the test below, the third point and the seventh exchanged.
points = [[52.000000, 36.000000], [54.534769, 43.218622], [11.200000, 26.731255], [38.552502, 48.210010],
          [26.490376, 44.117289], [16.604373, 36.197139], [49.221555, 47.660775], [10.985966, 18.481483]]
timing = "free"
[objective]
minimize = "path-rms"
)");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_GT(s.value("path-rms"), 1);
    EXPECT_FALSE(s.result.search.complete());
}

/// A linkage that exists is found again: points of a known crank-rocker, prescribed timing, everything free.
TEST(Paths, PointsOfAKnownLinkageAreMetExactly) {
    const Solved s = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 1, max = 400 }
crank = { min = 1, max = 400 }
coupler = { min = 1, max = 400 }
rocker = { min = 1, max = 400 }
point-along = { min = -200, max = 200 }
point-across = { min = -200, max = 200 }
assembly = "open"
[path]
# Coupler midpoint of frame 100, crank 25, coupler 90, rocker 75 (exercise M-2-3), six printed digits after the point
points = [[52.000000, 36.000000], [54.534769, 43.218622], [49.221555, 47.660775], [38.552502, 48.210010],
          [26.490376, 44.117289], [16.604373, 36.197139], [11.200000, 26.731255], [10.985966, 18.481483],
          [15.366767, 13.682682], [23.094556, 13.621775], [32.855368, 18.482381], [43.343772, 26.925979]]
timing = "prescribed"
crank_angles = [0, 30, 60, 90, 120, 150, 180, 210, 240, 270, 300, 330]
[objective]
minimize = "path-max"
)");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_LE(s.value("path-max"), 1e-6);
    EXPECT_NEAR(s.dimension("ground"), 100, 1e-4);
    EXPECT_NEAR(s.dimension("crank"), 25, 1e-4);
    EXPECT_NEAR(s.dimension("point-along"), 45, 1e-4);
}

}  // namespace

}  // namespace mechwright
