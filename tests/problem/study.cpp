// [study]

#include "synthesis/problem/study/study.h"

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

const std::string with_requirement = valid + "[[require]]\nquantity = \"swing\"\nequal = 60\n";

std::string study(const std::string& lines) { return with_requirement + "[study]\n" + lines; }

TEST(Study, AGridOfRangesAndListsIsRead) {
    const ReadProblem problem =
        read(study("\"require.swing.equal\" = { from = 40, to = 80, count = 5 }\n"
                   "\"dimensions.ground\" = [90, 100]\n"));
    ASSERT_TRUE(accepted(problem));
    const Study& s = *problem.problem.study;
    ASSERT_EQ(s.axes.size(), 2u);
    EXPECT_EQ(s.axes[0].name, "require.swing.equal");
    EXPECT_EQ(s.axes[0].count(), 5u);
    EXPECT_EQ(s.axes[1].count(), 2u);
    EXPECT_TRUE(s.axes[1].numeric());
    EXPECT_EQ(s.design, StudyDesign::grid);
}

TEST(Study, PathsWithoutQuotesAreTheSame) {
    const ReadProblem problem = read(study("require.swing.equal = { from = 40, to = 80, count = 5 }\n"));
    ASSERT_TRUE(accepted(problem));
    EXPECT_EQ(problem.problem.study->axes.at(0).name, "require.swing.equal");
}

TEST(Study, WhatDoesNotVaryAnythingIsAnError) {
    EXPECT_TRUE(only_says(read(study("")), "p.toml:11:1", {"varies nothing", "dimensions.ground"}));
}

TEST(Study, APathThatIsNotThereIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read(study("\"dimension.ground\" = [90, 100]\n")), "p.toml:11:1",
                          {"there is no 'dimension'", "'dimensions'"}));
    EXPECT_TRUE(only_says(read(study("\"require.stroke.equal\" = [90, 100]\n")), "p.toml:11:1",
                          {"'require' has no element 'stroke'"}));
    EXPECT_TRUE(only_says(read(study("\"require.2.equal\" = [90, 100]\n")), "p.toml:11:1", {"counted from 1 to 1"}));
    EXPECT_TRUE(only_says(read(study("\"dimensions.grund\" = [90, 100]\n")), "p.toml:11:1",
                          {"unknown key 'grund'", "dimensions.grund = 90"}));
    EXPECT_TRUE(
        only_says(read(study("\"mechanism.name\" = [90, 100]\n")), "p.toml:11:1", {"neither a table nor a list"}));
}

TEST(Study, WhatIsWrongAtItsFirstOrLastPointIsAnError) {
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = [100, -1]\n")), "p.toml:11:1",
                          {"with dimensions.ground = -1", "must be greater than 0"}));
}

// What is wrong elsewhere does not hide it, and is not told again of the points.
TEST(Study, WhatIsWrongAtItsPointsIsToldBesideOtherErrors) {
    const ReadProblem problem = read(study("\"dimensions.grund\" = [90, 100]\n") + "[solver]\nmethd = \"slsqp\"\n");
    EXPECT_EQ(problem.messages.size(), 2U) << all_messages(problem);
    EXPECT_TRUE(says(problem, "p.toml:11:1", {"'grund'", "dimensions.grund = 90"}));
    EXPECT_TRUE(says(problem, "p.toml:14:1", {"'methd'", "method"}));
}

TEST(Study, WrongRangesAreErrors) {
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = \"all\"\n")), "p.toml:12:23", {"a list", "from"}));
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = { from = 1, count = 3 }\n")), "p.toml:12:23",
                          {"'to' in 'dimensions.ground' is missing"}));
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = { from = 1, to = 3, count = 1 }\n")), "p.toml:12:51",
                          {"must be 2 or more, not 1"}));
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = { from = 1, to = 3 }\n")), "p.toml:12:23",
                          {"'count'", "how many values"}));
    EXPECT_TRUE(says(read(study("\"dimensions.ground\" = { from = 0, to = 3, count = 3, spacing = \"log\" }\n")),
                     "p.toml:12:64", {"two ends of one sign"}));
    EXPECT_TRUE(says(read(study("\"dimensions.ground\" = { from = 1, to = 3, cuont = 3 }\n")), "p.toml:12:43",
                     {"unknown key 'cuont'", "'count'"}));
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = []\n")), "p.toml:12:23", {"is empty"}));
    EXPECT_TRUE(only_says(read(study("\"dimensions.ground\" = { from = 1, to = 3, count = 200000000 }\n")),
                          "p.toml:11:1", {"too many"}));
    EXPECT_TRUE(only_says(read(study("design = \"girdle\"\n\"dimensions.ground\" = [100]\n")), "p.toml:12:10",
                          {"unknown design 'girdle'"}));
}

