// What benchmarks are kept and shown in: record, tables, diagrams.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "synthesis/bench/pages/diagram.h"
#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/record.h"
#include "synthesis/report/files/gnuplot.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::bench {
namespace {

using ::mechwright::testing::TemporaryFolder;

Record record() {
    Record r{surroundings(true), {}};
    r.sections["a"].emplace_back("first", std::vector<Row>{{1.5, "text"}, {Cell(), "a, \"b\""}});
    r.sections["a"].emplace_back("second", std::vector<Row>{{-1e-300, "x"}});
    r.sections["b"].emplace_back("first", std::vector<Row>{});
    return r;
}

TEST(BenchRecord, IsReadAsItWasWritten) {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path / "measured.json";
    ASSERT_FALSE(write_record(file, record()));
    const auto read = read_record(file);
    ASSERT_TRUE(read);
    EXPECT_EQ(read->surroundings, record().surroundings);
    EXPECT_EQ(read->sections, record().sections);
    EXPECT_TRUE(read->has("a", "second"));
    EXPECT_FALSE(read->has("a", "third"));
    EXPECT_FALSE(read->has("c", "first"));
}

TEST(BenchRecord, IsNothingWhereTheFileIsNone) {
    const TemporaryFolder folder;
    EXPECT_FALSE(read_record(folder.path / "missing.json"));
    for (const char* text : {"", "{", "[]", "{\"surroundings\": 3}", "{\"surroundings\": {}, \"sections\": {}}"})
        EXPECT_FALSE(read_record(folder.write("measured.json", text))) << text;
}

Section section() { return {"a", "", {"name", "number", "word"}, nullptr, nullptr, nullptr}; }

TEST(BenchSheet, HasTheRowsInTheOrderOfTheMeasurements) {
    const Sheet sheet = sheet_of(record(), section(), {{"second", {}}, {"never", {}}, {"first", {}}});
    ASSERT_EQ(sheet.rows.size(), 3u);
    EXPECT_EQ(sheet.text(sheet.rows[0], "name"), "second");
    EXPECT_EQ(sheet.number(sheet.rows[0], "number"), -1e-300);
    EXPECT_EQ(sheet.number(sheet.rows[1], "number"), 1.5);
    EXPECT_TRUE(std::isnan(sheet.number(sheet.rows[2], "number")));
    EXPECT_EQ(sheet.where("name", "first").size(), 2u);
    EXPECT_EQ(sheet.distinct("name"), (std::vector<std::string>{"second", "first"}));
    EXPECT_THROW(sheet.number(sheet.rows[0], "nothing"), std::logic_error);
}

TEST(BenchMarkdown, NumbersReadWell) {
    EXPECT_EQ(significant(0), "0");
    EXPECT_EQ(significant(0.01234), "0.0123");
    EXPECT_EQ(significant(1.2345), "1.23");
    EXPECT_EQ(significant(-12.345), "-12.3");
    EXPECT_EQ(significant(123.45), "123");
    EXPECT_EQ(significant(1234.5), "1234");
    EXPECT_EQ(significant(12345.6), "12 346");
    EXPECT_EQ(significant(1234567), "1 234 567");
    EXPECT_EQ(significant(12345678), "1.23e+07");
    EXPECT_EQ(significant(1.2345e-5), "1.23e-05");
    EXPECT_EQ(significant(std::nan("")), "");
    EXPECT_EQ(time_text(1.5e-9), "1.50 ns");
    EXPECT_EQ(time_text(2.5e-5), "25.0 us");
    EXPECT_EQ(time_text(0.125), "125 ms");
    EXPECT_EQ(time_text(90), "90.0 s");
    EXPECT_EQ(ratio_text(1.84), "1.8 x");
    EXPECT_EQ(to_markdown({{"a", "b"}, {{"1", "2"}}}), "| a | b |\n| --- | --- |\n| 1 | 2 |\n");
}

TEST(BenchDiagram, IsDrawnWithoutWhatCannotBe) {
    Diagram diagram{"name", "It's `true`", "x", "y", true, true, Diagram::Joined::by_lines, {}};
    diagram.curves.push_back({"one", {{1, 1}, {10, std::nan("")}, {-1, 5}, {100, 0.01}}});
    diagram.curves.push_back({"nothing", {{0, 1}, {1, std::numeric_limits<double>::infinity()}}});
    const std::string script = gnuplot_script(diagram);
    EXPECT_EQ(script.find("nan"), std::string::npos);
    EXPECT_EQ(script.find("inf"), std::string::npos);
    EXPECT_EQ(script.find("nothing"), std::string::npos);
    const std::string picture = gnuplot_picture(script, {Picture::Format::svg, 800, 420, true});
    EXPECT_NE(picture.find("It's `true`"), std::string::npos);
    EXPECT_NE(picture.find("one"), std::string::npos);
}

}  // namespace
}  // namespace mechwright::bench
