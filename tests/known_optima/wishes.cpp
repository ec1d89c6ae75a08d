// Objectives in order of their rank, against the same said by requirements and closed forms.

#include <numbers>

#include "tests/known_optima/solved.h"

namespace mechwright::testing {

namespace {

constexpr double deg = std::numbers::pi / 180;

/// The shipped problem with something else in place of its wish and what is allowed for it.
std::string transmission_then_size(const std::string& objectives) {
    const std::string text = shipped("transmission-then-size.toml");
    return text.substr(0, text.find("[[objective]]")) + objectives;
}

TEST(Wishes, TheNextIsMetAmongWhatRemains) {
    const Solved s = solved(shipped("transmission-then-size.toml"));
    ASSERT_EQ(s.result.status, Status::solved);
    ASSERT_EQ(s.result.best->wished.size(), 1u);
    // The closed form of the best transmission angle for 40 deg of swing and a time ratio of 1.25.
    const Solved first = solved(transmission_then_size("[objective]\nmaximize = \"transmission-angle-worst\"\n"));
    EXPECT_NEAR(first.result.best->objective, 42.80781, 1e-5);
    EXPECT_NEAR(s.result.best->wished[0].best, first.result.best->objective * deg, 1e-9);
    EXPECT_NEAR(s.result.best->wished[0].limit, s.result.best->wished[0].best - 2 * deg, 1e-12);
    const Solved required = solved(transmission_then_size(
        "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = " +
        std::to_string(first.result.best->objective - 2) + "\n[objective]\nminimize = \"total-length\"\n"));
    EXPECT_NEAR(s.result.best->objective, required.result.best->objective, 1e-4);
    EXPECT_NEAR(s.dimension("crank"), 15, 1e-7);
}

TEST(Wishes, WithoutRoomTheDesignIsAsGoodAsTheBest) {
    const Solved s =
        solved(transmission_then_size("[[objective]]\nminimize = \"total-length\"\nrank = 5\n"
                                      "[[objective]]\nmaximize = \"transmission-angle-worst\"\nrank = 2\n"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_NEAR(s.value("transmission-angle-worst"), s.result.best->wished[0].best, 2e-6);
    // The shape is that of the best transmission angle: only its size is left, and the shortest crank is 15.
    EXPECT_NEAR(s.dimension("crank"), 15, 1e-3);
}

TEST(Wishes, OfPointsThatCanBeMetTheSmallestLinkageIsFound) {
    const std::string task =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = { min = 30, max = 250 }\n"
        "crank = { min = 20, max = 120 }\ncoupler = { min = 30, max = 250 }\nrocker = { min = 30, max = 250 }\n"
        "point-along = { min = -250, max = 250 }\npoint-across = { min = -250, max = 250 }\n"
        "origin-x = { min = -200, max = 300 }\norigin-y = { min = -300, max = -20 }\ntilt = { min = 0, max = 360 }\n"
        "[path]\npoints = [[0, 0], [0, 40], [30, 70], [120, 70]]\ntiming = \"free\"\n"
        "[solver]\nstarts = 2\n[[objective]]\nminimize = \"path-max\"\n";
    const Solved s = solved(task + "[[objective]]\nminimize = \"total-length\"\nrank = 2\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_LE(s.value("path-max"), s.result.best->wished[0].limit * (1 + 1e-9) + 1e-12);
    EXPECT_LT(s.result.best->wished[0].limit, 1e-6);
    if (!in_long_form()) return;  // what follows finds the same a second time, and a third
    // Where nothing is said of the size, the same family is recognised, and the targets are met to rounding.
    const std::string path_alone = task.substr(0, task.find("[[objective]]"));
    const Solved family = solved(path_alone + "[objective]\nminimize = \"path-max\"\n");
    EXPECT_EQ(family.result.search.free_numbers, 5u);  // nine dimensions, of which four points settle one each
    EXPECT_LT(family.value("path-max"), 1e-11);
    EXPECT_NEAR(family.value("total-length"), s.value("total-length"), 1e-4 * s.value("total-length"));
    const Solved required = solved(path_alone +
                                   "[[require]]\nquantity = \"path-max\"\nmax = 1e-7\n[objective]\n"
                                   "minimize = \"total-length\"\n");
    EXPECT_NEAR(family.value("total-length"), required.value("total-length"), 1e-4 * s.value("total-length"));
}

TEST(Wishes, OfSixPointsTheSmallestLinkageIsTheShippedOne) {
    const Solved s = solved(shipped("six-points-compact.toml", "path"));
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_EQ(s.result.search.free_numbers, 3u);
    EXPECT_LT(s.value("path-max"), 1e-10);
    EXPECT_NEAR(s.value("total-length"), 356.83013, 1e-4);
    EXPECT_TRUE(s.result.search.complete());
}

TEST(Wishes, OfALinkageThatIsGivenNothingIsFree) {
    // Without a variable there is no family to look along, and a matrix without columns has no rank to ask for.
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1.5\ncoupler = 3.5\nrocker = 3\n"
        "point-along = 0\npoint-across = 0\n[path]\npoints = [[1.5, 0], [0, 1.5], [-1.5, 0]]\ntiming = \"none\"\n"
        "[objective]\nminimize = \"path-rms\"\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_LT(s.value("path-rms"), 1e-12);  // the crank pin goes round its circle
    EXPECT_EQ(s.result.search.free_numbers, 0u);
}

TEST(Wishes, WhatCannotBeMetIsInfeasibleWithoutThem) {
    const std::string text = transmission_then_size(
        "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = 60\n[[objective]]\nminimize = \"link-ratio\"\n"
        "[[objective]]\nminimize = \"total-length\"\nrank = 2\n");
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::infeasible);
}

TEST(Wishes, OfAGivenDesignAreWhatItHas) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = 30\ncoupler = 90\nrocker = 70\n"
        "[[objective]]\nmaximize = \"transmission-angle-worst\"\n[[objective]]\nminimize = \"total-length\"\nrank = "
        "2\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_EQ(s.result.best->objective, 290);
    EXPECT_EQ(s.result.best->wished[0].best, s.value("transmission-angle-worst"));
}

TEST(Wishes, OfALinkageAreThoseOfTheKindThatItIs) {
    const std::string rest =
        "[[objective]]\nmaximize = \"transmission-angle-worst\"\nwithin = 5\n"
        "[[objective]]\nminimize = \"total-length\"\nrank = 2\n";
    const std::string dimensions =
        "[dimensions]\nground = 100\ncrank = { choices = [20, 25, 30] }\n"
        "coupler = { min = 60, max = 140, step = 10 }\nrocker = { min = 50, max = 120, step = 10 }\n";
    const Solved linkage = solved("schema = 1\nmechanism = \"linkage\"\n" + dimensions +
                                  "[links]\nframe = { A = [0, 0], D = [\"ground\", 0] }\n"
                                  "crank = { A = [0, 0], B = [\"crank\", 0] }\n"
                                  "coupler = { B = [0, 0], C = [\"coupler\", 0] }\n"
                                  "rocker = { D = [0, 0], C = [\"rocker\", 0] }\n[drive]\nlink = \"crank\"\n[signals]\n"
                                  "turn = { angle = \"rocker\" }\n[[require]]\nquantity = \"turn.range\"\nmin = 45\n"
                                  "[[require]]\nquantity = \"full-turn-margin\"\nmin = 0.001\n" +
                                  rest);
    const Solved four_bar = solved("schema = 1\nmechanism = \"four-bar\"\n" + dimensions +
                                   "[[require]]\nquantity = \"swing\"\nmin = 45\n" + rest);
    ASSERT_EQ(linkage.result.status, Status::solved);
    EXPECT_NEAR(linkage.result.best->wished[0].best, four_bar.result.best->wished[0].best, 1e-9);
    EXPECT_EQ(linkage.result.best->objective, four_bar.result.best->objective);
}

TEST(Wishes, GoWithAllowedValues) {
    const Solved s = solved(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { choices = [20, 30, 40] }\n"
        "coupler = { min = 60, max = 140, step = 10 }\nrocker = { min = 50, max = 120, step = 10 }\n"
        "[[require]]\nquantity = \"swing\"\nmin = 45\n"
        "[[objective]]\nmaximize = \"transmission-angle-worst\"\nwithin = 5\n"
        "[[objective]]\nminimize = \"total-length\"\nrank = 2\n");
    ASSERT_EQ(s.result.status, Status::solved);
    EXPECT_GE(s.value("transmission-angle-worst"), s.result.best->wished[0].best - 5 * deg - 1e-9);
    for (const std::size_t i : {1U, 2U, 3U})
        EXPECT_EQ(std::remainder(s.result.best->design.dimensions[i], 10), 0);
}

}  // namespace

}  // namespace mechwright::testing
