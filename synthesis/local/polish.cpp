#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/local/local.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// How close to its limit a constraint counts as active: solvers end within the first of these. Where no step leads on,
/// the set was perhaps too small, and those farther away are tried, each time so many times as far.
constexpr double active_within = 1e-5, farthest_active = 1e-2, times_farther = 10;
/// Singular values and curvatures below this part of the greatest are taken as zero.
constexpr double rank_tolerance = 1e-11;
constexpr int most_steps = 60;
/// A sum of squares below this is zero by rounding.
constexpr double square_of_rounding = 1e-26;

/// A constraint held at a limit during one Newton step.
struct Active {
    Index row;  ///< of the program, or -1 for a bound
    Index variable;
    double limit;
    int sign;  ///< +1: at its upper limit, -1: at its lower, 0: equality
};

std::vector<Active> active_constraints(const Program& program, const VectorXd& x, const ProgramValues& v,
                                       double within) {
    std::vector<Active> active;
    const auto consider = [&](Index row, Index variable, double value, double lower, double upper) {
        if (lower == upper)
            active.push_back({row, variable, lower, 0});
        else if (value - lower <= within)
            active.push_back({row, variable, lower, -1});
        else if (upper - value <= within)
            active.push_back({row, variable, upper, 1});
    };
    for (std::size_t r = 0; r < program.rows.size(); ++r)
        consider(static_cast<Index>(r), -1, v.rows[static_cast<Index>(r)], program.rows[r].lower,
                 program.rows[r].upper);
    for (std::size_t i = 0; i < program.size(); ++i)
        consider(-1, static_cast<Index>(i), x[static_cast<Index>(i)], program.variables[i].lower,
                 program.variables[i].upper);
    return active;
}

struct Linearised {
    MatrixXd gradients;  ///< [active][variable]
    VectorXd residual;   ///< value - limit
};

Linearised linearise(const std::vector<Active>& active, const VectorXd& x, const ProgramValues& v) {
    Linearised l{MatrixXd::Zero(static_cast<Index>(active.size()), x.size()),
                 VectorXd::Zero(static_cast<Index>(active.size()))};
    for (std::size_t k = 0; k < active.size(); ++k) {
        const auto i = static_cast<Index>(k);
        const Active& a = active[k];
        if (a.row >= 0)
            l.gradients.row(i) = v.jacobian.row(a.row);
        else
            l.gradients(i, a.variable) = 1;
        l.residual[i] = (a.row >= 0 ? v.rows[a.row] : x[a.variable]) - a.limit;
    }
    return l;
}

/// Multipliers that balance the gradient best; inequalities that would have to pull the wrong way are let go, the worst
/// first, until none does.
VectorXd multipliers_of(std::vector<Active>& active, const VectorXd& x, const ProgramValues& v, Linearised& l) {
    while (true) {
        l = linearise(active, x, v);
        if (active.empty()) return {};
        const VectorXd lambda = l.gradients.transpose().completeOrthogonalDecomposition().solve(-v.gradient);
        Index worst = -1;
        double most = 1e-9 * (v.gradient.lpNorm<Eigen::Infinity>() + 1e-300);
        for (std::size_t k = 0; k < active.size(); ++k) {
            const double wrong = -active[k].sign * lambda[static_cast<Index>(k)];
            // A violated constraint stays, whatever it pulls.
            const bool violated = active[k].sign * l.residual[static_cast<Index>(k)] > 1e-13;
            if (active[k].sign != 0 && !violated && wrong > most) {
                most = wrong;
                worst = static_cast<Index>(k);
            }
        }
        if (worst < 0) return lambda;
        active.erase(active.begin() + worst);
    }
}

/// The Newton step in two parts: back onto the active constraints by the shortest way, and along them to where the
/// curved objective is stationary. Directions without curvature are left alone, those of negative curvature are turned
/// downhill.
struct NewtonStep {
    VectorXd back;
    VectorXd along;
};

NewtonStep newton_step(const MatrixXd& hessian, const VectorXd& gradient, const Linearised& l) {
    const Index n = gradient.size();
    NewtonStep step{VectorXd::Zero(n), VectorXd::Zero(n)};
    MatrixXd along = MatrixXd::Identity(n, n);
    if (l.residual.size() > 0) {
        Eigen::JacobiSVD<MatrixXd> svd(l.gradients, Eigen::ComputeFullU | Eigen::ComputeFullV);
        svd.setThreshold(rank_tolerance);
        step.back = -svd.solve(l.residual);
        along = svd.matrixV().rightCols(n - svd.rank());
    }
    if (along.cols() == 0) return step;
    const MatrixXd reduced = along.transpose() * hessian * along;
    const VectorXd slope = along.transpose() * (gradient + hessian * step.back);
    const Eigen::SelfAdjointEigenSolver<MatrixXd> eigen(0.5 * (reduced + reduced.transpose()));
    const double greatest = eigen.eigenvalues().cwiseAbs().maxCoeff();
    VectorXd coefficients = eigen.eigenvectors().transpose() * slope;
    for (Index i = 0; i < coefficients.size(); ++i) {
        const double curvature = std::abs(eigen.eigenvalues()[i]);
        coefficients[i] = curvature > rank_tolerance * greatest ? -coefficients[i] / curvature : 0;
    }
    step.along = along * (eigen.eigenvectors() * coefficients);
    return step;
}

