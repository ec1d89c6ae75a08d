#include <cmath>
#include <numbers>

#include "tests/degree.h"
#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

const std::string everything = R"(schema    = 1
title     = "Everything a file can say: ä°"
mechanism = "four-bar"

[units]
angle  = "deg"
length = "in"

[dimensions]
ground  = 100
crank   = { min = 5, max = 60.5 }
coupler = { min = 0, max = 300, start = 90 }
rocker  = { min = 7, max = 7 }
point-across = { min = -20, max = 20 }
tilt = { min = -90, max = 90, start = 45 }
crank-start = 30
assembly = "either"

[[require]]
quantity = "time-ratio"
equal    = 1.2

[[require]]
quantity = "swing"
min = 50
max = 60

[[require]]
quantity = "path-max"
max = 5

[[objective]]
maximize = "transmission-angle-worst"

[[objective]]
minimize = "total-length"
weight = 0.25

[path]
points = [[20, 20], [20.5, -25], [20, 30], [20, 20]]
timing = "prescribed"
crank_angles = [0, 20, 40, 360]
closed = true
weights = [1, 2, 3, 0.5]

[motion]
crank_range = [-30, 330]

[solver]
method = "slsqp"
starts = 7
seed = 9223372036854775807
time_limit = 2.5
tolerance = 1e-6
)";

void expect_range(const DimensionRange& range, double min, double max, std::optional<double> start) {
    EXPECT_DOUBLE_EQ(range.min, min);
    EXPECT_DOUBLE_EQ(range.max, max);
    EXPECT_EQ(range.start.has_value(), start.has_value());
    EXPECT_DOUBLE_EQ(range.start.value_or(-1), start.value_or(-1));
}

std::size_t quantity(const Problem& problem, std::string_view name) {
    return static_cast<std::size_t>(find_quantity(*problem.mechanism, name));
}

}  // namespace

TEST(WholeFile, EveryHeadValueIsRead) {
    const ReadProblem read_file = read(everything);
    ASSERT_TRUE(accepted(read_file));
    const Problem& problem = read_file.problem;
    EXPECT_EQ(problem.file, "p.toml");
    EXPECT_EQ(problem.title, "Everything a file can say: ä°");
    EXPECT_EQ(problem.mechanism->whole, find_mechanism("four-bar"));
    EXPECT_TRUE(problem.units.degrees);
    EXPECT_EQ(problem.units.length, "in");
    EXPECT_EQ(problem.solver.method, "slsqp");
    EXPECT_EQ(problem.solver.starts, 7);
    EXPECT_EQ(problem.solver.seed, 9223372036854775807u);
    EXPECT_EQ(problem.solver.time_limit, 2.5);
    EXPECT_EQ(problem.solver.tolerance, 1e-6);
    ASSERT_TRUE(problem.crank_range.has_value());
    EXPECT_DOUBLE_EQ(problem.crank_range->x, -30 * degree);
    EXPECT_DOUBLE_EQ(problem.crank_range->y, 330 * degree);
}

TEST(WholeFile, EveryDimensionIsReadInTheOrderOfTheMechanism) {
    const Problem problem = read(everything).problem;
    const auto& d = problem.dimensions;
    ASSERT_EQ(d.size(), 10u) << "the mechanism's, and crank-start of the path";
    expect_range(d[0], 100, 100, {});
    expect_range(d[1], 5, 60.5, {});
    expect_range(d[2], 0, 300, 90);
    expect_range(d[3], 7, 7, {});
    expect_range(d[4], 0, 0, {});
    expect_range(d[5], -20, 20, {});
    expect_range(d[8], -90 * degree, 90 * degree, 45 * degree);
    expect_range(d[9], 30 * degree, 30 * degree, {});
    const bool named[] = {true, true, true, true, false, true, false, false, true, true};
    const bool fixed[] = {true, false, false, true, true, false, true, true, false, true};
    for (std::size_t i = 0; i < std::size(named); ++i) {
        EXPECT_EQ(d[i].named, named[i]) << i;
        EXPECT_EQ(d[i].fixed(), fixed[i]) << i;
    }
    EXPECT_EQ(problem.assemblies, (std::vector<std::size_t>{0, 1}));
}

