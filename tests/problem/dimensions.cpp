#include "tests/problem/problem_text.h"

namespace mechwright::test {

TEST(Dimensions, EachMissingLengthIsAnError) {
    const ReadProblem read_file = read("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n");
    EXPECT_EQ(read_file.messages.size(), 4u);
    for (const std::string name : {"ground", "crank", "coupler", "rocker"})
        EXPECT_TRUE(says(read_file, "p.toml:3:1", {"'" + name + "'", "missing", "min = ..."}));
}

TEST(Dimensions, AMissingSectionIsAnErrorThatListsWhatItNeeds) {
    EXPECT_TRUE(only_says(read("schema = 1\nmechanism = \"four-bar\"\n"), "p.toml:1:1",
                          {"[dimensions] is missing", "ground, crank, coupler, rocker"}));
}

TEST(Dimensions, ASectionThatIsNoTableIsAnError) {
    EXPECT_TRUE(only_says(read("schema = 1\nmechanism = \"four-bar\"\ndimensions = 4\n"), "p.toml:3:14",
                          {"'dimensions'", "[dimensions]", "a number"}));
}

TEST(Dimensions, AMisspeltNameIsAnErrorWithTheNearestOne) {
    EXPECT_TRUE(only_says(read(valid + "piont-along = 3\n"), "p.toml:8:1",
                          {"unknown key 'piont-along' in [dimensions]", "did you mean 'point-along'"}));
    EXPECT_TRUE(only_says(read(valid + "assembley = \"open\"\n"), "p.toml:8:1", {"'assembley'", "'assembly'"}));
}

TEST(Dimensions, AFixedLengthIsPositive) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 0")), "p.toml:4:10", {"'ground'", "greater than 0", "not 0"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = -2.5")), "p.toml:4:10", {"greater than 0", "not -2.5"}));
}

TEST(Dimensions, CoordinatesAndAnglesHaveEitherSign) {
    EXPECT_TRUE(accepted(read(valid + "point-along = -3\norigin-x = { min = -5, max = -1 }\ntilt = -30\n")));
    EXPECT_TRUE(accepted(read(valid + "point-along = 0\n")));
}

TEST(Dimensions, ADimensionIsANumberOrARange) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground = \"100\"")), "p.toml:4:10", {"'ground'", "number", "a string"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = [1, 2]")), "p.toml:4:10", {"'ground'", "range", "a list"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = true")), "p.toml:4:10", {"'ground'", "true or false"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1979-05-27")), "p.toml:4:10", {"'ground'", "a date"}));
}

TEST(Dimensions, ARangeNeedsBothEnds) {
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5 }")), "p.toml:5:9", {"'max'", "'crank'", "missing"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { max = 5 }")), "p.toml:5:9", {"'min'", "'crank'", "missing"}));
    const ReadProblem empty = read(with_line(5, "crank = {}"));
    EXPECT_EQ(empty.messages.size(), 2u);
}

TEST(Dimensions, TheEndsOfARangeAreFiniteNumbers) {
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = \"a\", max = 5 }")), "p.toml:5:17",
                          {"'min'", "'crank'", "a number", "a string"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 1, max = inf }")), "p.toml:5:26", {"'max'", "finite"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = nan, max = 2 }")), "p.toml:5:17", {"'min'", "finite"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = -inf")), "p.toml:4:10", {"'ground'", "finite", "-inf"}));
    EXPECT_TRUE(only_says(read(valid + "tilt = nan\n"), "p.toml:8:8", {"'tilt'", "finite", "nan"}));
}

TEST(Dimensions, ARangeRises) {
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 60, max = 5 }")), "p.toml:5:17",
                          {"'min' 60", "greater", "'max' 5", "'crank'"}));
}

TEST(Dimensions, ALengthRangeMayStartAtZeroButNotBelow) {
    EXPECT_TRUE(accepted(read(with_line(5, "crank = { min = 0, max = 5 }"))));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = -1, max = 5 }")), "p.toml:5:17", {"0 or greater", "-1"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 0, max = 0 }")), "p.toml:5:26", {"greater than 0"}));
}

TEST(Dimensions, ARangeOfOneValueIsFixed) {
    const ReadProblem read_file = read(with_line(5, "crank = { min = 30, max = 30 }"));
    ASSERT_TRUE(accepted(read_file));
    EXPECT_TRUE(read_file.problem.dimensions[1].fixed());
}

