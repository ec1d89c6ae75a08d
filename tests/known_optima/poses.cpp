// Body guidance: poses of linkages that exist.

#include <cmath>
#include <numbers>

#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

TEST(Poses, FiveAreMetExactly) {
    for (const std::uint64_t seed : {1, 2, 3}) {
        const Solved s = solved(shipped("five-poses.toml", "poses"), "auto", seed);
        EXPECT_EQ(s.result.status, Status::solved);
        EXPECT_TRUE(s.result.search.complete());
        EXPECT_LE(s.value("pose-rms"), 1e-13);
    }
}

TEST(Poses, NineOfALinkageAreMetByIt) {
    const Solved s = solved(shipped("nine-poses.toml", "poses") + "\n[solver]\nstarts = 8\n");
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_LE(s.value("pose-max"), 1e-8);
    EXPECT_NEAR(s.dimension("ground"), 4, 1e-6);
    EXPECT_NEAR(s.dimension("crank"), 1.5, 1e-6);
    EXPECT_NEAR(s.dimension("body-angle"), 0.5, 1e-6);
}

/// A Grashof margin has three values where the crank turns fully and one elsewhere: programs of both have other
/// variables.
TEST(Poses, OfALinkageWithTheGreatestGrashofMargin) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = { min = 70, max = 130 }\n"
        "crank = { min = 28, max = 52 }\ncoupler = { min = 0, max = 1000 }\nrocker = { min = 0, max = 1000 }\n"
        "point-along = { min = -100, max = 100 }\npoint-across = { min = -100, max = 100 }\n"
        "origin-x = { min = -1, max = 1 }\norigin-y = { min = -100, max = 100 }\ntilt = { min = 0, max = 360 }\n"
        "body-angle = { min = 0, max = 360 }\n"
        "[poses]\nposes = [[41.3, 91.7, 47.5], [44.9, 109.2], [-6.1, 87.3, 27.0]]\n"
        "[objective]\nmaximize = \"grashof-margin\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    // The crank is the shortest link; of the other three the longest and one more cancel at best.
    EXPECT_NEAR(s.value("grashof-margin"), 130 - 28, 1e-6);
}

/// The distance of a pose by its definition: place and, times the length, the chord of the angle.
/// Four equal links are the longest within these ranges; but at that change point nothing says how they go on. Next to
/// it a crank-rocker is as long but for a part in ten million.
TEST(Poses, OfTheLongestLinkageKeepFromTheChangePoint) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = { min = 0, max = 20 }\n"
        "crank = { min = 0, max = 20 }\ncoupler = { min = 0, max = 20 }\nrocker = { min = 0, max = 20 }\n"
        "point-along = { min = 1, max = 3 }\npoint-across = { min = 1, max = 2 }\norigin-x = { min = 0, max = 1 }\n"
        "origin-y = { min = -30, max = 30 }\ntilt = { min = 0, max = 360 }\nbody-angle = { min = 0, max = 360 }\n"
        "assembly = \"either\"\n[poses]\nposes = [[2, 5, 90], [1, 5.6, 70], [0, 3.4, 80]]\n"
        "[objective]\nmaximize = \"total-length\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_GT(s.result.best->objective, 80 * (1 - 1e-6));
    EXPECT_LT(s.result.best->objective, 80);
}

TEST(Poses, HaveTheDistanceThatIsDefined) {
    const Solved s = solved(shipped("tipper.toml", "poses"));
    const PathTarget& path = *s.problem.path;
    const auto values = path_values(s.problem, s.result.best->design);
    ASSERT_TRUE(values);
    const double body = s.dimension("body-angle");
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        // The direction of the coupler from two points of it.
        const Design& design = s.result.best->design;
        std::vector<double> ahead = design.dimensions;
        ahead[4] += 1;
        PathMiss here{}, there{};
        s.problem.mechanism->point->miss(s.problem.mechanism->form(design.assembly), design.dimensions,
                                         design.path_angles[i], {0, 0}, here);
        s.problem.mechanism->point->miss(s.problem.mechanism->form(design.assembly), ahead, design.path_angles[i],
                                         {0, 0}, there);
        const double coupler = std::atan2(here.miss.y - there.miss.y, here.miss.x - there.miss.x);
        const double off = coupler + body - path.directions[i];
        const Vector<double> place = path.points[i] + here.miss;
        EXPECT_NEAR(values->distances[i], std::hypot(place.x, place.y, 2 * path.body_length * std::sin(off / 2)), 1e-9);
        EXPECT_NEAR(std::remainder(values->directions[i] - coupler - body, 2 * std::numbers::pi), 0, 1e-12);
    }
}

/// The hood's hinge is judged between its poses: what its transmission angle is there, is scanned by the law of cosines
/// over the crank angles of the range of use; beyond them the linkage comes to its limits.
void expect_judged_between_poses(const std::string& text, double before, double after, double greatest_length) {
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::solved);
    const Design& design = s.result.best->design;
    const double ground = s.dimension("ground"), crank = s.dimension("crank"), coupler = s.dimension("coupler"),
                 rocker = s.dimension("rocker");
    const auto transmission = [&](double angle) {
        const double square = ground * ground + crank * crank - 2 * ground * crank * std::cos(angle);
        return std::acos((coupler * coupler + rocker * rocker - square) / (2 * coupler * rocker));
    };
    constexpr double degree = std::numbers::pi / 180;
    const bool clockwise = design.path_angles.back() < design.path_angles.front();
    const double from = design.path_angles.front() + (clockwise ? before : -before) * degree;
    const double to = design.path_angles.back() + (clockwise ? -after : after) * degree;
    double least = std::numbers::pi;
    constexpr int steps = 100000;
    for (int i = 0; i <= steps; ++i) {
        const double angle = transmission(from + (to - from) * i / steps);
        least = std::min({least, angle, std::numbers::pi - angle});
    }
    EXPECT_NEAR(s.value("transmission-angle-worst"), least, 1e-8);
    EXPECT_GE(least, 30 * degree - 1e-8);
    EXPECT_LT(s.value("transmission-angle-worst.whole"), 15 * degree);
    EXPECT_LE(s.value("pose-max"), 0.5 * (1 + 1e-9));
    EXPECT_LT(s.value("total-length"), greatest_length);
}

TEST(Poses, OfAHingeAreJudgedBetweenThem) {
    const std::string text = shipped("hood-hinge.toml", "poses");
    expect_judged_between_poses(text, 1, 2, 566.6);
    const std::size_t margins = text.find("before = ");
    expect_judged_between_poses(text.substr(0, margins) + text.substr(text.find("\n\n", margins)), 0, 0, 543);
}

}  // namespace

}  // namespace mechwright
