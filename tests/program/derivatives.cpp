// Derivatives of programs: four-bars, their functions, lines, paths and poses.

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

TEST(Derivatives, OfCrankRockerWithEveryMotionQuantity) {
    expect_exact_derivatives(problem_of(std::string(head) + R"([[require]]
quantity = "swing"
equal = 40
[[require]]
quantity = "time-ratio"
max = 1.3
[[require]]
quantity = "transmission-angle-min"
min = 20
[[require]]
quantity = "transmission-angle-max"
max = 150
[[require]]
quantity = "link-ratio"
max = 8
[[require]]
quantity = "grashof-margin"
min = 1
[[objective]]
maximize = "transmission-angle-worst"
[[objective]]
minimize = "total-length"
weight = 0.3
)"));
}

TEST(Derivatives, OfVelocityRatiosOverFullAndLimitedMotion) {
    const std::string ratios = R"([[require]]
quantity = "velocity-ratio-max"
max = 0.6
[objective]
maximize = "velocity-ratio-min"
)";
    expect_exact_derivatives(problem_of(std::string(head) + ratios));
    expect_exact_derivatives(problem_of(std::string(head) + ratios + "[motion]\ncrank_range = [30, 200]\n"));
}

TEST(Derivatives, OfFunctionsWithFreeScales) {
    // Ranges whose ends differ: a start where coupler and rocker are equal lies on a kink of the assembly margin.
    const std::string links = uneven_head + R"([function]
input = { start = { min = 20, max = 90 }, range = { min = 60, max = 90 } }
output = { start = { min = 0, max = 90 }, range = { min = 30, max = 60 } }
)";
    for (const std::string quantity : {"function-max", "function-rms"})
        for (const std::string function :
             {"expression = \"x^1.5\"\nx = [1, 4]\n", "samples = [[0, 0], [1, 0.4], [2, 1.5], [3, 4]]\n"})
            expect_exact_derivatives(problem_of(links + function + "[objective]\nminimize = \"" + quantity + "\"\n"));
}

