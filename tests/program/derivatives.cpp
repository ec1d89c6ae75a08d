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

}  // namespace

}  // namespace mechwright
