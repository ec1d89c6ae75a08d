// What the command line accepts, and what it says about itself.

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

TEST(Usage, HelpGoesToStandardOutput) {
    const Outcome help = run({"--help"});
    EXPECT_EQ(help.exit_code, 0);
    EXPECT_EQ(help.err, "");
    for (const char* part :
         {"check", "solve", "compare", "analyse", "structure", "profile", "verify", "quantities", "methods", "new",
          "explain", "completion", "--version", "Exit codes", "130", "With several files"})
        expect_has(help.out, part);
    const Outcome of_solve = run({"solve", "--help"});
    EXPECT_EQ(of_solve.exit_code, 0);
    for (const char* part : {"--out DIR", "--csv", "--json", "--seed", "--jobs", "--time-limit", "--method", "--quiet"})
        expect_has(of_solve.out, part);
}

TEST(Usage, HelpFitsEightyColumns) {
    for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--help"},
                                                      {"solve", "--help"},
                                                      {"compare", "--help"},
                                                      {"check", "--help"},
                                                      {"analyse", "--help"},
                                                      {"structure", "--help"},
                                                      {"profile", "--help"},
                                                      {"verify", "--help"},
                                                      {"quantities", "--help"},
                                                      {"new", "--help"},
                                                      {"explain", "--help"},
                                                      {"completion", "--help"},
                                                      {"methods", "--help"}}) {
        std::istringstream lines(run(arguments).out);
        for (std::string line; std::getline(lines, line);)
            EXPECT_LE(line.size(), 80u) << line;
    }
}

TEST(Usage, VersionNamesTheLibraries) {
    const Outcome version = run({"--version"});
    EXPECT_EQ(version.exit_code, 0);
    EXPECT_EQ(version.out.rfind("mechwright ", 0), 0u) << version.out;
    for (const char* library : {"Ipopt 3.", "NLopt 2.", "Eigen 3."})
        expect_has(version.out, library);
}

TEST(Usage, WithoutACommandHelpGoesToStandardError) {
    const Outcome nothing = run(std::vector<std::string>{});
    EXPECT_EQ(nothing.exit_code, 2);
    EXPECT_EQ(nothing.out, "");
    expect_has(nothing.err, "solve");
}

TEST(Usage, UnknownCommandsAreNamedWithTheNearest) {
    const Outcome outcome = run({"slove", "x.toml"});
    EXPECT_EQ(outcome.exit_code, 2);
    expect_has(outcome.err, "unknown command 'slove'; did you mean 'solve'?");
}

TEST(Usage, UnknownOptionsAreNamedWithTheNearest) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    const auto told = [&](const std::vector<std::string>& words) {
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.exit_code, 2);
        return outcome.err;
    };
    expect_has(told({"solve", file, "--quite"}), "unknown option '--quite'; did you mean '--quiet'?");
    expect_has(told({"solve", file, "--sed=3"}), "unknown option '--sed=3'; did you mean '--seed'?");
    expect_has(told({"study", "export", "nowhere", "--jsn"}), "unknown option '--jsn'; did you mean '--json'?");
    expect_has(told({"quantities", "--bogus-option"}),
               "unknown option '--bogus-option'; known are --help, --about, --json");
    expect_has(told({"quantities", "four-bar", "swing"}), "not expected: swing");
}

TEST(Usage, WrongOptionsEndWithTwo) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    const std::vector<std::vector<std::string>> wrong{
        {"--bogus"},
        {"solve"},
        {"check"},
        {"analyse"},
        {"verify"},
        {"solve", file, "--bogus"},
        {"solve", file, "--seed"},
        {"solve", file, "--seed", "-1"},
        {"solve", file, "--seed", "1.5"},
        {"solve", file, "--seed", "0x10"},
        {"solve", file, "--seed", "99999999999999999999"},
        {"solve", file, "--seed", "1", "--seed", "2"},
        {"solve", file, "--jobs", "0"},
        {"solve", file, "--jobs", "many"},
        {"solve", file, "--jobs", "100000"},
        {"solve", file, "--time-limit", "0"},
        {"solve", file, "--time-limit", "-5"},
        {"solve", file, "--time-limit", "nan"},
        {"solve", file, "--time-limit", "inf"},
        {"solve", file, "--time-limit", "1e400"},
        {"solve", file, "--time-limit", "1,5"},
        {"solve", file, "--csv"},
        {"solve", file, "--out", ""},
        {"solve", file, "--method", ""},
        {"analyse", file, "--steps", "10"},
        {"analyse", file, "--csv", "--steps", "0"},
        {"analyse", file, "--csv", "--steps", "1000001"},
        {"analyse", file, "--csv", "--json"},
        {"analyse", file, file},
        {"quantities", "four-bar", "four-bar"},
    };
    for (const auto& arguments : wrong) {
        const Outcome outcome = run(arguments);
        EXPECT_EQ(outcome.exit_code, 2) << arguments.front() << " ... " << arguments.back() << "\n" << outcome.err;
        EXPECT_EQ(outcome.out, "");
        EXPECT_EQ(outcome.err.rfind("mechwright: ", 0), 0u) << outcome.err;
    }
}

TEST(Usage, AnUnknownMethodIsAnsweredWithTheKnownOnes) {
    const TemporaryFolder folder;
    const Outcome outcome = run({"solve", "--method", "sqslp", folder.write("a.toml", crank_rocker())});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    for (const char* part : {"unknown method 'sqslp'", "auto", "slsqp"})
        expect_has(outcome.err, part);
}

TEST(Usage, AMethodThatDoesNotApplyIsRefusedWithTheReason) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", long_search());
    const Outcome outcome = run({"solve", "--method", "closed-form", file});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, "method 'closed-form' cannot be used here: ");
}

TEST(Usage, FilesMayBeNamedLikeCommandsOrOptions) {
    const TemporaryFolder folder;
    EXPECT_EQ(run({"check", "solve"}).exit_code, 6);
    const Outcome dashed = run({"check", "--", "--quiet"});
    EXPECT_EQ(dashed.exit_code, 6);
    expect_has(dashed.err, "--quiet: ");
}

}  // namespace
}  // namespace mechwright::testing
