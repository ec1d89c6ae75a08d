#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "synthesis/problem/reader.h"

namespace {

using namespace mechwright;
using Json = nlohmann::ordered_json;

Json crank_rocker() {
    return {{"schema", 1},
            {"mechanism", "four-bar"},
            {"dimensions", {{"ground", 100}, {"crank", {{"min", 5}, {"max", 60}}}, {"coupler", 93.5}, {"rocker", 70}}},
            {"require", {{{"quantity", "swing"}, {"min", 50}}}}};
}

/// "name: text" of every message, a line each.
std::string messages_of(const Json& tables) {
    std::string lines;
    for (const Message& message : take_problem(tables, "<values>").messages)
        lines += to_string(message) + "\n";
    return lines;
}

TEST(ProblemInMemory, IsThatOfItsText) {
    const ReadProblem taken = take_problem(crank_rocker(), "<values>");
    ASSERT_TRUE(taken.ok());
    const ReadProblem read = parse_problem(taken.problem.text, "<values>");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read.problem.sha256, taken.problem.sha256);
    EXPECT_EQ(taken.problem.dimensions[1].max, 60);
    EXPECT_EQ(read.problem.dimensions[2].min, taken.problem.dimensions[2].min);
    EXPECT_EQ(read.problem.requirements[0].min, taken.problem.requirements[0].min);
}

/// Where a dyad is closed on a side that nobody named depends on which link comes first.
TEST(ProblemInMemory, KeepsTheOrderOfALinkage) {
    const Json tables = {{"schema", 1},
                         {"mechanism", "linkage"},
                         {"dimensions", {{"rocker", 70}, {"a-b", 40}, {"coupler", 93.5}}},
                         {"links",
                          {{"frame", {{"D", {100, 0}}, {"A", {0, 0}}}},
                           {"rocker", {{"D", {0, 0}}, {"C", {"rocker", 0}}}},
                           {"crank", {{"A", {0, 0}}, {"B", {"a-b", 0}}}},
                           {"coupler", {{"C", {0, 0}}, {"B", {"coupler", 0}}}}}},
                         {"drive", {{{"link", "crank"}}}},
                         {"assembly", {{"C", "left"}}}};
    const ReadProblem taken = take_problem(tables, "<values>");
    ASSERT_TRUE(taken.ok()) << messages_of(tables);
    const ReadProblem read = parse_problem(taken.problem.text, "<values>");
    ASSERT_TRUE(read.ok()) << taken.problem.text;
    EXPECT_EQ(read.problem.mechanism->made_from, taken.problem.mechanism->made_from) << taken.problem.text;
    EXPECT_NE(taken.problem.text.find("[links]\nframe = { D = [100, 0], A = [0, 0] }\nrocker = "), std::string::npos)
        << taken.problem.text;
}

TEST(ProblemInMemory, MessagesNameValuesInTheOrderInWhichTheyWereGiven) {
    Json tables = crank_rocker();
    tables["zone"] = 1;
    tables["area"] = 1;
    tables["require"].push_back({{"quantity", "swing"}, {"max", 40}});
    tables["dimensions"]["crank"]["min"] = "long";
    const std::string said = messages_of(tables);
    const auto at = [&](const char* text) { return said.find(text); };
    EXPECT_EQ(at("dimensions.crank.min: "), 0) << said;
    EXPECT_NE(at("\nrequire[1]: no value of 'swing' can meet both this and the requirement require[0]\n"),
              std::string::npos)
        << said;
    EXPECT_LT(at("\nzone: unknown key"), at("\narea: unknown key")) << said;
}

TEST(ProblemInMemory, WhatIsAboutTheWholeHasNoName) {
    EXPECT_EQ(messages_of(Json::object()).substr(0, 28), "<values>: the file is empty:") << messages_of(Json::object());
    EXPECT_EQ(messages_of({{"schema", 1}}).find("<values>: 'mechanism' is missing"), 0U);
}

}  // namespace
