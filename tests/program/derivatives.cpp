// Gradients and Hessians of whole programs against differences of their values and gradients: the assembly of the
// program (scatter to variables, epigraphs, weights, path sums) is what is tested here; the formulas beneath are tested
// against fifty digits in tests/properties.

#include <gtest/gtest.h>

#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"
#include "synthesis/search/starts.h"

namespace mechwright {

namespace {

constexpr const char* head = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 60 }
crank = { min = 5, max = 15 }
coupler = { min = 20, max = 60 }
rocker = { min = 20, max = 60 }
)";
constexpr const char* placement = R"(point-along = { min = -30, max = 60 }
point-across = { min = -30, max = 60 }
origin-x = { min = -30, max = 30 }
origin-y = { min = -30, max = 30 }
tilt = { min = 0, max = 360 }
)";

Problem problem_of(const std::string& text) {
    ReadProblem read = parse_problem(text, "test.toml");
    for (const Message& m : read.messages)
        ADD_FAILURE() << to_string(m);
    return read.problem;
}

/// Derivatives at a start point of every variant against central differences, relative to the greatest entry.
void expect_exact_derivatives(const Problem& problem) {
    constexpr double h = 1e-6;
    int tested = 0;
    for (const Variant& variant : variants(problem)) {
        const Program program = build_program(problem, variant);
        Eigen::VectorXd x = start_point(program, 3, 1, 50);
        ProgramValues at;
        evaluate(program, x, true, at);
        if (!at.assembled) continue;
        ++tested;
        const auto n = static_cast<Eigen::Index>(program.size());
        const Eigen::VectorXd multipliers =
            Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(program.rows.size()), -1.0, 1.3);
        const Eigen::MatrixXd hessian = lagrangian_hessian(program, x, 0.7, multipliers);
        const double slope = 1 + at.gradient.cwiseAbs().maxCoeff();
        const double curvature = 1 + hessian.cwiseAbs().maxCoeff();
        for (Eigen::Index i = 0; i < n; ++i) {
            ProgramValues up;
            ProgramValues down;
            Eigen::VectorXd y = x;
            y[i] = x[i] + h;
            evaluate(program, y, true, up);
            y[i] = x[i] - h;
            evaluate(program, y, true, down);
            EXPECT_NEAR(at.gradient[i], (up.objective - down.objective) / (2 * h), 1e-7 * slope)
                << name_of(problem, variant) << ", " << program.variables[static_cast<std::size_t>(i)].name;
            for (Eigen::Index r = 0; r < at.rows.size(); ++r)
                EXPECT_NEAR(at.jacobian(r, i), (up.rows[r] - down.rows[r]) / (2 * h),
                            1e-7 * (1 + at.jacobian.row(r).cwiseAbs().maxCoeff()))
                    << program.rows[static_cast<std::size_t>(r)].name;
            const Eigen::VectorXd column =
                (0.7 * (up.gradient - down.gradient) + (up.jacobian - down.jacobian).transpose() * multipliers) /
                (2 * h);
            EXPECT_LE((hessian.col(i) - column).cwiseAbs().maxCoeff(), 1e-6 * curvature)
                << name_of(problem, variant) << ", " << program.variables[static_cast<std::size_t>(i)].name;
        }
    }
    EXPECT_GT(tested, 0);
}

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
    const std::string links = R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 62 }
crank = { min = 5, max = 15 }
coupler = { min = 22, max = 65 }
rocker = { min = 20, max = 58 }
[function]
input = { start = { min = 20, max = 90 }, range = { min = 60, max = 90 } }
output = { start = { min = 0, max = 90 }, range = { min = 30, max = 60 } }
)";
    for (const std::string quantity : {"function-max", "function-rms"})
        for (const std::string function :
             {"expression = \"x^1.5\"\nx = [1, 4]\n", "samples = [[0, 0], [1, 0.4], [2, 1.5], [3, 4]]\n"})
            expect_exact_derivatives(problem_of(links + function + "[objective]\nminimize = \"" + quantity + "\"\n"));
}

