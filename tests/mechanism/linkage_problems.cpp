// Files of linkages as problems: analysed, solved, verified from their documents alone, against the built-in kinds that
// they describe anew.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>

#include "synthesis/document/document.h"
#include "synthesis/problem/judged_motion.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "tests/checked.h"
#include "tests/replaced.h"
#include "tests/triad.h"

namespace mechwright {

namespace {

using testing::replaced;
using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::is_refused;

ReadProblem linkage_of_text(const std::string& text) {
    ReadProblem read = parse_problem(text, "linkage.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read;
}

Json analysed(const std::string& text) {
    const ReadProblem read = linkage_of_text(text);
    return read.ok() ? analysis_document(read.problem, evaluate_given(read.problem)) : Json();
}

/// A crank-rocker of lengths 100, 40, 110, 80 with its coupler above the frame.
const std::string four_bar = R"(
schema = 1
mechanism = "linkage"
[dimensions]
ground = 100
crank = 40
coupler = 110
rocker = 80
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = [50, 30] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[assembly]
C = "left"
[signals]
swing = { angle = "rocker" }
height = { y = "P" }
pull = { transmission-angle = "C" }
)";

const std::string four_bar_built_in = R"(
schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 40
coupler = 110
rocker = 80
)";

TEST(LinkageProblems, AFourBarHasTheQuantitiesOfTheBuiltInKind) {
    const Json own = analysed(four_bar)["quantities"], built_in = analysed(four_bar_built_in)["quantities"];
    const auto expect_same = [&](const char* name, const char* built_in_name) {
        const double expected = built_in[built_in_name];
        EXPECT_NEAR(own[name].get<double>(), expected, 1e-12 * std::abs(expected)) << name;
    };
    expect_same("swing.range", "swing");
    expect_same("pull.least", "transmission-angle-min");
    expect_same("pull.greatest", "transmission-angle-max");
    expect_same("transmission-angle-worst", "transmission-angle-worst");
    expect_same("total-length", "total-length");
    expect_same("link-ratio", "link-ratio");
}

TEST(LinkageProblems, AnAnalysisIsVerifiedFromItsDocumentAlone) {
    const Json document = analysed(four_bar);
    expect_verified(document);
    Json changed = document;
    changed["quantities"]["swing.range"] = document["quantities"]["swing.range"].get<double>() * (1 + 1e-7);
    EXPECT_TRUE(is_refused(changed));
    changed = document;
    changed["design"]["rocker"] = 80.00001;
    EXPECT_TRUE(is_refused(changed));
    changed = document;
    changed["design"]["assembly"]["C"]["side"] = "right";
    EXPECT_TRUE(is_refused(changed));
    changed = document;
    changed["linkage"]["links"]["coupler"]["P"][1] = 30.0001;
    EXPECT_TRUE(is_refused(changed));
}

/// With a rocker and a crank to be found.
std::string freed(const std::string& text) {
    return replaced(replaced(text, "rocker = 80\n", "rocker = { min = 60, max = 200 }\n"), "crank = 40\n",
                    "crank = { min = 10, max = 60 }\n");
}

TEST(LinkageProblems, ALimitedMotionEndsWhereItsJointsDo) {
    const Json document = analysed(replaced(four_bar, "crank = 40", "crank = 140"));
    const Json expected = analysed(replaced(four_bar_built_in, "crank = 40", "crank = 140"))["quantities"];
    EXPECT_NEAR(document["quantities"]["pull.least"].get<double>(), expected["transmission-angle-min"].get<double>(),
                1e-9);
    EXPECT_EQ(document["quantities"]["pull.greatest"], expected["transmission-angle-max"]);
    expect_verified(document);
}

/// Peaucellier's inversor over its whole motion: at both ends the pins U and V meet, so that the dyads closed there and
/// at Q are at their limits at once. Inversion at the pole of power long^2 - short^2 makes Q's line, x = 2.5.
TEST(LinkageProblems, ALineIsStraightToItsEndsWherePinsMeet) {
    const Json document = analysed(R"(
schema = 1
mechanism = "linkage"
[links]
frame   = { O = [0, 0], M = [1, 0] }
arm     = { M = [0, 0], P = [1, 0] }
long-u  = { O = [0, 0], U = [3, 0] }
long-v  = { O = [0, 0], V = [3, 0] }
inner-u = { P = [0, 0], U = [2, 0] }
inner-v = { P = [0, 0], V = [2, 0] }
outer-u = { U = [0, 0], Q = [2, 0] }
outer-v = { V = [0, 0], Q = [2, 0] }
[drive]
link = "arm"
[assembly]
U = { side = "left", from = "O", to = "P" }
V = { side = "right", from = "O", to = "P" }
Q = { side = "left", from = "U", to = "V" }
[signals]
line = { x = "Q" }
)");
    EXPECT_EQ(document["quantities"]["joint-distance-least"], 0.0);  // they do meet
    EXPECT_NEAR(document["quantities"]["line.least"].get<double>(), 2.5, 1e-12);
    EXPECT_NEAR(document["quantities"]["line.greatest"].get<double>(), 2.5, 1e-12);
}

TEST(LinkageProblems, ARequirementIsMetAndTheDesignVerified) {
    const ReadProblem read =
        linkage_of_text(freed(four_bar) +
                        "[[require]]\nquantity = \"swing.range\"\nequal = 50\n"
                        "[objective]\nmaximize = \"transmission-angle-worst\"\n[solver]\nstarts = 8\n");
    ASSERT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    ASSERT_EQ(result.status, Status::solved) << result.note;
    EXPECT_TRUE(result.verified());
    // The same asked of the built-in kind.
    const ReadProblem same = linkage_of_text(freed(four_bar_built_in) +
                                             "[[require]]\nquantity = \"swing\"\nequal = 50\n"
                                             "[objective]\nmaximize = \"transmission-angle-worst\"\n");
    const Result expected = solve(same.problem, {});
    ASSERT_EQ(expected.status, Status::solved);
    EXPECT_NEAR(result.best->objective, expected.best->objective, 1e-7);
}

/// P's place is no dimension, and is not scaled as these are.
TEST(LinkageProblems, NumbersThatAreNoDimensionsStayWhatTheyAreInASearch) {
    const double height = analysed(four_bar)["quantities"]["height.greatest"].get<double>();
    const ReadProblem read =
        linkage_of_text(replaced(four_bar, "crank = 40\n", "crank = { min = 10, max = 60 }\n") +
                        "[[require]]\nquantity = \"height.greatest\"\nequal = " + std::to_string(height) + "\n");
    ASSERT_TRUE(read.ok());
    const Json found = document(read.problem, solve(read.problem, {}));
    EXPECT_EQ(found["status"], "solved");
    EXPECT_NEAR(found["design"]["crank"].get<double>(), 40, 1e-5);
    expect_verified(found);
}

/// A crank-rocker of which crank and ground are only 1e-5 shorter than coupler and rocker: beside the position in which
/// all lie in one line its other assembly is a hair's breadth away.
TEST(LinkageProblems, BesideAChangePointTheBranchIsKept) {
    std::string text = replaced(four_bar, "coupler = 110", "coupler = 80");
    expect_verified(analysed(replaced(text, "rocker = 80", "rocker = 60.00001")));
}

/// A lever that a crank moves stands upright once a turn where the crank is as long as the lever's pivot is to the
/// left; the upright slide that the lever moves goes beyond all bounds then.
TEST(LinkageProblems, LinesThatBecomeParallelAssembleNothing) {
    const auto margin = [](const std::string& crank) {
        std::ifstream file(MECHWRIGHT_SOURCE_DIR "/problems/linkage/lever-and-slide.toml");
        const std::string text{std::istreambuf_iterator<char>(file), {}};
        const Problem problem = linkage_of_text(replaced(text, "crank = 24", "crank = " + crank)).problem;
        const Family& turning = problem.mechanism->families.front();
        std::vector<double> dimensions;
        for (const DimensionRange& range : problem.dimensions)
            dimensions.push_back(range.min);
        return least_component(*turning.assembly_margin, motion_of(problem, 0, 0), dimensions);
    };
    EXPECT_GT(margin("24"), 0);
    EXPECT_GT(margin("46.99"), 0);
    for (const char* crank : {"46.9999", "47", "47.5", "47.8"})
        EXPECT_TRUE(std::isnan(margin(crank))) << crank;
}

/// A coupler on three equal cranks stays parallel to the frame, also where two of them and the frame lie in one line: C
/// goes round D as B goes round A, whatever is said of the dyad's side.
TEST(LinkageProblems, ARedundantCrankKeepsAParallelogramOne) {
    for (const char* side : {"left", "right", "either"}) {
        const Json document = analysed(R"(
schema = 1
mechanism = "linkage"
[links]
frame   = { A = [0, 0], D = [80, 60], G = [50, -20] }
crank   = { A = [0, 0], B = [40, 0] }
coupler = { B = [5, 5], C = [105, 5], H = [33, -41] }
rocker  = { D = [0, 0], C = [40, 0] }
third   = { G = [0, 0], H = [40, 0] }
[drive]
link = "crank"
[assembly]
C = ")" + std::string(side) + R"("
[signals]
turn = { angle = "coupler" }
height = { y = "C" }
way = { x = "H" }
)");
        const Json& quantities = document["quantities"];
        // D at 3:4 in the frame and along the coupler's x axis on it.
        EXPECT_NEAR(quantities["turn.least"].get<double>(), 36.86989764584402, 1e-12);
        EXPECT_NEAR(quantities["turn.range"].get<double>(), 0, 1e-12);
        EXPECT_NEAR(quantities["height.least"].get<double>(), 20, 1e-12);
        EXPECT_NEAR(quantities["height.greatest"].get<double>(), 100, 1e-12);
        EXPECT_NEAR(quantities["way.greatest"].get<double>(), 90, 1e-12);
        EXPECT_NEAR(quantities["way.least"].get<double>(), 10, 1e-12);
        if (side[0] == 'l') expect_verified(document);
    }
}

TEST(LinkageProblems, AnUnknownGroupIsNamedWithTheCommandThatShowsIt) {
    const ReadProblem read = parse_problem(testing::triad_text, "triad.toml");
    ASSERT_FALSE(read.ok());
    EXPECT_NE(to_string(read.messages.front()).find("structure"), std::string::npos)
        << to_string(read.messages.front());
}

}  // namespace

}  // namespace mechwright
