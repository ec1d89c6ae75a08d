#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

ReadProblem read_solver(const std::string& line) { return read(valid + "[solver]\n" + line + "\n"); }
ReadProblem read_motion(const std::string& line) { return read(valid + "[motion]\n" + line + "\n"); }

}  // namespace

TEST(Units, AnAngleUnitIsDegOrRad) {
    EXPECT_TRUE(only_says(read(valid + "[units]\nangle = \"degrees\"\n"), "p.toml:9:9",
                          {"unknown unit of angle 'degrees'", "deg, rad"}));
    EXPECT_TRUE(only_says(read(valid + "[units]\nangle = \"radd\"\n"), "p.toml:9:9", {"did you mean 'rad'"}));
    EXPECT_TRUE(only_says(read(valid + "[units]\nangle = 360\n"), "p.toml:9:9", {"'angle' in [units]", "string"}));
}

TEST(Units, ALengthUnitIsAString) {
    EXPECT_TRUE(only_says(read(valid + "[units]\nlength = 1\n"), "p.toml:9:10", {"'length' in [units]", "string"}));
}

TEST(Units, AnUnknownKeyIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(
        only_says(read(valid + "[units]\nlenght = \"mm\"\n"), "p.toml:9:1", {"'lenght' in [units]", "'length'"}));
}

TEST(Motion, ACrankRangeIsTwoRisingAngles) {
    EXPECT_TRUE(accepted(read_motion("crank_range = [-90, 90]")));
    EXPECT_TRUE(only_says(read_motion("crank_range = [90, -90]"), "p.toml:9:15", {"crank_range", "rise", "90", "-90"}));
    EXPECT_TRUE(only_says(read_motion("crank_range = [90, 90]"), "p.toml:9:15", {"crank_range", "rise"}));
    EXPECT_TRUE(only_says(read_motion("crank_range = [1]"), "p.toml:9:15", {"two angles", "not 1"}));
    EXPECT_TRUE(only_says(read_motion("crank_range = 90"), "p.toml:9:15", {"list of numbers", "a number"}));
    EXPECT_TRUE(only_says(read_motion("crank_range = [0, \"x\"]"), "p.toml:9:19", {"number 2", "a string"}));
    EXPECT_TRUE(only_says(read_motion("crank_range = [0, inf]"), "p.toml:9:19", {"number 2", "finite"}));
}

/// The time ratio of a ram is that of its two strokes: over a range of crank angles there is none, nor what is measured
/// of the slow stroke.
TEST(Motion, ACrankRangeHasNoQuantitiesOfTwoStrokes) {
    const std::string drive = R"(schema = 1
mechanism = "slider-crank"
dimensions = { crank = { min = 10, max = 50 }, rod = 120, offset = 20 }
motion = { crank_range = [-40, 180] }
)";
    for (const char* quantity : {"time-ratio", "ram-speed-min-working", "speed-variation"})
        EXPECT_TRUE(only_says(read(drive + "[[require]]\nquantity = \"" + quantity + "\"\nmin = 1\n"), "p.toml:4:26",
                              {quantity, "full turn", "crank_range"}));
    EXPECT_TRUE(only_says(read(drive + "objective = { minimize = \"time-ratio\" }\n"), "p.toml:4:26", {"full turn"}));
    EXPECT_TRUE(accepted(read(drive + "objective = { minimize = \"ram-acceleration-max\" }\n")));
}

/// The swing is that of a full turn, which the input range of a function, a line or an arc is not.
TEST(Motion, AnInputRangeHasNoQuantitiesOfAFullTurn) {
    const std::string four_bar = R"(schema = 1
mechanism = "four-bar"
dimensions = { ground = 100, crank = { min = 5, max = 60 }, coupler = { min = 20, max = 300 }, rocker = 80 }
objective = { maximize = "transmission-angle-worst" }
)";
    const std::string swing = "[[require]]\nquantity = \"swing\"\nequal = 60\n";
    for (const char* start : {"30", "{ min = 0, max = 360 }"}) {
        const std::string function = std::string("[function]\nexpression = \"x\"\nx = [0, 1]\ninput = { start = ") +
                                     start +
                                     ", range = 60 }\noutput = { start = { min = 0, max = 360 }, range = 20 }\n";
        EXPECT_TRUE(only_says(read(four_bar + function + swing), "p.toml:5:1", {"'swing'", "full turn", "[function]"}));
        EXPECT_TRUE(accepted(read(four_bar + function)));
        const std::string line = std::string("[line]\nangle = 0\noffset = 0\nstart = ") + start + "\nrange = 60\n";
        EXPECT_TRUE(only_says(read(four_bar + line + swing), "p.toml:5:1", {"'swing'", "full_turn = true", "[line]"}));
        EXPECT_TRUE(accepted(read(four_bar + line)));
    }
}

