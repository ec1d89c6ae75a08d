// mechwright analyse

#include <algorithm>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

TEST(Analyse, PrintsKindAndQuantities) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"analyse", folder.write("a.toml", given()), "--digits", "10"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* part : {"Design: crank-rocker, open assembly", "The crank turns fully.", "time-ratio", "1.2033340",
                             "swing", "61.41306", "total-length", "314.2"})
        expect_has(outcome.out, part);
}

TEST(Analyse, JsonHasTheSameNumbers) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"analyse", "--json", folder.write("a.toml", given())});
    EXPECT_EQ(outcome.exit_code, 0);
    const Json json = parsed(outcome.out);
    EXPECT_EQ(json["design"]["kind"], "crank-rocker");
    EXPECT_NEAR(json["quantities"]["time-ratio"], 1.203334074, 1e-9);
    EXPECT_EQ(json["quantities"]["total-length"], 314.2);
    EXPECT_FALSE(json.contains("search"));
}

/// Each point by the nearest point of the curve, which a given design has without any search.
TEST(Analyse, OfAPathInAnyOrderMeasuresItsDistances) {
    const TemporaryFolder folder;
    const std::string text =
        "schema = 1\nmechanism = 'four-bar'\n[dimensions]\nground = 60\ncrank = 20\ncoupler = 58\nrocker = 50\n"
        "point-along = 0\npoint-across = 0\norigin-x = 0\norigin-y = 0\ntilt = 0\n[path]\n"
        "points = [[30, 0], [0, 25], [-16, -12]]\ntiming = 'none'\n";
    const Outcome outcome = run({"analyse", "--json", folder.write("a.toml", text)});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    // The point is the crank pin, on a circle of 20.
    const Json distances = parsed(outcome.out)["path"]["distances"];
    EXPECT_NEAR(distances[0], 10, 1e-12);
    EXPECT_NEAR(distances[1], 5, 1e-12);
    EXPECT_NEAR(distances[2], 0, 1e-12);
}

TEST(Analyse, CsvIsTheMotion) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", given());
    const Outcome by_default = run({"analyse", "--csv", file});
    EXPECT_EQ(by_default.exit_code, 0);
    EXPECT_EQ(by_default.err, "");
    EXPECT_EQ(by_default.out.rfind("crank-angle [deg],", 0), 0u);
    EXPECT_EQ(std::count(by_default.out.begin(), by_default.out.end(), '\n'), 362);
    const Outcome four = run({"analyse", "--csv", "--steps", "4", file});
    EXPECT_EQ(std::count(four.out.begin(), four.out.end(), '\n'), 6);
    for (const char* part : {"\n0,", "\n90,", "\n180,", "\n270,", "\n360,"})
        expect_has(four.out, part);
}

TEST(Analyse, AMillionStepsAreNoTrouble) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"analyse", "--csv", "--steps", "1000000", folder.write("a.toml", given())});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(std::count(outcome.out.begin(), outcome.out.end(), '\n'), 1'000'002);
}

TEST(Analyse, NamesWhatIsLeftOpen) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    const Outcome outcome = run({"analyse", file});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err.rfind(file + ": ", 0), 0u) << outcome.err;
    expect_has(outcome.err, "crank, coupler, rocker");
    expect_has_not(outcome.err, "ground");
    const std::string either = folder.write("b.toml", given("assembly = \"either\"\n"));
    const Outcome both = run({"analyse", either});
    EXPECT_EQ(both.exit_code, 3);
    expect_has(both.err, "assembly");
}

TEST(Analyse, AMechanismThatDoesNotAssembleEndsWithFour) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml",
                                          "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\n"
                                          "crank = 10\ncoupler = 20\nrocker = 30\n");
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"analyse", file}, {"analyse", "--csv", file}, {"analyse", "--json", file}}) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 4);
        expect_has(outcome.err, "does not assemble");
        expect_has_not(outcome.out, "nan");
    }
}

TEST(Analyse, ACrankRangeOverWhichItDoesNotAssembleEndsWithFour) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml",
                                          "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\n"
                                          "crank = 80\ncoupler = 50\nrocker = 60\n"
                                          "[motion]\ncrank_range = [20, 200]\n");
    const Outcome outcome = run({"analyse", file});
    EXPECT_EQ(outcome.exit_code, 4);
    for (std::string text : {outcome.out, outcome.err}) {
        std::replace(text.begin(), text.end(), '\n', ' ');
        for (const char* part :
             {"not assemble throughout", "from 20 deg to 200 deg", "it does from 20 deg to 74.41 deg"})
            expect_has(text, part);
    }
    expect_has_not(outcome.out, "close to a singular position");
    const Outcome json = run({"analyse", "--json", file});
    EXPECT_EQ(json.exit_code, 4);
    EXPECT_FALSE(parsed(json.out).contains("warnings"));
}

/// A slide that drives from 80 mm to 160 mm, asked for from 70 mm on: tables and texts have what there is.
TEST(Analyse, ADisplacementAtWhichItDoesNotAssembleIsTold) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", R"(
schema = 1
mechanism = "linkage"
[links]
frame = { A = [0, 0] }
crank = { A = [0, 0], B = [40, 0] }
rod   = { B = [0, 0], C = [120, 0] }
block = { C = [0, 0] }
[[slide]]
name = "block"
link = "block"
on = "frame"
point = "A"
direction = 0
[drive]
slide = "block"
[motion]
crank_range = [70, 160]
[signals]
c = { angle = "crank" }
)");
    const Outcome outcome = run({"analyse", file});
    EXPECT_EQ(outcome.exit_code, 4);
    expect_has(outcome.err, "displacements from 70 mm to 160 mm; it does from 80 mm to 160 mm");
    const Outcome table = run({"analyse", "--csv", "--steps", "9", file});
    EXPECT_EQ(table.exit_code, 4);
    EXPECT_EQ(std::count(table.out.begin(), table.out.end(), '\n'), 10) << table.out;
}

TEST(Analyse, WhereNoLoopClosesNothingIsCloseToASingularPosition) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"analyse", folder.write("a.toml", R"(
schema = 1
mechanism = "linkage"
[links]
frame = { A = [0, 0] }
wheel = { A = [0, 0] }
bar   = { X = [0, 0] }
[[slide]]
link = "bar"
on = "frame"
name = "s"
point = [0, 10]
direction = 0
[[rack]]
link = "bar"
wheel = "wheel"
radius = 20
phase = 5
[drive]
link = "wheel"
[motion]
crank_range = [0, 200]
[signals]
s = { slide = "s" }
)")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    expect_has_not(outcome.out, "Warning");
}

TEST(Analyse, RequirementsAreJudgedButDoNotDecide) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", given("[[require]]\nquantity = \"swing\"\nmin = 70\n"));
    const Outcome outcome = run({"analyse", file});
    EXPECT_EQ(outcome.exit_code, 0);
    expect_has(outcome.out, "missed by 8.587");
}

TEST(Analyse, ALimitedMotionIsFollowedFromEndToEnd) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", given("[motion]\ncrank_range = [30, 120]\n"));
    expect_has(run({"analyse", file}).out, "crank angles from 30 deg to 120 deg");
    const Outcome table = run({"analyse", "--csv", "--steps", "3", file});
    for (const char* part : {"\n30,", "\n60,", "\n90,", "\n120,"})
        expect_has(table.out, part);
}

}  // namespace
}  // namespace mechwright::testing