TEST(Derivatives, OfTransmissionOverAFreeInputRange) {
    expect_exact_derivatives(problem_of(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 62 }
crank = { min = 5, max = 15 }
coupler = { min = 22, max = 65 }
rocker = { min = 20, max = 58 }
[function]
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
    expect_exact_derivatives(problem_of(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 62 }
crank = { min = 5, max = 15 }
coupler = { min = 22, max = 65 }
rocker = { of = "coupler", times = 0.8 }
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

TEST(Derivatives, OfArcs) {
    expect_exact_derivatives(problem_of(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = { min = 20, max = 62 }
crank = { min = 5, max = 15 }
coupler = { min = 22, max = 65 }
rocker = { min = 20, max = 58 }
point-along = { min = -40, max = -20 }
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
crank = { min = 5, max = 15 }
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
    expect_exact_derivatives(problem_of(std::string(head) + placement + R"([path]
points = [[0, 0], [3, 8], [9, 12], [18, 9], [25, 2]]
timing = "free"
[objective]
minimize = ["path-rms", "total-length"]
reduce = "max"
)"));
}

constexpr const char* slider_crank_head = R"(schema = 1
mechanism = "slider-crank"
[dimensions]
crank = { min = 10, max = 40 }
rod = { min = 60, max = 160 }
offset = { min = -15, max = 15 }
)";
constexpr const char* shaper_head = R"(schema = 1
mechanism = "crank-shaper"
[dimensions]
centre-distance = { min = 90, max = 120 }
crank = { min = 30, max = 60 }
lever = { min = 150, max = 200 }
rod = { min = 100, max = 200 }
ram-distance = { min = 150, max = 190 }
)";
constexpr const char* whitworth_head = R"(schema = 1
mechanism = "whitworth"
[dimensions]
centre-distance = { min = 30, max = 60 }
crank = { min = 80, max = 120 }
arm = { min = 40, max = 60 }
rod = { min = 90, max = 200 }
slide-angle = { min = 40, max = 140 }
)";
constexpr const char* drag_link_head = R"(schema = 1
mechanism = "drag-link"
[dimensions]
ground = { min = 25, max = 35 }
crank = { min = 60, max = 80 }
coupler = { min = 60, max = 80 }
follower = { min = 60, max = 80 }
arm = { min = 40, max = 60 }
arm-angle = { min = -40, max = 40 }
rod = { min = 100, max = 200 }
slide-angle = { min = 20, max = 80 }
slide-offset = { min = -15, max = 15 }
)";
constexpr const char* ram_quantities = R"([[require]]
quantity = "transmission-angle-min"
min = 20
[[require]]
quantity = "transmission-angle-max"
max = 150
[[require]]
quantity = "ram-speed-max"
max = 90
[[require]]
quantity = "ram-acceleration-max"
max = 200
[[require]]
quantity = "stroke"
max = 100
[[require]]
quantity = "link-ratio"
max = 8
)";
constexpr const char* stroke_quantities = R"([quick-return]
working-share = 0.7
[[require]]
quantity = "time-ratio"
max = 1.3
[[require]]
quantity = "ram-speed-min-working"
min = 10
[[require]]
quantity = "speed-variation"
max = 0.5
[[objective]]
maximize = "transmission-angle-worst"
[[objective]]
minimize = "total-length"
weight = 0.3
)";

TEST(Derivatives, OfDrivesWithEveryQuantity) {
    for (const char* drive : {slider_crank_head, shaper_head, whitworth_head, drag_link_head})
        expect_exact_derivatives(problem_of(std::string(drive) + ram_quantities + stroke_quantities));
}

TEST(Derivatives, OfDrivesOverALimitedMotion) {
    for (const char* drive : {slider_crank_head, shaper_head, whitworth_head, drag_link_head})
        expect_exact_derivatives(
            problem_of(std::string(drive) + ram_quantities + "[motion]\ncrank_range = [30, 200]\n"));
}

