// mechwright draw --assemblies and --skeleton

#include <filesystem>
#include <sstream>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

std::string linkage_problem(const std::string& name) {
    return std::string(MECHWRIGHT_SOURCE_DIR "/problems/linkage/") + name + ".toml";
}

/// The text of a problem without its section [assembly].
std::string without_assembly(const std::string& text) {
    const std::size_t from = text.find("[assembly]");
    if (from == std::string::npos) return text;
    const std::size_t to = text.find("\n[", from);
    return text.substr(0, from) + (to == std::string::npos ? "" : text.substr(to + 1));
}

/// Blocks that start with [assembly].
std::vector<std::string> blocks_of(const std::string& text) {
    std::vector<std::string> blocks;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with("[assembly]")) blocks.emplace_back();
        if (!blocks.empty()) blocks.back() += line + '\n';
    }
    return blocks;
}

/// What --assemblies prints, put into the file, is that assembly to `structure`.
TEST(DrawAssemblies, PrintsWhatGivesThemBack) {
    const TemporaryFolder folder;
    for (const auto& [name, at, count] : {std::tuple("jansen-leg", "90", 8u), std::tuple("peaucellier", "40", 4u),
                                          std::tuple("geared-five-bar", "60", 2u),
                                          std::tuple("dwell-six-bar", "75", 4u), std::tuple("scotch-yoke", "30", 1u)}) {
        const std::string picture = folder / "all.svg";
        const Outcome outcome = run({"draw", linkage_problem(name), "--assemblies", "--at", at, "--out", picture});
        ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
        EXPECT_EQ(outcome.err, "");
        const std::string svg = content_of(picture);
        const std::vector<std::string> blocks = blocks_of(outcome.out);
        EXPECT_EQ(blocks.size(), count) << name;
        const std::string text = content_of(linkage_problem(name));
        const auto all = nlohmann::json::parse(run({"structure", linkage_problem(name), "--json", "--at", at}).out);
        std::size_t as_in_file = 0;
        for (std::size_t i = 0; i < blocks.size(); ++i) {
            as_in_file += blocks[i].find("as in the file") != std::string::npos;
            // Each line stands in the picture, too.
            std::istringstream lines(blocks[i]);
            std::string line;
            for (std::getline(lines, line); std::getline(lines, line) && !line.empty();) {
                std::string quoted;
                for (const char c : line)
                    quoted += c == '"' ? std::string("&quot;") : std::string(1, c);
                EXPECT_NE(svg.find(quoted), std::string::npos) << line;
            }
            // The six-bar's dimensions are ranges: structure shows positions of given ones only.
            if (!all.contains("assemblies")) continue;
            const std::string file = folder.write("one.toml", without_assembly(text) + "\n" + blocks[i]);
            const Outcome again = run({"structure", file, "--json", "--at", at});
            ASSERT_EQ(again.exit_code, 0) << again.err << blocks[i];
            std::vector<nlohmann::json> asked;
            const auto there = nlohmann::json::parse(again.out);
            for (const auto& one : there["assemblies"])
                if (one["as-in-file"]) asked.push_back(one);
            ASSERT_EQ(asked.size(), 1u) << blocks[i];
            EXPECT_EQ(asked[0]["sides"], all["assemblies"][i]["sides"]);
            EXPECT_EQ(asked[0]["points"], all["assemblies"][i]["points"]);
        }
        // "either" asks for both.
        EXPECT_EQ(as_in_file, std::string(name) == "dwell-six-bar" ? 2u : 1u);
    }
}

TEST(DrawAssemblies, SaysWhereTheyAreNone) {
    const TemporaryFolder folder;
    const Outcome none = run({"draw", linkage_problem("peaucellier"), "--assemblies", "--at", "180"});
    EXPECT_EQ(none.exit_code, 4);
    EXPECT_EQ(none.out, "");
    expect_has(none.err, "does not close at this input");
    EXPECT_EQ(run({"draw", linkage_problem("peaucellier"), "--assemblies", "--at", "x"}).exit_code, 2);
    EXPECT_EQ(run({"draw", linkage_problem("peaucellier"), "--at", "3"}).exit_code, 2);
    EXPECT_EQ(run({"draw", linkage_problem("peaucellier"), "--assemblies", "--skeleton"}).exit_code, 2);
    EXPECT_EQ(run({"draw", linkage_problem("peaucellier"), "--assemblies", "--plots"}).exit_code, 2);
    EXPECT_EQ(run({"draw", folder / "missing.toml", "--assemblies"}).exit_code, 6);
}

TEST(DrawSkeleton, ShowsTheLinksOfWhatNeverCloses) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "short.toml",
        "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0], D = [100, 0] }\ncrank = { A = [0, 0], B = "
        "[20, "
        "0] }\ncoupler = { B = [0, 0], C = [30, 0], P = [10, 12.5] }\nrocker = { D = [0, 0], C = [25, 0] }\n[drive]\n"
        "link = \"crank\"\n");
    EXPECT_EQ(run({"draw", file, "--assemblies"}).exit_code, 3);
    const Outcome outcome = run({"draw", file, "--skeleton"});
    EXPECT_EQ(outcome.exit_code, 0);
    expect_has(outcome.err, "never closes");
    for (const char* part :
         {"<svg", ">frame<", ">crank<", ">coupler<", ">rocker<", ">P<", "B (0, 0), C (30, 0), P (10, 12.5)"})
        expect_has(outcome.out, part);
    // What is no linkage at all has none.
    const std::string empty = folder.write("empty.toml", "schema = 1\nmechanism = \"linkage\"\n");
    EXPECT_EQ(run({"draw", empty, "--skeleton"}).exit_code, 3);
    EXPECT_EQ(run({"draw", folder / "missing.toml", "--skeleton"}).exit_code, 6);
    const std::string png = folder / "links.png";
    EXPECT_EQ(run({"draw", linkage_problem("jansen-leg"), "--skeleton", "--out", png}).exit_code, 0);
    EXPECT_TRUE(content_of(png).starts_with("\x89PNG"));
}

}  // namespace
}  // namespace mechwright::testing
