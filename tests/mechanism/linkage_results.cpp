// What results say of linkages: the circuit and branch that they move on, signals in tables, and fronts.

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <string>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/report/drawing/finished.h"
#include "synthesis/report/text/summary.h"
#include "synthesis/solve/solve.h"
#include "tests/checked.h"
#include "tests/long_form.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::is_refused;

/// A rocker of two circuits: with a crank of 2 and a ground of 5 it turns fully on either side.
std::string crank_rocker(const std::string& side) {
    return testing::head + R"(
[links]
frame = { A = [0, 0], D = [5, 0] }
crank = { A = [0, 0], B = [2, 0] }
coupler = { B = [0, 0], C = [4.5, 0] }
rocker = { D = [0, 0], C = [4, 0] }
[drive]
link = "crank"
[assembly]
C = ")" + side +
           R"("
[signals]
rocker-turn = { angle = "rocker" }
C-x = { x = "C" }
speed = { speed-of = "C" }
)";
}

Json analysed_circuit(const std::string& text) {
    const ReadProblem read = testing::read_without_fault(text);
    return read.ok() ? analysis_document(read.problem, evaluate_given(read.problem)) : Json();
}

TEST(LinkageResults, NameCircuitAndBranch) {
    for (const auto& [side, circuit] : {std::pair("left", 1), {"right", 2}}) {
        Json document = analysed_circuit(crank_rocker(side));
        EXPECT_EQ(document["circuit"], circuit);
        EXPECT_EQ(document["branch"], 1);
        expect_verified(document);
        document["circuit"] = 3 - circuit;
        EXPECT_TRUE(is_refused(document));
        document["circuit"] = 0.5;
        EXPECT_TRUE(is_refused(document));
    }
}

std::string with_long_crank(const std::string& side) {
    std::string text = crank_rocker(side);
    text.replace(text.find("B = [2, 0]"), 10, "B = [6, 0]");
    return text;
}

/// A crank that cannot turn fully goes to and fro on one circuit with two branches, which meet where the dyad is at its
/// limits.
TEST(LinkageResults, TellBranchesOfOneCircuitApart) {
    const Json left = analysed_circuit(with_long_crank("left")), right = analysed_circuit(with_long_crank("right"));
    EXPECT_EQ(left["circuit"], 1);
    EXPECT_EQ(left["branch"], 1);
    EXPECT_EQ(right["circuit"], 1);
    EXPECT_EQ(right["branch"], 2);
    expect_verified(right);
    const ReadProblem read = testing::read_without_fault(with_long_crank("right"));
    const std::string summary = analysis_summary(read.problem, evaluate_given(read.problem), {});
    EXPECT_NE(summary.find(", on branch 2 of circuit 1.\n"), std::string::npos) << summary;
}

TEST(LinkageResults, HaveColumnsForSignals) {
    const ReadProblem read = testing::read_without_fault(crank_rocker("left"));
    ASSERT_TRUE(read.ok());
    const auto& columns = read.problem.mechanism->table.columns;
    const std::vector<std::string> expected{"crank-angle", "coupler-angle", "rocker-angle", "A-x", "A-y",
                                            "D-x",         "D-y",           "B-x",          "B-y", "C-y",
                                            "rocker-turn", "C-x",           "speed"};
    EXPECT_EQ(columns, expected);
    const FinishedDesign design = finished_design(read.problem, evaluate_given(read.problem).design);
    const auto place = [&](double angle) { return MotionRow(design, angle).vector("C"); };
    double last = MotionRow(design, 0)["rocker-turn"];
    for (int i = 0; i <= 90; ++i) {
        const double angle = 2 * std::numbers::pi * i / 90, h = 1e-5;
        const MotionRow row(design, angle);
        ASSERT_TRUE(row.assembled());
        EXPECT_NEAR(std::remainder(row["rocker-turn"] - row["rocker-angle"], 2 * std::numbers::pi), 0, 1e-13);
        EXPECT_LT(std::abs(row["rocker-turn"] - last), 0.5);
        last = row["rocker-turn"];
        const Vector<double> way = place(angle + h) - place(angle - h);
        EXPECT_NEAR(row["speed"], std::hypot(way.x, way.y) / (2 * h), 1e-8);
    }
}