TEST(Dimensions, AStartLiesInItsRange) {
    EXPECT_TRUE(accepted(read(with_line(5, "crank = { min = 5, max = 60, start = 60 }"))));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5, max = 60, start = 61 }")), "p.toml:5:38",
                          {"'start' 61", "between", "5", "60"}));
    EXPECT_TRUE(
        only_says(read(with_line(5, "crank = { min = 5, max = 60, start = 4 }")), "p.toml:5:38", {"'start' 4"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 0, max = 60, start = 0 }")), "p.toml:5:38",
                          {"'start'", "greater than 0"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5, max = 60, start = \"x\" }")), "p.toml:5:38",
                          {"'start'", "number", "string"}));
}

TEST(Dimensions, AnUnknownKeyInARangeIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5, max = 60, stat = 9 }")), "p.toml:5:30",
                          {"unknown key 'stat'", "'crank'", "did you mean 'start'"}));
}

TEST(Dimensions, ARangeMayBeASectionOfItsOwn) {
    const ReadProblem read_file = read(with_line(5, "") + "[dimensions.crank]\nmin = 5\nmax = 60\n");
    ASSERT_TRUE(accepted(read_file));
    EXPECT_EQ(read_file.problem.dimensions[1].max, 60);
}

TEST(Dimensions, AnAssemblyIsOneOfThoseOfTheMechanismOrEither) {
    EXPECT_EQ(read(valid + "assembly = \"open\"\n").problem.assemblies, std::vector<std::size_t>{0});
    EXPECT_EQ(read(valid + "assembly = \"crossed\"\n").problem.assemblies, std::vector<std::size_t>{1});
    EXPECT_EQ(read(valid + "assembly = \"either\"\n").problem.assemblies, (std::vector<std::size_t>{0, 1}));
    EXPECT_TRUE(only_says(read(valid + "assembly = \"croosed\"\n"), "p.toml:8:12",
                          {"unknown assembly 'croosed'", "did you mean 'crossed'"}));
    EXPECT_TRUE(only_says(read(valid + "assembly = 1\n"), "p.toml:8:12", {"'assembly'", "string", "number"}));
}

TEST(Dimensions, SeveralErrorsAreAllReported) {
    const ReadProblem read_file = read(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 0\ncrank = { min = 9, max = 1, strat = 2 }\n"
        "coupler = \"x\"\n");
    EXPECT_EQ(read_file.messages.size(), 5u) << all_messages(read_file);
    EXPECT_TRUE(says(read_file, "p.toml:3:1", {"'rocker'"}));
    EXPECT_TRUE(says(read_file, "p.toml:4:10", {"'ground'"}));
    EXPECT_TRUE(says(read_file, "p.toml:5:17", {"'min' 9"}));
    EXPECT_TRUE(says(read_file, "p.toml:5:29", {"'strat'"}));
    EXPECT_TRUE(says(read_file, "p.toml:6:11", {"'coupler'"}));
}

TEST(Dimensions, AllowedValuesAreChoicesOrSteps) {
    const ReadProblem choices = read(with_line(5, "crank = { choices = [30, 20, 25], start = 22 }"));
    ASSERT_TRUE(accepted(choices));
    EXPECT_EQ(choices.problem.dimensions[1].choices, (std::vector<double>{20, 25, 30}));
    EXPECT_EQ(choices.problem.dimensions[1].min, 20);
    EXPECT_EQ(choices.problem.dimensions[1].max, 30);
    EXPECT_TRUE(read(with_line(5, "crank = { choices = [30] }")).problem.dimensions[1].fixed());
    const ReadProblem steps = read(with_line(5, "crank = { min = 20, max = 33, step = 2.5 }"));
    ASSERT_TRUE(accepted(steps));
    EXPECT_EQ(steps.problem.dimensions[1].step, 2.5);
    EXPECT_EQ(steps.problem.dimensions[1].max, 32.5);
    EXPECT_EQ(read(with_line(5, "crank = { min = 0.1, max = 0.7, step = 0.1 }")).problem.dimensions[1].max, 0.7);
}

