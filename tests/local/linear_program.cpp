// Linear programs against the best of all their vertices, degenerate ones too.

#include "synthesis/local/linear_program.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Random planes that leave the origin feasible, within a box.
LinearProgram random_program(std::mt19937_64& random, Index size, Index planes) {
    std::normal_distribution<double> number;
    LinearProgram p{VectorXd(size), MatrixXd::Zero(planes + 2 * size, size), VectorXd::Ones(planes + 2 * size)};
    for (Index i = 0; i < size; ++i) {
        p.cost[i] = number(random);
        p.rows(planes + 2 * i, i) = 1;
        p.rows(planes + 2 * i + 1, i) = -1;
    }
    for (Index r = 0; r < planes; ++r) {
        for (Index i = 0; i < size; ++i)
            p.rows(r, i) = number(random);
        p.limit[r] = 0.5 * std::abs(number(random));
    }
    return p;
}

bool feasible(const LinearProgram& p, const VectorXd& z) {
    return ((p.rows * z - p.limit).array() <= 1e-9 * (1 + p.limit.array().abs())).all();
}

/// The least cost of all points where as many planes meet as there are variables.
double best_vertex(const LinearProgram& p) {
    const Index size = p.cost.size(), count = p.rows.rows();
    double best = 1e300;
    std::vector<bool> chosen(static_cast<std::size_t>(count), false);
    std::fill_n(chosen.begin(), size, true);
    do {
        MatrixXd planes(size, size);
        VectorXd limits(size);
        for (Index r = 0, k = 0; r < count; ++r)
            if (chosen[static_cast<std::size_t>(r)]) {
                planes.row(k) = p.rows.row(r);
                limits[k++] = p.limit[r];
            }
        const Eigen::FullPivLU<MatrixXd> lu(planes);
        if (!lu.isInvertible()) continue;
        const VectorXd z = lu.solve(limits);
        if (feasible(p, z)) best = std::min(best, p.cost.dot(z));
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    return best;
}

TEST(LinearPrograms, HaveTheirBestVertexAsSolution) {
    std::mt19937_64 random(1);
    for (int k = 0; k < 200; ++k) {
        const Index size = 2 + k % 3;
        const LinearProgram p = random_program(random, size, 6);
        const VectorXd z = solution_of(p, VectorXd::Zero(size));
        EXPECT_TRUE(feasible(p, z)) << k;
        EXPECT_NEAR(p.cost.dot(z), best_vertex(p), 1e-10) << k;
    }
}

TEST(LinearPrograms, MayHavePlanesTwiceAndThroughTheStart) {
    std::mt19937_64 random(2);
    for (int k = 0; k < 200; ++k) {
        const Index size = 2 + k % 3;
        LinearProgram p = random_program(random, size, 6);
        p.rows.row(1) = p.rows.row(0);
        p.limit[1] = p.limit[0];
        p.rows.row(2) = 3 * p.rows.row(0);
        p.limit[2] = 3 * p.limit[0];
        p.limit.segment(3, 3).setZero();
        const VectorXd z = solution_of(p, VectorXd::Zero(size));
        EXPECT_TRUE(feasible(p, z)) << k;
        EXPECT_NEAR(p.cost.dot(z), best_vertex(p), 1e-10) << k;
    }
}

/// The straight line nearest to e^x in [0, 1], at its 41 samples: known in closed form for all of the interval.
TEST(LinearPrograms, FindTheNearestStraightLine) {
    constexpr Index samples = 41;
    LinearProgram p{VectorXd::Unit(3, 2), MatrixXd(2 * samples, 3), VectorXd(2 * samples)};
    for (Index i = 0; i < samples; ++i) {
        const double x = static_cast<double>(i) / (samples - 1);
        p.rows.row(2 * i) << 1, x, -1;
        p.rows.row(2 * i + 1) << -1, -x, -1;
        p.limit[2 * i] = std::exp(x);
        p.limit[2 * i + 1] = -std::exp(x);
    }
    const VectorXd z = solution_of(p, VectorXd::Unit(3, 2) * 10);
    const double slope = std::exp(1.0) - 1, greatest = 0.5 * (1 - slope + slope * std::log(slope));
    EXPECT_NEAR(z[1], slope, 1e-12);
    EXPECT_NEAR(z[2], greatest, 2e-4);
    EXPECT_LT(z[2], greatest);
}

}  // namespace

}  // namespace mechwright
