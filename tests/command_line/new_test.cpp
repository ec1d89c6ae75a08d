// mechwright new: problem files from a few answers.

#include <signal.h>

#include <thread>

#include "synthesis/command_line/new/task.h"
#include "tests/command_line/program.h"
#include "tests/long_form.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

/// What a task makes of some answers, the others at their presets.
Outcome made(const std::string& mechanism, const std::string& task, const std::vector<std::string>& answers = {}) {
    std::vector<std::string> arguments{"new", "--mechanism", mechanism, "--task", task};
    for (const std::string& answer : answers)
        arguments.insert(arguments.end(), {"--set", answer});
    return run(arguments);
}

Outcome answered(const std::vector<std::string>& arguments, const std::string& in) {
    Start how;
    how.arguments = {"new"};
    how.arguments.insert(how.arguments.end(), arguments.begin(), arguments.end());
    how.in = in;
    return run(how);
}

Outcome typed(const std::vector<std::string>& arguments, const std::string& in) {
    Start how;
    how.arguments = {"new"};
    how.arguments.insert(how.arguments.end(), arguments.begin(), arguments.end());
    how.in = in;
    how.in_on_terminal = true;
    return run(how);
}

TEST(New, EveryTaskIsSolvedAndVerifiedWithItsPresets) {
    const TemporaryFolder folder;
    for (const Task& task : tasks()) {
        const std::string name = std::string(task.mechanism) + " " + std::string(task.name);
        const std::string file = folder / "problem.toml";
        const Outcome made =
            run({"new", "--mechanism", std::string(task.mechanism), "--task", std::string(task.name), "--force", file});
        ASSERT_EQ(made.exit_code, 0) << name << made.err;
        EXPECT_EQ(made.out, "");
        const Outcome checked = run({"check", file});
        EXPECT_EQ(checked.exit_code, 0) << name;
        EXPECT_EQ(checked.err, "") << name;
        // The longest searches begin at fewer places.
        const std::string text = content_of(file);
        if (!in_long_form() && text.find("[solver]") == std::string::npos)
            folder.write("problem.toml", text + "\n[solver]\nstarts = 1\n");
        const Outcome solved = run({"solve", "--quiet", "--json", file});
        EXPECT_EQ(solved.exit_code, 0) << name << solved.err;
        const auto result = parsed(solved.out);
        EXPECT_EQ(result["status"], "solved") << name;
        EXPECT_TRUE(result["verification"]["passed"]) << name;
    }
}

TEST(New, ThereIsATaskForEveryMechanism) {
    const std::vector<Task> all = tasks();
    for (const char* mechanism :
         {"four-bar", "slider-crank", "crank-shaper", "whitworth", "drag-link", "cam", "linkage"})
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Task& t) { return t.mechanism == mechanism; }))
            << mechanism;
}

/// A line of a made file is code, a comment, or code with a comment, and none is left with a place for an answer.
TEST(New, FilesAreCommentedAndWhole) {
    for (const Task& task : tasks()) {
        const std::string text = made(std::string(task.mechanism), std::string(task.name)).out;
        EXPECT_EQ(text.find('@'), std::string::npos) << text;
        EXPECT_EQ(text.rfind("# ", 0), 0u) << text;
        expect_has(text, "\n# mechwright draw --figure ");
        std::istringstream lines(text);
        for (std::string line; std::getline(lines, line);) {
            EXPECT_LE(line.size(), 120u) << line;
            const std::size_t comment = line.find(" # ");
            const std::string rest = comment == std::string::npos ? "" : line.substr(comment + 1);
            EXPECT_EQ(rest.find(" # "), std::string::npos) << line;
        }
    }
}

TEST(New, PutsTheAnswersWhereTheyBelong) {
    const std::string swing = made("four-bar", "swing", {"swing=45", "time-ratio=1.25", "ground=.5"}).out;
    for (const char* part : {"equal    = 45 ", "equal    = 1.25\n", "ground  = 0.5\n", "max = 2.5 }"})
        expect_has(swing, part);
    const std::string path = made("four-bar", "path", {"points=0 0; 10 5;20 0", "timing=none", "closed=false"}).out;
    for (const char* part : {"points = [[0, 0], [10, 5], [20, 0]]", "timing = \"none\"", "closed = false"})
        expect_has(path, part);
    const std::string cam =
        made("cam", "knife", {"segments=rise 90, return 90, dwell 180", "lift=12", "law=3-4-5"}).out;
    for (const char* part :
         {"kind  = \"rise\"\nangle = 90\nlift  = 12\nlaw   = \"3-4-5\"\n\n[[segment]]\nkind  = \"return\"",
          "kind  = \"dwell\"\nangle = 180\n\n[dimensions]"})
        expect_has(cam, part);
}