TEST(Dimensions, WrongChoicesAndStepsAreErrors) {
    const auto wrong = [](const char* range, const char* place, std::initializer_list<std::string_view> words) {
        EXPECT_TRUE(only_says(read(with_line(5, std::string("crank = ") + range)), place, words)) << range;
    };
    wrong("{ choices = [] }", "p.toml:5:21", {"'choices'", "'crank'", "is empty"});
    wrong("{ choices = [20, 30, 20] }", "p.toml:5:21", {"20 twice"});
    wrong("{ choices = [0, 30] }", "p.toml:5:21", {"'crank'", "greater than 0, not 0"});
    wrong("{ choices = [20, \"a\"] }", "p.toml:5:26", {"number 2 of 'choices'", "a string"});
    wrong("{ choices = [20, 30], start = 40 }", "p.toml:5:39", {"'start' 40", "least choice 20", "30"});
    wrong("{ choices = [20, 30], min = 4 }", "p.toml:5:31", {"'min'", "does not go with 'choices'"});
    wrong("{ min = 20, max = 30, step = 0 }", "p.toml:5:38", {"'step' 0", "greater than 0"});
    wrong("{ min = 20, max = 30, step = 11 }", "p.toml:5:38", {"'step' 11", "greater than the range from 20 to 30"});
    wrong("{ min = 20, max = 30, step = 1e-9 }", "p.toml:5:38", {"more than 1000000 values"});
    wrong("{ min = 0, max = 30, step = 5 }", "p.toml:5:17", {"'min'", "greater than 0, not 0"});
    wrong("{ min = 20, max = 30, stp = 5 }", "p.toml:5:31", {"unknown key 'stp'", "did you mean 'step'"});
}

TEST(Dimensions, RoundLeavesMultiplesAlone) {
    const ReadProblem one = read(with_line(5, "crank = { min = 20.2, max = 33.4, start = 20.3, round = 0.5 }"));
    ASSERT_TRUE(accepted(one));
    const DimensionRange& crank = one.problem.dimensions[1];
    EXPECT_EQ(crank.min, 20.5);
    EXPECT_EQ(crank.max, 33);
    EXPECT_EQ(crank.step, 0.5);
    EXPECT_EQ(crank.start, 20.5);
    EXPECT_EQ(read(with_line(5, "crank = { min = 5.02, max = 6, round = 0.1 }")).problem.dimensions[1].min, 5.1);
    EXPECT_TRUE(read(with_line(5, "crank = { min = 18, max = 23, round = 20 }")).problem.dimensions[1].fixed());

    const auto wrong = [](const char* range, const char* place, std::initializer_list<std::string_view> words) {
        EXPECT_TRUE(only_says(read(with_line(5, std::string("crank = ") + range)), place, words)) << range;
    };
    wrong("{ min = 21, max = 24, round = 5 }", "p.toml:5:39", {"no multiple of 'round' 5", "between 21 and 24"});
    wrong("{ min = 20, max = 30, round = 0 }", "p.toml:5:39", {"'round' 0", "greater than 0"});
    wrong("{ min = 20, max = 30, round = 1e-9 }", "p.toml:5:39", {"more than 1000000 values"});
    wrong("{ min = 20, max = 30, step = 1, round = 1 }", "p.toml:5:41", {"'round' does not go with 'step'"});
    wrong("{ choices = [20, 30], round = 4 }", "p.toml:5:31", {"'round'", "does not go with 'choices'"});
}

TEST(Dimensions, RoundOfTheSolverIsOfEveryLengthThatIsDesigned) {
    const auto rounded = [](const std::string& round) {
        return read(
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 100.3\n"
            "crank = { min = 5.2, max = 60.1 }\ncoupler = { min = 20, max = 300, step = 7 }\n"
            "rocker = { of = \"crank\", times = 2 }\ntilt = { min = 0, max = 60 }\n[solver]\nround = " +
            round + "\n");
    };
    const ReadProblem half = rounded("0.5");
    ASSERT_TRUE(accepted(half));
    const auto& ranges = half.problem.dimensions;
    EXPECT_EQ(ranges[0].min, 100.3);
    EXPECT_EQ(ranges[1].min, 5.5);
    EXPECT_EQ(ranges[1].max, 60);
    EXPECT_EQ(ranges[1].step, 0.5);
    EXPECT_EQ(ranges[2].step, 7);
    for (std::size_t i = 3; i < ranges.size(); ++i)
        EXPECT_FALSE(ranges[i].discrete());
    EXPECT_TRUE(only_says(rounded("80"), "p.toml:10:9", {"no multiple of 'round' 80", "the range of 'crank'"}));
    EXPECT_TRUE(only_says(rounded("0"), "p.toml:10:9", {"'round'", "greater than 0, not 0"}));
}

}  // namespace mechwright::test
