// mechwright completion and mechwright man-page: the shells complete, and nothing is missing.

#include <sys/wait.h>

#include <cstdio>
#include <regex>
#include <set>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

struct ShellOutcome {
    int exit_code = -1;
    std::string out;  ///< with what it says on standard error
};

ShellOutcome shell(const std::string& line) {
    ShellOutcome outcome;
    FILE* pipe = ::popen((line + " 2>&1").c_str(), "r");
    if (pipe == nullptr) return outcome;
    for (int c = std::fgetc(pipe); c != EOF; c = std::fgetc(pipe))
        outcome.out += static_cast<char>(c);
    const int status = ::pclose(pipe);
    if (WIFEXITED(status)) outcome.exit_code = WEXITSTATUS(status);
    return outcome;
}

bool installed(const std::string& program) { return shell("command -v " + program).exit_code == 0; }

std::string script_for(const std::string& shell) {
    const Outcome outcome = run({"completion", shell});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
}

/// A folder with files to complete, and the script for bash.
struct Bash {
    TemporaryFolder folder;

    Bash() {
        folder.write("completion.bash", script_for("bash"));
        for (const char* name : {"one.toml", "two words.toml", "result.json", "other.txt", "sub/three.toml"})
            folder.write(name, "");
    }

    /// What the words of a command line, the last of them unfinished, can be completed to.
    std::set<std::string> completed(const std::vector<std::string>& words) const {
        std::string line = "source ./completion.bash; COMP_WORDS=(mechwright";
        for (const std::string& word : words)
            line += " '" + word + "'";
        line += "); COMP_CWORD=" + std::to_string(words.size()) + "; _mechwright; printf \"%s\\n\" \"${COMPREPLY[@]}\"";
        folder.write("line.bash", line);
        const ShellOutcome outcome = shell("cd '" + folder.path.string() + "' && bash --norc --noprofile line.bash");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
        std::set<std::string> found;
        std::istringstream lines(outcome.out);
        for (std::string one; std::getline(lines, one);)
            if (!one.empty()) found.insert(one);
        return found;
    }
};

using Set = std::set<std::string>;

TEST(Completion, OfBashKnowsCommandsOptionsAndNames) {
    const Bash bash;
    EXPECT_EQ(bash.completed({"so"}), Set{"solve"});
    EXPECT_EQ(bash.completed({"s"}), (Set{"schema", "solve", "structure", "study", "start-system"}));
    EXPECT_EQ(bash.completed({"--v"}), Set{"--version"});
    EXPECT_EQ(bash.completed({"man"}), Set{});
    EXPECT_EQ(bash.completed({"solve", "--me"}), Set{"--method"});
    EXPECT_EQ(bash.completed({"solve", "--method", "b"}), Set{"branch-and-bound"});
    EXPECT_EQ(bash.completed({"solve", "--quiet", "--seed", "3", "--j"}), (Set{"--json", "--jobs"}));
    EXPECT_EQ(bash.completed({"study", "e"}), Set{"export"});
    EXPECT_EQ(bash.completed({"study", "export", "--s"}), Set{"--sql"});
    EXPECT_EQ(bash.completed({"study", "--quiet", "run", "--ch"}), Set{"--chunk"});
    EXPECT_EQ(bash.completed({"quantities", "four"}), Set{"four-bar"});
    EXPECT_EQ(bash.completed({"explain", "swi"}), Set{"swing"});
    EXPECT_EQ(bash.completed({"explain", "stroke", "wh"}), Set{"whitworth"});
    EXPECT_EQ(bash.completed({"explain", "stroke", "whitworth", ""}), Set{});
    EXPECT_EQ(bash.completed({"completion", ""}), (Set{"bash", "zsh", "fish"}));
    EXPECT_EQ(bash.completed({"schema", ""}), (Set{"problem", "result"}));
    EXPECT_EQ(bash.completed({"new", "--mechanism", "d"}), Set{"drag-link"});
    EXPECT_EQ(bash.completed({"start-system", "n"}), Set{"nine-point"});
}

TEST(Completion, OfBashKnowsWhichFilesACommandTakes) {
    const Bash bash;
    EXPECT_EQ(bash.completed({"solve", ""}), (Set{"one.toml", "two words.toml", "sub"}));
    EXPECT_EQ(bash.completed({"solve", "one.toml", "t"}), Set{"two words.toml"});
    EXPECT_EQ(bash.completed({"check", "sub/"}), Set{"sub/three.toml"});
    EXPECT_EQ(bash.completed({"verify", ""}), (Set{"result.json", "sub"}));
    EXPECT_EQ(bash.completed({"profile", "o"}), Set{"one.toml"});
    EXPECT_EQ(bash.completed({"solve", "--out", ""}), Set{"sub"});
    EXPECT_EQ(bash.completed({"study", "status", ""}), Set{"sub"});
    EXPECT_EQ(bash.completed({"study", "o"}), Set{"one.toml"});
    EXPECT_EQ(bash.completed({"study", "driver", "one.toml", "oth"}), Set{"other.txt"});
    EXPECT_EQ(bash.completed({"solve", "--seed", ""}), Set{});
}

TEST(Completion, OfZshIsAScript) {
    if (!installed("zsh")) GTEST_SKIP() << "there is no zsh here";
    const TemporaryFolder folder;
    const std::string file = folder.write("_mechwright", script_for("zsh"));
    const ShellOutcome outcome = shell("zsh -f -n '" + file + "'");
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_EQ(outcome.out, "");
    const ShellOutcome loaded = shell("zsh -f -c 'compdef() { echo $* }; source \"" + file +
                                      "\"; whence -w _mechwright _mechwright_solve _mechwright_study_export'");
    EXPECT_EQ(loaded.out,
              "_mechwright mechwright\n_mechwright: function\n_mechwright_solve: function\n_mechwright_study_export: "
              "function\n");
}

