#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <vector>

#include "synthesis/local/local.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// A sum of squares below this part of its start, or a gain below that part of the sum, is rounding.
constexpr double rounding = 1e-30;
constexpr double least_gain = 1e-13;
constexpr int most_small_gains = 3;

/// The derivatives of a point's residuals by its crank angle, four of them at most, and the damping of that.
using Column = Eigen::Matrix<double, 5, 1>;

/// The point reached, with what the next step needs.
struct Place {
    VectorXd x;
    PathResiduals residuals;
    double sum = unlimited;
};

/// Reflections (Householder's) that make all columns but the last upper triangular, carried out on the last too. For so
/// few columns plain loops are several times quicker than a general factorisation.
void triangularise(MatrixXd& a) {
    const Index rows = a.rows();
    for (Index k = 0; k + 1 < a.cols(); ++k) {
        double* column = a.data() + k * rows;
        double square = 0;
        for (Index r = k; r < rows; ++r)
            square += column[r] * column[r];
        if (!(square > 0)) continue;
        const double size = std::copysign(std::sqrt(square), column[k]);
        column[k] += size;
        const double per = 1 / (size * column[k]);
        for (Index c = k + 1; c < a.cols(); ++c) {
            double* other = a.data() + c * rows;
            double product = 0;
            for (Index r = k; r < rows; ++r)
                product += column[r] * other[r];
            product *= per;
            for (Index r = k; r < rows; ++r)
                other[r] -= product * column[r];
        }
        column[k] = -size;
    }
}

/// Variables that a step may change: not those at a bound that descent would leave.
struct Free {
    std::vector<Index> dimensions;
    std::vector<bool> angle;  ///< by point
};

struct Fit {
    const Program& program;
    Index points;
    Index each;  ///< residuals of a point
    Index dimensions;
    bool untimed;
    VectorXd scale;        ///< of the dimension variables: the greatest norms of their columns so far
    VectorXd angle_scale;  ///< of the crank angles
    MatrixXd stacked;      ///< rows of the linear problem, right-hand side last

    explicit Fit(const Program& p)
        : program(p),
          points(static_cast<Index>(p.targets.size())),
          each(static_cast<Index>(residuals_per_point(p))),
          dimensions(static_cast<Index>(p.dimension_variables)),
          untimed(p.untimed_path()),
          scale(VectorXd::Zero(dimensions)),
          angle_scale(VectorXd::Zero(untimed ? points : 0)) {}

    Index angle_variable(Index point) const { return static_cast<Index>(program.first_path_angle) + point; }

    void update_scales(const PathResiduals& r) {
        for (Index k = 0; k < dimensions; ++k)
            scale[k] = std::max(scale[k], r.jacobian.col(k).norm());
        for (Index i = 0; i < angle_scale.size(); ++i)
            angle_scale[i] = std::max(angle_scale[i], r.by_angle.segment(each * i, each).norm());
    }

    bool held(Index variable, double x, double slope) const {
        const Variable& v = program.variables[static_cast<std::size_t>(variable)];
        return (x <= v.lower && slope > 0) || (x >= v.upper && slope < 0);
    }

    Free free_variables(const Place& at) const {
        Free free;
        const VectorXd slope = at.residuals.jacobian.transpose() * at.residuals.value;
        for (Index k = 0; k < dimensions; ++k)
            if (!held(k, at.x[k], slope[k]) && scale[k] > 0) free.dimensions.push_back(k);
        for (Index i = 0; i < angle_scale.size(); ++i) {
            const double s =
                at.residuals.by_angle.segment(each * i, each).dot(at.residuals.value.segment(each * i, each));
            free.angle.push_back(!held(angle_variable(i), at.x[angle_variable(i)], s) && angle_scale[i] > 0);
        }
        return free;
    }

