#include <chrono>

#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// What a path says whose points are those of a file with this text; places in it start with "points.csv".
ReadProblem read_table(std::string_view table, const std::string& more = "") {
    const TemporaryFolder folder;
    folder.write("points.csv", table);
    ReadProblem problem = parse_problem(valid + "[path]\npoints_file = \"points.csv\"\n" + more, folder.file("p.toml"));
    for (Message& message : problem.messages)
        message.file = message.file.substr(message.file.rfind('/') + 1);
    return problem;
}

testing::AssertionResult has_points(std::string_view table, const std::vector<std::pair<double, double>>& expected) {
    const ReadProblem problem = read_table(table);
    if (!problem.ok()) return testing::AssertionFailure() << all_messages(problem);
    std::vector<std::pair<double, double>> found;
    for (const auto& point : problem.problem.path->points)
        found.emplace_back(point.x, point.y);
    if (found == expected) return testing::AssertionSuccess();
    return testing::AssertionFailure() << "found " << testing::PrintToString(found);
}

}  // namespace

TEST(PointTable, ColumnsAreSeparatedByCommaSemicolonTabOrBlanks) {
    for (const std::string separator : {",", ", ", ";", " ; ", "\t", " ", "   ", " \t "})
        EXPECT_TRUE(has_points("1.5" + separator + "-2e1\n3" + separator + "+4\n", {{1.5, -20}, {3, 4}})) << separator;
}

TEST(PointTable, HeadersCommentsBlankLinesAndLineEndsAreUnderstood) {
    const std::vector<std::pair<double, double>> points{{1, 2}, {3, 4}};
    EXPECT_TRUE(has_points("x,y\n1,2\n3,4\n", points));
    EXPECT_TRUE(has_points("\"x [mm]\"; \"y [mm]\"\n1;2\n3;4", points));
    EXPECT_TRUE(has_points("x, y\n1 2\n3 4\n", points));
    EXPECT_TRUE(has_points("# figure\n\n  \nx,y\n1,2 # first\n#3,3\n\n3,4\n\n", points));
    EXPECT_TRUE(has_points("\xEF\xBB\xBFx,y\r\n1,2\r\n\r\n3,4\r\n", points));
    EXPECT_TRUE(has_points("1,2\r3,4\r", points));
    EXPECT_TRUE(has_points("  1 2 \n\t3 4\t\n", points));
}

TEST(PointTable, RaggedRowsAreErrorsAtTheirPlaces) {
    const ReadProblem problem = read_table("x,y\n1,2\n3\n 4,5,6\n7,8\n");
    EXPECT_EQ(problem.messages.size(), 2u) << all_messages(problem);
    EXPECT_TRUE(says(problem, "points.csv:3:1", {"1 column ", "2"}));
    EXPECT_TRUE(says(problem, "points.csv:4:2", {"3 columns", "2"}));
    EXPECT_FALSE(problem.unreadable);
}

TEST(PointTable, DecimalCommasAreRaggedRowsWithAHint) {
    EXPECT_TRUE(only_says(read_table("1,5 2,5\n"), "points.csv:1:1", {"decimal point"}));
    EXPECT_TRUE(says(read_table("1,5;2,5\n"), "points.csv:1:1", {"'1,5'", "not a number"}));
}

TEST(PointTable, WhatIsNoFiniteNumberIsAnErrorAtItsPlace) {
    EXPECT_TRUE(only_says(read_table("1,2\n3, four\n"), "points.csv:2:4", {"'four'", "not a number"}));
    EXPECT_TRUE(only_says(read_table("1,2\n3,\n"), "points.csv:2:3", {"''", "not a number"}));
    EXPECT_TRUE(only_says(read_table("1,2\n3,4mm\n"), "points.csv:2:3", {"'4mm'", "not a number"}));
    EXPECT_TRUE(only_says(read_table("1,2\n3,1e999\n"), "points.csv:2:3", {"'1e999'", "outside the range"}));
    EXPECT_TRUE(only_says(read_table("1,2\n3,-1e99\n"), "points.csv:2:3", {"'-1e99'", "at most 1e60"}));
    EXPECT_TRUE(only_says(read_table("1,2\nnan,4\n"), "points.csv:2:1", {"'nan'", "finite"}));
    EXPECT_TRUE(only_says(read_table("1,2\n3,-inf\n"), "points.csv:2:3", {"'-inf'", "finite"}));
    EXPECT_TRUE(only_says(read_table("1,2\n+-3,4\n"), "points.csv:2:1", {"'+-3'", "not a number"}));
}

