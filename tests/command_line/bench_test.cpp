// mechwright bench. What it measures is its own business: here it must keep it, go on, and write its report.

#include <signal.h>
#include <sys/wait.h>

#include <thread>

#include "synthesis/report/files/run_program.h"
#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/long_form.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

const std::string problems = std::string(MECHWRIGHT_SOURCE_DIR) + "/problems";

Outcome bench(std::vector<std::string> more) {
    std::vector<std::string> arguments{"bench", "--problems", problems};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
}

TEST(Bench, WritesTablesAndAReportAndDoesNotMeasureTwice) {
    const TemporaryFolder folder;
    const std::vector<std::string> words{"--only", "start-up", "--out", folder / "results"};
    // What another run measured is not replaced, but where that is asked for.
    std::filesystem::create_directories(folder.path / "results/bench");
    const std::string other =
        R"({"surroundings": {"program": "mechwright 9", "compiler": "", "libraries": "", "processor": "a slide rule",
            "instructions": "", "effort": "full"}, "sections": {}})";
    folder.write("results/bench/measured.json", other);
    const Outcome refused = bench(words);
    EXPECT_EQ(refused.exit_code, 6);
    expect_has(refused.err, "mechwright 9, a slide rule, full");
    expect_has(refused.err, "--anew");
    EXPECT_EQ(content_of(folder / "results/bench/measured.json"), other);
    const Outcome first = bench({"--only", "start-up", "--out", folder / "results", "--anew"});
    ASSERT_EQ(first.exit_code, 0) << first.err;
    expect_has(first.out, "results/README.md");
    const std::string report = content_of(folder / "results/README.md");
    expect_has(report, "## Whole runs of the program");
    expect_has(report, "mechwright solve crank-rocker.toml");
    expect_has_not(report, "## Kernels");
    const std::string table = content_of(folder / "results/bench/start-up.csv");
    expect_has(table, "command,ms,ms lower quartile,ms upper quartile\n/bin/true,");
    const Outcome again = bench(words);
    EXPECT_EQ(again.exit_code, 0) << again.err;
    expect_has(again.err, "7 measurements are of an earlier run.");
    EXPECT_EQ(content_of(folder / "results/bench/start-up.csv"), table);
    EXPECT_EQ(content_of(folder / "results/README.md"), report);
}

/// In the long form the first section is measured, whose every measurement takes long.
TEST(Bench, GoesOnWhereItWasInterrupted) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"bench", "--problems", problems, "--out", folder / "results"};
    if (!in_long_form()) how.arguments.insert(how.arguments.end(), {"--only", "start-up"});
    const Running running = start(how);
    const std::string data = folder / "results/bench/measured.json";
    for (int i = 0; i < 1200 && !std::filesystem::exists(data); ++i)
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    ASSERT_EQ(::kill(running.id, SIGINT), 0);
    const Outcome outcome = finish(running);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    expect_has(outcome.err, "the same command goes on");
    const Json kept = parsed(content_of(data));
    EXPECT_GE(kept["sections"].size(), 1u);
    EXPECT_FALSE(std::filesystem::exists(folder / "results/README.md"));
    const Outcome rest = bench({"--only", "start-up", "--out", folder / "results"});
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    const Json all = parsed(content_of(data));
    for (const auto& [section, measurements] : kept["sections"].items())
        for (const auto& [name, rows] : measurements.items())
            EXPECT_EQ(all["sections"][section][name], rows) << section << ": " << name;
    EXPECT_EQ(all["sections"]["start-up"].size(), 7u);
}

TEST(Bench, SaysWhatIsWrongWithItsOptions) {
    const Outcome section = bench({"--only", "kernel"});
    EXPECT_EQ(section.exit_code, 2);
    expect_has(section.err, "unknown section 'kernel'; did you mean 'kernels'?");
    const Outcome place = run({"bench", "--problems", "/nowhere"});
    EXPECT_EQ(place.exit_code, 2);
    expect_has(place.err, "--problems DIR");
    const TemporaryFolder folder;
    const Outcome full = bench({"--only", "start-up", "--out", folder.write("file", "") + "/results"});
    EXPECT_EQ(full.exit_code, 6);
    expect_has(full.err, "file");
}

TEST(Bench, IsAProgramOfItsOwn) {
    const Outcome help = run({"bench", "--help"});
    EXPECT_EQ(help.exit_code, 0);
    expect_has(help.out, "Sections: kernels, start-up");
    const Outcome unknown = run({"bench", "--fast", "solve"});
    EXPECT_EQ(unknown.exit_code, 2);
    expect_has(unknown.err, "--fast");
}

TEST(Bench, IsMissedPolitely) {
    const TemporaryFolder folder;
    const std::string alone = folder / "mechwright";
    std::filesystem::copy_file(MECHWRIGHT_PROGRAM, alone);
    const ProgramRun without = run_program({"sh", "-c", "PATH=/nowhere " + alone + " bench --help 2>&1"}, "");
    EXPECT_EQ(WEXITSTATUS(without.status), 6);
    expect_has(without.output, "./bootstrap bench");
    // Beside the program comes first, then PATH.
    const std::string other = folder.write("other/mechwright-bench", "#!/bin/sh\necho of PATH; exit 5\n");
    std::filesystem::permissions(other, std::filesystem::perms::owner_all);
    const std::string path = "PATH=" + (folder / "other") + ":$PATH ";
    const ProgramRun of_path = run_program({"sh", "-c", path + alone + " bench"}, "");
    EXPECT_EQ(WEXITSTATUS(of_path.status), 5);
    EXPECT_EQ(of_path.output, "of PATH\n");
    const std::string beside = folder.write("mechwright-bench", "#!/bin/sh\necho \"$@\"\n");
    std::filesystem::permissions(beside, std::filesystem::perms::owner_all);
    EXPECT_EQ(run_program({"sh", "-c", path + alone + " bench --jobs 2 --out x"}, "").output, "--jobs 2 --out x\n");
}

}  // namespace
}  // namespace mechwright::testing
