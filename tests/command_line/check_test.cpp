// mechwright check

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

TEST(Check, SaysNothingOfGoodFiles) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"check", folder.write("a.toml", crank_rocker()), folder.write("b.toml", given())});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(outcome.err, "");
}

TEST(Check, ReadsAProblemFromStandardInput) {
    Start good;
    good.arguments = {"check", "-"};
    good.in = crank_rocker();
    EXPECT_EQ(run(good).exit_code, 0);
    Start wrong;
    wrong.arguments = {"check", "-"};
    wrong.in = "schema = 1\nmechanism = \"four-bar\"\ndimension = 3\n";
    const Outcome outcome = run(wrong);
    EXPECT_EQ(outcome.exit_code, 3);
    expect_has(outcome.err, "-:3:1: unknown key 'dimension'");
    Start solved;
    solved.arguments = {"solve", "-", "--json"};
    solved.in = crank_rocker();
    const Outcome design = run(solved);
    EXPECT_EQ(design.exit_code, 0) << design.err;
    EXPECT_EQ(parsed(design.out)["problem"]["file"], "-");
}

/// More equalities than variables.
std::string overdetermined() { return given("[[require]]\nquantity = \"swing\"\nequal = 60\n"); }

TEST(Check, WarningsDoNotMakeAFileInvalid) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", overdetermined());
    const Outcome outcome = run({"check", file});
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, "warning: ");
    EXPECT_EQ(run({"check", "--quiet", file}).err, "");
}

TEST(Check, TheMostSevereOfSeveralFilesDecides) {
    const TemporaryFolder folder;
    const std::string good = folder.write("good.toml", crank_rocker());
    const std::string invalid = folder.write("invalid.toml", "schema = 1\n");
    const std::string missing = folder / "missing.toml";
    EXPECT_EQ(run({"check", good, invalid}).exit_code, 3);
    EXPECT_EQ(run({"check", invalid, missing, good}).exit_code, 6);
    const Outcome outcome = run({"check", missing, good, invalid});
    EXPECT_EQ(outcome.exit_code, 6);
    expect_has(outcome.err, missing);
    expect_has(outcome.err, invalid);
}

TEST(Check, AMethodThatDoesNotApplyIsAnError) {
    const TemporaryFolder folder;
    std::string text = long_search();
    text.replace(text.find("starts = 100000"), 15, "method = \"closed-form\"");
    const std::string file = folder.write("a.toml", text);
    for (const char* command : {"check", "solve"}) {
        const Outcome outcome = run({command, file});
        EXPECT_EQ(outcome.exit_code, 3);
        EXPECT_EQ(outcome.out, "");
        expect_has(outcome.err, "cannot be used here: ");
    }
}

TEST(Check, ShippedProblemsAreGood) {
    std::vector<std::string> command{"check"};
    const std::filesystem::path shipped = std::filesystem::path(MECHWRIGHT_SOURCE_DIR) / "problems";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(shipped))
        if (entry.path().extension() == ".toml") command.push_back(entry.path().string());
    ASSERT_GT(command.size(), 1u);
    const Outcome outcome = run(command);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

}  // namespace
}  // namespace mechwright::testing
