// Exit codes, and what cannot happen and did.

#include "synthesis/command_line/exit_code.h"

#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <stdexcept>

#include "synthesis/command_line/defect.h"
#include "synthesis/command_line/run.h"

namespace mechwright {
namespace {

TEST(ExitCode, FollowsTheStatus) {
    EXPECT_EQ(exit_code::of(Status::solved), 0);
    EXPECT_EQ(exit_code::of(Status::infeasible), 4);
    EXPECT_EQ(exit_code::of(Status::limit), 5);
    EXPECT_EQ(exit_code::of(Status::unverified), 7);
    EXPECT_EQ(exit_code::of(Status::interrupted), 130);
}

TEST(ExitCode, TheMoreSevereWins) {
    constexpr std::array order{1, 2, 130, 6, 3, 7, 5, 4, 0};
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i; j < order.size(); ++j) {
            EXPECT_EQ(exit_code::worse(order[i], order[j]), order[i]);
            EXPECT_EQ(exit_code::worse(order[j], order[i]), order[i]);
        }
}

/// Refuses every character.
struct FailingBuffer : std::streambuf {
    int overflow(int) override { return traits_type::eof(); }
};

TEST(Defect, AnUnexpectedExceptionEndsWithOneAndSaysHowToReportIt) {
    FailingBuffer buffer;
    std::ostream out(&buffer);
    out.exceptions(std::ios::badbit);  // an exception from where nobody expects one
    std::ostringstream err;
    Console console{out, err};
    const std::array arguments{"mechwright", "quantities"};
    EXPECT_EQ(run(2, arguments.data(), console), 1);
    for (const char* part : {"mechwright: internal error: ", "defect of mechwright", "report", "--version"})
        EXPECT_NE(err.str().find(part), std::string::npos) << err.str();
}

TEST(Defect, AnythingThrownIsReported) {
    std::ostringstream out;
    std::ostringstream err;
    Console console{out, err};
    try {
        throw std::logic_error("an index too far");
    } catch (...) {
        EXPECT_EQ(report_defect(console, "a.toml"), 1);
    }
    EXPECT_NE(err.str().find("a.toml: internal error: an index too far"), std::string::npos) << err.str();
    try {
        throw 5;
    } catch (...) {
        EXPECT_EQ(report_defect(console, ""), 1);
    }
    EXPECT_NE(err.str().find("unknown exception"), std::string::npos);
    try {
        throw std::bad_alloc();
    } catch (...) {
        EXPECT_EQ(report_defect(console, ""), 1);
    }
    EXPECT_NE(err.str().find("out of memory"), std::string::npos);
    EXPECT_EQ(out.str(), "");
}

TEST(Run, WorksWithoutAProcess) {
    std::ostringstream out;
    std::ostringstream err;
    Console console{out, err};
    const std::array arguments{"mechwright", "--version"};
    EXPECT_EQ(run(2, arguments.data(), console), 0);
    EXPECT_EQ(out.str().rfind("mechwright ", 0), 0u);
    EXPECT_EQ(err.str(), "");
}

}  // namespace
}  // namespace mechwright
