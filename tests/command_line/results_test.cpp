// The files that solve --out writes, and what stands in their way.

#include <algorithm>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

TEST(Results, AreWrittenAndVerified) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    const std::string out = folder / "deep/results";
    const Outcome outcome = run({"solve", "--out", out, "--csv", "--json", file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(content_of(out + "/a.json"), outcome.out);
    EXPECT_EQ(outcome.err, "wrote " + out + "/a.json and " + out + "/a.csv\n");
    EXPECT_EQ(count_files(out), 2u);
    const std::string table = content_of(out + "/a.csv");
    EXPECT_EQ(table.rfind("crank-angle [deg],", 0), 0u);
    EXPECT_EQ(std::count(table.begin(), table.end(), '\n'), 362);
    const Outcome verified = run({"verify", out + "/a.json"});
    EXPECT_EQ(verified.exit_code, 0) << verified.out;
    EXPECT_EQ(run({"solve", "--quiet", "--out", out, file}).err, "");
}

TEST(Results, OfAnInfeasibleProblemAreWrittenToo) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", impossible);
    EXPECT_EQ(run({"solve", "--out", folder / "out", file}).exit_code, 4);
    EXPECT_EQ(parsed(content_of(folder / "out/a.json"))["status"], "infeasible");
}

TEST(Results, EqualNamesAreToldApart) {
    const TemporaryFolder folder;
    const std::vector<std::string> files{folder.write("a/x.toml", crank_rocker()), folder.write("b/x.toml", given()),
                                         folder.write("c/x-2.toml", given()), folder.write("d/x.toml", given())};
    std::vector<std::string> command{"solve", "--out", folder / "out"};
    command.insert(command.end(), files.begin(), files.end());
    EXPECT_EQ(run(command).exit_code, 0);
    const auto file_of = [&](const std::string& name) {
        return parsed(content_of(folder / "out/" + name))["problem"]["file"].get<std::string>();
    };
    EXPECT_EQ(count_files(folder.path / "out"), 4u);
    EXPECT_EQ(file_of("x.json"), files[0]);
    EXPECT_EQ(file_of("x-3.json"), files[1]);
    EXPECT_EQ(file_of("x-2.json"), files[2]);
    EXPECT_EQ(file_of("x-4.json"), files[3]);
}

TEST(Results, AFolderThatCannotBeWrittenIsFoundBeforeSolving) {
    const TemporaryFolder folder;
    const std::string file = folder.write("long.toml", long_search());
    for (const std::string& out : {file, file + "/below", std::string("/dev/full"), std::string("/dev/null/x"),
                                   std::string("/proc/mechwright"), std::string("/proc")}) {
        const auto begin = std::chrono::steady_clock::now();
        const Outcome outcome = run({"solve", "--time-limit", "60", "--out", out, file});
        EXPECT_EQ(outcome.exit_code, 6) << out << ": " << outcome.err;
        EXPECT_EQ(outcome.out, "");
        expect_has(outcome.err, out);
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(30)) << out;
    }
}

TEST(Results, AFolderInTheWayOfAFileIsFoundBeforeSolving) {
    const TemporaryFolder folder;
    const std::string file = folder.write("long.toml", long_search());
    std::filesystem::create_directories(folder.path / "out" / "long.json" / "inside");
    const Outcome outcome = run({"solve", "--time-limit", "60", "--out", folder / "out", file});
    EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
    expect_has(outcome.err, "long.json");
    EXPECT_EQ(count_files(folder.path / "out"), 1u);
    std::filesystem::create_directories(folder.path / "tables" / "long.csv");
    EXPECT_EQ(run({"solve", "--time-limit", "60", "--csv", "--out", folder / "tables", file}).exit_code, 6);
}

TEST(Results, AFullDiskLeavesNothingHalfWritten) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"solve", "--out", folder / "out", folder.write("a.toml", crank_rocker())};
    how.largest_file = 512;
    folder.write("out/a.json", "old");
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 6) << outcome.err;
    expect_has(outcome.err, "a.json");
    expect_has(outcome.err, "File too large");
    expect_has(outcome.out, "Solved");  // what was found is not lost
    EXPECT_EQ(content_of(folder / "out/a.json"), "old");
    EXPECT_EQ(count_files(folder.path / "out"), 1u);
}

TEST(Results, FileNamesNeedNotBeText) {
    const TemporaryFolder folder;
    const std::string file = folder.write("w\xffhy \x1b[31m.toml", crank_rocker());
    const Outcome outcome = run({"solve", "--out", folder / "out", "--json", file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    parsed(outcome.out);
    EXPECT_EQ(count_files(folder.path / "out"), 1u);
    expect_has_not(run({"solve", file}).out, "\x1b");
}

}  // namespace
}  // namespace mechwright::testing
