// mechwright study

#include <SQLiteCpp/SQLiteCpp.h>
#include <signal.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <random>
#include <thread>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

/// Solved by searches, most of them from the neighbour's design: 4 strands of 16 points.
const std::string searched = crank_rocker(R"(
[solver]
method = "slsqp"

[study]
quantities = ["swing", "transmission-angle-worst"]
"require.time-ratio.equal" = { from = 1.1, to = 1.3, count = 4 }
"require.swing.equal"      = { from = 40, to = 70, count = 16 }
)");

/// As many points as are wanted, each of them quickly dealt with.
std::string quick(int points) {
    return given("\n[study]\ndesign = \"sobol\"\ncount = " + std::to_string(points) +
                 "\nquantities = [\"link-ratio\"]\n\"dimensions.crank\" = { from = 10, to = 40 }\n");
}

std::string exported(const std::string& folder) { return run({"study", "export", folder, "--csv"}).out; }

TEST(Study, RunsToItsEndAndSaysWhatItIs) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"study", folder.write("a.toml", searched), "--out", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"64 points: 64 solved", "solved from their neighbours alone", "Data: "})
        expect_has(outcome.out, part);
    expect_has(outcome.err, "64 points in ");
    EXPECT_EQ(count_files(folder.path / "out"), 1u);
    const Outcome again = run({"study", folder / "a.toml", "--out", folder / "out"});
    EXPECT_EQ(again.exit_code, 0);
    EXPECT_EQ(again.err, "");
    EXPECT_EQ(again.out, outcome.out);
}

TEST(Study, ExportsCsvAndJsonAndWhatSqlSelects) {
    const TemporaryFolder folder;
    run({"study", folder.write("a.toml", searched), "--out", folder / "out"});
    const std::string csv = exported(folder / "out");
    EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 65);
    EXPECT_TRUE(csv.starts_with("point,require.time-ratio.equal,require.swing.equal,status,start,"));
    const Json json = parsed(run({"study", "export", folder / "out", "--json"}).out);
    ASSERT_EQ(json.size(), 64u);
    EXPECT_NEAR(json[17]["swing"], json[17]["require.swing.equal"], 1e-7);
    const Outcome best = run({"study", "export", folder / "out", "--sql",
                              "SELECT max(objective) AS best FROM points WHERE \"require.time-ratio.equal\" < 1.15"});
    EXPECT_TRUE(best.out.starts_with("best\n53.3")) << best.out;
    const Outcome wrong = run({"study", "export", folder / "out", "--sql", "SELECT nowhere FROM points"});
    EXPECT_EQ(wrong.exit_code, 2);
    expect_has(wrong.err, "no such column: nowhere");
    EXPECT_NE(run({"study", "export", folder / "out", "--sql", "DROP TABLE points"}).exit_code, 0);
    EXPECT_EQ(exported(folder / "out"), csv);
}

TEST(Study, QueriesEndAndReadAlone) {
    const TemporaryFolder folder;
    run({"study", folder.write("a.toml", quick(4)), "--out", folder / "out"});
    const auto query = [&](const std::string& sql, const std::string& limit) {
        return run({"study", "export", folder / "out", "--sql", sql, "--time-limit", limit});
    };
    const Outcome endless =
        query("WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) SELECT count(*) FROM n", "0.1");
    EXPECT_EQ(endless.exit_code, 5);
    expect_has(endless.err, "--time-limit");
    const Outcome writes = query("VACUUM INTO '" + (folder / "copy") + "'", "10");
    EXPECT_EQ(writes.exit_code, 2);
    expect_has(writes.err, "only queries that read");
    EXPECT_FALSE(std::filesystem::exists(folder.path / "copy"));
}

TEST(Study, APipeInThePlaceOfTheDataIsNotWaitedFor) {
    const TemporaryFolder folder;
    ASSERT_EQ(::mkfifo((folder / "study.sqlite").c_str(), 0600), 0);
    for (const char* command : {"status", "export"}) {
        const Outcome outcome = run({"study", command, folder.path.string()});
        EXPECT_EQ(outcome.exit_code, 6) << command;
        expect_has(outcome.err, "is not a regular file");
    }
    expect_has(run({"report", folder.path.string()}).err, "is not a regular file");
}

