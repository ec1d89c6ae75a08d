// mechwright solve

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

TEST(Solve, PrintsASummary) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"solve", folder.write("a.toml", crank_rocker())});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    for (const char* part : {"Crank-rocker of 60 deg swing", "Solved: ", "Design: crank-rocker", "Objective: maximize",
                             "Requirements", "met", "Verification: ", "Search: "})
        expect_has(outcome.out, part);
    expect_has_not(outcome.out, "\x1b");
}

TEST(Solve, JsonIsTheDocumentAlone) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    const Outcome outcome = run({"solve", "--json", file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    const Json json = parsed(outcome.out);
    EXPECT_EQ(json["schema"], 1);
    EXPECT_EQ(json["problem"]["file"], file);
    EXPECT_EQ(json["status"], "solved");
    EXPECT_EQ(json["verification"]["passed"], true);
    EXPECT_NEAR(json["quantities"]["time-ratio"], 1.2, 1e-8);
    EXPECT_NEAR(json["quantities"]["swing"], 60, 1e-7);
}

/// Between the targets the transmission angle is better than over the whole turn: the text says how to ask for that.
TEST(Solve, SaysThatARequirementIsOverMoreThanTheTargetsUse) {
    const TemporaryFolder folder;
    const std::string text =
        "schema = 1\nmechanism = 'four-bar'\n[dimensions]\nground = 100\ncrank = 40\ncoupler = 90\nrocker = 80\n"
        "point-along = 30\npoint-across = 20\norigin-x = 0\norigin-y = 0\ntilt = 0\n[path]\n"
        "points = [[60, 60], [40, 70]]\ntiming = 'free'\n[[require]]\nquantity = 'transmission-angle-worst'\nmin = 50\n"
        "[solver]\nstarts = 4\n";
    const Outcome whole = run({"solve", folder.write("whole.toml", text)});
    EXPECT_EQ(whole.exit_code, 4) << whole.err;
    expect_has(whole.out, "from = \"first-target\"");
    const std::string use = text + "[motion]\nfrom = 'first-target'\nto = 'last-target'\n";
    const Outcome between = run({"solve", folder.write("between.toml", use)});
    EXPECT_EQ(between.exit_code, 0) << between.out << between.err;
    expect_has_not(between.out, "asks for it");
}

TEST(Solve, SeveralFilesGiveAListAndInTheirOrder) {
    const TemporaryFolder folder;
    const std::string a = folder.write("a.toml", crank_rocker());
    const std::string b = folder.write("b.toml", impossible);
    const Outcome outcome = run({"solve", "--json", b, a});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    const Json json = parsed(outcome.out);
    ASSERT_TRUE(json.is_array());
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(json[0]["problem"]["file"], b);
    EXPECT_EQ(json[0]["status"], "infeasible");
    EXPECT_EQ(json[1]["status"], "solved");
    EXPECT_EQ(outcome.err, "2 problems: 1 solved, 1 infeasible\n");
    EXPECT_EQ(run({"solve", "--json", "--quiet", b, a}).err, "");
}

TEST(Solve, OfSeveralFilesTheGoodOnesAreSolved) {
    const TemporaryFolder folder;
    const std::string good = folder.write("good.toml", crank_rocker());
    const std::string invalid = folder.write("invalid.toml", "schema = 1\n");
    const Outcome outcome = run({"solve", "--json", invalid, good});
    EXPECT_EQ(outcome.exit_code, 3);
    const Json json = parsed(outcome.out);
    ASSERT_EQ(json.size(), 1u);
    EXPECT_EQ(json[0]["problem"]["file"], good);
    expect_has(outcome.err, invalid + ":");
    expect_has(outcome.err, "2 problems: 1 solved, 1 not solved");
    const Outcome none = run({"solve", "--json", invalid, folder / "missing.toml"});
    EXPECT_EQ(none.exit_code, 6);
    EXPECT_EQ(none.out, "[]\n");
}

TEST(Solve, AnInfeasibleProblemShowsHowCloseItCame) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", impossible);
    const Outcome outcome = run({"solve", file});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    for (const char* part : {"Infeasible: ", "closest", "Design: ", "swing", "missed by"})
        expect_has(outcome.out, part);
    const Json json = parsed(run({"solve", "--json", file}).out);
    EXPECT_EQ(json["status"], "infeasible");
    EXPECT_TRUE(json["design"].contains("crank"));
    EXPECT_GT(json["requirements"][0]["violation"], 0.1);
    EXPECT_FALSE(json.contains("verification"));
}

