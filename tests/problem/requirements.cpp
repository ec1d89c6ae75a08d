#include <cmath>
#include <set>

#include "synthesis/mechanism/mechanism.h"
#include "synthesis/mechanism/possible_values.h"
#include "tests/problem/problem_text.h"

namespace mechwright::test {

namespace {

/// The section starts in line 8, what is given in line 9.
ReadProblem read_requirement(const std::string& lines) { return read(valid + "[[require]]\n" + lines + "\n"); }

std::string equal(const std::string& quantity, const std::string& value) {
    return "[[require]]\nquantity = \"" + quantity + "\"\nequal = " + value + "\n";
}

}  // namespace

TEST(Requirements, AMisspeltQuantityIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"time-ration\"\nequal = 1"), "p.toml:9:12",
                          {"unknown quantity 'time-ration'", "did you mean 'time-ratio'"}));
}

TEST(Requirements, AnUnknownQuantityIsAnErrorThatListsTheKnownOnes) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"colour\"\nequal = 1"), "p.toml:9:12",
                          {"unknown quantity 'colour'", "swing", "total-length"}));
}

TEST(Requirements, AQuantityIsNeededAndIsAString) {
    EXPECT_TRUE(only_says(read_requirement("equal = 1"), "p.toml:8:1", {"needs a 'quantity'"}));
    EXPECT_TRUE(only_says(read_requirement("quantity = 3\nequal = 1"), "p.toml:9:12", {"'quantity'", "string"}));
}

TEST(Requirements, AValueIsNeeded) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\""), "p.toml:8:1", {"value", "'equal'", "'min'"}));
}

TEST(Requirements, EqualExcludesMinAndMax) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nmin = 1\nequal = 2"), "p.toml:11:9", {"not both"}));
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nequal = 2\nmax = 1"), "p.toml:10:9", {"not both"}));
}

TEST(Requirements, AValueIsAFiniteNumber) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nequal = \"60\""), "p.toml:10:9",
                          {"'equal' in [[require]]", "a number", "a string"}));
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nmin = nan"), "p.toml:10:7", {"'min'", "finite"}));
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nmax = inf"), "p.toml:10:7", {"'max'", "finite"}));
}

TEST(Requirements, ARangeThatNoValueCanMeetIsAnError) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nmin = 3\nmax = 2"), "p.toml:10:7",
                          {"no value can meet", "'min' 3", "'max' 2"}));
}

// What no mechanism reaches is a well-formed question, whose answer is that there is none.
TEST(Requirements, WhatNoMechanismReachesCanBeAskedFor) {
    EXPECT_TRUE(accepted(read_requirement("quantity = \"time-ratio\"\nequal = 0.8")));
    EXPECT_TRUE(accepted(read_requirement("quantity = \"transmission-angle-worst\"\nmin = 100")));
    EXPECT_TRUE(accepted(read_requirement("quantity = \"velocity-ratio-min\"\nequal = -3")));
}

/// A name in the list of possible values that no mechanism has would be one that changed.
TEST(Requirements, EveryQuantityOfBoundedValuesIsOneOfAMechanism) {
    std::set<std::string_view> bounded;
    for (const auto& mechanism : mechanisms())
        for (const Quantity& quantity : mechanism->quantities)
            if (std::isfinite(possible_values(quantity.name).least)) bounded.insert(quantity.name);
    EXPECT_EQ(bounded.size(), 28u);
}

TEST(Requirements, RequirementsThatExcludeEachOtherAreAnError) {
    EXPECT_TRUE(only_says(read(valid + equal("swing", "60") + equal("swing", "70")), "p.toml:11:1",
                          {"'swing'", "both", "line 8"}));
    EXPECT_TRUE(only_says(read(valid + "[[require]]\nquantity = \"swing\"\nmin = 50\n" + equal("swing", "40")),
                          "p.toml:11:1", {"'swing'", "line 8"}));
    EXPECT_TRUE(accepted(read(valid + "[[require]]\nquantity = \"swing\"\nmin = 50\n" + equal("swing", "60"))));
}

TEST(Requirements, AnUnknownKeyIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read_requirement("quantity = \"swing\"\nequal = 1\nequals = 2"), "p.toml:11:1",
                          {"unknown key 'equals' in [[require]]", "'equal'"}));
}

TEST(Requirements, ASingleBracketIsAnErrorThatShowsTheDoubleOne) {
    EXPECT_TRUE(only_says(read(valid + "[require]\nquantity = \"swing\"\nequal = 1\n"), "p.toml:8:1",
                          {"'require'", "[[require]]", "a table"}));
    EXPECT_TRUE(only_says(read("require = [1]\n" + valid), "p.toml:1:12", {"'require'", "[[require]]", "a number"}));
}

TEST(Requirements, ARequirementMayBeWrittenInOneLine) {
    const ReadProblem read_file = read("require = [{ quantity = \"swing\", equal = 60 }]\n" + valid);
    ASSERT_TRUE(accepted(read_file));
    EXPECT_EQ(read_file.problem.requirements.size(), 1u);
}

TEST(Requirements, APathQuantityNeedsAPath) {
    EXPECT_TRUE(
        only_says(read_requirement("quantity = \"path-rms\"\nmax = 1"), "p.toml:9:12", {"'path-rms'", "no [path]"}));
    EXPECT_TRUE(accepted(read(valid + "[[require]]\nquantity = \"path-rms\"\nmax = 1\n[path]\npoints = [[1, 2]]\n")));
}

TEST(Requirements, AWrongPathIsNotAlsoReportedAsMissing) {
    EXPECT_TRUE(
        only_says(read(valid + "[[require]]\nquantity = \"path-rms\"\nmax = 1\n[path]\npoints = [[1, 2], [1, 2]]\n"),
                  "p.toml:12:19", {"coincide"}));
}

TEST(Requirements, MoreEqualitiesThanFreeDimensionsAreAWarning) {
    const std::string three = equal("swing", "60") + equal("time-ratio", "1.2") + equal("total-length", "300");
    EXPECT_TRUE(accepted(read(valid + three)));
    const ReadProblem four = read(valid + three + equal("link-ratio", "3"));
    EXPECT_TRUE(four.ok());
    ASSERT_EQ(four.messages.size(), 1u);
    EXPECT_TRUE(four.messages[0].warning);
    EXPECT_TRUE(says(four, "p.toml:8:1", {"warning: 4 quantities", "only 3"}));
}

TEST(Requirements, OneQuantityRequiredTwiceIsOneEquality) {
    const std::string three = equal("swing", "60") + equal("time-ratio", "1.2") + equal("total-length", "300");
    EXPECT_TRUE(accepted(read(valid + three + equal("swing", "60"))));
}

TEST(Requirements, DimensionsThatTheQuantitiesDoNotDependOnDoNotCountAsFree) {
    const std::string three = equal("swing", "60") + equal("time-ratio", "1.2") + equal("total-length", "300");
    EXPECT_EQ(read(valid + "tilt = { min = 0, max = 9 }\n" + three + equal("link-ratio", "3")).messages.size(), 1u);
}

TEST(Requirements, WithoutAKnownMechanismValuesAreStillChecked) {
    const ReadProblem read_file =
        read("schema = 1\nmechanism = \"x\"\n[[require]]\nquantity = \"y\"\nmin = 2\nmax = 1\n");
    EXPECT_EQ(read_file.messages.size(), 2u) << all_messages(read_file);
    EXPECT_TRUE(says(read_file, "p.toml:5:7", {"no value can meet"}));
}

}  // namespace mechwright::test
