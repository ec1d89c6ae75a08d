// The README and the manuals show commands and what they print: this keeps them true, the seconds apart.

#include <array>
#include <filesystem>
#include <regex>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {

namespace {

std::string without_seconds(const std::string& text) {
    return std::regex_replace(text, std::regex(R"([0-9.e-]+\s+s\.)"), "T s.");
}

constexpr std::string_view of_all = "README.md", of_files = "problems/README.md",
                           of_studies = "problems/studies/README.md", of_program = "synthesis/README.md",
                           of_python = "synthesis/python/README.md";

std::string manual(std::string_view name) {
    return content_of((std::filesystem::path(MECHWRIGHT_SOURCE_DIR) / name).string());
}

/// A manual has what a command prints on standard output.
void expect_shown(std::string_view in, const std::vector<std::string>& arguments) {
    Start how;
    how.arguments = arguments;
    how.folder = MECHWRIGHT_SOURCE_DIR;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 0);
    expect_has(without_seconds(manual(in)), without_seconds(outcome.out));
}

TEST(Readme, IsOnePage) {
    const std::string text = manual(of_all);
    EXPECT_LE(std::count(text.begin(), text.end(), '\n'), 150);
}

TEST(Readme, ShowsWhatSolvePrints) { expect_shown(of_all, {"solve", "problems/four-bar/crank-rocker.toml"}); }

TEST(Manuals, ListEverySectionAndKey) { expect_shown(of_files, {"schema", "problem", "--markdown"}); }

/// Links to files and folders, and to headings of the same manual.
TEST(Manuals, LinkToWhatThereIs) {
    const std::regex link(R"(\]\(([^)\s]+)\))"), heading(R"((?:^|\n)#+ ([^\n]+))"), not_in_anchor("[^a-z0-9 -]");
    for (const std::string_view name : std::array{of_all, of_files, of_studies, of_program, of_python}) {
        const std::string text = manual(name);
        std::string anchors;
        for (std::sregex_iterator at(text.begin(), text.end(), heading), end; at != end; ++at) {
            std::string anchor = (*at)[1];
            std::transform(anchor.begin(), anchor.end(), anchor.begin(), [](char c) { return std::tolower(c); });
            anchor = std::regex_replace(anchor, not_in_anchor, "");
            std::replace(anchor.begin(), anchor.end(), ' ', '-');
            anchors += "#" + anchor + "\n";
        }
        std::size_t links = 0;
        for (std::sregex_iterator at(text.begin(), text.end(), link), end; at != end; ++at, ++links) {
            const std::string target = (*at)[1];
            if (target.rfind("https:", 0) == 0) continue;
            const auto folder = (std::filesystem::path(MECHWRIGHT_SOURCE_DIR) / name).parent_path();
            if (target[0] == '#')
                expect_has(anchors, target + "\n");
            else
                EXPECT_TRUE(std::filesystem::exists(folder / target)) << name << ": " << target;
        }
        EXPECT_TRUE(links > 0 || name == of_python) << name;
    }
}

TEST(Manuals, ShowWhatAFunctionGeneratorPrints) { expect_shown(of_files, {"solve", "problems/function/power.toml"}); }

TEST(Manuals, ShowWhatComparePrints) {
    const std::string each = "problems/quick-return/uniform-speed-";
    expect_shown(of_files, {"compare", each + "crank-shaper.toml", each + "drag-link.toml", each + "whitworth.toml"});
}

TEST(Manuals, ShowWhatNewWrites) {
    expect_shown(of_files, {"new", "--mechanism", "slider-crank", "--task", "stroke", "--set", "stroke=80"});
}

TEST(Manuals, ShowWhatExplainPrints) { expect_shown(of_files, {"explain", "swing"}); }

TEST(Manuals, ShowTheAnalysisOfALinkage) { expect_shown(of_files, {"analyse", "problems/linkage/scotch-yoke.toml"}); }
TEST(Manuals, ShowWhatStructurePrints) {
    expect_shown(of_files, {"structure", "problems/linkage/geared-five-bar.toml"});
}

/// What a study of tolerances prints, up to where it says `end`.
void expect_tolerances_shown(const std::string& study, const std::string& end) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"study", "problems/studies/" + study, "--out", folder / "out"};
    how.folder = MECHWRIGHT_SOURCE_DIR;
    const Outcome outcome = run(how);
    const std::size_t tables = outcome.out.find("20000 samples");
    ASSERT_NE(tables, std::string::npos) << outcome.out;
    expect_has(manual(of_studies), outcome.out.substr(tables, outcome.out.find(end) - tables));
}

TEST(Manuals, ShowWhatTolerancesDo) { expect_tolerances_shown("crank-rocker-tolerances.toml", "\nData: "); }
TEST(Manuals, ShowWhichTolerancesWillDo) { expect_tolerances_shown("crank-rocker-allocation.toml", "\nSpread"); }

}  // namespace

}  // namespace mechwright::testing
