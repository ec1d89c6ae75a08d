#include <chrono>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

TEST(Syntax, AnEmptyFileSaysWhatAProblemNeeds) {
    for (const std::string text : {"", "\n\n", "  # nothing but words\n", "\xEF\xBB\xBF"})
        EXPECT_TRUE(only_says(read(text), "p.toml:1:1", {"empty", "schema = 1", "mechanism", "[dimensions]"}));
}

TEST(Syntax, ADuplicateKeyIsAnErrorAtItsSecondPlace) {
    EXPECT_TRUE(only_says(read(valid + "ground = 3\n"), "p.toml:8:1", {"duplicate key 'ground'", "once"}));
    EXPECT_TRUE(only_says(read(valid + "  \"ground\" = 3\n"), "p.toml:8:3", {"duplicate key", "ground", "once"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5, min = 60 }")), "p.toml:5:20", {"duplicate key 'min'"}));
}

TEST(Syntax, ADuplicateSectionIsAnErrorAtItsSecondPlace) {
    EXPECT_TRUE(only_says(read(valid + "[dimensions]\n"), "p.toml:8:1", {"duplicate key 'dimensions'", "once"}));
    EXPECT_TRUE(only_says(read(valid + "[objective]\n[[objective]]\n"), "p.toml:9:1", {"'objective'", "another form"}));
    EXPECT_TRUE(only_says(read(valid + "[[require]]\n  [require]\n"), "p.toml:9:3", {"'require'", "another form"}));
    EXPECT_TRUE(only_says(read("dimensions.ground.x = 3\n" + valid), "p.toml:4:1", {"duplicate key 'dimensions'"}));
}

TEST(Syntax, NumbersOutsideTheRangeOfDoublesAreErrorsWhereTheyStart) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1e400")), "p.toml:4:10", {"'1e400'", "outside the range"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = -1e400")), "p.toml:4:10", {"1e400'", "outside the range"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 1, max = 1.5e999 }")), "p.toml:5:26", {"'1.5e999'"}));
    EXPECT_TRUE(only_says(read(with_line(1, "schema = 99999999999999999999")), "p.toml:1:10",
                          {"'99999999999999999999'", "9223372036854775807"}));
}

/// Angles of linkages of 1e78 were wrong, products of their lengths being infinite.
TEST(Syntax, NumbersOfExtremeSizeAreErrors) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 100e78")), "p.toml:4:10", {"'ground'", "at most 1e60", "1e+80"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = -2e60")), "p.toml:4:10", {"'ground'", "at most 1e60"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1e-61")), "p.toml:4:10", {"'ground'", "0, or at least 1e-60"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 1, max = 1.5e99 }")), "p.toml:5:26", {"at most 1e60"}));
}

TEST(Syntax, SlipsAreNamedWithTheirRemedy) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1,5")), "p.toml:4:11", {"decimal point", "comma"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = .5")), "p.toml:4:10", {"digit before its decimal point"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 5.")), "p.toml:4:12", {"digits after its decimal point"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 05")), "p.toml:4:10", {"start with a 0"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground 5")), "p.toml:4:8", {"'='"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground =")), "p.toml:4:9", {"missing"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = a")), "p.toml:4:10", {"no value", "in quotes"}));
    EXPECT_TRUE(only_says(read(with_line(2, "mechanism = \"four-bar")), "p.toml:2:22", {"quote"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5,\n max = 60 }")), "p.toml:5:19", {"on one line"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1 crank = 2")), "p.toml:4:12", {"on a line"}));
    EXPECT_TRUE(only_says(read(with_line(2,
                                         "mechanism = \"four\x01"
                                         "bar\"")),
                          "p.toml:2:18", {"control character"}));
}

TEST(Syntax, AFileThatEndsTooEarlySaysSo) {
    EXPECT_TRUE(only_says(read(valid + "[path]\npoints = [[1, 2], [3"), "p.toml:9:21", {"ends too early"}));
    EXPECT_TRUE(only_says(read(valid + "[path"), "p.toml:8:6", {"ends too early"}));
}