TEST(Study, WrongUsageIsNamed) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", searched);
    EXPECT_EQ(run({"study"}).exit_code, 2);
    const Outcome nowhere = run({"study", file});
    EXPECT_EQ(nowhere.exit_code, 2);
    expect_has(nowhere.err, "--out DIR");
    const Outcome none = run({"study", folder.write("b.toml", crank_rocker()), "--out", folder / "out"});
    EXPECT_EQ(none.exit_code, 3);
    expect_has(none.err, "there is no [study] in it");
    EXPECT_EQ(run({"study", folder / "c.toml", "--out", folder / "out"}).exit_code, 6);
    EXPECT_EQ(run({"study", "status", folder / "nothing"}).exit_code, 6);
    EXPECT_EQ(run({"study", "export", folder / "nothing"}).exit_code, 6);
    EXPECT_EQ(run({"study", "merge", folder / "nothing"}).exit_code, 6);
    EXPECT_EQ(run({"study", "run", folder / "nothing", "--chunk", "1"}).exit_code, 6);
    EXPECT_FALSE(std::filesystem::exists(folder.path / "out"));
}

/// Twenty runs, each killed at a moment of its own: nothing is lost and nothing done twice.
TEST(Study, KilledTwentyTimesComesToTheSameData) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", searched);
    run({"study", file, "--out", folder / "whole", "--quiet"});
    const std::string whole = exported(folder / "whole");

    std::mt19937 random(7);
    std::uint64_t done = 0;
    int killed = 0;
    for (int k = 0; k < 20; ++k) {
        Start how;
        how.arguments = {"study", file, "--out", folder / "killed", "--quiet", "--jobs", "2"};
        const Running running = start(how);
        std::this_thread::sleep_for(std::chrono::milliseconds(10 + random() % 25));
        ::kill(running.id, SIGKILL);
        killed += finish(running).killed_by == SIGKILL;
        if (!std::filesystem::exists(folder.path / "killed/study.sqlite")) continue;
        const Outcome count = run({"study", "export", folder / "killed", "--sql", "SELECT count(*) FROM points"});
        if (count.exit_code != 0) continue;  // killed before there was a table
        const std::uint64_t now = std::stoull(count.out.substr(count.out.find('\n') + 1));
        EXPECT_GE(now, done);
        done = now;
    }
    EXPECT_GT(killed, 5);
    EXPECT_EQ(run({"study", file, "--out", folder / "killed", "--quiet"}).exit_code, 0);
    EXPECT_EQ(exported(folder / "killed"), whole);
}

TEST(Study, StoppedByCtrlCGoesOn) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", quick(100000));
    Start how;
    how.arguments = {"study", file, "--out", folder / "out", "--quiet"};
    const Running running = start(how);
    std::this_thread::sleep_for(std::chrono::milliseconds(800));
    ::kill(running.id, SIGINT);
    const Outcome outcome = finish(running);
    EXPECT_EQ(outcome.exit_code, 130);
    const Outcome status = run({"study", "status", folder / "out"});
    EXPECT_EQ(status.exit_code, 0);
    expect_has(status.out, " of 100000 points: ");
    const Outcome limited = run({"study", file, "--out", folder / "out", "--time-limit", "0.3", "--quiet"});
    EXPECT_EQ(limited.exit_code, 5);
    expect_has(run({"study", "export", folder / "out", "--sql", "SELECT 1"}).err, "not complete");
}

TEST(Study, ASecondProcessIsSentAway) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", quick(100000));
    Start how;
    how.arguments = {"study", file, "--out", folder / "out", "--quiet"};
    const Running first = start(how);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    const Outcome second = run(how);
    EXPECT_EQ(second.exit_code, 6);
    expect_has(second.err, "another process is running the study");
    expect_has(run({"study", "status", folder / "out"}).out, " of 100000 points: ");  // while the first one runs
    ::kill(first.id, SIGKILL);
    finish(first);
    EXPECT_EQ(run({"study", file, "--out", folder / "out", "--time-limit", "0.1", "--quiet"}).exit_code, 5);
}

