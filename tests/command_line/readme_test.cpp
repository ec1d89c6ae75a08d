// The README shows a command and what it prints: this keeps it true, the seconds apart.

#include <fstream>
#include <iterator>
#include <regex>

#include "tests/command_line/program.h"

namespace mechwright::testing {

namespace {

std::string without_seconds(const std::string& text) {
    return std::regex_replace(text, std::regex(R"([0-9.e-]+\s+s\.)"), "T s.");
}

/// The README has what a command prints on standard output.
void expect_shown(const std::vector<std::string>& arguments) {
    std::ifstream file(MECHWRIGHT_SOURCE_DIR "/README.md");
    const std::string readme{std::istreambuf_iterator<char>(file), {}};
    Start how;
    how.arguments = arguments;
    how.folder = MECHWRIGHT_SOURCE_DIR;
    const Outcome outcome = run(how);
    EXPECT_EQ(outcome.exit_code, 0);
    expect_has(without_seconds(readme), without_seconds(outcome.out));
}

TEST(Readme, ShowsWhatSolvePrints) { expect_shown({"solve", "problems/four-bar/crank-rocker.toml"}); }

TEST(Readme, ShowsWhatAFunctionGeneratorPrints) { expect_shown({"solve", "problems/function/power.toml"}); }

TEST(Readme, ShowsWhatComparePrints) {
    const std::string files = "problems/quick-return/uniform-speed-";
    expect_shown({"compare", files + "crank-shaper.toml", files + "drag-link.toml", files + "whitworth.toml"});
}

}  // namespace

}  // namespace mechwright::testing
