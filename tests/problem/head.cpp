#include "tests/problem/problem_text.h"

namespace mechwright::test {

TEST(Head, AMissingSchemaIsAnError) {
    EXPECT_TRUE(only_says(read(with_line(1, "")), "p.toml:1:1", {"'schema'", "missing", "schema = 1"}));
}

TEST(Head, AnotherSchemaIsAnError) {
    EXPECT_TRUE(only_says(read(with_line(1, "schema = 2")), "p.toml:1:10", {"schema 2", "schema = 1"}));
}

TEST(Head, ASchemaThatIsNoWholeNumberIsAnError) {
    EXPECT_TRUE(only_says(read(with_line(1, "schema = \"1\"")), "p.toml:1:10", {"'schema'", "whole number", "string"}));
    EXPECT_TRUE(only_says(read(with_line(1, "schema = 1.0")), "p.toml:1:10", {"'schema'", "whole number"}));
}

TEST(Head, AMissingMechanismIsAnErrorThatListsThem) {
    EXPECT_TRUE(only_says(read(with_line(2, "")), "p.toml:1:1", {"'mechanism'", "missing", "four-bar"}));
}

TEST(Head, AMisspeltMechanismIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read(with_line(2, "mechanism = \"fourbar\"")), "p.toml:2:13",
                          {"unknown mechanism 'fourbar'", "did you mean 'four-bar'"}));
}

TEST(Head, AnUnknownMechanismIsAnErrorThatListsThem) {
    EXPECT_TRUE(only_says(read(with_line(2, "mechanism = \"pantograph\"")), "p.toml:2:13",
                          {"unknown mechanism 'pantograph'", "known are four-bar"}));
}

TEST(Head, AMechanismThatIsNoStringIsAnError) {
    EXPECT_TRUE(only_says(read(with_line(2, "mechanism = 4")), "p.toml:2:13", {"'mechanism'", "string", "number"}));
}

TEST(Head, ATitleThatIsNoStringIsAnError) {
    EXPECT_TRUE(only_says(read("title = 7\n" + valid), "p.toml:1:9", {"'title'", "string", "number"}));
}

TEST(Head, AMisspeltKeyOfTheTopLevelIsAnErrorWithTheNearestName) {
    EXPECT_TRUE(only_says(read("titel = \"x\"\n" + valid), "p.toml:1:1", {"unknown key 'titel'", "'title'"}));
    EXPECT_TRUE(only_says(read(valid + "[sovler]\n"), "p.toml:8:2", {"unknown key 'sovler'", "'solver'"}));
}

TEST(Head, AnUnknownKeyOfTheTopLevelIsAnErrorThatListsTheKnownOnes) {
    EXPECT_TRUE(only_says(read(valid + "[completely-different]\n"), "p.toml:8:2",
                          {"unknown key 'completely-different'", "dimensions", "require", "objective"}));
}

TEST(Head, ASectionThatIsNoTableIsAnError) {
    for (const std::string section : {"units", "path", "motion", "solver", "study"})
        EXPECT_TRUE(only_says(read(section + " = 3\n" + valid), "p.toml:1:" + std::to_string(section.size() + 4),
                              {"'" + section + "'", "[" + section + "]", "a number"}));
}

TEST(Head, NamesInMessagesAreShortenedAndMadeVisible) {
    const ReadProblem long_name = read(std::string(5000, 'x') + " = 1\n" + valid);
    ASSERT_EQ(long_name.messages.size(), 1u);
    EXPECT_LT(long_name.messages[0].text.size(), 300u);
    EXPECT_TRUE(only_says(read("\"a\\u001b[31m\\nb\" = 1\n" + valid), "p.toml:1:1", {"a\\x1b[31m\\x0ab"}));
}

}  // namespace mechwright::test
