// The README shows a command and what it prints: this keeps it true, the seconds apart.

#include <regex>

#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {

namespace {

std::string without_seconds(const std::string& text) {
    return std::regex_replace(text, std::regex(R"([0-9.e-]+\s+s\.)"), "T s.");
}

std::string readme() { return content_of(MECHWRIGHT_SOURCE_DIR "/README.md"); }

/// The README has what a command prints on standard output.
void expect_shown(const std::vector<std::string>& arguments) {
    Start how;
    how.arguments = arguments;
    how.folder = MECHWRIGHT_SOURCE_DIR;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 0);
    expect_has(without_seconds(readme()), without_seconds(outcome.out));
}

TEST(Readme, ShowsWhatSolvePrints) { expect_shown({"solve", "problems/four-bar/crank-rocker.toml"}); }

TEST(Readme, ShowsWhatAFunctionGeneratorPrints) { expect_shown({"solve", "problems/function/power.toml"}); }

TEST(Readme, ShowsWhatComparePrints) {
    const std::string files = "problems/quick-return/uniform-speed-";
    expect_shown({"compare", files + "crank-shaper.toml", files + "drag-link.toml", files + "whitworth.toml"});
}

TEST(Readme, ShowsWhatNewWrites) {
    expect_shown({"new", "--mechanism", "slider-crank", "--task", "stroke", "--set", "stroke=80"});
}

TEST(Readme, ShowsWhatExplainPrints) { expect_shown({"explain", "swing"}); }

TEST(Readme, ShowsTheAnalysisOfALinkage) { expect_shown({"analyse", "problems/linkage/scotch-yoke.toml"}); }
TEST(Readme, ShowsWhatStructurePrints) { expect_shown({"structure", "problems/linkage/geared-five-bar.toml"}); }

TEST(Readme, ShowsWhatTolerancesDo) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"study", "problems/studies/crank-rocker-tolerances.toml", "--out", folder / "out"};
    how.folder = MECHWRIGHT_SOURCE_DIR;
    const Outcome outcome = run(how);
    const std::size_t tables = outcome.out.find("20000 samples");
    ASSERT_NE(tables, std::string::npos) << outcome.out;
    expect_has(readme(), outcome.out.substr(tables, outcome.out.find("\nData: ") - tables));
}

}  // namespace

}  // namespace mechwright::testing