TEST(PointTable, ASlipInTheFirstRowIsNotTakenForAHeader) {
    EXPECT_TRUE(only_says(read_table("1.O,2\n3,4\n"), "points.csv:1:1", {"'1.O'", "not a number"}));
    EXPECT_TRUE(only_says(read_table("nan,2\n3,4\n"), "points.csv:1:1", {"'nan'", "finite"}));
    EXPECT_TRUE(says(read_table("inf,inf\n3,4\n"), "points.csv:1:1", {"'inf'", "finite"}));
}

TEST(PointTable, NeighbouringPointsMustNotCoincide) {
    EXPECT_TRUE(only_says(read_table("x,y\n1,2\n\n1,2.0\n"), "points.csv:4:1", {"points 1 and 2", "coincide"}));
}

TEST(PointTable, AWrongRowHidesNoOthersAndTheirOrderIsThatOfTheFile) {
    const ReadProblem problem = read_table("1,2\n3\n4,5\n4,5\n6,x\n");
    ASSERT_EQ(problem.messages.size(), 3u) << all_messages(problem);
    EXPECT_TRUE(says(problem, "points.csv:4:1", {"points 3 and 4", "coincide"}));
    EXPECT_EQ(problem.messages[0].line, 2);
    EXPECT_EQ(problem.messages[1].line, 4);
    EXPECT_EQ(problem.messages[2].line, 5);
}

TEST(PointTable, AFileWithoutPointsIsAnError) {
    for (const std::string table : {"", "\n\n", "# nothing\n", "x,y\n"})
        EXPECT_TRUE(only_says(read_table(table), "points.csv:1:1", {"empty point list"})) << table;
}

TEST(PointTable, BinaryFilesAreErrorsAtTheFirstByteThatShowsIt) {
    EXPECT_TRUE(only_says(read_table(std::string_view("1,2\n3,\0004\n", 8)), "points.csv:2:3", {"NUL", "binary"}));
    EXPECT_TRUE(only_says(read_table("1,2\n\xFF\xFE\n"), "points.csv:2:1", {"UTF-8"}));
    EXPECT_TRUE(only_says(read_table("1,2\nä,\xC3\n"), "points.csv:2:3", {"UTF-8"}));
}

TEST(PointTable, AMillionLinesAreOneQuickMessage) {
    std::string numbers = "x,y\n";
    std::string words;
    for (int i = 0; i < 1000000; ++i) {
        numbers += std::to_string(i) + ",1\n";
        words += "no number in this line\n";
    }
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_TRUE(only_says(read_table(numbers), "points.csv:10002:1", {"1000000 points", "at most 10000", "thin"}));
    EXPECT_TRUE(only_says(read_table(words), "points.csv:10002:1", {"999999 points", "at most 10000"}));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
}

TEST(PointTable, AFileThatIsTooLargeIsAnError) {
    const TemporaryFolder folder;
    folder.write("points.csv", "1,2\n");
    std::filesystem::resize_file(folder.file("points.csv"), (std::uintmax_t{64} << 20) + 1);
    const ReadProblem problem = parse_problem(valid + "[path]\npoints_file = \"points.csv\"\n", folder.file("p.toml"));
    EXPECT_TRUE(only_says(problem, folder.file("points.csv"), {"larger than 64 MB"}));
    EXPECT_FALSE(problem.unreadable);
}

TEST(PointTable, AFreelyTimedFileHasTheSameLimitAsAList) {
    std::string table;
    for (int i = 0; i < 201; ++i)
        table += std::to_string(i) + " 0\n";
    EXPECT_TRUE(only_says(read_table(table), "p.toml:9:15", {"201", "at most 200"}));
}

TEST(PointTable, ListsThatGoWithThePointsAreCompared) {
    EXPECT_TRUE(accepted(read_table("1,2\n3,4\n", "weights = [1, 2]\n")));
    EXPECT_TRUE(only_says(read_table("1,2\n3,4\n", "weights = [1]\n"), "p.toml:10:11", {"1 numbers", "2 points"}));
}

TEST(PointTable, MessagesAboutTheFileComeWhereTheProblemNamesIt) {
    const ReadProblem problem = read_table("1,2\nx,y\n", "closd = true\n[solver]\nseed = -1\n");
    ASSERT_EQ(problem.messages.size(), 4u) << all_messages(problem);
    EXPECT_EQ(problem.messages[0].file, "points.csv");
    EXPECT_EQ(problem.messages[1].file, "points.csv");
    EXPECT_EQ(problem.messages[2].line, 10);
    EXPECT_EQ(problem.messages[3].line, 12);
}

}  // namespace mechwright::test
