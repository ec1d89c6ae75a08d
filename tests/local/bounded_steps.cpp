// Steps to the least of a quadratic model within limits: against every choice of limits that may hold, and against
// steps beside them.

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>

#include "synthesis/search/curve/bounded_step.h"
#include "synthesis/search/curve/shapes.h"

namespace mechwright::bounded_steps {
namespace {

/// A model of ill-conditioned curvature, and limits that no step at all keeps to.
struct StepModel {
    StepMatrix matrix;
    StepVector slope;
    StepLimits limits;

    double value(const StepVector& s) const { return slope.dot(s) + s.dot(matrix * s) / 2; }
    double passed(const StepVector& s) const {
        double worst = 0;
        for (const StepLimit& limit : limits)
            worst = std::max(worst, limit.least - limit.normal.dot(s));
        return worst;
    }
    /// The step without limits, where the method begins, may be a million times as long: what its last digits are worth
    /// in sums of nine, after some ten changes.
    double rounding() const { return 1e-14 * (1 + StepVector(matrix.llt().solve(slope)).norm()); }
    StepVector step() const { return bounded_step(Eigen::LLT<StepMatrix>(matrix), slope, limits); }
};

StepVector random_vector(Eigen::Index n, RandomNumbers& random) {
    StepVector v(n);
    for (double& x : v)
        x = random.normal();
    return v;
}

StepModel random_model(Eigen::Index n, RandomNumbers& random) {
    StepModel model{StepMatrix::Zero(n, n), random_vector(n, random), {}};
    for (Eigen::Index i = 0; i < n; ++i) {
        const StepVector row = random_vector(n, random);
        model.matrix += std::pow(10, -5 * random.even()) * row * row.transpose();
        model.matrix(i, i) += 1e-6;
    }
    // Now and then a limit is met already.
    const auto least = [&] { return random.even() < 0.2 ? 0 : -random.even(); };
    for (Eigen::Index i = 0; i < n; ++i) {
        model.limits.push_back({StepVector::Unit(n, i), least()});
        model.limits.push_back({-StepVector::Unit(n, i), least()});
    }
    for (int i = 0; i < 3; ++i)
        model.limits.push_back({random_vector(n, random), least()});
    return model;
}

/// The least on the flat where some limits hold with nothing to spare, if there is one.
StepVector least_where_held(const StepModel& m, unsigned held) {
    const Eigen::Index n = m.slope.size();
    const auto count = static_cast<Eigen::Index>(__builtin_popcount(held));
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(n + count, n + count);
    Eigen::VectorXd right(n + count);
    all.topLeftCorner(n, n) = m.matrix;
    right.head(n) = -m.slope;
    Eigen::Index row = n;
    for (unsigned i = 0; i < m.limits.size(); ++i) {
        if ((held >> i & 1U) == 0) continue;
        all.row(row).head(n) = m.limits[i].normal.transpose();
        all.col(row).head(n) = m.limits[i].normal;
        right[row++] = m.limits[i].least;
    }
    return Eigen::VectorXd(all.fullPivLu().solve(right)).head(n);
}

TEST(BoundedSteps, AreTheBestOfAllChoicesOfLimitsThatHold) {
    RandomNumbers random(17);
    for (int trial = 0; trial < 60; ++trial) {
        const Eigen::Index n = 1 + trial % 3;
        const StepModel model = random_model(n, random);
        double least = 0;
        for (unsigned held = 0; held < 1U << model.limits.size(); ++held) {
            if (__builtin_popcount(held) > n) continue;
            const StepVector s = least_where_held(model, held);
            if (s.allFinite() && model.passed(s) < 1e-9) least = std::min(least, model.value(s));
        }
        const StepVector step = model.step();
        EXPECT_LE(model.passed(step), model.rounding());
        EXPECT_NEAR(model.value(step), least, 1e-8 * (1 + std::abs(least))) << trial;
    }
}

TEST(BoundedSteps, OfAllArgumentsAreBetterThanStepsBesideThem) {
    RandomNumbers random(23);
    for (int trial = 0; trial < 60; ++trial) {
        const StepModel model = random_model(most_step_size, random);
        const StepVector step = model.step();
        EXPECT_LE(model.passed(step), model.rounding());
        const double least = model.value(step);
        EXPECT_LE(least, 0);
        for (int k = 0; k < 400; ++k) {
            const double size = std::pow(10, -4 * random.even());
            StepVector beside = step + size * random_vector(most_step_size, random);
            // Back towards no step at all until all limits are kept.
            for (int i = 0; i < 60 && model.passed(beside) > 0; ++i)
                beside *= 0.8;
            if (model.passed(beside) > 0) continue;
            EXPECT_GE(model.value(beside), least - 1e-9 * (1 + std::abs(least)));
            const StepVector between = 0.99 * step + 0.01 * beside;
            EXPECT_GE(model.value(between), least - 1e-9 * (1 + std::abs(least)));
        }
    }
}

}  // namespace
}  // namespace mechwright::bounded_steps