TEST(Motion, ACrankRangeIsOneTurnAtMost) {
    EXPECT_TRUE(accepted(read_motion("crank_range = [10, 370]")));
    EXPECT_TRUE(only_says(read_motion("crank_range = [10, 371]"), "p.toml:9:15", {"10", "371", "one full turn"}));
    const std::string radians = "[units]\nangle = \"rad\"\n";
    EXPECT_TRUE(accepted(read(valid + radians + "[motion]\ncrank_range = [0, 6.283185307179586]\n")));
    EXPECT_TRUE(only_says(read(valid + radians + "[motion]\ncrank_range = [0, 6.3]\n"), "p.toml:11:15", {"turn"}));
}

TEST(Motion, AnUnknownKeyIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_motion("crank-range = [0, 9]"), "p.toml:9:1", {"'crank-range'", "'crank_range'"}));
}

TEST(Motion, WhatHasNoValueOverARangeIsToldTogetherWithAllElse) {
    const ReadProblem both = read(
        "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\ncrank = { min = 5, max = 60 }\nrod = -1\n"
        "offset = 10\n[motion]\ncrank_range = [0, 90]\n[[require]]\nquantity = \"time-ratio\"\nequal = 1.2\n"
        "[solver]\nstarts = 0\n");
    EXPECT_EQ(both.messages.size(), 3u) << all_messages(both);
    EXPECT_TRUE(says(both, "p.toml:5:7", {"'rod'", "greater than 0"}));
    EXPECT_TRUE(says(both, "p.toml:8:15", {"'time-ratio'", "no value over crank_range"}));
    EXPECT_TRUE(says(both, "p.toml:13:10", {"'starts'"}));
}

TEST(Solver, StartsAreWithinLimits) {
    EXPECT_TRUE(accepted(read_solver("starts = 1")));
    EXPECT_TRUE(accepted(read_solver("starts = 100000")));
    EXPECT_TRUE(only_says(read_solver("starts = 0"), "p.toml:9:10", {"'starts'", "between 1 and 100000", "not 0"}));
    EXPECT_TRUE(only_says(read_solver("starts = 100001"), "p.toml:9:10", {"between 1 and 100000"}));
    EXPECT_TRUE(only_says(read_solver("starts = 1.5"), "p.toml:9:10", {"whole number"}));
    EXPECT_TRUE(only_says(read_solver("starts = true"), "p.toml:9:10", {"whole number", "true or false"}));
}

TEST(Solver, ASeedIsNotNegative) {
    EXPECT_TRUE(accepted(read_solver("seed = 0")));
    EXPECT_TRUE(accepted(read_solver("seed = 9223372036854775807")));
    EXPECT_TRUE(only_says(read_solver("seed = -1"), "p.toml:9:8", {"'seed'", "between 0 and 9223372036854775807"}));
}

TEST(Solver, ATimeLimitIsPositive) {
    EXPECT_TRUE(accepted(read_solver("time_limit = 0.01")));
    EXPECT_TRUE(only_says(read_solver("time_limit = 0"), "p.toml:9:14", {"'time_limit'", "greater than 0"}));
    EXPECT_TRUE(only_says(read_solver("time_limit = -5"), "p.toml:9:14", {"'time_limit'", "greater than 0"}));
    EXPECT_TRUE(only_says(read_solver("time_limit = 1e300"), "p.toml:9:14", {"'time_limit'", "at most"}));
    EXPECT_TRUE(only_says(read_solver("time_limit = inf"), "p.toml:9:14", {"'time_limit'", "finite"}));
}

TEST(Solver, AToleranceIsPositiveAndSmall) {
    EXPECT_TRUE(accepted(read_solver("tolerance = 1e-2")));
    EXPECT_TRUE(only_says(read_solver("tolerance = 0"), "p.toml:9:13", {"'tolerance'", "greater than 0", "0.01"}));
    EXPECT_TRUE(only_says(read_solver("tolerance = 0.02"), "p.toml:9:13", {"'tolerance'", "at most 0.01"}));
    EXPECT_TRUE(only_says(read_solver("tolerance = nan"), "p.toml:9:13", {"'tolerance'", "finite"}));
}

TEST(Solver, AMethodIsKeptAsItIs) {
    const ReadProblem read_file = read_solver("method = \"no such method\"");
    ASSERT_TRUE(accepted(read_file));
    EXPECT_EQ(read_file.problem.solver.method, "no such method");
    EXPECT_TRUE(only_says(read_solver("method = 1"), "p.toml:9:10", {"'method'", "string"}));
}

TEST(Solver, AnUnknownKeyIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_solver("timelimit = 3"), "p.toml:9:1", {"'timelimit' in [solver]", "'time_limit'"}));
}

}  // namespace mechwright::test