TEST(Study, RandomDesignsHaveOneCount) {
    EXPECT_TRUE(
        accepted(read(study("design = \"sobol\"\ncount = 64\n\"dimensions.ground\" = { from = 90, to = 110 }\n"))));
    EXPECT_TRUE(only_says(read(study("design = \"sobol\"\n\"dimensions.ground\" = { from = 90, to = 110 }\n")),
                          "p.toml:11:1", {"'count' in [study] is missing"}));
    EXPECT_TRUE(only_says(read(study("count = 9\n\"dimensions.ground\" = [90, 110]\n")), "p.toml:12:9",
                          {"for random designs"}));
}

TEST(Study, CasesChangeSeveralValuesTogether) {
    const ReadProblem problem =
        read(study("[[study.case]]\nname = \"a\"\n\"dimensions.ground\" = 90\n"
                   "[[study.case]]\nname = \"b\"\ndimensions = { ground = 90, crank = 10, "
                   "coupler = 95, rocker = 50 }\n"));
    ASSERT_TRUE(accepted(problem));
    EXPECT_EQ(problem.problem.study->axes.at(0).labels, (std::vector<std::string>{"a", "b"}));
    EXPECT_TRUE(says(read(study("[[study.case]]\n\"dimensions.ground\" = 90\n")), "p.toml:12:1", {"needs a 'name'"}));
    EXPECT_TRUE(says(read(study("[[study.case]]\nname = \"a\"\n[[study.case]]\nname = \"a\"\n")), "p.toml:14:1",
                     {"two cases 'a'"}));
}

TEST(Study, ExpressionsFollowAxes) {
    const std::string axis = "\"dimensions.crank.max\" = { from = 50, to = 60, count = 3 }\n";
    EXPECT_TRUE(accepted(read(study(axis + "\"dimensions.crank.min\" = { expression = \"m - 10\", m = "
                                           "\"dimensions.crank.max\" }\n"))));
    EXPECT_TRUE(says(read(study(axis + "\"dimensions.crank.min\" = { expression = \"m -\", m = "
                                       "\"dimensions.crank.max\" }\n")),
                     "p.toml:13:41", {"not understood"}));
    EXPECT_TRUE(
        says(read(study(axis + "\"dimensions.crank.min\" = { expression = \"m\", m = \"dimensions.ground\" }\n")),
             "p.toml:13:50", {"not the path of numbers"}));
}

TEST(Study, QuantitiesMustBeKnown) {
    EXPECT_TRUE(only_says(read(study("quantities = [\"swign\"]\n\"dimensions.ground\" = [90]\n")), "p.toml:12:15",
                          {"swign", "swing"}));
}

TEST(Study, TolerancesAreRead) {
    const ReadProblem problem =
        read(study("count = 100\n[study.tolerance]\nlengths = \"IT7\"\ncrank = { normal = 0.01 }\n"));
    ASSERT_TRUE(accepted(problem));
    const Study& s = *problem.problem.study;
    ASSERT_EQ(s.deviations.size(), 4u);
    EXPECT_EQ(s.deviations[0].grade, 7);
    EXPECT_EQ(s.deviations[1].size, 0.01);
    const ReadProblem general = read(study("count = 100\n[study.tolerance]\nlengths = \"ISO 2768-c\"\n"));
    ASSERT_TRUE(accepted(general));
    EXPECT_EQ(general.problem.study->deviations[3].general, 3);
}

TEST(Study, WrongTolerancesAreErrors) {
    const auto tolerance = [](const std::string& line) {
        return study("count = 9\n[study.tolerance]\n" + line + "\n");
    };
    EXPECT_TRUE(only_says(read(tolerance("crank = \"IT3\"")), "p.toml:14:9", {"\"IT5\" to \"IT13\"", "IT3"}));
    EXPECT_TRUE(only_says(read(tolerance("cranck = \"IT7\"")), "p.toml:14:1", {"'cranck'", "'crank'"}));
    EXPECT_TRUE(only_says(read(tolerance("crank = { normal = -1 }")), "p.toml:14:20", {"greater than 0"}));
    EXPECT_TRUE(only_says(read(tolerance("crank = { normal = 1, uniform = 1 }")), "p.toml:14:9", {"needs one of"}));
    EXPECT_TRUE(
        only_says(read(tolerance("tilt = \"IT7\"")), "p.toml:14:8", {"tolerances of standards are for lengths"}));
    EXPECT_TRUE(says(read(tolerance("crank = \"IT7\"\n[units]\nlength = \"in\"")), "p.toml:14:9", {"millimetres"}));
    EXPECT_TRUE(only_says(read(study("count = 9\n\"dimensions.ground\" = [90]\n[study.tolerance]\ncrank = \"IT7\"\n")),
                          "p.toml:14:1", {"not both"}));
}