TEST(Syntax, BinaryFilesAreErrorsAtTheFirstByteThatShowsIt) {
    EXPECT_TRUE(only_says(read(valid + std::string("[pa\0th]", 7)), "p.toml:8:4", {"NUL", "binary"}));
    EXPECT_TRUE(only_says(read("\x7F"
                               "ELF\x02\x01\x01" +
                               std::string(20, '\0')),
                          "p.toml:1:8", {"NUL", "binary"}));
    EXPECT_TRUE(only_says(read("\xFF\xFEs\0c\0"), "p.toml:1:1", {"UTF-8"}));
}

TEST(Syntax, BytesThatAreNotUtf8AreErrorsWithTheirPlace) {
    for (const std::string bytes : {"\x80", "\xC3", "\xC0\x80", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                                    "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xE2\x82", "\xE2\x28\xA1"})
        EXPECT_TRUE(only_says(read(valid + "# ä€😀" + bytes), "p.toml:8:6", {"UTF-8"}));
}

TEST(Syntax, DeepNestingIsAnErrorAndNoCrash) {
    EXPECT_TRUE(only_says(read("a = " + std::string(100000, '[')), "p.toml:1:261", {"nested too deep"}));
    std::string tables = "a = ";
    for (int i = 0; i < 100000; ++i)
        tables += "{a=";
    EXPECT_TRUE(only_says(read(tables), "p.toml:1:773", {"nested too deep"}));
    std::string dotted = "a";
    for (int i = 0; i < 100000; ++i)
        dotted += ".a";
    EXPECT_TRUE(only_says(read(dotted + " = 1"), "p.toml:1:16", {"dotted key", "8 parts"}));
    EXPECT_TRUE(only_says(read("[" + dotted + "]"), "p.toml:1:17", {"dotted key"}));
    EXPECT_TRUE(only_says(read("x = {" + dotted + "= 1}"), "p.toml:1:21", {"dotted key"}));
}

TEST(Syntax, ASectionNeedsAName) {
    for (const std::string header : {"[(am]", "[\n", "[[=]]", "[ .a]", "[$", "[[ \t%]]"})
        EXPECT_TRUE(only_says(read(valid + header + "\n"), "p.toml:8:1", {"name of a [section]"})) << header;
    EXPECT_TRUE(only_says(read(valid + "[]\n"), "p.toml:8:2", {"not valid TOML"}));
}

TEST(Syntax, OtherThanAsciiStandsOnlyInQuotesAndComments) {
    EXPECT_TRUE(only_says(read("l\u00e4nge = 1\n" + valid), "p.toml:1:2", {"in quotes", "comment"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground =\u00a01")), "p.toml:4:9", {"in quotes", "comment"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1\u2060")), "p.toml:4:11", {"in quotes", "comment"}));
    EXPECT_TRUE(says(read("\"l\u00e4nge\" = 1\n" + valid), "p.toml:1:1", {"unknown key 'l\u00e4nge'"}));
    EXPECT_TRUE(accepted(read("title = '\u00e4' # \u00e4\n" + valid)));
    EXPECT_TRUE(accepted(read("title = \"\"\"\u00e4\n\u00e4 \\\n a\u00e4\"\"\"\n" + valid)));
    EXPECT_TRUE(only_says(read("title = \"\"\"a \\\n \u00e4\"\"\"\n" + valid), "p.toml:1:9", {"continued", "ASCII"}));
}

