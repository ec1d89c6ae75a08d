#include <gtest/gtest.h>
// Needs gtest.h before it.
#include <rapidcheck/gtest.h>

#include <charconv>
#include <cmath>
#include <numbers>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// A number as TOML, with all its digits.
std::string written(double number) {
    char digits[64];
    const auto end = std::to_chars(digits, digits + sizeof digits, number, std::chars_format::scientific).ptr;
    return std::string(digits, end);
}

double drawn_number() {
    const int mantissa = *rc::gen::inRange(-1000000, 1000000);
    const int exponent = *rc::gen::inRange(-12, 12);
    return mantissa * std::pow(10.0, exponent) / 7;
}

}  // namespace

RC_GTEST_PROP(Properties, EveryDigitOfANumberSurvives, ()) {
    const double x = drawn_number();
    const double length = std::abs(x) + 1e-3;
    const ReadProblem problem = read(with_line(4, "ground = " + written(length)) + "origin-x = " + written(x) + "\n");
    RC_ASSERT(problem.messages.empty());
    RC_ASSERT(problem.problem.dimensions[0].min == length);
    RC_ASSERT(problem.problem.dimensions[6].min == x);
}

RC_GTEST_PROP(Properties, ARangeIsAcceptedExactlyIfItRisesAndHoldsItsStart, ()) {
    const double min = drawn_number();
    const double max = drawn_number();
    const double start = *rc::gen::element(min, max, (min + max) / 2, drawn_number());
    const ReadProblem problem = read(valid + "tilt = { min = " + written(min) + ", max = " + written(max) +
                                     ", start = " + written(start) + " }\n");
    RC_ASSERT(problem.ok() == (min <= max && min <= start && start <= max));
    if (!problem.ok()) return;
    RC_ASSERT(std::abs(problem.problem.dimensions[8].min - min * std::numbers::pi / 180) <= 1e-15 * std::abs(min));
}

RC_GTEST_PROP(Properties, PointsAndTablesOfThemGiveTheSamePath, ()) {
    const int count = *rc::gen::inRange(1, 30);
    std::string list, table;
    for (int i = 0; i < count; ++i) {
        const std::string x = written(drawn_number()), y = written(i + 0.25);
        list += "[" + x + ", " + y + "], ";
        table += x + ";" + y + "\n";
    }
    const TemporaryFolder folder;
    folder.write("points.csv", table);
    const ReadProblem inlined = read(valid + "[path]\npoints = [" + list + "]\n");
    const ReadProblem filed = parse_problem(valid + "[path]\npoints_file = \"points.csv\"\n", folder.file("p.toml"));
    RC_ASSERT(inlined.ok());
    RC_ASSERT(filed.ok());
    RC_ASSERT(inlined.problem.path->points.size() == static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < inlined.problem.path->points.size(); ++i) {
        RC_ASSERT(inlined.problem.path->points[i].x == filed.problem.path->points[i].x);
        RC_ASSERT(inlined.problem.path->points[i].y == filed.problem.path->points[i].y);
    }
}

RC_GTEST_PROP(Properties, NoTextMakesTheReaderStumble, ()) {
    const auto text = *rc::gen::container<std::string>(
        rc::gen::oneOf(rc::gen::arbitrary<char>(), rc::gen::elementOf(std::string("[]{}=.,\"'#\n\\1e-nai"))));
    const ReadProblem problem = read(text);
    RC_ASSERT(!problem.ok());
    RC_ASSERT(!problem.messages.empty());
}

}  // namespace mechwright::test
