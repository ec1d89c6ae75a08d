// Targets of a linkage that is where it was after several turns of its drive, met anywhere in them, against positions
// by intersected circles.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/verify.h"
#include "tests/mechanism/linkage_known.h"
#include "tests/mechanism/linkage_texts.h"
#include "tests/replaced.h"

namespace mechwright {

namespace {

using testing::replaced;

/// Where P of the shipped five-bar with two drives is.
Vector<double> point_of_two_drives(double crank_degrees) {
    const double crank = crank_degrees * known_linkages::one_degree,
                 second = (125 - crank_degrees / 2) * known_linkages::one_degree;
    const Vector<double> b{std::cos(crank), std::sin(crank)}, d{3 + 1.2 * std::cos(second), 1.2 * std::sin(second)},
        base = d - b;
    const double apart = std::hypot(base.x, base.y), foot = (apart * apart + 2.5 * 2.5 - 2.8 * 2.8) / (2 * apart),
                 up = std::sqrt(2.5 * 2.5 - foot * foot);
    return b + foot / apart * base + up / apart * Vector<double>{-base.y, base.x};
}

const std::vector<double> angles_of_two_turns{30, 150, 270, 390, 510, 630};

/// A problem that asks for those points, with the lengths of the rods to be found.
std::string through_points(const std::string& more) {
    std::string text = known_linkages::shipped_text("two-drives");
    text = replaced(text, "left   = 2.5", "left = { min = 2, max = 3 }");
    text = replaced(text, "right  = 2.8", "right = { min = 2.4, max = 3.4 }");
    text += "\n[path]\npoint = \"P\"\npoints = [";
    for (const double angle : angles_of_two_turns) {
        const Vector<double> at = point_of_two_drives(angle);
        text += fmt::format("[{:.17g}, {:.17g}], ", at.x, at.y);
    }
    return text + "]\n" + more + "\n[objective]\nminimize = \"path-rms\"\n";
}

void expect_found(const std::string& text, double within) {
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    ASSERT_TRUE(result.best);
    EXPECT_LT(result.best->objective, within);
    EXPECT_NEAR(*value_named(read.problem, result.best->design, "left"), 2.5, 1e3 * within);
    EXPECT_NEAR(*value_named(read.problem, result.best->design, "right"), 2.8, 1e3 * within);
    ASSERT_EQ(result.best->design.path_angles.size(), angles_of_two_turns.size());
    const double swept = result.best->design.path_angles.back() - result.best->design.path_angles.front();
    EXPECT_NEAR(std::abs(swept), 600 * known_linkages::one_degree, 1e3 * within);
    for (const Check& check : verify(document(read.problem, result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

TEST(CyclesOfSeveralTurns, PointsAreMetAtPrescribedAnglesOfAnyTurn) {
    expect_found(through_points("timing = \"prescribed\"\ncrank_angles = [30, 150, 270, 390, 510, 630]"), 1e-9);
    // Counted from an angle that is found, anywhere in the cycle.
    expect_found(through_points("timing = \"prescribed\"\ncrank_angles = [0, 120, 240, 360, 480, 600]\n"
                                "crank-start = { min = -180, max = 540 }"),
                 1e-9);
    EXPECT_NE(
        testing::first_error(through_points("timing = \"prescribed\"\ncrank_angles = [30, 150, 270, 390, 510, 760]"))
            .find("they must stay within 2 turns"),
        std::string::npos);
}

TEST(CyclesOfSeveralTurns, PointsAreMetInOrderWithoutTiming) { expect_found(through_points(""), 1e-7); }

TEST(CyclesOfSeveralTurns, EachPointCountsByTheNearestOfTheWholeCurve) {
    const ReadProblem read = testing::read_without_fault(through_points("timing = \"none\""));
    ASSERT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    ASSERT_TRUE(result.best);
    EXPECT_LT(result.best->objective, 1e-7);
    for (const Check& check : verify(document(read.problem, result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

// A line is followed in the second turn, where the linkage is elsewhere than in the first: the greatest distance from
// it by a scan.
TEST(CyclesOfSeveralTurns, LinesAreFollowedInTheSecondTurn) {
    const std::string text = known_linkages::shipped_text("two-drives") + R"(
[line]
point = "P"
start = 500
range = 60
[objective]
minimize = "line-deviation"
)";
    const Problem problem = testing::read_without_fault(text).problem;
    const Result result = solve(problem, {});
    ASSERT_TRUE(result.best);
    const double direction = *value_named(problem, result.best->design, "line-angle"),
                 offset = *value_named(problem, result.best->design, "line-offset");
    double greatest = 0;
    for (int i = 0; i <= 60000; ++i) {
        const Vector<double> p = point_of_two_drives(500 + i * 1e-3);
        greatest = std::max(greatest, std::abs(std::cos(direction) * p.y - std::sin(direction) * p.x - offset));
    }
    EXPECT_NEAR(result.best->objective, greatest, 1e-9);
    for (const Check& check : verify(document(problem, result)))
        EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
}

}  // namespace

}  // namespace mechwright