TEST(Syntax, BracketsAndBracesMatch) {
    EXPECT_TRUE(only_says(read(valid + "[path]\npoints = [}\n"), "p.toml:9:11", {"bracket or brace", "other kind"}));
    EXPECT_TRUE(only_says(read(valid + "[path]\npoints = [1, # }\n }\n"), "p.toml:10:2", {"other kind"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = { min = 5, max = 60 ]")), "p.toml:5:29", {"other kind"}));
    EXPECT_TRUE(only_says(read(with_line(5, "crank = 5 }")), "p.toml:5:11", {"not valid TOML"}));
}

TEST(Syntax, AQuoteStandsAtTheStartOfAKeyOrValue) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 100\"mm\"")), "p.toml:4:13", {"a quote", "start"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 1979-05-27 '\u00e4'")), "p.toml:4:21", {"a quote", "start"}));
    EXPECT_TRUE(says(read("a . \"b.c\".'d' = 1\n" + valid), "p.toml:1:1", {"unknown key 'a'"}));
    EXPECT_TRUE(accepted(read("\"title\"=\"a\"#\"\n" + valid)));
}

TEST(Syntax, AColonStandsOnlyInQuotesAndComments) {
    EXPECT_TRUE(only_says(read(with_line(4, "ground: 100")), "p.toml:4:7", {"':'", "key = value"}));
    EXPECT_TRUE(only_says(read(with_line(4, "ground = 07:32:00")), "p.toml:4:12", {"':'", "time of day"}));
    EXPECT_TRUE(accepted(read("title = 'a: b' # c: d\n" + valid)));
}

TEST(Syntax, WhatIsWrongFirstIsReported) {
    EXPECT_TRUE(only_says(read("title =\n" + valid + "[(am]\n"), "p.toml:1:8", {"missing"}));
    EXPECT_TRUE(only_says(read("title = \"x\n" + valid + "a.b.c.d.e.f.g.h.i.j = 1\n"), "p.toml:1:11", {"quote"}));
}

TEST(Syntax, DotsInStringsCommentsAndNumbersAreNoDottedKeys) {
    EXPECT_TRUE(accepted(read("title = \"a.b.c.d.e.f.g.h.i.j.k\" # a.b.c.d.e.f.g.h.i.j\n" + valid)));
    EXPECT_TRUE(accepted(read("title = 'a.b.c.d.e.f.g.h.i.j.k'\n" + valid)));
    EXPECT_TRUE(accepted(read("title = \"\"\"a.b.c\n.d.e.f.g.h.i.j.k\"\"\"\n" + valid)));
    EXPECT_TRUE(accepted(read("title = '''a.b.c\n.d.e.f.g.h'.i.j.k'''\n" + valid)));
    EXPECT_TRUE(accepted(read("title = \"a\\\".b.c.d.e.f.g.h.i.j\"\n" + valid)));
    EXPECT_TRUE(
        accepted(read(valid + "[path]\npoints = [[0.1, 2.5], [3.5, 4.5], [5.5, 6.5], [7.5, 8.5], [9.5, 1.5]]\n")));
}

TEST(Syntax, HugeFilesAreRefusedQuickly) {
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(only_says(read("# " + std::string(5 << 20, 'x')), "p.toml", {"larger than 4 MB", "points_file"}));
    std::string sections, keys, arrays;
    for (int i = 0; i < 200000; ++i)
        sections += "[a" + std::to_string(i) + "]\n";
    for (int i = 0; i < 200000; ++i)
        keys += "a" + std::to_string(i) + ".b=1\n";
    for (int i = 0; i < 200000; ++i)
        arrays += "[[a" + std::to_string(i) + "]]\n";
    EXPECT_TRUE(only_says(read(sections), "p.toml:10001:1", {"more than 10000 sections"}));
    EXPECT_TRUE(only_says(read(keys), "p.toml:10001:9", {"more than 10000 sections"}));
    EXPECT_TRUE(only_says(read(arrays), "p.toml:10001:1", {"more than 10000 sections"}));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(Syntax, AHundredThousandUnknownKeysAreCutAndCounted) {
    std::string keys;
    for (int i = 0; i < 100000; ++i)
        keys += "k" + std::to_string(i) + " = 1\n";
    const ReadProblem problem = read(keys + valid);
    ASSERT_EQ(problem.messages.size(), 101u);
    EXPECT_TRUE(says(problem, "p.toml:100:1", {"unknown key 'k99'"}));
    EXPECT_EQ(to_string(problem.messages.back()), "p.toml: and 99900 more; correct these first");
}

}  // namespace mechwright::test