/// A pattern that zsh takes for qualifiers of another would end a completion without a word.
TEST(Completion, OfZshNamesFilesByPatternsThatItUnderstands) {
    if (!installed("zsh")) GTEST_SKIP() << "there is no zsh here";
    const TemporaryFolder folder;
    const std::vector<std::string> names{"a.toml", "b.json", "c.html", "d.svg", "e.png",
                                         "f.pdf",  "g.dxf",  "h.slvs", "i.csv"};
    for (const std::string& name : names)
        folder.write(name, "");
    const std::string script = script_for("zsh");
    const std::regex pattern("_files -g (\"[^\"]+\")");
    Set found;
    for (std::sregex_iterator i(script.begin(), script.end(), pattern); i != std::sregex_iterator(); ++i) {
        const ShellOutcome outcome =
            shell("cd '" + folder.path.string() + "' && zsh -f -c 'p=" + i->str(1) + "; print -r -- ${~p}'");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
        found.insert(outcome.out);
    }
    EXPECT_EQ(found, (Set{"a.toml\n", "b.json\n", "a.toml b.json\n", "c.html\n", "d.svg e.png f.pdf\n",
                          "b.json g.dxf h.slvs i.csv\n"}));
}

TEST(Completion, OfFishKnowsCommandsOptionsAndNames) {
    if (!installed("fish")) GTEST_SKIP() << "there is no fish here";
    const TemporaryFolder folder;
    const std::string file = folder.write("mechwright.fish", script_for("fish"));
    const auto completed = [&](const std::string& line) {
        const ShellOutcome outcome = shell("HOME='" + folder.path.string() + "' fish --no-config -c 'source " + file +
                                           "; complete -C \"" + line + "\"'");
        EXPECT_EQ(outcome.exit_code, 0) << outcome.out;
        Set found;
        std::istringstream lines(outcome.out);
        for (std::string one; std::getline(lines, one);)
            found.insert(one.substr(0, one.find('\t')));
        return found;
    };
    EXPECT_EQ(completed("mechwright so"), Set{"solve"});
    EXPECT_EQ(completed("mechwright solve --meth"), Set{"--method"});
    EXPECT_EQ(completed("mechwright solve --method b"), Set{"branch-and-bound"});
    EXPECT_EQ(completed("mechwright explain swi"), Set{"swing"});
    EXPECT_EQ(completed("mechwright study exp"), Set{"export"});
    EXPECT_EQ(completed("mechwright study export --s"), Set{"--sql"});
    EXPECT_EQ(completed("mechwright export --s"), Set{"--steps"});
}

TEST(Completion, OfAnUnknownShell) {
    const Outcome outcome = run({"completion", "tcsh"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_EQ(outcome.out, "");
    expect_has(outcome.err, "unknown shell 'tcsh'; known are bash, zsh, fish");
}

/// The commands that a help lists.
std::vector<std::string> commands_in(const std::string& help) {
    std::vector<std::string> names;
    std::istringstream lines(help);
    bool listing = false;
    for (std::string line; std::getline(lines, line);) {
        if (line.ends_with("ommands:")) listing = true;
        if (line.empty()) listing = false;
        if (listing && line.starts_with("  ") && line[2] != ' ') names.push_back(line.substr(2, line.find(' ', 2) - 2));
    }
    return names;
}

TEST(ManPage, HasEveryCommandAndOption) {
    const Outcome page = run({"man-page"});
    EXPECT_EQ(page.exit_code, 0);
    // As it is read: without roff's own.
    const std::string text = std::regex_replace(page.out, std::regex(R"(\\(f[BIR]|(?=-)))"), "");
    const auto expect_options = [&](std::vector<std::string> arguments) {
        std::string heading = "mechwright";
        for (const std::string& argument : arguments)
            heading += " " + argument;
        expect_has(text, heading);
        arguments.push_back("--help");
        const std::string help = run(arguments).out;
        const std::regex option("--[a-z][a-z-]*");
        for (std::sregex_iterator i(help.begin(), help.end(), option); i != std::sregex_iterator(); ++i)
            expect_has(text, i->str());
        return help;
    };
    const std::vector<std::string> commands = commands_in(expect_options({}));
    EXPECT_GE(commands.size(), 13u);
    std::size_t below = 0;
    for (const std::string& command : commands) {
        if (command == "bench") continue;  // its options are those of another program
        for (const std::string& other : commands_in(expect_options({command}))) {
            expect_options({command, other});
            ++below;
        }
    }
    EXPECT_GE(below, 7u);
    for (const char* part : {"EXIT STATUS", "\n130\n", "NO_COLOR", "ENVIRONMENT", "FILES", "EXAMPLES"})
        expect_has(text, part);
}

TEST(ManPage, IsFaultless) {
    if (!installed("groff")) GTEST_SKIP() << "there is no groff here";
    const TemporaryFolder folder;
    const std::string file = folder.write("mechwright.1", run({"man-page"}).out);
    const ShellOutcome warnings = shell("groff -man -Tascii -ww -z '" + file + "'");
    EXPECT_EQ(warnings.exit_code, 0);
    EXPECT_EQ(warnings.out, "");
    const ShellOutcome page = shell("groff -man -Tascii -P-cbou '" + file + "'");
    for (const char* part : {"mechwright solve FILE...", "--time-limit X", "mechwright study export DIR"})
        expect_has(page.out, part);
}

TEST(ManPage, IsNoCommandThatHelpShows) { expect_has_not(run({"--help"}).out, "man-page"); }

}  // namespace
}  // namespace mechwright::testing