TEST(WholeFile, EveryRequirementAndObjectiveIsRead) {
    const Problem problem = read(everything).problem;
    ASSERT_EQ(problem.requirements.size(), 3u);
    const auto& [ratio, swing, path] =
        std::tie(problem.requirements[0], problem.requirements[1], problem.requirements[2]);
    EXPECT_EQ(ratio.quantity, quantity(problem, "time-ratio"));
    EXPECT_EQ(ratio.equal, 1.2);
    EXPECT_FALSE(ratio.min || ratio.max);
    EXPECT_EQ(swing.quantity, quantity(problem, "swing"));
    EXPECT_FALSE(swing.equal);
    EXPECT_DOUBLE_EQ(swing.min.value(), 50 * degree);
    EXPECT_DOUBLE_EQ(swing.max.value(), 60 * degree);
    EXPECT_EQ(path.quantity, quantity(problem, "path-max"));
    EXPECT_EQ(path.max, 5.0);
    ASSERT_TRUE(problem.objective.has_value());
    EXPECT_FALSE(problem.objective->worst);
    const auto& terms = problem.objective->terms;
    ASSERT_EQ(terms.size(), 2u);
    EXPECT_EQ(terms[0].quantity, quantity(problem, "transmission-angle-worst"));
    EXPECT_TRUE(terms[0].maximize);
    EXPECT_EQ(terms[0].weight, 1);
    EXPECT_EQ(terms[1].quantity, quantity(problem, "total-length"));
    EXPECT_FALSE(terms[1].maximize);
    EXPECT_EQ(terms[1].weight, 0.25);
}

TEST(WholeFile, EveryPathValueIsRead) {
    const Problem problem = read(everything).problem;
    ASSERT_TRUE(problem.path.has_value());
    const PathTarget& path = *problem.path;
    ASSERT_EQ(path.points.size(), 4u);
    EXPECT_EQ(path.points[1].x, 20.5);
    EXPECT_EQ(path.points[1].y, -25);
    EXPECT_TRUE(path.prescribed_timing);
    EXPECT_TRUE(path.closed);
    EXPECT_EQ(path.weights, (std::vector<double>{1, 2, 3, 0.5}));
    ASSERT_EQ(path.crank_angles.size(), 4u);
    EXPECT_DOUBLE_EQ(path.crank_angles[1], 20 * degree);
    EXPECT_DOUBLE_EQ(path.crank_angles[3], 2 * std::numbers::pi);
}

TEST(WholeFile, WhatIsNotSaidHasItsDefault) {
    const ReadProblem read_file = read(valid + "[path]\npoints = [[1, 2], [3, 4]]\n");
    ASSERT_TRUE(accepted(read_file));
    const Problem& problem = read_file.problem;
    EXPECT_EQ(problem.title, "");
    EXPECT_TRUE(problem.units.degrees);
    EXPECT_EQ(problem.units.length, "mm");
    EXPECT_EQ(problem.assemblies, std::vector<std::size_t>{0});
    EXPECT_TRUE(problem.requirements.empty());
    EXPECT_FALSE(problem.objective.has_value());
    EXPECT_FALSE(problem.crank_range.has_value());
    EXPECT_EQ(problem.solver.method, "auto");
    EXPECT_EQ(problem.solver.starts, 32);
    EXPECT_EQ(problem.solver.seed, 1u);
    EXPECT_EQ(problem.solver.time_limit, 60);
    EXPECT_EQ(problem.solver.tolerance, 1e-9);
    EXPECT_FALSE(problem.path->prescribed_timing);
    EXPECT_FALSE(problem.path->closed);
    EXPECT_EQ(problem.path->weights, (std::vector<double>{1, 1}));
    EXPECT_TRUE(problem.path->crank_angles.empty());
}

