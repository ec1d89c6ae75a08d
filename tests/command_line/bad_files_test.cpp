// Problem files that cannot be solved because of what stands in them, or because they cannot be read.

#include <algorithm>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

struct BadFile {
    const char* name;
    std::string text;
    const char* message;  ///< part of what is said
};

/// The example with one line put in place of another.
std::string with(const std::string& line, const std::string& instead) {
    std::string text = crank_rocker();
    const std::size_t at = text.find(line);
    EXPECT_NE(at, std::string::npos) << line;
    return text.replace(at, line.size(), instead);
}

std::vector<BadFile> bad_files() {
    const std::string ground = "ground  = 100.0";
    return {
        {"empty", "", "schema"},
        {"not TOML", "this is not a problem file\n", "bad_file.toml:1:"},
        {"binary",
         std::string("\x7f"
                     "ELF\0\1\2\3\xff\xfe",
                     10),
         "bad_file.toml:"},
        {"unknown key", crank_rocker("[solvers]\nstarts = 3\n"), "did you mean 'solver'"},
        {"unknown dimension", with("rocker  =", "roker   ="), "did you mean 'rocker'"},
        {"duplicate key", with(ground, ground + "\n" + ground), "ground"},
        {"wrong type", with(ground, "ground = \"long\""), "ground"},
        {"negative length", with(ground, "ground = -100.0"), "ground"},
        {"zero length", with(ground, "ground = 0"), "ground"},
        {"min > max", with("min = 5, max = 60", "min = 60, max = 5"), "crank"},
        {"start outside", with("min = 5, max = 60", "min = 5, max = 60, start = 70"), "start"},
        {"NaN", with(ground, "ground = nan"), "ground"},
        {"infinity", with(ground, "ground = inf"), "ground"},
        {"1e400", with(ground, "ground = 1e400"), "bad_file.toml:6:"},
        {"missing dimension", with(ground, ""), "ground"},
        {"unknown mechanism", with("four-bar", "five-bar"), "unknown mechanism 'five-bar'"},
        {"unknown quantity", with("\"swing\"", "\"swinng\""), "did you mean 'swing'"},
        {"requirement on a missing path", with("\"swing\"", "\"path-rms\""), "path"},
        {"requirement that nothing meets", with("equal    = 60", "min = 70\nmax = 60"), "min"},
        {"unknown method", crank_rocker("[solver]\nmethod = \"magic\"\n"), "unknown method 'magic'"},
        {"newer schema", with("schema    = 1", "schema = 2"), "schema"},
        {"empty point list", given("[path]\npoints = []\n"), "empty point list"},
        {"coinciding points", given("[path]\npoints = [[1, 2], [1, 2], [3, 4]]\n"), "points"},
    };
}

TEST(BadFiles, AreInvalidForEveryCommand) {
    const TemporaryFolder folder;
    for (const BadFile& bad : bad_files()) {
        const std::string file = folder.write("bad_file.toml", bad.text);
        const std::vector<std::vector<std::string>> commands{
            {"check", file}, {"solve", file}, {"solve", "--json", file}, {"solve", "--out", folder / "out", file}};
        for (const auto& command : commands) {
            const Outcome outcome = run(command);
            EXPECT_EQ(outcome.exit_code, 3) << bad.name << ": " << outcome.err;
            EXPECT_EQ(outcome.out, "") << bad.name;
            EXPECT_EQ(outcome.err.rfind(file + ":", 0), 0u) << bad.name << ": " << outcome.err;
            expect_has(outcome.err, bad.message);
        }
        EXPECT_FALSE(std::filesystem::exists(folder.path / "out" / "bad_file.json")) << bad.name;
    }
}

TEST(BadFiles, AllErrorsAreReportedInTheirOrder) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.toml",
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = -1\ncrank = 0\ncoupler = 1\nroker = 2\n");
    const Outcome outcome = run({"check", file});
    EXPECT_EQ(outcome.exit_code, 3);
    EXPECT_GE(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 3) << outcome.err;
    EXPECT_LT(outcome.err.find(file + ":4:"), outcome.err.find(file + ":5:")) << outcome.err;
    EXPECT_LT(outcome.err.find(file + ":5:"), outcome.err.find(file + ":7:")) << outcome.err;
}

TEST(BadFiles, PointTablesThatCannotBeUnderstood) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", given("[path]\npoints_file = \"points.csv\"\n"));
    std::string million = "x,y\n";
    for (int i = 0; i < 1'000'000; ++i)
        million += std::to_string(i) + ",1\n";
    const std::vector<std::pair<const char*, std::string>> tables{
        {"ragged", "1,2\n3\n4,5,6\n"},   {"binary", std::string("\0\1\2\3\xff\xfe,\x80\n", 9)},
        {"not numbers", "x,y\n1,two\n"}, {"not finite", "1,nan\n2,inf\n"},
        {"too large", "1,1e400\n2,3\n"}, {"empty", ""},
        {"a million points", million},
    };
    for (const auto& [name, text] : tables) {
        folder.write("points.csv", text);
        const auto begin = std::chrono::steady_clock::now();
        const Outcome outcome = run({"check", file});
        EXPECT_EQ(outcome.exit_code, 3) << name << ": " << outcome.err;
        expect_has(outcome.err, "points.csv");
        EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(20)) << name;
    }
}

TEST(BadFiles, ThatCannotBeReadEndWithSix) {
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder.path / "folder.toml");
    const std::string names_missing = folder.write("a.toml", given("[path]\npoints_file = \"missing.csv\"\n"));
    const std::string names_folder = folder.write("b.toml", given("[path]\npoints_file = \"folder.toml\"\n"));
    for (const std::string& file : {folder / "missing.toml", folder / "folder.toml", std::string(), names_missing,
                                    names_folder, folder / "a.toml" + "/below"}) {
        for (const char* command : {"check", "solve", "analyse", "methods"}) {
            if (file.empty() && command == std::string("methods")) continue;  // as if no file were named
            const Outcome outcome = run({command, file});
            EXPECT_EQ(outcome.exit_code, 6) << command << " '" << file << "': " << outcome.err;
            EXPECT_EQ(outcome.out, "");
            EXPECT_NE(outcome.err, "");
        }
    }
    const Outcome missing = run({"check", folder / "missing.toml"});
    expect_has(missing.err, "missing.toml");
    expect_has(missing.err, "No such file");
}

TEST(BadFiles, ASpecialFileIsNotWaitedFor) {
    EXPECT_NE(run({"check", "/dev/zero"}).exit_code, 0);
    EXPECT_NE(run({"check", "/dev/null"}).exit_code, 0);
}

}  // namespace
}  // namespace mechwright::testing
