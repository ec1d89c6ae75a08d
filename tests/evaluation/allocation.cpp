// No evaluation allocates: once an object for results has been used for a program, its memory serves every later point.

#include <Eigen/Core>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/four_bar.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "analysis/quick_return.h"
#include "analysis/slider_crank.h"
#include "tests/evaluation/counted.h"
#include "tests/evaluation/shipped.h"

namespace mechwright::testing {

namespace {

/// Requests for memory while something is done.
template <class Do>
long requests_of(const Do& what) {
    const long before = allocations();
    what();
    return allocations() - before;
}

class Allocation : public ::testing::Test {
protected:
    void SetUp() override {
        if (!allocations_are_counted()) GTEST_SKIP() << "not counted under the sanitizers";
    }
};

TEST_F(Allocation, IsSeenByTheCount) {
    EXPECT_GT(requests_of([] {
                  int* volatile kept = new int(1);  // else the compiler does without
                  delete kept;
              }),
              0);
    EXPECT_GT(requests_of([] { Eigen::VectorXd::Zero(100).eval(); }), 0);
}

TEST_F(Allocation, IsNotNeededToEvaluateAShippedProblem) {
    int programs = 0;
    for_each_program(4, [&](const std::string& name, const Program& program, const auto& points) {
        ++programs;
        ProgramValues plain, full;
        PathResiduals residuals;
        LagrangianHessian hessian;
        const Eigen::VectorXd multipliers = Eigen::VectorXd::Ones(static_cast<Eigen::Index>(program.rows.size()));
        const auto values = [&](const Eigen::VectorXd& x) { evaluate(program, x, false, plain); };
        const auto gradients = [&](const Eigen::VectorXd& x) { evaluate(program, x, true, full); };
        const auto worst = [&](const Eigen::VectorXd& x) { violation(program, x, plain); };
        const auto of_points = [&](const Eigen::VectorXd& x) {
            if (program.path) path_residuals(program, x, true, residuals);
        };
        const auto second = [&](const Eigen::VectorXd& x) { lagrangian_hessian(program, x, 1, multipliers, hessian); };
        const auto expect_none = [&](const char* what, const auto& evaluation) {
            evaluation(points.front());
            for (const Eigen::VectorXd& x : points)
                EXPECT_EQ(requests_of([&] { evaluation(x); }), 0) << what << " of " << name;
        };
        expect_none("values", values);
        expect_none("gradients", gradients);
        expect_none("violation", worst);
        expect_none("residuals", of_points);
        expect_none("Hessian", second);
    });
    EXPECT_GT(programs, 90);
}

TEST_F(Allocation, IsNotNeededToScreenAGroupOfCandidates) {
    const Mechanism& four_bar = *find_mechanism("four-bar");
    std::array<Group, 4> lengths;
    for (std::size_t lane = 0; lane < 8; ++lane)
        for (std::size_t i = 0; i < 4; ++i)
            lengths[i][lane] = std::array{4.0, 1.0, 3.0, 3.5}[i] + 0.05 * static_cast<double>(lane);
    std::vector<ScreenedPoint> points;
    for (int k = 0; k < 12; ++k) {
        const double angle = k * std::numbers::pi / 6;
        points.push_back({{std::cos(angle), 0.5 * std::sin(angle)}, 1, {std::cos(angle / 2), std::sin(angle / 2)}});
    }
    double score = 0;
    const auto screen = [&] {
        score = four_bar.point->screening(widest_instruction_set(), 0, lengths, points, {true, true, true}).score[0];
    };
    EXPECT_EQ(requests_of(screen), 0);
    EXPECT_GT(score, 0);
}

TEST_F(Allocation, IsNotNeededForTheGuidedPointOfALinkage) {
    const ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/linkage/six-bar-timed-points.toml");
    ASSERT_TRUE(read.ok());
    const Mechanism& six_bar = *read.problem.mechanism;
    const std::vector<double> dimensions{40, 120, 150};
    std::array<double, 4> gradient_x{}, gradient_y{};
    std::array<double, 10> hessian_x{}, hessian_y{};
    PathMiss out{{}, 0, gradient_x, gradient_y, hessian_x, hessian_y};
    const auto miss = [&] {
        six_bar.point->miss({six_bar.model.data(), 0}, dimensions, 1.0, Vector<double>{100, 200}, out);
    };
    EXPECT_EQ(requests_of(miss), 0);
    EXPECT_GT(out.margin, 0);
    EXPECT_NE(gradient_x[3], 0);
    EXPECT_NE(hessian_y[9], 0);
}

/// Position, velocity, acceleration and the extremes of them, as numbers of type T.
template <class T>
double analysed() {
    const T angle(0.7);
    const FourBar<T> links{T(4.0), T(1.0), T(3.0), T(3.5)};
    const auto p = pose(links, angle, Assembly::open);
    const auto v = velocity(links, p);
    const auto a = acceleration(links, p, v);
    const auto point = position(links, CouplerPoint<T>{T(1.0), T(0.5)}, p);
    const SliderCrank<T> drive{T(1.0), T(3.0), T(0.2)};
    return value_of(T(a.rocker + point.x + swing(links) + stroke_excess(links) + ram_velocity(drive, angle) +
                      ram_acceleration(drive, angle) + stroke(drive)));
}

TEST_F(Allocation, IsNotNeededByTheKernelsOfTheAnalysis) {
    double sum = 0;
    const auto kernels = [&] {
        sum += analysed<double>() + analysed<Dual<double, 4>>() + analysed<SecondDual<double, 4>>();
        const CrankRange<double> turn{true, 0, 2 * std::numbers::pi};
        const FourBar<double> links{4, 1, 3, 3.5};
        const SliderCrank<double> drive{1, 3, 0.2};
        sum += velocity_ratio_extremes(links, Assembly::open, turn).at[0] + ram_velocity_extremes(drive, turn).at[0] +
               ram_acceleration_extremes(drive, turn).at[0];
    };
    EXPECT_EQ(requests_of(kernels), 0);
    EXPECT_TRUE(std::isfinite(sum));
}

}  // namespace

}  // namespace mechwright::testing