/// Coupler and rocker in one line: the rocker pin is on the line from the rocker's pivot to the crank pin, and its
/// speed is beyond all bounds.
TEST(LinkageResults, HaveColumnsForSignalsAtLimits) {
    const ReadProblem read = testing::read_without_fault(with_long_crank("left"));
    ASSERT_TRUE(read.ok());
    const FinishedDesign design = finished_design(read.problem, evaluate_given(read.problem).design);
    for (const double end : {design.motion.from, design.motion.to}) {
        const MotionRow row(design, end);
        ASSERT_TRUE(row.assembled());
        EXPECT_TRUE(std::isinf(row["speed"])) << row["speed"];
        const Vector<double> crank_pin{6 * std::cos(end), 6 * std::sin(end)};
        const double length = std::hypot(crank_pin.x - 5, crank_pin.y);
        EXPECT_NEAR(row["C-x"], 5 + 4 * (crank_pin.x - 5) / length, 1e-13);
    }
}

/// A wheel that moves a rack never comes back to where it was: no turn of it is full, and no margin is of one.
TEST(LinkageResults, AreVerifiedWhereADriveMovesARack) {
    const ReadProblem read = testing::read_without_fault(testing::head + R"(
[dimensions]
arm = { min = 30, max = 90 }
reach = { min = 20, max = 120 }
[links]
frame = { A = [0, 0], D = [60, 0], E = [0, -40] }
rod   = { S = [0, 0], C = ["arm", 0], P = ["reach", 10] }
ram   = { S = [0, 0] }
rocker = { D = [0, 0], C = [50, 0] }
wheel = { E = [0, 0], W = [1, 0] }
[[slide]]
name = "cylinder"
link = "ram"
on = "frame"
point = "A"
direction = 90
[[rack]]
link = "ram"
wheel = "wheel"
radius = 10
[drive]
link = "wheel"
[motion]
crank_range = [0, 200]
[path]
point = "P"
timing = "none"
points = [[40, 20], [45, 25], [50, 32], [54, 40]]
[objective]
minimize = "path-rms"
[solver]
starts = 1
)");
    const Json found = document(read.problem, solve(read.problem, {}));
    EXPECT_EQ(found["status"], "solved");
    EXPECT_FALSE(found["quantities"].contains("full-turn-margin"));
    expect_verified(found);
    Json claimed = found;
    claimed["quantities"]["full-turn-margin"] = 1.0;
    EXPECT_TRUE(is_refused(claimed));
}

/// Two wishes against each other: the rocker's swing as near 60 degrees as it can be to 80, and a good transmission
/// angle.
TEST(LinkageResults, CanBeFronts) {
    std::string text = crank_rocker("left");
    text.replace(text.find("[links]"), 0,
                 "[dimensions]\ncrank = { min = 1, max = 2.4 }\ncoupler = { min = 4, max = 6 }\n"
                 "rocker = { min = 3, max = 6 }\n");
    text.replace(text.find("B = [2, 0]"), 10, "B = [\"crank\", 0]");
    text.replace(text.find("C = [4.5, 0]"), 12, "C = [\"coupler\", 0]");
    text.replace(text.find("C = [4, 0]"), 10, "C = [\"rocker\", 0]");
    text += R"(
[[objective]]
maximize = "rocker-turn.range"
[[objective]]
maximize = "transmission-angle-worst"
[solver]
pareto = 3
starts = )" +
            std::to_string(cases_to_try(1, 4)) + "\n";
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    EXPECT_EQ(result.front.size(), 3u);
    expect_verified(document(read.problem, result));
    EXPECT_EQ(testing::first_error(crank_rocker("left") + "[solver]\npareto = 3\n").find("'pareto' needs two"), 0u);
}

}  // namespace

}  // namespace mechwright
