#include <cmath>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// The section starts in line 8, what is given in line 9.
ReadProblem read_line(const std::string& lines) { return read(valid + "[line]\n" + lines + "\n"); }

const DimensionRange& line_number(const Problem& p, std::size_t k) {
    return p.dimensions[p.mechanism->line->place + k];
}
const DimensionRange& arc_number(const Problem& p, std::size_t k) { return p.dimensions[p.mechanism->arc->place + k]; }

TEST(Line, IsReadWithItsInputRange) {
    const ReadProblem read = read_line("start = 120\nrange = 120");
    ASSERT_TRUE(accepted(read));
    const Problem& p = read.problem;
    ASSERT_TRUE(p.followed);
    EXPECT_FALSE(p.followed->full_turn);
    ASSERT_TRUE(p.crank_range);
    EXPECT_NEAR(p.crank_range->y, std::acos(-1.0) * 4 / 3, 1e-15);
    EXPECT_TRUE(line_number(p, 0).any_angle());
    EXPECT_GT(line_number(p, 1).max, 0);
}

TEST(Line, MayBeGivenWhole) {
    const ReadProblem read =
        read_line("start = { min = 0, max = 360 }\nrange = 90\nangle = 45\noffset = -3\nfull_turn = true");
    ASSERT_TRUE(accepted(read));
    EXPECT_TRUE(read.problem.followed->full_turn);
    EXPECT_FALSE(read.problem.crank_range);
    EXPECT_NEAR(line_number(read.problem, 0).min, std::acos(-1.0) / 4, 1e-15);
    EXPECT_EQ(line_number(read.problem, 1).max, -3);
}

TEST(Line, NeedsItsInputRange) {
    EXPECT_TRUE(says(read_line(""), "p.toml:8:1", {"'start'", "an angle"}));
    EXPECT_TRUE(says(read_line("start = 3"), "p.toml:8:1", {"'range'"}));
    EXPECT_TRUE(only_says(read_line("start = 3\nrange = 0"), "p.toml:10:9", {"must not be 0"}));
    EXPECT_TRUE(says(read_line("start = nan\nrange = 3"), "p.toml:9:9", {"finite"}));
    EXPECT_TRUE(says(read_line("start = 3\nrange = 3\nslope = 1"), "p.toml:11:1", {"unknown", "slope"}));
}

TEST(Line, GoesWithAPathWhoseMotionHasAnEnd) {
    const std::string with_path = "start = 3\nrange = 3\n[path]\npoints = [[1, 1], [2, 2], [3, 1]]\n";
    EXPECT_TRUE(accepted(read_line(with_path)));
    EXPECT_TRUE(accepted(read_line(with_path + "timing = \"none\"\nclosed = true")));
    EXPECT_TRUE(only_says(read_line(with_path + "timing = \"none\""), "p.toml:8:1", {"closed = true"}));
}

TEST(Arc, IsReadWithItsInputRange) {
    const ReadProblem read =
        test::read(valid +
                   "[arc]\nstart = 10\nrange = { min = 60, max = 90 }\nradius = { min = 5, max = 50 }\n"
                   "centre-y = 3\nfull_turn = true\n");
    ASSERT_TRUE(accepted(read));
    const Problem& p = read.problem;
    ASSERT_TRUE(p.followed);
    EXPECT_EQ(p.followed->shape, Followed::arc);
    EXPECT_TRUE(p.followed->full_turn);
    EXPECT_FALSE(p.crank_range);
    EXPECT_FALSE(arc_number(p, 0).fixed());
    EXPECT_EQ(arc_number(p, 1).max, 3);
    EXPECT_EQ(arc_number(p, 2).max, 50);
}

TEST(Arc, HasARadiusGreaterThanZero) {
    EXPECT_TRUE(
        only_says(read(valid + "[arc]\nstart = 1\nrange = 9\nradius = -4\n"), "p.toml:11:10", {"greater than 0"}));
    EXPECT_TRUE(only_says(read(valid + "[arc]\nstart = 1\nrange = 9\nradius = { min = -1, max = 3 }\n"), "p.toml:11:10",
                          {"greater than 0"}));
    EXPECT_TRUE(says(read(valid + "[arc]\nstart = 1\nrange = 9\n[line]\nstart = 1\nrange = 9\n"), "p.toml:8:1",
                     {"cannot have [arc] beside [line]", "expand"}));
}

TEST(Line, ItsQuantitiesNeedIt) {
    EXPECT_TRUE(says(read(valid + "[objective]\nminimize = \"line-deviation\"\n"), "p.toml:9:12", {"[line]"}));
}

/// Ranges of tied dimensions follow from those they are tied to.
ReadProblem read_tied(const std::string& rocker, const std::string& more = "") {
    return read(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1\n"
        "coupler = { min = 2, max = 3 }\nrocker = " +
        rocker + "\n" + more);
}

TEST(Ties, FollowTheOtherDimension) {
    const ReadProblem read = read_tied("{ of = \"coupler\" }", "point-along = { of = \"coupler\", times = -2 }\n");
    ASSERT_TRUE(accepted(read));
    EXPECT_TRUE(read.problem.dimensions[3].tied());
    EXPECT_EQ(read.problem.dimensions[3].min, 2);
    EXPECT_EQ(read.problem.dimensions[4].min, -6);
    EXPECT_EQ(read.problem.dimensions[4].max, -4);
}

