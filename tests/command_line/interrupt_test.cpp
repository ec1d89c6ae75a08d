// Ctrl-C.

#include "synthesis/command_line/interrupt.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "tests/command_line/problems.h"
#include "tests/command_line/program.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing {
namespace {

using Json = nlohmann::ordered_json;

struct InterruptBy : ::testing::TestWithParam<int> {};

TEST_P(InterruptBy, TheBestSoFarIsWritten) {
    const TemporaryFolder folder;
    Start how;
    how.arguments = {
        "solve", "--json", "--time-limit", "100", "--out", folder / "out", folder.write("a.toml", long_search())};
    const auto begin = std::chrono::steady_clock::now();
    const Running running = start(how);
    std::this_thread::sleep_for(std::chrono::seconds(3));
    ASSERT_EQ(::kill(running.id, GetParam()), 0);
    const Outcome outcome = finish(running);
    EXPECT_EQ(outcome.killed_by, 0);
    EXPECT_EQ(outcome.exit_code, 130) << outcome.err;
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
    const Json json = parsed(outcome.out);
    EXPECT_EQ(json["status"], "interrupted");
    EXPECT_TRUE(json["design"].contains("crank"));
    EXPECT_TRUE(json["quantities"].contains("path-rms"));
    EXPECT_EQ(content_of(folder / "out/a.json"), outcome.out);
    EXPECT_EQ(count_files(folder.path / "out"), 1u);
}

INSTANTIATE_TEST_SUITE_P(Signals, InterruptBy, ::testing::Values(SIGINT, SIGTERM, SIGHUP));

TEST(Interrupt, WhatWasNotStartedIsNotSolved) {
    const TemporaryFolder folder;
    const std::string file = folder.write("a.toml", crank_rocker());
    Start how;
    how.arguments = {"solve", "--time-limit", "100", file, folder.write("b.toml", long_search()), file, file};
    const Running running = start(how);
    std::this_thread::sleep_for(std::chrono::seconds(3));
    ASSERT_EQ(::kill(running.id, SIGINT), 0);
    const Outcome outcome = finish(running);
    EXPECT_EQ(outcome.exit_code, 130);
    expect_has(outcome.out, "Solved");
    expect_has(outcome.out, "Interrupted");
    EXPECT_EQ(outcome.err, "4 problems: 1 solved, 1 interrupted, 2 not solved\n");
}

/// How a child ends that does this.
template <class Action>
int status_of_child(Action action) {
    const pid_t child = ::fork();
    if (child == 0) {
        action();
        ::_exit(0);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return status;
}

TEST(Interrupt, TheFirstSignalAsksAndTheSecondEnds) {
    const int status = status_of_child([] {
        ::signal(SIGINT, SIG_DFL);
        const mechwright::Interrupt interrupt(false);
        if (mechwright::Interrupt::requested()) ::_exit(1);
        ::raise(SIGINT);
        if (!mechwright::Interrupt::requested()) ::_exit(2);
        ::raise(SIGINT);
        ::_exit(3);
    });
    EXPECT_TRUE(WIFSIGNALED(status)) << WEXITSTATUS(status);
    EXPECT_EQ(WTERMSIG(status), SIGINT);
}

TEST(Interrupt, ASignalThatWasIgnoredStaysIgnored) {
    const int status = status_of_child([] {
        ::signal(SIGINT, SIG_IGN);
        const mechwright::Interrupt interrupt(false);
        ::raise(SIGINT);
        ::_exit(mechwright::Interrupt::requested() ? 1 : 0);
    });
    EXPECT_EQ(status, 0);
}

TEST(Interrupt, AfterwardsEverythingIsAsBefore) {
    const int status = status_of_child([] {
        ::signal(SIGTERM, SIG_DFL);
        { const mechwright::Interrupt interrupt(false); }
        ::raise(SIGTERM);
        ::_exit(1);
    });
    EXPECT_TRUE(WIFSIGNALED(status));
}

}  // namespace
}  // namespace mechwright::testing
