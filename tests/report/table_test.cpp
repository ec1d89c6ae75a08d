#include "synthesis/report/text/table.h"

#include <gtest/gtest.h>

#include <locale>
#include <sstream>

namespace mechwright {
namespace {

TEST(Table, AlignsDecimalPoints) {
    const Table table{{Align::left, Align::point, Align::left},
                      {{"", "value", ""}, {"crank", "39.125", "mm"}, {"ground", "100", "mm"}, {"x", "-1.5e-07", ""}}};
    EXPECT_EQ(to_text(table, 2),
              "              value\n"
              "  crank    39.125    mm\n"
              "  ground  100        mm\n"
              "  x        -1.5e-07\n");
}

TEST(Table, EmptyColumnsTakeNoRoom) {
    const Table table{{Align::left, Align::left, Align::right}, {{"a", "", "1"}, {"b", "", "22"}}};
    EXPECT_EQ(to_text(table, 0), "a   1\nb  22\n");
}

TEST(Table, CountsCharactersNotBytesNorTerminalCodes) {
    EXPECT_EQ(width_of("Kurbelgetriebe für Übung"), 24u);
    EXPECT_EQ(width_of("\x1b[1;31mfailed\x1b[0m"), 6u);
    const Table table{{Align::left, Align::left}, {{"µm", "x"}, {"abc", "y"}}};
    EXPECT_EQ(to_text(table, 0), "µm   x\nabc  y\n");
}

TEST(Folded, StaysWithinEightyColumnsAndHangs) {
    std::string words;
    for (int i = 0; i < 60; ++i)
        words += "word" + std::to_string(i) + " ";
    std::istringstream lines(folded("Search: ", words));
    int count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
        EXPECT_LE(width_of(line), terminal_width);
        EXPECT_EQ(line.substr(0, 8), count == 0 ? "Search: " : "        ");
        EXPECT_NE(line.back(), ' ');
    }
    EXPECT_GT(count, 3);
}

TEST(Folded, DoesNotBreakATiedSpace) {
    const std::string text = std::string(76, 'x') + " 60\x1f" + "deg";
    EXPECT_EQ(folded("", text), std::string(76, 'x') + "\n60 deg\n");
}

TEST(Folded, KeepsAWordThatIsTooLong) {
    const std::string longest(200, 'x');
    EXPECT_EQ(folded("a ", longest), "a " + longest + "\n");
    EXPECT_EQ(folded("a ", "b " + longest), "a b\n  " + longest + "\n");
    EXPECT_EQ(folded("a", ""), "a\n");
}

TEST(NumberText, EightDigitsAtMost) {
    EXPECT_EQ(number_text(100), "100");
    EXPECT_EQ(number_text(39.123456789), "39.123457");
    EXPECT_EQ(number_text(-0.0), "0");
    EXPECT_EQ(number_text(1.23e-12, 2), "1.2e-12");
    EXPECT_EQ(number_text(1234567.5, 10), "1234567.5");
}

/// A locale as in German: 1.234,5.
struct GermanNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    char do_thousands_sep() const override { return '.'; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(FixedText, HasNoNegativeZero) {
    EXPECT_EQ(fixed_text(-0.0001, 3), "0.000");
    EXPECT_EQ(fixed_text(-1.5, 1), "-1.5");
    EXPECT_EQ(fixed_text(0, 0), "0");
}

TEST(NumberText, IsTheSameInEveryLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new GermanNumbers));
    EXPECT_EQ(number_text(1234.5), "1234.5");
    std::locale::global(before);
}

TEST(Emphasised, OnlyWithColour) {
    EXPECT_EQ(emphasised("Solved", Emphasis::good, false), "Solved");
    EXPECT_EQ(emphasised("Solved", Emphasis::none, true), "Solved");
    EXPECT_EQ(emphasised("Solved", Emphasis::good, true), "\x1b[1;32mSolved\x1b[0m");
}

}  // namespace
}  // namespace mechwright
