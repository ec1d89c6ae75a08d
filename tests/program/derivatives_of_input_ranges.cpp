// Programs of a linkage with several functions, lines and arcs, beside paths and poses: quantities of all and of each,
// and margins and signals along the stretch in which all are met.

#include <gtest/gtest.h>

#include <string>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

constexpr const char* links_of_ranges = R"(schema = 1
mechanism = "linkage"
[dimensions]
ground = { min = 5, max = 7 }
crank = { min = 1, max = 2 }
coupler = { min = 5, max = 7 }
rocker = { min = 4, max = 5 }
along = { min = -3, max = 3 }
across = { min = -3, max = 3 }
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["along", "across"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[signals]
swing = { angle = "rocker" }
lean = { angle = "coupler" }
)";

constexpr const char* two_functions = R"([[function]]
name = "low"
signal = "swing"
expression = "x^2"
x = [1, 2]
input = { start = { min = 20, max = 40 }, range = { min = 70, max = 90 } }
output = { start = { min = 90, max = 140 }, range = { min = 20, max = 40 } }
[[function]]
name = "high"
weight = 3
signal = "lean"
samples = [[0, 0], [1, 1], [2, 4]]
input = { start = { min = 280, max = 320 }, range = { min = -60, max = -40 } }
output = { start = { min = 20, max = 60 }, range = { min = -40, max = -20 } }
)";

constexpr const char* of_functions = R"([[objective]]
minimize = "function-max"
[[objective]]
minimize = "function-rms"
weight = 2
[[objective]]
minimize = "low.function-rms"
[[require]]
quantity = "high.function-max"
max = 3
[[require]]
quantity = "swing.range"
max = 50
[[require]]
quantity = "lean.mean"
min = 10
)";

constexpr const char* upper_path = R"([path]
point = "P"
points = [[1, 2], [0, 2.5], [-1, 2]]
)";

}  // namespace

TEST(DerivativesOfInputRanges, AreExactForSeveralFunctions) {
    expect_exact_derivatives(problem_of(std::string(links_of_ranges) + two_functions + of_functions));
}

TEST(DerivativesOfInputRanges, AreExactBesideAPath) {
    expect_exact_derivatives(problem_of(std::string(links_of_ranges) + two_functions + of_functions + upper_path));
    expect_exact_derivatives(
        problem_of(std::string(links_of_ranges) + two_functions + of_functions + upper_path +
                   "timing = \"prescribed\"\ncrank_angles = [0, 20, 50]\ncrank-start = { min = 90, max = 120 }\n"));
}

/// Offsets and radius are given: those that come closest make two distances equal, and which is the greatest then
/// changes.
TEST(DerivativesOfInputRanges, AreExactForLinesAndArcs) {
    expect_exact_derivatives(problem_of(links_of_ranges + std::string(R"([[line]]
name = "flat"
point = "P"
start = { min = 20, max = 40 }
range = { min = 50, max = 80 }
offset = 2
[[line]]
name = "other"
point = "C"
start = { min = 200, max = 220 }
range = { min = 50, max = 80 }
full_turn = true
offset = 3
[arc]
name = "round"
point = "P"
start = { min = 120, max = 140 }
range = { min = 50, max = 80 }
centre-x = 0.3
radius = 4
[[objective]]
minimize = "line-deviation"
[[objective]]
minimize = "arc-deviation"
[[require]]
quantity = "other.line-length"
min = 1
[[require]]
quantity = "lean.deviation"
max = 30
)")));
}

/// Three times sixteen extremes are more than a quantity has components: the greatest are kept.
TEST(DerivativesOfInputRanges, AreExactWhereTheGreatestExtremesAreKept) {
    const std::string third = R"([[function]]
name = "third"
signal = "swing"
expression = "x^3"
x = [1, 2]
input = { start = { min = 100, max = 140 }, range = 50 }
output = { start = { min = 90, max = 140 }, range = { min = 20, max = 40 } }
)";
    expect_exact_derivatives(problem_of(std::string(links_of_ranges) + two_functions + third +
                                        "[objective]\nminimize = \"function-max\"\n"));
}

}  // namespace mechwright::testing