TEST(Study, DataThatAnotherProgramHoldsLockedAreWaitedForThenNamed) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", quick(200));
    ASSERT_EQ(run({"study", file, "--out", folder / "out", "--time-limit", "0.01", "--quiet"}).exit_code, 5);
    Start how;
    how.arguments = {"study", file, "--out", folder / "out", "--quiet"};
    {
        SQLite::Database other(folder / "out/study.sqlite", SQLite::OPEN_READWRITE);
        other.exec("BEGIN EXCLUSIVE");
        const Outcome locked = run(how);
        EXPECT_EQ(locked.exit_code, 6);
        expect_has(locked.err, "another program holds it locked");
    }
    EXPECT_EQ(run(how).exit_code, 0);
}

TEST(Study, AFullDiskKeepsWhatWasDone) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", quick(2500));
    Start how;
    how.arguments = {"study", file, "--out", folder / "out", "--quiet"};
    how.largest_file = 130'000;
    const Outcome full = run(how);
    EXPECT_EQ(full.exit_code, 6) << full.err;
    expect_has(full.err, "study.sqlite");
    const Outcome status = run({"study", "status", folder / "out"});
    EXPECT_EQ(status.exit_code, 0) << status.err;
    expect_has(status.out, " of 2500 points: ");
    how.largest_file.reset();
    EXPECT_EQ(run(how).exit_code, 0);
    expect_has(run({"study", "status", folder / "out"}).out, "2500 points: 2500 solved");
}

TEST(Study, AFolderThatCannotBeWrittenIsNamed) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", quick(10));
    for (const std::string& where : {std::string("/proc/study"), file + "/below"}) {
        const Outcome outcome = run({"study", file, "--out", where});
        EXPECT_EQ(outcome.exit_code, 6);
        expect_has(outcome.err, where);
    }
}

TEST(Study, ChangedProblemsDoNotGoOn) {
    const TemporaryFolder folder;
    run({"study", folder.write("a.toml", quick(10)), "--out", folder / "out", "--quiet"});
    const Outcome other = run({"study", folder.write("a.toml", quick(11)), "--out", folder / "out"});
    EXPECT_EQ(other.exit_code, 6);
    expect_has(other.err, "holds another study");
}

/// A path whose points stand in a file of their own, planned, cut and merged.
TEST(Study, ChunksComeToTheDataOfTheWhole) {
    const TemporaryFolder folder;
    folder.write("data/points.csv", "3 3\n2.759 3.363\n2.372 3.663\n1.89 3.862\n1.355 3.943\n");
    const std::string file = folder.write("a.toml", R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground  = { min = 0, max = 50 }
crank   = { min = 0, max = 50 }
coupler = { min = 0, max = 50 }
rocker  = { min = 0, max = 50 }
point-along  = { min = -50, max = 50 }
point-across = { min = -50, max = 50 }
crank-start = { min = 0, max = 360 }
[path]
points_file  = "data/points.csv"
timing       = "prescribed"
crank_angles = [0, 15, 30, 45, 60]
[objective]
minimize = "path-sse"
[study]
quantities = ["path-sse"]
"dimensions.ground.max" = { from = 5, to = 50, count = 12 }
)");
    run({"study", file, "--out", folder / "whole", "--quiet"});
    const std::string whole = exported(folder / "whole");
    ASSERT_EQ(run({"study", "plan", file, "--out", folder / "cut", "--chunks", "3"}).exit_code, 0);
    EXPECT_EQ(run({"study", "plan", file, "--out", folder / "cut", "--chunks", "3"}).exit_code, 0);  // the same again
    EXPECT_EQ(run({"study", "plan", file, "--out", folder / "cut", "--chunks", "2"}).exit_code, 6);
    EXPECT_EQ(run({"study", "plan", file, "--out", folder / "no", "--chunks", "100"}).exit_code, 2);
    EXPECT_EQ(run({"study", "run", folder / "cut", "--chunk", "4"}).exit_code, 2);
    EXPECT_EQ(run({"study", "run", folder / "cut"}).exit_code, 2);
    const Outcome early = run({"study", "merge", folder / "cut"});
    EXPECT_EQ(early.exit_code, 5);
    expect_has(early.err, "3 of 3 chunks are missing: 1-3");

    ASSERT_EQ(run({"study", "run", folder / "cut", "--chunk", "2", "--quiet"}).exit_code, 0);
    const Outcome status = run({"study", "status", folder / "cut"});
    expect_has(status.out, "1 complete");
    expect_has(status.out, "--array=1,3 ");
    expect_has(status.out, "::: 1 3\n");
    for (const char* variable : {"SLURM_ARRAY_TASK_ID", "PARALLEL_SEQ"}) {
        Start how;
        how.arguments = {"study", "run", folder / "cut", "--quiet"};
        how.environment = {{variable, std::string(variable) == "PARALLEL_SEQ" ? "1" : "3"}};
        EXPECT_EQ(run(how).exit_code, 0);
    }
    const Outcome again = run({"study", "run", folder / "cut", "--chunk", "2"});
    EXPECT_EQ(again.exit_code, 0);
    expect_has(again.err, "chunk 2 is complete");
    EXPECT_EQ(run({"study", "merge", folder / "cut"}).exit_code, 0);
    EXPECT_EQ(exported(folder / "cut"), whole);

    folder.write("cut/data/points.csv", "3 3\n2.759 3.363\n2.372 3.663\n1.89 3.862\n1.355 3.9\n");
    expect_has(run({"study", "run", folder / "cut", "--chunk", "1"}).err, "is not that of the plan");
    folder.write("cut/plan.json", "{");
    EXPECT_EQ(run({"study", "merge", folder / "cut"}).exit_code, 6);
}