TEST(Study, AllocationsAreReadAndChecked) {
    const std::string limit = "[[require]]\nquantity = \"swing\"\nmin = 10\n";
    const auto allocation = [&](const std::string& lines, const std::string& before) {
        return study("count = 9\n" + before + "[study.allocation]\n" + lines) + limit;
    };
    const std::string usual = "[study.tolerance]\ncrank = \"IT7\"\n";
    const ReadProblem problem = read(allocation("share = 95\nexponent = 2\nweights = { crank = 3 }\n", usual));
    ASSERT_TRUE(accepted(problem));
    const Allocation& read_one = *problem.problem.study->allocation;
    EXPECT_DOUBLE_EQ(read_one.share, 0.95);
    EXPECT_EQ(read_one.exponent, 2);
    EXPECT_EQ(read_one.weights, std::vector<double>{3});
    EXPECT_TRUE(only_says(read(allocation("share = 100\n", usual)), "p.toml:16:9", {"below 100"}));
    EXPECT_TRUE(only_says(read(allocation("exponent = 0\n", usual)), "p.toml:16:12", {"above 0"}));
    EXPECT_TRUE(only_says(read(allocation("weights = { crank = 0 }\n", usual)), "p.toml:16:21", {"greater than 0"}));
    EXPECT_TRUE(only_says(read(allocation("weights = { rocker = 1 }\n", usual)), "p.toml:16:13", {"known are crank"}));
    EXPECT_TRUE(says(read(allocation("share = 95\n", "")), "p.toml:13:1", {"[study.tolerance]", "IT9"}));
    EXPECT_TRUE(says(read(study("count = 9\n" + usual + "[study.allocation]\nshare = 95\n")), "p.toml:15:1",
                     {"needs a limit"}));
}

TEST(Study, ChartsAreChecked) {
    const auto chart = [](const std::string& lines) {
        return study("\"dimensions.ground\" = [90, 100]\n[[study.chart]]\n" + lines);
    };
    EXPECT_TRUE(accepted(read(chart("kind = \"curves\"\nx = \"dimensions.ground\"\nvalue = \"swing\"\n"))));
    EXPECT_TRUE(only_says(read(chart("kind = \"curves\"\nx = \"dimensions.ground\"\n")), "p.toml:13:1",
                          {"'value' in [[study.chart]] is missing"}));
    EXPECT_TRUE(says(read(chart("kind = \"pie\"\nx = \"a\"\nvalue = \"b\"\ny = \"c\"\n")), "p.toml:14:8",
                     {"unknown kind of chart 'pie'"}));
    EXPECT_TRUE(only_says(read(chart("kind = \"curves\"\nname = \"../x\"\nx = \"a\"\nvalue = \"b\"\n")), "p.toml:15:8",
                          {"letters, digits"}));
}

TEST(Study, GradesMayBeSpreadEvenly) {
    const ReadProblem problem =
        read(study("count = 9\n[study.tolerance]\ncrank = { grade = \"IT7\", distribution = \"uniform\" }\n"));
    ASSERT_TRUE(accepted(problem));
    ASSERT_EQ(problem.problem.study->deviations.size(), 1u);
    EXPECT_EQ(problem.problem.study->deviations[0].grade, 7);
    EXPECT_TRUE(problem.problem.study->deviations[0].uniform);
    EXPECT_TRUE(only_says(read(study("count = 9\n[study.tolerance]\ncrank = { grade = 7 }\n")), "p.toml:14:19",
                          {"in quotes, as in \"IT7\""}));
    EXPECT_TRUE(only_says(read(study("count = 9\n[study.tolerance]\n")), "p.toml:13:1", {"is empty", "lengths"}));
}

TEST(Study, ListsAndTablesInItAreWhatTheyMustBe) {
    const std::string axis = "\"dimensions.ground\" = [90, 100]\n";
    EXPECT_TRUE(says(read(study(axis + "case = 3\n")), "p.toml:13:8", {"each headed [[study.case]]"}));
    EXPECT_TRUE(says(read(study(axis + "chart = 3\n")), "p.toml:13:9", {"each headed [[study.chart]]"}));
    EXPECT_TRUE(says(read(study(axis + "quantities = [3]\n")), "p.toml:13:15", {"a string in quotes"}));
    EXPECT_TRUE(says(read(study("schema = [1, 2]\n")), "p.toml:12:10", {"'schema' cannot be varied"}));
    EXPECT_TRUE(
        says(read(study("count = 0\ndesign = \"latin-hypercube\"\n\"dimensions.ground\" = { from = 90, to = 100 }\n")),
             "p.toml:12:9", {"must be 1 or more, not 0"}));
}

TEST(Study, AWordThatTellsTwoElementsIsNoPath) {
    const std::string two =
        "[[require]]\nquantity = \"swing\"\nmin = 60\n[[require]]\nquantity = \"swing\"\nmax = 70\n";
    EXPECT_TRUE(only_says(read(valid + two + "[study]\n\"require.swing.min\" = [60, 65]\n"), "p.toml:14:1",
                          {"more than one element 'swing'", "'require.1'"}));
}

}  // namespace

}  // namespace mechwright::test
