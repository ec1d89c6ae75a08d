// Coupler-path cases of the literature with their best known values; data and values as in the shipped problem files.

#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

TEST(Paths, CaseOneIsMetExactlyAndInOrder) {
    const Solved s = solved(shipped("path-case-1.toml"));
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_LE(s.value("path-sse"), 1e-24);
    const auto& angles = s.result.best->design.path_angles;
    const double direction = angles.back() > angles.front() ? 1 : -1;
    for (std::size_t i = 1; i < angles.size(); ++i)
        EXPECT_GT(direction * (angles[i] - angles[i - 1]), 0);
}

TEST(Paths, CaseTwoIsFoundFromEverySeed) {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        const Solved s = solved(shipped("path-case-2.toml"), "auto", seed);
        EXPECT_EQ(s.result.status, Status::solved);
        EXPECT_NEAR(s.value("path-sse") / 7.415751307e-7, 1, 1e-9) << "seed " << seed;
    }
}

TEST(Paths, CaseThreeIsFoundFromEverySeed) {
    for (std::uint64_t seed = 1; seed <= 4; ++seed) {
        const Solved s = solved(shipped("path-case-3.toml"), "auto", seed);
        EXPECT_EQ(s.result.status, Status::solved);
        EXPECT_NEAR(s.value("path-sse") / 0.009028884631, 1, 1e-9) << "seed " << seed;
    }
}

TEST(Paths, CaseTwoIsFoundByIpoptToo) {
    const Solved s = solved(shipped("path-case-2.toml"), "ipopt");
    EXPECT_NEAR(s.value("path-sse") / 7.415751307e-7, 1, 1e-9);
}

/// The same numbers, to the last bit, however many threads share the starts.
TEST(Paths, ResultsDoNotDependOnTheNumberOfJobs) {
    const Solved one = solved(shipped("path-case-3.toml"), "auto", 5, 1);
    for (const int jobs : {2, 7}) {
        const Solved other = solved(shipped("path-case-3.toml"), "auto", 5, jobs);
        EXPECT_EQ(one.result.best->design.dimensions, other.result.best->design.dimensions);
        EXPECT_EQ(one.result.best->objective, other.result.best->objective);
        EXPECT_EQ(one.result.search.evaluations, other.result.search.evaluations);
        EXPECT_EQ(one.result.alternatives.size(), other.result.alternatives.size());
    }
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
