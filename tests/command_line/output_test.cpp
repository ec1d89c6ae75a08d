// Standard output that cannot be written, or that nobody reads to its end.

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

TEST(Output, AFullDiskEndsWithSix) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    const std::string fixed = folder.write("b.toml", given());
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"solve", file},
                                                      {"solve", "--json", file},
                                                      {"analyse", "--csv", fixed},
                                                      {"quantities"},
                                                      {"methods"},
                                                      {"--help"},
                                                      {"--version"}}) {
        Start how;
        how.arguments = arguments;
        how.out_to = "/dev/full";
        const Outcome outcome = run(how);
        EXPECT_EQ(outcome.exit_code, 6) << arguments.front();
        expect_has(outcome.err, "cannot write to standard output: No space left on device");
    }
}

TEST(Output, NothingToSayIsNoFailure) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"check", folder.write("a.toml", crank_rocker())};
    how.out_to = "/dev/full";
    EXPECT_EQ(run(how).exit_code, 0);
}

TEST(Output, ResultsAreStillWritten) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"solve", "--out", folder / "out", folder.write("a.toml", crank_rocker())};
    how.out_to = "/dev/full";
    EXPECT_EQ(run(how).exit_code, 6);
    EXPECT_EQ(parsed(content_of(folder / "out/a.json"))["status"], "solved");
}

TEST(Output, WithoutStandardOutput) {
    Start how;
    how.arguments = {"quantities"};
    how.out_closed = true;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 6);
    expect_has(outcome.err, "cannot write to standard output");
}

TEST(Output, AReaderThatLeavesEarlyIsNoFailure) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"analyse", "--csv", "--steps", "200000", folder.write("a.toml", given())};
    how.out_read = 100;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.killed_by, 0);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.err, "");
}

TEST(Output, AReaderThatLeavesBeforeTheResultCostsNoResult) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    Start how;
    how.arguments = {"solve", "--quiet", "--out", folder / "out", file, folder.write("b.toml", impossible)};
    how.out_read = 0;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.killed_by, 0);
    EXPECT_EQ(outcome.exit_code, 4);
    EXPECT_EQ(outcome.err, "");
    EXPECT_EQ(count_files(folder.path / "out"), 2u);
}

}  // namespace
}  // namespace mechwright::testing