TEST(Study, ShowsItsProgressOnATerminal) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"study", folder.write("a.toml", quick(2000)), "--out", folder / "out"};
    how.err_on_terminal = true;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 0);
    expect_has(outcome.err, "/2000 points");
    expect_has(outcome.err, " a second");
    expect_has(outcome.err, " s left");
}

TEST(Study, DrawsItsCharts) {
    const TemporaryFolder folder;
    run({"study", folder.write("a.toml", searched), "--out", folder / "out", "--quiet"});
    const Outcome outcome = run({"study", "charts", folder / "out", "--png"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const std::string picture = folder / "out/charts/objective";
    EXPECT_EQ(outcome.out, picture + ".gnuplot\n" + picture + ".svg\n" + picture + ".png\n");
    EXPECT_EQ(count_files(folder.path / "out/charts"), 3u);
    Start how;
    how.arguments = {"study", "charts", folder / "out"};
    how.environment = {{"PATH", "/nowhere"}};
    const Outcome none = run(how);
    EXPECT_EQ(none.exit_code, 6);
    expect_has(none.err, "there is no gnuplot: install it");
}

TEST(Study, TellsWhatTolerancesDo) {
    const TemporaryFolder folder;
    const std::string file =
        folder.write("a.toml", given("\n[study]\ncount = 3000\n[study.tolerance]\nlengths = \"IT7\"\n"));
    const Outcome outcome = run({"study", file, "--out", folder / "out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"3000 samples, 3000 assemble", "predicted", "swing, deg", "Change per unit"})
        expect_has(outcome.out, part);
}

TEST(Study, DrivesForDakota) {
    const TemporaryFolder folder;
    const std::string problem = folder.write("p.toml", given());
    const std::string parameters =
        folder.write("params.in",
                     "1 variables\n41 dimensions.crank\n1 functions\n1 ASV_1:total-length\n1 derivative_variables\n"
                     "1 DVV_1:dimensions.crank\n0 analysis_components\n1 eval_id\n");
    const Outcome outcome = run({"study", "driver", problem, parameters, folder / "results.out"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_NEAR(std::stod(content_of(folder / "results.out")), 315.2, 1e-12);
    EXPECT_EQ(run({"study", "driver", problem, folder.write("bad.in", "nothing\n"), folder / "r"}).exit_code, 3);
    EXPECT_EQ(run({"study", "driver", problem, folder / "none.in", folder / "r"}).exit_code, 6);
}

}  // namespace
}  // namespace mechwright::testing