/// What of a gradient no multipliers of the active constraints balance.
VectorXd unbalanced_by(const VectorXd& gradient, const Linearised& active) {
    if (active.residual.size() == 0) return gradient;
    const MatrixXd columns = active.gradients.transpose();
    return gradient - columns * columns.completeOrthogonalDecomposition().solve(gradient);
}

/// The multipliers of the active constraints as those of all rows.
VectorXd by_rows(const Program& program, const std::vector<Active>& active, const VectorXd& lambda) {
    VectorXd on_rows = VectorXd::Zero(static_cast<Index>(program.rows.size()));
    for (std::size_t i = 0; i < active.size(); ++i)
        if (active[i].row >= 0) on_rows[active[i].row] += lambda[static_cast<Index>(i)];
    return on_rows;
}

/// A violation that rounding explains.
constexpr double least_violation = 4e-15;

/// Whether a step was worth taking: much closer to the constraints, at a price in the objective that the way back onto
/// them explains; or lower, by more than the constraints that it strays from are worth at `price` for each unit.
bool better(const LocalOutcome& there, const LocalOutcome& here, double price) {
    const double size = 1 + std::abs(here.objective);
    if (there.violation < 0.5 * here.violation && here.violation > least_violation)
        return there.objective < here.objective + 1e3 * here.violation * size;
    const double strayed = there.violation - std::max(here.violation, least_violation);
    return there.violation <= LocalOutcome::feasible_below &&
           there.objective + price * std::max(0.0, strayed) < here.objective;
}

}  // namespace

LocalOutcome polish(const Program& program, const LocalOutcome& from, const LocalLimits& limits) {
    LocalOutcome best = from;
    if (from.x.size() == 0 || !std::isfinite(from.violation) || from.violation > 1e-2) return best;
    ProgramValues values;
    ProgramValues there;
    LocalOutcome trial;
    LagrangianHessian hessian;
    double within = active_within;
    for (int k = 0; k < most_steps && !limits.reached(); ++k) {
        evaluate(program, best.x, true, values);
        ++best.evaluations;
        std::vector<Active> active = active_constraints(program, best.x, values, within);
        Linearised l;
        const VectorXd lambda = multipliers_of(active, best.x, values, l);
        ++best.hessians;
        lagrangian_hessian(program, best.x, 1, by_rows(program, active, lambda), hessian);
        if (!hessian.value.allFinite()) break;
        const NewtonStep step = newton_step(hessian.value, values.gradient, l);
        // Above the sum of its multipliers a unit of any violation costs more than it gains (exact penalty).
        const double price = 2 * lambda.lpNorm<1>();
        bool moved = false;
        for (const double length : {1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125, 0.015625, 0.0}) {
            if (moved) break;
            const VectorXd x = within_bounds(program, best.x + step.back + length * step.along);
            evaluate(program, x, false, there);
            ++best.evaluations;
            if (!there.assembled) continue;
            trial.objective = there.objective;
            trial.violation = violation(program, x, there);
            if (!better(trial, best, price)) continue;
            best.x = x;
            best.objective = trial.objective;
            best.violation = trial.violation;
            moved = true;
        }
        if (moved) continue;
        within *= times_farther;
        if (within > farthest_active) break;
    }
    return best;
}

double unbalanced_part(const Program& program, const VectorXd& x) {
    ProgramValues values;
    evaluate(program, x, true, values);
    const double size = values.gradient.norm();
    if (!values.assembled || !std::isfinite(size)) return 1;
    if (size == 0) return 0;
    std::vector<Active> active = active_constraints(program, x, values, active_within);
    Linearised l;
    const VectorXd lambda = multipliers_of(active, x, values, l);
    const double unbalanced = std::min(1.0, unbalanced_by(values.gradient, l).norm() / size);
    if (active.empty() && std::abs(values.objective) < square_of_rounding) return 0;
    LagrangianHessian hessian;
    lagrangian_hessian(program, x, 1, by_rows(program, active, lambda), hessian);
    if (!hessian.value.allFinite()) return unbalanced;
    l.residual.setZero();  // how far the constraints are is not asked here
    const VectorXd step = newton_step(hessian.value, values.gradient, l).along;
    const double gain = std::sqrt(std::abs(values.gradient.dot(step) / values.objective));
    const double left = unbalanced_by(values.gradient + hessian.value * step, l).norm() / size;
    return std::min(unbalanced, std::max(gain, left));
}

}  // namespace mechwright
