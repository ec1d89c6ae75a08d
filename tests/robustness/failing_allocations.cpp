// Whatever allocation fails, of reading, solving, verifying and writing: the caller gets std::bad_alloc or the right
// result, and the next call is none the worse for it.

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <exception>
#include <new>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/report/json_text.h"
#include "synthesis/solve/solve.h"
#include "tests/long_form.h"
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
    Result result = solve(read.problem, options);
    result.search.seconds = 0;
    return json_text(document(read.problem, result));
}

struct Case {
    const char* problem;
    const char* method;
    int jobs;
};

enum Ending { right = 0, thrown = 1, wrong = 2, wrong_afterwards = 3, in_a_destructor = 4, by_a_signal = 5 };

/// Ends the process as the program ends: the JSON library needs memory in destructors, which cannot throw.
[[noreturn]] void out_of_memory_in_a_destructor() { ::_exit(in_a_destructor); }

/// Lets an allocation fail in a process of its own, which then does the same once more.
template <class Document>
Ending ending_of(const Document& document, const std::string& answer, long number) {
    const pid_t child = ::fork();
    if (child == 0) {
        std::set_terminate(out_of_memory_in_a_destructor);
        Ending ending = right;
        fail_allocation(number);
        try {
            const std::string got = document();
            let_allocations_succeed();
            if (got != answer) ending = wrong;
        } catch (const std::bad_alloc&) {
            let_allocations_succeed();
            ending = thrown;
        }
        ::_exit(document() == answer ? ending : wrong_afterwards);
    }
    int status = 0;
    EXPECT_EQ(::waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? static_cast<Ending>(WEXITSTATUS(status)) : by_a_signal;
}

class FailingAllocation : public ::testing::TestWithParam<Case> {};

TEST_P(FailingAllocation, IsToldAndForgotten) {
    const std::string file = problem_file(GetParam().problem);
    std::string text = content_of(file);
    if (*GetParam().method != 0)
        text += fmt::format("\n[solver]\nstarts = {}\nmethod = \"{}\"\n", cases_to_try(2, 4), GetParam().method);
    const auto document = [&] { return document_of(text, file, GetParam().jobs); };
    const std::string answer = document();
    ASSERT_NE(answer.find("\"status\": \"solved\""), std::string::npos) << answer;
    fail_allocation(-1);
    document();
    const long all = let_allocations_succeed();
    const long tried = cases_to_try(24, 40);
    std::array<int, 6> count{};
    for (long i = 0; i < tried; ++i) {
        // Dense where it begins, where the reader is, then evenly.
        const long number = i < tried / 4 ? i * 7 : all * i / tried + i % 5;
        const Ending ending = ending_of(document, answer, number);
        ++count[ending];
        EXPECT_TRUE(ending == right || ending == thrown || ending == in_a_destructor)
            << "ending " << ending << " after allocation " << number << " of " << all;
    }
    EXPECT_GT(count[thrown], tried / 2);
    EXPECT_LT(count[in_a_destructor], tried / 4);
    EXPECT_EQ(document(), answer);
}

INSTANTIATE_TEST_SUITE_P(Problems, FailingAllocation,
                         ::testing::Values(Case{"four-bar/crank-rocker", "", 1},
                                           Case{"quick-return/slider-crank-compact", "slsqp", 2},
                                           Case{"quick-return/slider-crank-compact", "ipopt", 1},
                                           Case{"cam/roller-uneven", "", 1}, Case{"exact/five-timed-points", "", 2}),
                         [](const auto& test) { return "N" + std::to_string(test.index); });

}  // namespace
}  // namespace mechwright::testing