/// A crank that moves five rockers by rods too short to reach them, each on either side: 32 assemblies, of which none
/// closes anywhere.
TEST(Solve, WhereNothingAssemblesInAnyOfManyAssembliesIsSaid) {
    std::string links = "crank = { A = [0, 0], B = [30, 0] }\n", pivots, sides;
    for (const char* k : {"1", "2", "3", "4", "5"}) {
        const std::string number = k;
        pivots += ", D" + number + " = [100, " + number + "0]";
        links += "rod-" + number + " = { B = [0, 0], C" + number + " = [\"rod\", 0] }\nrocker-" + number + " = { D" +
                 number + " = [0, 0], C" + number + " = [60, 0], T" + number + " = [80, 0] }\n";
        sides += "C" + number + " = \"either\"\n";
    }
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.toml",
        "schema = 1\nmechanism = \"linkage\"\n[dimensions]\nrod = { min = 4, max = 5 }\n[links]\nframe = { A = [0, 0]" +
            pivots + " }\n" + links + "[drive]\nlink = \"crank\"\n[assembly]\n" + sides +
            "[path]\npoint = \"T5\"\npoints = [[40, 20], [50, 40]]\nclosed = true\n[objective]\nminimize = "
            "\"path-rms\"\n[solver]\nstarts = 1\n");
    const Outcome outcome = run({"solve", file});
    EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    expect_has(outcome.out, "Infeasible: no design that meets all requirements was found");
    expect_has(outcome.out, "none of the candidates that were drawn assembles");
}

TEST(Solve, ATimeLimitEndsWithFiveAndTheBestSoFar) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", long_search());
    const Outcome outcome = run({"solve", "--json", "--time-limit", "2", file});
    EXPECT_EQ(outcome.exit_code, 5) << outcome.err;
    const Json json = parsed(outcome.out);
    EXPECT_EQ(json["status"], "limit");
    EXPECT_TRUE(json.contains("design"));
    EXPECT_LT(json["search"]["seconds"], 30.0);
    expect_has(run({"solve", "--time-limit", "2", file}).out, "Limit: stopped before the search ended");
}

TEST(Solve, OptionsOverrideTheFile) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker("[solver]\nseed = 3\nmethod = \"magic\"\n"));
    const Outcome outcome = run({"solve", "--json", "--seed", "42", "--method", "slsqp", file});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    const Json json = parsed(outcome.out);
    EXPECT_EQ(json["search"]["seed"], 42);
    EXPECT_EQ(json["search"]["method"], "slsqp");
}

TEST(Solve, JobsDoNotChangeASingleByte) {
    const TemporaryFolder folder;
    std::string text = long_search();
    text.replace(text.find("starts = 100000"), 15, "starts = 21");
    const std::string path = folder.write("path.toml", text);
    const std::string crank = folder.write("crank.toml", crank_rocker("[solver]\nmethod = \"slsqp\"\n"));
    const auto with_jobs = [&](const std::string& jobs) {
        const Outcome outcome = run({"solve", "--json", "--time-limit", "1000", "--jobs", jobs, path, crank});
        EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
        return without_times(parsed(outcome.out)).dump();
    };
    const std::string one = with_jobs("1");
    EXPECT_EQ(with_jobs("2"), one);
    EXPECT_EQ(with_jobs("7"), one);
}

TEST(Solve, TheLocaleDoesNotMatter) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"solve", "--json", folder.write("a.toml", crank_rocker()), "--time-limit", "59.5"};
    const std::string plain = without_times(parsed(run(how).out)).dump();
    how.environment = {{"LC_ALL", "de_DE.UTF-8"}, {"LANG", "de_DE"}, {"LC_NUMERIC", "de_DE"}};
    EXPECT_EQ(without_times(parsed(run(how).out)).dump(), plain);
}

TEST(Solve, AGivenDesignIsJudged) {
    const TemporaryFolder folder;
    const std::string met = "[[require]]\nquantity = \"swing\"\nmin = 61\nmax = 62\n";
    EXPECT_EQ(run({"solve", folder.write("a.toml", given(met))}).exit_code, 0);
    const std::string missed = "[[require]]\nquantity = \"swing\"\nmin = 70\n";
    const std::string file = folder.write("b.toml", given(missed));
    const Outcome outcome = run({"solve", file});
    EXPECT_EQ(outcome.exit_code, 4);
    expect_has(outcome.out, "70 deg and is 61.41 deg: off by 8.587 deg");
    expect_has(run({"solve", file, "--digits", "8"}).out, "70 deg and is 61.413062 deg: off by 8.586938 deg");
    EXPECT_EQ(run({"solve", file, "--digits", "1"}).exit_code, 2);
}

}  // namespace
}  // namespace mechwright::testing
