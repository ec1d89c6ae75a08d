// A body on two rockers that something else drives: the rockers are those of its poses, and its own motion says when it
// is in them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <initializer_list>
#include <string>
#include <vector>

#include "synthesis/exact/exact.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "tests/degree.h"
#include "tests/long_form.h"

namespace mechwright {
namespace {

using PlaceInPlane = std::complex<double>;

/// Where two circles meet to the left (1) or the right (-1) of the way from the first centre to the second.
PlaceInPlane where_circles_meet(const PlaceInPlane& a, double of_a, const PlaceInPlane& b, double of_b, int side) {
    const double apart = std::abs(b - a), along = (apart * apart + of_a * of_a - of_b * of_b) / (2 * apart);
    return a + (b - a) / apart * PlaceInPlane(along, side * std::sqrt(of_a * of_a - along * along));
}

const std::string flap_file = MECHWRIGHT_SOURCE_DIR "/problems/exact/five-poses-driven-rocker.toml";

/// The shipped problem with other words in some places.
ReadProblem read_flap(std::initializer_list<std::array<const char*, 2>> changes) {
    std::string text = read_problem(flap_file).problem.text;
    for (const auto& [what, with] : changes) {
        const auto at = text.find(what);
        EXPECT_NE(at, std::string::npos) << what;
        if (at != std::string::npos) text.replace(at, std::string(what).size(), with);
    }
    ReadProblem read = parse_problem(text, "p.toml");
    EXPECT_TRUE(read.ok()) << read.messages.front().text;
    return read;
}

double number_of(const Problem& problem, const Design& design, const char* name) {
    return design.dimensions[static_cast<std::size_t>(find_dimension(*problem.mechanism, name))];
}

/// The pose of the flap at a crank angle, by circles alone: x, y, direction in degrees.
std::array<double, 3> flap_at(const Problem& problem, const Design& design, double crank_angle, int at_rod,
                              int at_flap) {
    const auto of = [&](const char* name) { return number_of(problem, design, name); };
    const PlaceInPlane pivot(of("r-x"), of("r-y")), other(of("s-x"), of("s-y")), arm(30, 10);
    const PlaceInPlane pin = PlaceInPlane(-60, -40) + std::polar(15.0, crank_angle);
    const PlaceInPlane rod = where_circles_meet(pin, 76, pivot, std::abs(arm), at_rod);
    const PlaceInPlane a = pivot + of("driven") * (rod - pivot) / arm;
    const PlaceInPlane b = where_circles_meet(a, of("flap"), other, of("other"), at_flap);
    const PlaceInPlane along = (b - a) / of("flap");
    const PlaceInPlane point = a + along * PlaceInPlane(of("p-along"), of("p-across"));
    return {point.real(), point.imag(), (std::arg(along) + of("body-angle")) / degree};
}

ExactDesigns designs_of(const Problem& problem) {
    RunOptions options;
    options.jobs = 2;
    return exact_designs(problem, options, {});
}

/// The design that made the poses, if it is among those found.
const Design* made_by(const Problem& problem, const ExactDesigns& found) {
    for (const Solution& solution : found.designs) {
        const auto is = [&](const char* name, double value) {
            return std::abs(number_of(problem, solution.design, name) - value) < 1e-7;
        };
        if (is("r-x", 0) && is("r-y", 0) && is("s-x", 30) && is("s-y", 20) && is("driven", 60) && is("other", 50) &&
            is("flap", 40))
            return &solution.design;
    }
    return nullptr;
}

TEST(DrivenChains, HaveThePosesOfTheLinkageThatMadeThem) {
    const ReadProblem read = read_problem(flap_file);
    ASSERT_TRUE(read.ok());
    const Problem& problem = read.problem;
    const ExactDesigns found = designs_of(problem);
    EXPECT_TRUE(found.proof);
    ASSERT_TRUE(found.counts);
    EXPECT_EQ(found.counts->tracked, 4U);
    EXPECT_EQ(found.counts->certified, 2U);
    EXPECT_EQ(found.designs.size() + found.excluded.size(), 2U);  // either rocker may be the one that is driven
    const Design* design = made_by(problem, found);
    ASSERT_NE(design, nullptr);
    ASSERT_EQ(design->path_angles.size(), 5U);
    for (std::size_t i = 0; i < 5; ++i) {
        const auto pose = flap_at(problem, *design, design->path_angles[i], 1, -1);
        EXPECT_NEAR(pose[0], problem.path->points[i].x, 1e-9);
        EXPECT_NEAR(pose[1], problem.path->points[i].y, 1e-9);
        EXPECT_NEAR(std::remainder(pose[2] - problem.path->directions[i] / degree, 360), 0, 1e-9);
    }
    // The rocker goes to and fro, through each pose twice in a turn: on one way in their order.
    const double way = design->path_angles[4] - design->path_angles[0];
    EXPECT_LT(std::abs(way), 360 * degree);
    for (std::size_t i = 1; i < 5; ++i)
        EXPECT_GT((design->path_angles[i] - design->path_angles[i - 1]) * way, 0);
}

/// The length of a cylinder in place of crank and rod: a displacement for each pose, from the pivots alone.
TEST(DrivenChains, MayBeDrivenByACylinder) {
    const ReadProblem read =
        read_flap({{"crank  = { O = [0, 0], C = [15, 0] }", "barrel = { O = [0, 0] }"},
                   {"rod    = { C = [0, 0], K = [76, 0] }", "ram    = { K = [0, 0] }"},
                   {"[drive]\nlink = \"crank\"",
                    "[[slide]]\nname = \"length\"\nlink = \"ram\"\non = \"barrel\"\npoint = \"O\"\ndirection = 0\n"
                    "[drive]\nslide = \"length\"\nmin = 40\nmax = 120"}});
    const ExactDesigns found = designs_of(read.problem);
    const Design* design = made_by(read.problem, found);
    ASSERT_NE(design, nullptr);
    const auto& points = read.problem.path->points;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PlaceInPlane along =
            std::polar(1.0, read.problem.path->directions[i] - number_of(read.problem, *design, "body-angle"));
        const PlaceInPlane a =
            PlaceInPlane(points[i].x, points[i].y) - along * PlaceInPlane(number_of(read.problem, *design, "p-along"),
                                                                          number_of(read.problem, *design, "p-across"));
        EXPECT_NEAR(std::abs(a / 60.0 * PlaceInPlane(30, 10) - PlaceInPlane(-60, -40)), design->path_angles[i], 1e-8);
    }
}

/// Dimensions of the drive that have ranges: the best that is found of them, for poses of two rockers alone.
TEST(DrivenChains, AreSearchedForTheirDrive) {
    const ReadProblem read = read_flap({{"[dimensions]", "[dimensions]\nbar = { min = 60, max = 90 }"},
                                        {"K = [76, 0]", "K = [\"bar\", 0]"},
                                        {"K = \"either\"", "K = \"left\""},
                                        {"B = \"either\"", "B = \"right\""},
                                        {"method = \"exact\"", "method = \"exact\"\nstarts = 1"}});
    EXPECT_EQ(why_not_applicable("exact", read.problem), "");
    if (!in_long_form()) GTEST_SKIP() << "the rest is of the long form";
    const ExactDesigns found = designs_of(read.problem);
    EXPECT_FALSE(found.proof);
    ASSERT_FALSE(found.designs.empty());
    EXPECT_GE(found.designs.front().objective, 43.01);  // of a bar of 76
}

}  // namespace
}  // namespace mechwright
