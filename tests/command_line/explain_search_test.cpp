// mechwright solve --explain-search: what is known of how searches end, and the same for any number of threads.

#include <fmt/format.h>

#include <regex>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

/// What --explain-search adds to the summary, with one blank for many.
std::string search_of(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), {"solve", "--explain-search", "--digits", "8"});
    const Outcome outcome = run(arguments);
    const std::size_t begin = outcome.out.find("\nStarts\n");
    EXPECT_NE(begin, std::string::npos) << outcome.out << outcome.err;
    return std::regex_replace(outcome.out.substr(std::min(begin, outcome.out.size())), std::regex("\\s+"), " ");
}

std::string without_times_of(const std::string& text) { return std::regex_replace(text, std::regex("[0-9.]+ s "), ""); }

TEST(ExplainSearch, EveryStartEndsAtTheOnlyOptimum) {
    const std::string text = search_of({shipped_file("quick-return/shaper-stroke-75.toml"), "--method", "slsqp"});
    expect_has(text,
               "513 candidates drawn, of which 513 assembled and were screened, 32 starts optimised, 32 searches taken "
               "to their end.");
    expect_has(text, " 32 the design 1.2729259 0.0e+00 ");
    expect_has(text, "; from screened 32 ");
    expect_has_not(text, "an optimum");
    expect_has_not(text, "not feasible");
}

TEST(ExplainSearch, BothOptimaOfACrankRockerAreShownTheBestFirst) {
    // Of the closed form: one for each direction of the crank. Half of the starts choose none, and end at the better.
    const std::string text = search_of({shipped_file("four-bar/crank-rocker.toml"), "--method", "slsqp"});
    const std::size_t best = text.find("24 the design 45.008219 "), other = text.find("8 an optimum 37.370521 ");
    EXPECT_LT(best, other) << text;
    EXPECT_NE(other, std::string::npos) << text;
}

TEST(ExplainSearch, WhatIsInfeasibleIsNoOptimumWhateverTheSolverSays) {
    const std::string text = search_of({shipped_file("four-bar/transmission-not-reachable.toml"), "--method", "ipopt"});
    expect_has(text, "64 searches taken to their end.");
    expect_has(text, " 64 not feasible 1.8e-01 ");
    expect_has(text, "ipopt: locally infeasible ");
    expect_has(text, "from least shortfall 32, screened 32");
    expect_has_not(text, "the design");
}

TEST(ExplainSearch, SearchesAlongAPathBeganNearAnotherEndOrWereScreened) {
    const std::string text = search_of({shipped_file("path/case-4.toml")});
    expect_has(text, "from near another end ");
    EXPECT_TRUE(std::regex_search(text, std::regex("; from ([a-z ]+ [0-9]+, )?screened [0-9]+ "))) << text;
    expect_has_not(text, "from drawn");
}

TEST(ExplainSearch, ATimeLimitCutsOffStarts) {
    const TemporaryFolder folder;
    const std::string file = folder.write("long.toml", long_search());
    const std::string text = search_of({file, "--method", "slsqp", "--time-limit", "0.3"});
    EXPECT_TRUE(std::regex_search(text, std::regex(" [1-9][0-9]* cut off by the limit, or never begun\\."))) << text;
}

TEST(ExplainSearch, AMethodWithoutStartsSaysSo) {
    expect_has(search_of({shipped_file("four-bar/crank-rocker.toml")}),
               "None: the method closed-form has no local searches.");
}

TEST(ExplainSearch, TimesAreThoseOfTheRun) {
    const std::string text = search_of({shipped_file("quick-return/uniform-speed-drag-link.toml"), "--jobs", "1"});
    double sum = 0, whole = 0;
    const std::regex row(
        "(reading the file|screening starts|local searches|polishing|verification|from beginning to "
        "end) ([0-9.]+) s ");
    for (std::sregex_iterator at(text.begin(), text.end(), row), end; at != end; ++at)
        ((*at)[1] == "from beginning to end" ? whole : sum) += std::stod((*at)[2]);
    EXPECT_GT(sum, 0.5 * whole) << text;
    EXPECT_LT(sum, whole + 0.1) << text;
}

TEST(ExplainSearch, IsTheSameForAnyNumberOfThreads) {
    for (const char* name :
         {"path/case-4.toml", "path/yu1-compact.toml", "quick-return/uniform-speed-drag-link.toml"}) {
        const auto with = [&](const char* jobs) {
            return without_times_of(search_of({shipped_file(name), "--jobs", jobs}));
        };
        EXPECT_EQ(with("1"), with("2")) << name;
    }
}

TEST(ExplainSearch, ChangesNoDocument) {
    const TemporaryFolder folder;
    const std::string file = shipped_file("quick-return/uniform-speed-drag-link.toml");
    ASSERT_EQ(run({"solve", file, "--quiet", "--explain-search", "--out", folder / "explained"}).exit_code, 0);
    ASSERT_EQ(run({"solve", file, "--quiet", "--out", folder / "plain"}).exit_code, 0);
    const auto document = [&](const std::string& name) {
        return without_times(parsed(content_of(folder / (name + "/uniform-speed-drag-link.json"))));
    };
    EXPECT_EQ(document("explained"), document("plain"));
    EXPECT_EQ(run({"solve", file, "--json", "--explain-search"}).exit_code, 2);
}

}  // namespace
}  // namespace mechwright::testing