TEST(Derivatives, OfTransmissionOverAFreeInputRange) {
    expect_exact_derivatives(problem_of(uneven_head + R"([function]
samples = [[0, 0], [1, 0.4], [2, 1.5], [3, 4]]
input = { start = { min = 20, max = 90 }, range = { min = 60, max = 90 } }
output = { start = { min = 0, max = 90 }, range = { min = 30, max = 60 } }
[[require]]
quantity = "transmission-angle-min"
min = 30
[[require]]
quantity = "transmission-angle-max"
max = 140
[objective]
maximize = "transmission-angle-worst"
)"));
}

TEST(Derivatives, OfLinesWithTiedDimensions) {
    const std::string line = R"([line]
start = { min = 20, max = 90 }
range = { min = 60, max = 90 }
[[require]]
quantity = "line-length"
min = 8
[[require]]
quantity = "transmission-angle-worst"
min = 30
[objective]
minimize = "line-deviation"
)";
    expect_exact_derivatives(problem_of(uneven_links + R"(rocker = { of = "coupler", times = 0.8 }
point-along = { of = "coupler", times = 2 }
point-across = { of = "crank", times = -0.5 }
tilt = { min = 0, max = 90 }
)" + line));
    expect_exact_derivatives(problem_of(R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 5, max = 15 }
rod = { min = 22, max = 65 }
offset = { min = -3, max = 5 }
point-along = { of = "rod", times = 0.4 }
point-across = { min = -3, max = 5 }
)" + line));
}

TEST(Derivatives, OfSumsOfDimensions) {
    expect_exact_derivatives(problem_of(uneven_links + R"(rocker = "0.5 ground + 0.25 coupler + 5"
[function]
expression = "x^1.5"
x = [1, 4]
input = { start = { min = 20, max = 90 }, range = { min = 60, max = 90 } }
output = { start = "170 - 0.8 input-start + 0.1 input-range", range = { of = "input-range", times = 0.4, plus = 10 } }
[[require]]
quantity = "transmission-angle-min"
min = 30
[objective]
minimize = "function-max"
)"));
}

TEST(Derivatives, OfArcs) {
    expect_exact_derivatives(problem_of(uneven_head + R"(point-along = { min = -40, max = -20 }
point-across = { min = 20, max = 40 }
[arc]
start = { min = 20, max = 90 }
range = { min = 60, max = 90 }
radius = { min = 30, max = 80 }
[[require]]
quantity = "arc-angle"
min = 20
[objective]
minimize = "arc-deviation"
)"));
}

TEST(Derivatives, OfFunctionsOfARam) {
    // No ram follows this zigzag closely: the root of a small sum of squares would bend too much for differences.
    for (const std::string quantity : {"function-max", "function-rms"})
        expect_exact_derivatives(problem_of(R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 6, max = 15 }
rod = { min = 45, max = 65 }
offset = { min = -3, max = 5 }
[function]
samples = [[0, 0], [1, 2], [2, 0.5], [3, 3], [4, 2.2], [5, 4]]
input = { start = { min = 20, max = 90 }, range = { min = 60, max = 90 } }
output = { start = { min = 20, max = 60 }, range = { min = -10, max = -5 } }
[[require]]
quantity = "transmission-angle-worst"
min = 30
[objective]
minimize = ")" + quantity + "\"\n"));
}

TEST(Derivatives, OfPosesWithEveryMeasure) {
    const std::string body =
        "body-angle = { min = 0, max = 360 }\n[poses]\nposes = [[0, 0, 10], [3, 8, 30], [9, 12, 45]]\n"
        "length = 7\n[[require]]\nquantity = \"pose-max\"\nmax = 3\n[objective]\nminimize = \"pose-rms\"\n";
    expect_exact_derivatives(problem_of(std::string(head) + placement + body));
}

TEST(Derivatives, OfTimedPathWithEveryPathMeasure) {
    expect_exact_derivatives(problem_of(std::string(head) + placement + R"(crank-start = { min = 0, max = 360 }
[path]
points = [[0, 0], [3, 8], [9, 12], [18, 9]]
timing = "prescribed"
crank_angles = [0, 40, 90, 130]
weights = [1, 2, 3, 1]
[[require]]
quantity = "path-max"
max = 4
[[objective]]
minimize = "path-rms"
[[objective]]
minimize = "path-sse"
weight = 0.2
[[objective]]
minimize = "path-max"
weight = 0.5
)"));
}

TEST(Derivatives, OfUntimedPathWithMinimax) {
    expect_exact_derivatives(problem_of(uneven_head + placement + R"([path]
points = [[0, 0], [3, 8], [9, 12], [18, 9], [25, 2]]
timing = "free"
[objective]
minimize = ["path-rms", "total-length"]
reduce = "max"
)"));
}

TEST(Derivatives, OfTheDistanceFromPreferredValues) {
    expect_exact_derivatives(problem_of(std::string(head) + "[[require]]\nquantity = \"swing\"\nmin = 30\n"));
}

TEST(Derivatives, ValuesAreTheSameBitsWithAndWithoutDerivatives) {
    const Problem problem = problem_of(std::string(head) + placement + R"([path]
points = [[0, 0], [3, 8], [9, 12], [18, 9]]
timing = "prescribed"
crank_angles = [0, 40, 90, 130]
[objective]
minimize = "path-sse"
)");
    const Program program = build_program(problem, variants(problem).front());
    for (int i = 0; i < 20; ++i) {
        const Eigen::VectorXd x = start_point(program, 7, i, 20);
        ProgramValues plain;
        ProgramValues full;
        evaluate(program, x, false, plain);
        evaluate(program, x, true, full);
        EXPECT_EQ(plain.objective, full.objective);
        EXPECT_EQ(plain.rows, full.rows);
    }
}

TEST(Derivatives, OfPosesAlongAStretchWithTiedLinks) {
    const std::string poses = R"(body-angle = { min = 0, max = 360 }
[poses]
poses = [[0, 0, 0], [10, 3, 20], [20, 4, 35], [31, 2, 50]]
length = 10
[objective]
minimize = "pose-rms"
)";
    const std::string free = uneven_head + placement;
    expect_exact_derivatives(problem_of(free + poses));
    std::string tied = free;
    const std::string rocker = "rocker = { min = 20, max = 58 }";
    tied.replace(tied.find(rocker), rocker.size(), "rocker = { of = \"coupler\", times = 1.3 }");
    expect_exact_derivatives(problem_of(tied + poses));
    std::string summed = free;
    summed.replace(summed.find(rocker), rocker.size(), "rocker = \"0.7 coupler + 0.3 ground - crank + 12\"");
    expect_exact_derivatives(problem_of(summed + poses));
}

}  // namespace

}  // namespace mechwright::testing
