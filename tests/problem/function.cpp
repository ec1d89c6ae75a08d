#include <cmath>

#include "synthesis/target/function/function_target.h"
#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// The section starts in line 8, what is given in line 9.
ReadProblem read_function(const std::string& lines) { return read(valid + "[function]\n" + lines + "\n"); }

const std::string scales =
    "input = { start = 30, range = 90 }\noutput = { start = 90, range = { min = 60, max = 90 } }\n";
const std::string power = "expression = \"x^1.5\"\nx = [1, 4]\n";

TEST(Function, IsReadWithItsScales) {
    const ReadProblem read = read_function(power + scales);
    ASSERT_TRUE(accepted(read));
    const Problem& p = read.problem;
    ASSERT_TRUE(p.function);
    const std::size_t first = p.mechanism->input->start;
    EXPECT_EQ(first, 9u) << "after the dimensions of the mechanism";
    EXPECT_TRUE(p.dimensions[first].fixed());
    EXPECT_NEAR(p.dimensions[first + 1].min, std::acos(-1.0) / 2, 1e-15);
    EXPECT_NEAR(p.dimensions[first + 3].max, std::acos(-1.0) / 2, 1e-15);
    ASSERT_TRUE(p.crank_range);
    EXPECT_NEAR(p.crank_range->y, std::acos(-1.0) * 2 / 3, 1e-15);
}

TEST(Function, HasAccuracyPointsAsANumberOrAsAList) {
    const std::string exactly = "\n[solver]\nmethod = \"exact\"";
    const ReadProblem passed_over = read_function(power + scales + "accuracy_points = 3");
    ASSERT_EQ(passed_over.messages.size(), 1u);
    EXPECT_TRUE(passed_over.ok());
    EXPECT_TRUE(passed_over.messages[0].warning);
    EXPECT_EQ(passed_over.messages[0].line, 13);
    EXPECT_NE(passed_over.messages[0].text.find("passes them over"), std::string::npos);
    const ReadProblem three = read_function(power + scales + "accuracy_points = 3" + exactly);
    ASSERT_TRUE(accepted(three));
    const auto& spread = three.problem.function->accuracy_points;
    ASSERT_EQ(spread.size(), 3u);
    EXPECT_NEAR(spread[0], 2.5 - 1.5 * std::cos(std::acos(-1.0) / 6), 1e-15);
    const ReadProblem listed = read_function(power + scales + "accuracy_points = [1, 2, 2.5, 4]" + exactly);
    ASSERT_TRUE(accepted(listed));
    EXPECT_EQ(listed.problem.function->accuracy_points, (std::vector<double>{1, 2, 2.5, 4}));
    // Line 13: behind the section's head, two lines of the function and two of its scales.
    EXPECT_TRUE(
        only_says(read_function(power + scales + "accuracy_points = 6"), "p.toml:13:19", {"3, 4 or 5", "not 6"}));
    EXPECT_TRUE(only_says(read_function(power + scales + "accuracy_points = [1, 2]"), "p.toml:13:19",
                          {"from 3 to 5", "not 2"}));
    EXPECT_TRUE(only_says(read_function(power + scales + "accuracy_points = [1, 2, 5]"), "p.toml:13:26",
                          {"5 is outside the range of x, 1 to 4"}));
    EXPECT_TRUE(only_says(read_function(power + scales + "accuracy_points = [1, 3, 2]"), "p.toml:13:26",
                          {"must rise", "from 3 to 2"}));
    EXPECT_TRUE(only_says(read_function("samples = [[0, 0], [1, 1], [2, 3]]\n" + scales + "accuracy_points = 3"),
                          "p.toml:12:19", {"go with an expression"}));
}

TEST(Function, ARangeThatRunsBackwardsSetsTheMotionForwards) {
    const ReadProblem read =
        read_function(power + "input = { start = 30, range = -90 }\noutput = { start = 90, range = 90 }\n");
    ASSERT_TRUE(accepted(read));
    EXPECT_LT(read.problem.crank_range->x, read.problem.crank_range->y);
}

TEST(Function, NeedsAFunctionAndBothScales) {
    EXPECT_TRUE(says(read_function(""), "p.toml:8:1", {"expression", "samples"}));
    EXPECT_TRUE(says(read_function(""), "p.toml:8:1", {"'input'"}));
    EXPECT_TRUE(says(read_function(""), "p.toml:8:1", {"'output'"}));
    EXPECT_TRUE(only_says(read_function("samples = [[0, 0], [1, 1]]\n" + power + scales), "p.toml:8:1", {"both"}));
    EXPECT_TRUE(only_says(read_function("expression = \"x\"\n" + scales), "p.toml:8:1", {"x = [from, to]"}));
}

