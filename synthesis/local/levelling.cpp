#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "synthesis/local/local.h"
#include "synthesis/program/path_outputs.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// What is made small along the input range; null where there is no such thing.
const Quantity* errors_of(const Program& program) {
    if (program.problem->followed)
        return followed_shape_of(*program.problem->mechanism, *program.problem->followed).errors;
    return program.problem->function ? program.problem->mechanism->function_errors : nullptr;
}

constexpr int most_steps = 200;
constexpr int most_corrections = 4;
constexpr int most_equalisations = 20;
constexpr double shortest_step = 0.01;
/// Extremes above this part of the greatest will be among those of one size.
constexpr double counts_from = 0.3;
constexpr int most_tries_of_step = 8;
/// The sum has settled once a step gains less than this part of it.
constexpr double settled_within = 1e-10;

/// The error along the range and its derivatives by the variables.
struct Errors {
    VectorXd value;
    MatrixXd jacobian;

    Errors(const Program& program, const VectorXd& x, bool derivatives) {
        const Quantity& q = *errors_of(program);
        const Motion motion = motion_of(*program.problem, program.variant.family, program.variant.assembly);
        const auto count = static_cast<Index>(q.components(motion)), reads = static_cast<Index>(q.reads);
        value.resize(count);
        Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor> gradient(derivatives ? count : 0, reads);
        q.measure(motion, dimensions_at(program, x),
                  {{value.data(), static_cast<std::size_t>(count)},
                   {gradient.data(), static_cast<std::size_t>(gradient.size())},
                   {}});
        if (!derivatives) return;
        jacobian.setZero(count, x.size());
        for (Index i = 0; i < reads; ++i)
            if (const std::ptrdiff_t v = program.variable_of[static_cast<std::size_t>(i)]; v >= 0)
                jacobian.col(v) += program.times[static_cast<std::size_t>(i)] * gradient.col(i);
    }
};

/// The step that makes the linearised values least, held back by `damping` in units of each column.
VectorXd damped_step(const MatrixXd& jacobian, const VectorXd& value, double damping) {
    const Index m = jacobian.rows(), n = jacobian.cols();
    VectorXd scale = jacobian.colwise().norm();
    MatrixXd stacked = MatrixXd::Zero(m + n, n);
    for (Index j = 0; j < n; ++j) {
        if (!(scale[j] > 0)) scale[j] = 1;
        stacked.col(j).head(m) = jacobian.col(j) / scale[j];
        stacked(m + j, j) = damping;
    }
    VectorXd right = VectorXd::Zero(m + n);
    right.head(m) = -value;
    const VectorXd step = stacked.completeOrthogonalDecomposition().solve(right);
    return step.cwiseQuotient(scale);
}

/// The extremes of the error at a point, and their derivatives: the rows that keep the worst above them read
/// t - extreme >= 0.
struct Extremes {
    VectorXd value;
    MatrixXd jacobian;

    Extremes(const Program& program, const VectorXd& x) {
        ProgramValues values;
        evaluate(program, x, true, values);
        if (!values.assembled) return;
        const std::size_t t = program.epigraphs.front().variable;
        std::vector<Index> rows;
        double greatest = 0;
        const auto extreme = [&](Index row) { return x[static_cast<Index>(t)] - values.rows[row]; };
        for (std::size_t r = 0; r < program.rows.size(); ++r) {
            const auto& variables = program.rows[r].form.variables;
            if (variables.size() != 1 || variables.front().index != t) continue;
            rows.push_back(static_cast<Index>(r));
            greatest = std::max(greatest, extreme(rows.back()));
        }
        std::erase_if(rows, [&](Index row) { return extreme(row) < counts_from * greatest; });
        value.resize(static_cast<Index>(rows.size()));
        jacobian.resize(value.size(), x.size());
        for (std::size_t k = 0; k < rows.size(); ++k) {
            value[static_cast<Index>(k)] = extreme(rows[k]);
            jacobian.row(static_cast<Index>(k)) = -values.jacobian.row(rows[k]);
        }
        jacobian.col(static_cast<Index>(t)).setZero();
    }
};

/// Newton's method on what a minimax optimum is known by: extremes of one size. Ends where the greatest falls no more.
VectorXd equalised(const Program& program, VectorXd x) {
    const auto t = static_cast<Index>(program.epigraphs.front().variable);
    for (int k = 0; k < most_equalisations; ++k) {
        Extremes here(program, x);
        if (here.value.size() == 0 || !here.jacobian.allFinite()) break;
        here.jacobian.col(t).setConstant(-here.value.maxCoeff());
        const VectorXd step = damped_step(here.jacobian, here.value, 0);
        bool moved = false;
        for (double length = 1; length > shortest_step && !moved; length *= 0.5) {
            VectorXd next = within_bounds(program, x + length * step);
            settle_epigraphs(program, next);
            for (int c = 0; c < most_corrections; ++c) {
                Extremes there(program, next);
                if (there.value.size() != here.value.size()) break;
                // The column of t stands for the size that all are to have.
                VectorXd strayed = there.value - (here.value + length * (here.jacobian * step));
                VectorXd corrected = within_bounds(program, next + damped_step(here.jacobian, strayed, 0));
                settle_epigraphs(program, corrected);
                if (!(corrected[t] < next[t])) break;
                next = std::move(corrected);
            }
            moved = next[t] < x[t];
            if (moved) x = std::move(next);
        }
        if (!moved) break;
    }
    return x;
}

}  // namespace

Eigen::VectorXd levelled(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    VectorXd x = start;
    if (errors_of(program) == nullptr) return x;
    double damping = 1e-3;
    for (int k = 0; k < most_steps && !limits.reached(); ++k) {
        const Errors here(program, x, true);
        if (!here.value.allFinite() || !here.jacobian.allFinite()) return start;
        const double sum = here.value.squaredNorm();
        double gained = 0;
        for (int tries = 0; tries < most_tries_of_step && gained == 0; ++tries) {
            const VectorXd step = damped_step(here.jacobian, here.value, damping);
            VectorXd next = within_bounds(program, x + step);
            Errors there(program, next, false);
            // Back to where the linear values would be: along a curved valley this is what allows long steps.
            for (int c = 0; c < most_corrections; ++c) {
                const VectorXd strayed = there.value - (here.value + here.jacobian * step);
                const VectorXd corrected = within_bounds(program, next + damped_step(here.jacobian, strayed, damping));
                Errors nearer(program, corrected, false);
                if (!(nearer.value.squaredNorm() < there.value.squaredNorm())) break;
                next = corrected;
                there = std::move(nearer);
            }
            if (there.value.squaredNorm() < sum) {
                gained = 1 - there.value.squaredNorm() / sum;
                x = next;
                damping = std::max(0.1 * damping, 1e-15);
            } else {
                damping *= 10;
            }
        }
        if (gained < settled_within) break;
    }
    settle_epigraphs(program, x);
    return program.epigraphs.size() == 1 ? equalised(program, std::move(x)) : x;
}

}  // namespace mechwright