TEST(New, OtherAnswersAreSolvedToo) {
    const TemporaryFolder folder;
    const std::vector<std::string> asked{
        made("four-bar", "swing", {"swing=90", "time-ratio=1", "ground=7"}).out,
        made("slider-crank", "stroke", {"stroke=0.05"}).out,
        made("whitworth", "stroke", {"time-ratio=1.5", "stroke=1000"}).out,
        made("drag-link", "stroke", {"time-ratio=1.5", "stroke=80"}).out,
        made("crank-shaper", "stroke", {"time-ratio=1.4", "stroke=500"}).out,
        made("cam", "roller", {"lift=5", "law=modified-sine", "segments=rise 90, dwell 90, return 60, dwell 120"}).out,
        made("cam", "oscillating-roller", {"lift=15", "arm-length=30", "roller-radius=3"}).out,
        made("four-bar", "function", {"expression=log10(x)", "from=1", "to=2", "input=60"}).out};
    for (const std::string& problem : asked) {
        const Outcome solved = run({"solve", "--quiet", folder.write("a.toml", problem)});
        EXPECT_EQ(solved.exit_code, 0) << problem << solved.err << solved.out;
    }
}

TEST(New, TakesAnswersFromStandardInputOneALine) {
    const Outcome all = answered({}, "four-bar\nswing\n45\n\n120\n");
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_EQ(all.err, "");
    EXPECT_EQ(all.out, made("four-bar", "swing", {"swing=45", "ground=120"}).out);
    const Outcome rest = answered({"--mechanism", "slider-crank", "-"}, "stroke\n\n  1.3  \r\n");
    EXPECT_EQ(rest.exit_code, 0) << rest.err;
    EXPECT_EQ(rest.out, made("slider-crank", "stroke", {"time-ratio=1.3"}).out);
}

TEST(New, InputThatEndsTooSoonWritesNothing) {
    const TemporaryFolder folder;
    for (const char* in : {"", "four-bar\n", "four-bar\nswing\n60\n1.1\n"}) {
        const Outcome outcome = answered({folder / "a.toml"}, in);
        EXPECT_EQ(outcome.exit_code, 2);
        expect_has(outcome.err, "the input ended before the question");
        expect_has(outcome.err, "Nothing is written.");
        EXPECT_EQ(count_files(folder.path), 0u);
    }
}

TEST(New, AWrongAnswerOfAScriptIsRefused) {
    const Outcome outcome = answered({}, "four-bar\nswing\nwide\n");
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, "Swing of the rocker, deg: 'wide' is not a number");
}

TEST(New, OnATerminalAsksAgainUntilTheAnswerIsRight) {
    const TemporaryFolder folder;
    const std::string file = folder / "a.toml";
    const Outcome outcome = typed({file}, "for-bar\nfour-bar\n\nwide\n500\n50\n0.5\n1.2\n\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    for (const char* part :
         {"Mechanism (four-bar, slider-crank", "did you mean 'four-bar'?", "Task (swing, path",
          "a coupler point through given points", "Swing of the rocker, deg [60]: ", "'wide' is not a number",
          "it must be 175 at most", "it must be 1 at least", "mechwright solve"})
        expect_has(outcome.err, part);
    EXPECT_EQ(content_of(file), made("four-bar", "swing", {"swing=50", "time-ratio=1.2"}).out);
}

TEST(New, OnATerminalAnswersThatDoNotGoTogetherAreAskedForOnceMore) {
    const Outcome outcome = typed({"--mechanism", "four-bar"}, "function\nx^^2\n\n\n\n\nx^2\n\n\n\n\n");
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    for (const char* part : {"That does not go together:", "expression", "Once more:"})
        expect_has(outcome.err, part);
    EXPECT_EQ(outcome.out, made("four-bar", "function", {"expression=x^2"}).out);
}