TEST(Function, ARangeOfZeroIsWrong) {
    EXPECT_TRUE(only_says(read_function(power + "input = { start = 0, range = 0 }\noutput = { start = 0, range = 9 }"),
                          "p.toml:11:30", {"range of the input", "not be 0"}));
    EXPECT_TRUE(only_says(
        read_function(power +
                      "input = { start = 0, range = { min = -1, max = 2 } }\noutput = { start = 0, range = 9 }"),
        "p.toml:11:30", {"same sign"}));
    EXPECT_TRUE(
        only_says(read_function("expression = \"x\"\nx = [2, 2]\n" + scales), "p.toml:10:5", {"smaller", "greater"}));
}

TEST(Function, AnExpressionThatIsNotUnderstoodIsSaidToBe) {
    for (const char* wrong : {"x +", "foo(x)", "2 x y", "", "x = 3 +", "((x)", "sin()"})
        EXPECT_TRUE(only_says(read_function("expression = \"" + std::string(wrong) + "\"\nx = [1, 2]\n" + scales),
                              "p.toml:9:14", {"not understood"}))
            << wrong;
    EXPECT_TRUE(only_says(read_function("expression = \"" + std::string(2000, 'x') + "\"\nx = [1, 2]\n" + scales),
                          "p.toml:9:14", {"longer"}));
}

TEST(Function, AnExpressionMustHaveValuesAndBeSmoothInItsRange) {
    EXPECT_TRUE(only_says(read_function("expression = \"1/(x-1.5)\"\nx = [1, 2]\n" + scales), "p.toml:9:14",
                          {"no value", "1.5"}));
    EXPECT_TRUE(only_says(read_function("expression = \"sqrt(x)\"\nx = [-1, 2]\n" + scales), "p.toml:9:14",
                          {"no value", "-1"}));
    EXPECT_TRUE(only_says(read_function("expression = \"abs(x-1.55)\"\nx = [1, 2]\n" + scales), "p.toml:9:14",
                          {"not smooth", "samples"}));
    EXPECT_TRUE(
        only_says(read_function("expression = \"(x-1.5)^2\"\nx = [1, 2]\n" + scales), "p.toml:9:14", {"same value"}));
    // The sine of a whole turn is a rounding of 0 away from where it began.
    EXPECT_TRUE(only_says(read_function("expression = \"sin(x)\"\nx = [0, 6.283185307179586]\n" + scales),
                          "p.toml:9:14", {"same value"}));
}

TEST(Function, SamplesRiseInX) {
    EXPECT_TRUE(only_says(read_function("samples = [[0, 0], [1, 1], [1, 2]]\n" + scales), "p.toml:9:28", {"rise"}));
    EXPECT_TRUE(only_says(read_function("samples = [[0, 0]]\n" + scales), "p.toml:9:11", {"from 2 to"}));
    EXPECT_TRUE(only_says(read_function("samples = [[0, 0], 3]\n" + scales), "p.toml:9:20", {"pair"}));
    EXPECT_TRUE(only_says(read_function("samples = [[0, nan], [1, 1]]\n" + scales), "p.toml:9:16", {"finite"}));
}

TEST(Function, ItsQuantitiesNeedIt) {
    EXPECT_TRUE(says(read(valid + "[objective]\nminimize = \"function-max\"\n"), "p.toml:9:12", {"[function]"}));
}

TEST(Function, ScalesDoNotStandInDimensions) {
    EXPECT_TRUE(says(read(valid + "input-start = 3\n"), "p.toml:8:1", {"unknown", "input-start"}));
}

TEST(Function, OtherMechanismsGenerateNone) {
    EXPECT_TRUE(
        says(read("schema = 1\nmechanism = \"whitworth\"\n[dimensions]\ncentre-distance = 1\ncrank = 2\narm = 1\n"
                  "rod = 5\nslide-angle = 90\n[function]\n" +
                  power + scales),
             "p.toml:9:1", {"whitworth", "leave [function] out"}));
}

TEST(Function, HasARangeOfTwoNumbers) {
    EXPECT_TRUE(says(read_function("expression = \"x\"\nx = [1, 2, 3]\n" + scales), "p.toml:10:5",
                     {"must be two numbers, [from, to], not 3"}));
}

}  // namespace

}  // namespace mechwright::test
