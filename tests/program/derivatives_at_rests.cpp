// Derivatives by the dimensions of what is extreme beside a rest, which the dimensions move.

#include "tests/program/derivatives.h"

namespace mechwright::testing {
namespace {

TEST(DerivativesAtRests, AreThoseOfDifferences) {
    for (const char* objective : {"speed.speed.greatest", "speed.acceleration.greatest"})
        expect_exact_derivatives(problem_of(std::string(R"(schema = 1
mechanism = "linkage"
[dimensions]
ground = { min = 3.9, max = 4.2 }
crank = { min = 0.9, max = 1.1 }
coupler = { min = 3.4, max = 3.6 }
rocker = { min = 2.4, max = 2.6 }
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
[signals]
speed = { speed-of = "C" }
[objective]
minimize = ")") + objective + "\"\n"));
}

}  // namespace
}  // namespace mechwright::testing