    /// The step that makes the linearised residuals least, with steps in scaled variables weighed by root(damping).
    VectorXd step(const Place& at, const Free& free, double damping) {
        const auto n = static_cast<Index>(free.dimensions.size());
        const double root = std::sqrt(damping);
        const Index per_point = untimed ? each + 1 : each;
        stacked.setZero(per_point * points + n, n + 1);
        // Rows that give each free angle once the dimensions are known, and what multiplies it there.
        MatrixXd angle_rows(angle_scale.size(), n + 1);
        VectorXd angle_pivots(angle_scale.size());
        for (Index i = 0; i < points; ++i) {
            auto rows = stacked.middleRows(per_point * i, per_point);
            for (Index c = 0; c < each; ++c) {
                for (Index k = 0; k < n; ++k)
                    rows(c, k) = at.residuals.jacobian(each * i + c, free.dimensions[static_cast<std::size_t>(k)]);
                rows(c, n) = -at.residuals.value[each * i + c];
            }
            if (!untimed || !free.angle[static_cast<std::size_t>(i)]) continue;
            // A reflection that turns the column of the angle into its first component; the other rows are rid of it.
            Column column = Column::Zero();
            column.head(each) = at.residuals.by_angle.segment(each * i, each);
            column[each] = root * angle_scale[i];
            const double size = column.norm();
            Column axis = column;
            axis[0] += std::copysign(size, column[0]);
            const double per = 2 / axis.squaredNorm();
            for (Index k = 0; k <= n; ++k) {
                const double part = per * axis.head(per_point).dot(rows.col(k));
                rows.col(k) -= part * axis.head(per_point);
            }
            angle_pivots[i] = -std::copysign(size, column[0]);
            angle_rows.row(i) = rows.row(0);
            rows.row(0).setZero();
        }
        for (Index k = 0; k < n; ++k)
            stacked(per_point * points + k, k) = root * scale[free.dimensions[static_cast<std::size_t>(k)]];

        triangularise(stacked);
        const VectorXd solved =
            stacked.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(stacked.col(n).head(n));

        VectorXd change = VectorXd::Zero(at.x.size());
        for (Index k = 0; k < n; ++k)
            change[free.dimensions[static_cast<std::size_t>(k)]] = solved[k];
        for (Index i = 0; i < angle_scale.size(); ++i)
            if (free.angle[static_cast<std::size_t>(i)])
                change[angle_variable(i)] =
                    (angle_rows(i, n) - angle_rows.row(i).head(n).dot(solved)) / angle_pivots[i];
        return change;
    }

    /// The sum of squares that the linearised residuals promise after a change.
    double promised(const Place& at, const VectorXd& change) const {
        VectorXd r = at.residuals.value + at.residuals.jacobian * change.head(dimensions);
        for (Index i = 0; i < angle_scale.size(); ++i)
            r.segment(each * i, each) += change[angle_variable(i)] * at.residuals.by_angle.segment(each * i, each);
        return r.squaredNorm();
    }
};

}  // namespace

LocalOutcome levenberg_marquardt(const Program& program, const VectorXd& start, const LocalLimits& limits) {
    LocalOutcome outcome;
    Fit fit(program);
    Place at{within_bounds(program, start), {}, unlimited};
    Place next;
    double damping = 1e-2;
    double growth = 2;
    int small_gains = 0;
    bool known = path_residuals(program, at.x, true, at.residuals);
    outcome.evaluations = 1;
    if (known) at.sum = at.residuals.value.squaredNorm();
    const double negligible = known ? rounding * at.sum : 0;
    const double enough = std::max(limits.tolerance, least_gain);
    while (known && !limits.reached() && outcome.evaluations < limits.most_evaluations && at.sum > negligible &&
           small_gains < most_small_gains && damping < 1e20) {
        fit.update_scales(at.residuals);
        const Free free = fit.free_variables(at);
        while (outcome.evaluations < limits.most_evaluations && damping < 1e20) {
            next.x = within_bounds(program, at.x + fit.step(at, free, damping));
            const double promised = fit.promised(at, next.x - at.x);
            known = next.x.allFinite() && path_residuals(program, next.x, true, next.residuals);
            ++outcome.evaluations;
            next.sum = known ? next.residuals.value.squaredNorm() : unlimited;
            if (next.sum < at.sum) break;
            damping *= growth;
            growth *= 2;
            if (at.sum - promised <= least_gain * at.sum) damping = unlimited;
            if (limits.reached()) break;
        }
        known = true;
        if (!(next.sum < at.sum)) break;
        const double gain = (at.sum - next.sum) / (at.sum - fit.promised(at, next.x - at.x));
        damping *= std::clamp(1 - std::pow(2 * gain - 1, 3), 1.0 / 9, 2.0);
        damping = std::max(damping, 1e-14);
        growth = 2;
        small_gains = at.sum - next.sum <= enough * at.sum ? small_gains + 1 : 0;
        std::swap(at, next);
    }
    if (!(at.sum < unlimited)) return outcome;
    settle_epigraphs(program, at.x);
    ProgramValues values;
    evaluate(program, at.x, false, values);
    outcome.x = at.x;
    outcome.objective = at.sum;
    outcome.violation = violation(program, at.x, values);
    return outcome;
}

}  // namespace mechwright
