// What only a terminal gets to see: colour, and a progress line.

#include <signal.h>

#include <cmath>
#include <sstream>
#include <thread>

#include "synthesis/command_line/progress_line.h"
#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

/// A search that takes a second or two on a terminal.
Start search_on_terminal(const TemporaryFolder& folder) {
    Start how;
    how.arguments = {"solve", "--json", "--time-limit", "2", folder.write("a.toml", long_search())};
    how.err_on_terminal = true;
    return how;
}

TEST(Terminal, ShowsProgressAndWipesItOut) {
    const TemporaryFolder folder;
    const Outcome outcome = run(search_on_terminal(folder));
    EXPECT_EQ(outcome.exit_code, 5);
    expect_has(outcome.err, "/1200000");
    expect_has(outcome.err, " starts  best ");
    expect_has(outcome.err, " mm  ");
    EXPECT_EQ(outcome.err.find('\n'), std::string::npos) << outcome.err;
    const std::size_t last = outcome.err.rfind('\r');
    ASSERT_EQ(last, outcome.err.size() - 1);
    const std::size_t before = outcome.err.rfind('\r', last - 1);
    EXPECT_EQ(outcome.err.find_first_not_of(' ', before + 1), last);
    std::size_t lines = 0;
    for (const char c : outcome.err)
        lines += c == '\r';
    EXPECT_LT(lines, 60u);  // not more than ten a second, and some leisure for a slow machine
    parsed(outcome.out);
}

TEST(Terminal, QuietShowsNoProgress) {
    const TemporaryFolder folder;
    Start how = search_on_terminal(folder);
    how.arguments.push_back("--quiet");
    EXPECT_EQ(run(how).err, "");
}

TEST(Terminal, ADumbOneShowsNoProgress) {
    const TemporaryFolder folder;
    Start how = search_on_terminal(folder);
    how.environment = {{"TERM", "dumb"}};
    EXPECT_EQ(run(how).err, "");
}

TEST(Terminal, AFileOrPipeGetsNoProgress) {
    const TemporaryFolder folder;
    Start how = search_on_terminal(folder);
    how.err_on_terminal = false;
    EXPECT_EQ(run(how).err, "");
}

TEST(Terminal, AnInterruptIsAcknowledged) {
    const TemporaryFolder folder;
    Start how = search_on_terminal(folder);
    how.arguments[3] = "100";
    const Running running = start(how);
    std::this_thread::sleep_for(std::chrono::seconds(2));
    ::kill(running.id, SIGINT);
    const Outcome outcome = finish(running);
    EXPECT_EQ(outcome.exit_code, 130);
    expect_has(outcome.err, "stopping with the best design so far");
}

TEST(Terminal, IsColouredUnlessItIsAskedNotToBe) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {"solve", folder.write("a.toml", crank_rocker())};
    how.out_on_terminal = true;
    const std::string coloured = run(how).out;
    expect_has(coloured, "\x1b[1;32mSolved:\x1b[0m");
    how.environment = {{"NO_COLOR", "1"}};
    const std::string plain = run(how).out;
    expect_has_not(plain, "\x1b");
    expect_has(plain, "Solved:");
    how.environment = {{"TERM", "dumb"}};
    expect_has_not(run(how).out, "\x1b");
    how.environment = {{"TERM", ""}};
    expect_has_not(run(how).out, "\x1b");
}

TEST(ProgressLine, FitsTheLineAndLeavesNothing) {
    std::ostringstream out;
    std::ostringstream err;
    Console console{out, err, false, true};
    ProgressLine line{&console, std::string(200, 'x') + "ü.toml", "deg"};
    draw(line, 1, 32, std::nan(""));
    expect_has(err.str(), "\r1/32 starts  no design yet");
    EXPECT_LE(err.str().size(), 81u);
    draw(line, 2, 32, 40.315);  // too soon
    expect_has_not(err.str(), "2/32");
    line.drawn -= std::chrono::seconds(1);
    line.label = "a.toml";
    draw(line, 3, 32, 40.315);
    expect_has(err.str(), "\r3/32 starts  best 40.315 deg");
    line.drawn -= std::chrono::seconds(1);
    draw_bound(line, 0.97, 1200);
    expect_has(err.str(), "\rbound 97% of the best  1200 boxes  ");
    line.drawn -= std::chrono::seconds(1);
    draw_measurements(line, 3, 12);
    expect_has(err.str(), "\r3/12 measurements  ");
    erase(line);
    EXPECT_EQ(err.str().back(), '\r');
    const std::string before = err.str();
    erase(line);
    EXPECT_EQ(err.str(), before);
    EXPECT_EQ(out.str(), "");
}

}  // namespace
}  // namespace mechwright::testing