TEST(Ties, ToANumberAreANumber) {
    const ReadProblem read = read_tied("{ of = \"ground\", times = 0.75 }");
    ASSERT_TRUE(accepted(read));
    EXPECT_FALSE(read.problem.dimensions[3].tied());
    EXPECT_TRUE(read.problem.dimensions[3].fixed());
    EXPECT_EQ(read.problem.dimensions[3].min, 3);
}

TEST(Ties, ThatMakeNoSenseAreReported) {
    EXPECT_TRUE(only_says(read_tied("{ of = \"rocker\" }"), "p.toml:7:17", {"another dimension", "coupler"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"tilt\" }"), "p.toml:7:17", {"same kind"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"coupler\", times = 0 }"), "p.toml:7:36", {"other than 0"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"coupler\", times = -1 }"), "p.toml:7:36", {"greater than 0"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"coupler\", times = -1, plus = -1 }"), "p.toml:7:36", {"greater than 0"}));
    EXPECT_TRUE(only_says(read_tied("{ of = 3 }"), "p.toml:7:17", {"string"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"coupler\", min = 2 }"), "p.toml:7:28", {"unknown"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"point-along\" }"), "p.toml:7:10", {"not given"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"coupler\" }", "point-along = { of = \"rocker\" }\n"), "p.toml:8:15",
                          {"tied itself"}));
    EXPECT_TRUE(only_says(read_tied("{ of = \"coupler\" }", "[path]\npoints = [[1, 1], [2, 2], [3, 1]]\n"),
                          "p.toml:8:1", {"tied"}));
}

TEST(Ties, AreSumsOfMultiplesAndANumber) {
    const ReadProblem read =
        read_tied("{ of = \"coupler\", times = -1, plus = 6 }", "point-along = \"2 coupler - rocker-stays / 2\"\n");
    EXPECT_TRUE(only_says(read, "p.toml:8:15", {"rocker-stays", "another dimension of the same kind", "coupler"}));
    const ReadProblem sums = read_tied("{ of = \"coupler\", times = -1, plus = 6 }",
                                       "point-along = \"2 coupler - 0.5 ground + 3\"\npoint-across = \"ground - 1\"\n");
    ASSERT_TRUE(accepted(sums));
    const auto& d = sums.problem.dimensions;
    EXPECT_EQ(d[3].tie.constant, 6);
    EXPECT_EQ(d[3].min, 3);
    EXPECT_EQ(d[3].max, 4);
    EXPECT_EQ(d[4].tie.constant, 1);
    EXPECT_EQ(d[4].tie.terms.size(), 1);
    EXPECT_EQ(d[4].max, 7);
    EXPECT_TRUE(d[5].fixed());
    EXPECT_EQ(d[5].min, 3);
}

TEST(Ties, OfScalesAreInTheUnitOfTheFile) {
    const std::string function =
        "[function]\nexpression = \"x^2\"\nx = [1, 2]\ninput = { start = { min = 0, max = 90 }, range = 60 }\n"
        "output = { start = \"180 - input-start\", range = ";
    const ReadProblem read = read_tied("3", function + "{ of = \"input-range\", times = -1, plus = 20 } }\n");
    ASSERT_TRUE(accepted(read));
    const std::size_t start = read.problem.mechanism->input->start;
    const DimensionRange& output = read.problem.dimensions[start + 2];
    ASSERT_TRUE(output.tied());
    EXPECT_NEAR(output.tie.constant, std::acos(-1.0), 1e-15);
    EXPECT_NEAR(output.min, std::acos(-1.0) / 2, 1e-15);
    EXPECT_NEAR(read.problem.dimensions[start + 3].min, -std::acos(-1.0) * 2 / 9, 1e-15);
    EXPECT_TRUE(says(read_tied("3", function + "{ of = \"input-range\", times = -1, plus = 60 } }\n"), "p.toml:12:49",
                     {"0 for all values"}));
    EXPECT_TRUE(
        says(read_tied("3", function + "{ of = \"crank\" } }\n"), "p.toml:12:56", {"same kind", "input-range"}));
}

TEST(Ties, OfALineAreReportedWhereTheyStand) {
    EXPECT_TRUE(
        says(read_tied("3", "[line]\nstart = { of = \"tilt\" }\nrange = 30\n"), "p.toml:9:9", {"is not given"}));
    EXPECT_TRUE(
        says(read_tied("3", "[line]\nstart = 10\nrange = \"0 input-start\"\n"), "p.toml:10:9", {"write a number"}));
}

TEST(Ties, ThatLeaveNoLengthAreReported) {
    EXPECT_TRUE(only_says(read_tied("\"coupler - 3\""), "p.toml:7:10", {"not greater than 0"}));
    EXPECT_TRUE(only_says(read_tied("\"2 3\""), "p.toml:7:10", {"write sums like"}));
    EXPECT_TRUE(only_says(read_tied("\"3\""), "p.toml:7:10", {"write a number"}));
    EXPECT_TRUE(only_says(read_tied("\"0 coupler + 3\""), "p.toml:7:10", {"write a number"}));
    EXPECT_TRUE(accepted(read_tied("\"coupler - 2.5\"")));
}

TEST(Line, IsForMechanismsThatGuideAPoint) {
    EXPECT_TRUE(says(read("schema = 1\nmechanism = \"whitworth\"\n[line]\nstart = 0\nrange = 90\n"), "p.toml:3:1",
                     {"guides no point along a line or an arc"}));
}

}  // namespace

}  // namespace mechwright::test