TEST(Derivatives, OfThePathOfARodsPoint) {
    expect_exact_derivatives(problem_of(std::string(slider_crank_head) + placement + R"([path]
points = [[0, 0], [3, 8], [9, 12], [18, 9], [25, 2]]
timing = "free"
[objective]
minimize = "path-sse"
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

/// Segments of a cam whose angles and lifts are free, one of them a polynomial with free numbers.
const std::string free_motion = R"([[segment]]
kind = "rise"
angle = { min = 80, max = 100 }
lift = { min = 10, max = 12 }
law = "modified-sine"
[[segment]]
kind = "dwell"
angle = { min = 20, max = 120 }
[[segment]]
kind = "rise"
angle = { min = 50, max = 60 }
lift = { min = 4, max = 5 }
law = "polynomial"
start = [{ min = -0.2, max = 0.2 }, 0]
end = [0, { min = -1, max = 1 }]
shape = [{ min = -0.4, max = 0.4 }]
[[segment]]
kind = "return"
angle = { min = 120, max = 130 }
lift = { min = 14, max = 17 }
law = "spline"
shape = [{ min = 13, max = 14 }, 8, { min = 1, max = 2 }]
)";

std::string at_most(const std::vector<std::string>& quantities) {
    std::string text;
    for (const std::string& quantity : quantities)
        text += "[[require]]\nquantity = \"" + quantity + "\"\nmax = 1000\n";
    return text;
}

std::string cam(const std::string& kind, const std::string& dimensions, const std::vector<std::string>& quantities) {
    return "schema = 1\nmechanism = \"cam\"\n[cam]\n" + kind + "\n[dimensions]\n" + dimensions + free_motion +
           at_most(quantities) + "[objective]\nminimize = \"cam-size\"\n";
}

TEST(Derivatives, OfTranslatingCams) {
    const std::string load = R"(spring-rate = { min = 5, max = 9 }
precompression = { min = 10, max = 20 }
load = { min = 1, max = 3 }
weight = { min = 1, max = 3 }
guide-length = { min = 50, max = 60 }
overhang = { min = 20, max = 30 }
stem-diameter = { min = 10, max = 12 }
[dynamics]
mass = 0.01
speed = 100
friction = 0.1
)";
    expect_exact_derivatives(problem_of(cam(
        "follower = \"roller\"",
        "prime-radius = { min = 40, max = 60 }\noffset = { min = 2, max = 9 }\nroller-radius = { min = 3, max = 6 }\n" +
            load,
        {"pressure-angle-rise", "pressure-angle-return", "pressure-angle-max", "pitch-radius-min", "profile-radius-min",
         "undercut-margin", "velocity-max", "acceleration-max", "jerk-max", "velocity-jump", "acceleration-jump",
         "contact-force-min", "contact-force-max", "drive-torque-max", "jump-speed", "jamming-angle", "offset"})));
    expect_exact_derivatives(problem_of(cam(
        "follower = \"flat\"", "base-radius = { min = 60, max = 80 }\n" + load,
        {"profile-radius-min", "undercut-margin", "face-length", "velocity-max", "contact-force-max", "jump-speed"})));
}

TEST(Derivatives, OfOscillatingCams) {
    expect_exact_derivatives(problem_of(
        cam("follower = \"roller\"\nmotion = \"oscillating\"\nrotation = \"either\"",
            "prime-radius = { min = 40, max = 50 }\npivot-distance = { min = 70, max = 80 }\narm-length = { min = 50, "
            "max = "
            "60 }\nroller-radius = { min = 3, max = 6 }\n",
            {"start-angle", "pressure-angle-max", "pitch-radius-min", "undercut-margin", "acceleration-max"})));
    expect_exact_derivatives(problem_of(cam(
        "follower = \"flat\"\nmotion = \"oscillating\"\nrotation = \"either\"",
        "base-radius = { min = 60, max = 70 }\npivot-distance = { min = 110, max = 130 }\nface-offset = { min = 2, max "
        "= 8 }\n",
        {"start-angle", "pressure-angle-max", "profile-radius-min", "face-length"})));
}

}  // namespace

}  // namespace mechwright