TEST(New, OnATerminalTheEndOfInputWritesNothing) {
    const TemporaryFolder folder;
    const Outcome outcome = typed({folder / "a.toml"}, "four-bar\nswing\n\x04");
    EXPECT_EQ(outcome.exit_code, 2);
    expect_has(outcome.err, "the input ended before the question");
    EXPECT_EQ(count_files(folder.path), 0u);
}

TEST(New, AnInterruptLeavesNothingBehind) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"new", folder / "a.toml"};
    how.in = "four-bar\n";
    how.in_on_terminal = true;
    const Running running = start(how);
    std::this_thread::sleep_for(std::chrono::milliseconds(500));
    ::kill(running.id, SIGINT);
    EXPECT_EQ(finish(running).killed_by, SIGINT);
    EXPECT_EQ(count_files(folder.path), 0u);
}

TEST(New, DoesNotOverwriteUnlessForced) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", "mine");
    const std::vector<std::string> arguments{"new", "--mechanism", "cam", "--task", "flat", file};
    const Outcome refused = run(arguments);
    EXPECT_EQ(refused.exit_code, 6);
    expect_has(refused.err, "exists; --force replaces it");
    EXPECT_EQ(content_of(file), "mine");
    auto forced = arguments;
    forced.push_back("--force");
    EXPECT_EQ(run(forced).exit_code, 0);
    EXPECT_EQ(content_of(file), made("cam", "flat").out);
    EXPECT_EQ(run({"new", "--mechanism", "cam", "--task", "flat", folder / "missing/a.toml"}).exit_code, 6);
    EXPECT_EQ(count_files(folder.path), 1u);
}

TEST(New, UnknownNamesAndValuesAreAnsweredWithARemedy) {
    const auto refused = [](const Outcome& outcome, const std::string& why) {
        EXPECT_EQ(outcome.exit_code, 2);
        EXPECT_EQ(outcome.out, "");
        expect_has(outcome.err, why);
    };
    refused(made("for-bar", "swing"), "did you mean 'four-bar'?");
    refused(made("four-bar", "swin"), "did you mean 'swing'?");
    refused(made("four-bar", "swing", {"swng=3"}), "did you mean 'swing'?");
    refused(made("four-bar", "swing", {"swing"}), "write NAME=VALUE");
    refused(made("four-bar", "swing", {"swing=0"}), "it must be 1 at least");
    refused(made("four-bar", "swing", {"swing=nan"}), "'nan' is not a number");
    refused(made("four-bar", "path", {"points=0 0"}), "give two or more");
    refused(made("four-bar", "path", {"points=0 0; 1"}), "is not 2 numbers");
    refused(made("four-bar", "path", {"points=0 0; 0 0; 1 1"}), "Nothing is written.");
    refused(made("four-bar", "poses", {"poses=0 0 0; 1 1 x"}), "'x' is not a number");
    refused(made("four-bar", "function", {"expression=x\"\n[solver]"}), "give an expression in x");
    refused(made("four-bar", "function", {"expression=y"}), "Nothing is written.");
    refused(made("cam", "roller", {"law=cyclodal"}), "did you mean 'cycloidal'?");
    refused(made("cam", "roller", {"segments=rise 90, return 90"}), "must add up to 360 deg, not to 180");
    refused(made("cam", "roller", {"segments=rise 180, dwell 180"}), "a return is missing");
    refused(made("cam", "roller", {"segments=return 180, rise 180"}), "a rise first");
    refused(made("cam", "roller", {"segments=raise 180, return 180"}), "did you mean 'rise'?");
    refused(made("cam", "roller", {"segments=rise, return 180"}), "is not a segment");
    refused(run({"new", "--mechanism", "cam", "--set", "lift=3"}), "--set needs --mechanism and --task");
}

TEST(New, ListsTasksAndAnswers) {
    const Outcome list = run({"new", "--list"});
    EXPECT_EQ(list.exit_code, 0);
    for (const Task& task : tasks()) {
        expect_has(list.out, std::string(task.mechanism) + " " + std::string(task.name) + ": ");
        for (const Question& question : task.questions)
            expect_has(list.out, "\n  " + std::string(question.name) + " ");
    }
    std::istringstream lines(list.out);
    for (std::string line; std::getline(lines, line);)
        EXPECT_LE(line.size(), 80u) << line;
}

}  // namespace
}  // namespace mechwright::testing
