// Whole problems whose optimum lies at a change point, a toggle, a limit of a dimension or a cusp: the best value is
// met to its digits, the design is verified, and a place that is no mechanism is approached, not taken.

#include <cmath>

#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "tests/hard_cases/table.h"

namespace mechwright::test {
namespace {

Problem problem_of(const Row& row) {
    ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/tests/hard_cases/data/syntheses/" + row.text("file"));
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return std::move(read.problem);
}

Result solved(const Problem& problem) {
    RunOptions options;
    options.jobs = 2;
    return solve(problem, options);
}

/// The conditions of an optimum are met to 1e-13; at a change point the objective may move by the root of a length.
constexpr double within = 1e-12;

TEST(HardSyntheses, MeetTheBestValueAndAreVerified) {
    const auto rows = table("syntheses.csv");
    ASSERT_EQ(rows.size(), 21u);
    for (const Row& row : rows) {
        const Result result = solved(problem_of(row));
        EXPECT_EQ(result.status, Status::solved) << row.label();
        EXPECT_TRUE(result.verified()) << row.label();
        ASSERT_TRUE(result.best) << row.label();
        const Precise best = row.exact("best");
        EXPECT_LE(abs(Precise(result.best->objective) - best), within * abs(best))
            << row.label() << ": " << result.best->objective;
    }
}

/// A problem with the dimension at the limit itself and nothing to choose.
std::string at_the_limit(const std::string& mechanism, const std::string& dimensions) {
    return "schema = 1\nmechanism = \"" + mechanism + "\"\n[dimensions]\n" + dimensions;
}

// With a crank that no more than just turns a linkage has a pose from which it can go on in two ways; with a rod that
// no more than just reaches the slide, too.
TEST(HardSyntheses, AChangePointOrToggleIsNotCalledSolved) {
    for (const std::string& text :
         {at_the_limit("four-bar", "ground = 100\ncrank = 65\ncoupler = 90\nrocker = 75\n"),
          at_the_limit("four-bar", "ground = 100\ncrank = 50\ncoupler = 100\nrocker = 50\n"),
          at_the_limit("four-bar", "ground = 100\ncrank = 100\ncoupler = 75\nrocker = 75\n"),
          at_the_limit("drag-link",
                       "ground = 100\ncrank = 250\ncoupler = 150\nfollower = 200\narm = 100\n"
                       "arm-angle = 20\nrod = 300\nslide-angle = 10\nslide-offset = 0\n"),
          at_the_limit("slider-crank", "crank = 90\nrod = 100\noffset = 10\n"),
          at_the_limit("whitworth", "centre-distance = 50\ncrank = 120\narm = 100\nrod = 100\nslide-angle = 90\n")}) {
        const ReadProblem read = parse_problem(text, "limit.toml");
        ASSERT_TRUE(read.ok()) << text;
        const Result result = solved(read.problem);
        EXPECT_NE(result.status, Status::solved) << text;
        EXPECT_FALSE(result.verified()) << text;
    }
}

}  // namespace
}  // namespace mechwright::test