TEST(WholeFile, InRadiansNothingIsConverted) {
    const ReadProblem read_file = read(valid +
                                       "tilt = 1.5\n[units]\nangle = \"rad\"\n[motion]\ncrank_range = [0, 6.25]\n"
                                       "[[require]]\nquantity = \"swing\"\nequal = 1.25\n"
                                       "[path]\npoints = [[0, 0], [1, 0]]\ntiming = \"prescribed\"\n"
                                       "crank_angles = [0.5, 0.25]\n");
    ASSERT_TRUE(accepted(read_file));
    const Problem& problem = read_file.problem;
    EXPECT_EQ(problem.dimensions[8].min, 1.5);
    EXPECT_EQ(problem.crank_range->y, 6.25);
    EXPECT_EQ(problem.requirements[0].equal, 1.25);
    EXPECT_EQ(problem.path->crank_angles, (std::vector<double>{0.5, 0.25}));
}

TEST(WholeFile, TheChecksumIsThatOfTheBytes) {
    EXPECT_EQ(parse_problem("", "p.toml").problem.sha256,
              "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(parse_problem("abc", "p.toml").problem.sha256,
              "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

TEST(WholeFile, ByteOrderMarkAndWindowsLineEndsChangeNothing) {
    std::string windows = "\xEF\xBB\xBF";
    for (const char c : everything)
        windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    const ReadProblem read_file = read(windows);
    ASSERT_TRUE(accepted(read_file));
    EXPECT_EQ(read_file.problem.dimensions[1].max, 60.5);
    EXPECT_EQ(read_file.problem.path->points.size(), 4u);
}

TEST(WholeFile, AllErrorsComeInTheOrderOfTheirPlaces) {
    const ReadProblem read_file = read(
        "[solver]\nstarts = 0\n[path]\npoints = []\n[dimensions]\nground = -1\ncrank = \"x\"\n"
        "[[require]]\nquantity = \"swng\"\nequal = 1\n[units]\nangle = \"grad\"\nlenght = \"m\"\n");
    const std::vector<std::pair<int, int>> expected{{1, 1}, {1, 1}, {2, 10}, {4, 10}, {12, 9}, {13, 1}};
    std::vector<std::pair<int, int>> places;
    for (const Message& message : read_file.messages)
        places.emplace_back(message.line, message.column);
    EXPECT_EQ(places, expected) << all_messages(read_file);
}

TEST(WholeFile, ALongRowOfErrorsIsCutAndCounted) {
    std::string points = "[path]\npoints = [";
    for (int i = 0; i < 5000; ++i)
        points += "[1, \"y\"],";
    const ReadProblem read_file = read(valid + points + "]\nclosd = true\n");
    ASSERT_EQ(read_file.messages.size(), 101u);
    EXPECT_EQ(to_string(read_file.messages.back()), "p.toml: and 4902 more; correct these first");
    EXPECT_TRUE(says(read_file, "p.toml:9:15", {"y of point 1", "number", "string"}));
    EXPECT_FALSE(read_file.ok());
}

TEST(WholeFile, TheCutKeepsTheFirstPlacesWhateverIsReadFirst) {
    std::string text = "[path]\npoints = [";
    for (int i = 0; i < 5000; ++i)
        text += "[1, \"y\"],";
    const ReadProblem read_file = read("[solver]\nseed = -1\n" + text + "]\n");
    ASSERT_EQ(read_file.messages.size(), 101u);
    EXPECT_TRUE(says(read_file, "p.toml:2:8", {"'seed'"}));
}

TEST(WholeFile, WarningsAreMarkedAndDoNoHarm) {
    const Message warning{"p.toml", 3, 4, "take care", true};
    EXPECT_EQ(to_string(warning), "p.toml:3:4: warning: take care");
    ReadProblem problem;
    problem.messages = {warning};
    EXPECT_TRUE(problem.ok());
    problem.messages.push_back({"p.toml", 0, 0, "that is wrong"});
    EXPECT_FALSE(problem.ok());
    EXPECT_EQ(to_string(problem.messages[1]), "p.toml: that is wrong");
}

}  // namespace mechwright::test
