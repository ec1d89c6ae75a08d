// Whatever allocation fails, of reading, solving, verifying and writing: the caller gets std::bad_alloc or the right
// result, and the next call is none the worse for it.

#include <new>

#include "synthesis/problem/reader.h"
#include "synthesis/report/document.h"
#include "synthesis/report/json_text.h"
#include "synthesis/search/solve.h"
#include "tests/robustness/allocation.h"
#include "tests/robustness/problems.h"

namespace mechwright::testing {
namespace {

/// Reads a problem, solves it, and writes the document.
std::string document_of(const std::string& text, const std::string& file, int jobs) {
    const ReadProblem read = parse_problem(text, file);
    if (!read.ok()) return read.messages.empty() ? "?" : to_string(read.messages.front());
    RunOptions options;
    options.jobs = jobs;
    return without_seconds(json_text(document(read.problem, solve(read.problem, options))));
}

struct Case {
    const char* problem;
    const char* method;
    int jobs;
};

class FailingAllocation : public ::testing::TestWithParam<Case> {};

TEST_P(FailingAllocation, IsToldAndForgotten) {
    const std::string file = problem_file(GetParam().problem);
    std::string text = content_of(file);
    if (*GetParam().method != 0) text += std::string("\n[solver]\nmethod = \"") + GetParam().method + "\"\n";
    const auto document = [&] { return document_of(text, file, GetParam().jobs); };
    const std::string right = document();
    ASSERT_NE(right.find("\"status\": \"solved\""), std::string::npos) << right;
    fail_allocation(-1);
    document();
    const long all = let_allocations_succeed();
    constexpr long tried = 120, checked_every = 15;
    int thrown = 0;
    for (long i = 0; i < tried; ++i) {
        // Dense where it begins, where the reader is, then evenly.
        const long number = i < tried / 4 ? i * 7 : all * i / tried + i % 5;
        std::string got;
        fail_allocation(number);
        try {
            got = document();
        } catch (const std::bad_alloc&) {
            ++thrown;
        }
        let_allocations_succeed();
        EXPECT_TRUE(got.empty() || got == right) << "allocation " << number << " of " << all << "\n" << got;
        if (i % checked_every == 0) EXPECT_EQ(document(), right) << "after allocation " << number;
    }
    EXPECT_GT(thrown, tried / 2);
    EXPECT_EQ(document(), right);
}

INSTANTIATE_TEST_SUITE_P(Problems, FailingAllocation,
                         ::testing::Values(Case{"four-bar/crank-rocker", "", 1},
                                           Case{"quick-return/slider-crank-compact", "slsqp", 2},
                                           Case{"quick-return/slider-crank-compact", "ipopt", 1},
                                           Case{"cam/roller-uneven", "", 1}, Case{"exact/five-timed-points", "", 2}),
                         [](const auto& info) { return "N" + std::to_string(info.index); });

}  // namespace
}  // namespace mechwright::testing
