#include "synthesis/local/path_fit.h"

#include <algorithm>
#include <cmath>

#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The derivatives of a point's residuals by its crank angle, four of them at most, and the damping of that.
using Column = Eigen::Matrix<double, 5, 1>;

/// A row that is missed by more than this part of what it was missed by before gets a greater weight.
constexpr double slow = 0.25;
constexpr double growth_of_weight = 10;

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

}  // namespace

PathFit::PathFit(const Program& program)
    : program_(program),
      points_(static_cast<Index>(program.targets.size())),
      each_(static_cast<Index>(residuals_per_point(program))),
      dimensions_(static_cast<Index>(program.dimension_variables)),
      untimed_(program.untimed_path()),
      rows_(rows_beside_path(program)),
      multipliers_(VectorXd::Zero(static_cast<Index>(rows_.size()))),
      scale_(VectorXd::Zero(static_cast<Index>(program.size()))) {}

Index PathFit::angle_variable(Index point) const { return static_cast<Index>(program_.first_path_angle) + point; }

bool PathFit::evaluate(PathPlace& at) {
    if (!at.x.allFinite() || !path_residuals(program_, at.x, true, at.path)) return false;
    if (!rows_.empty() && !evaluate_beside_path(program_, rows_, at.x, true, at.beside)) return false;
    at.sum = at.path.value.squaredNorm();
    weigh(at);
    for (Index k = 0; k < dimensions_; ++k)
        scale_[k] = std::max(scale_[k], at.path.jacobian.col(k).norm());
    for (Index i = 0; untimed_ && i < points_; ++i)
        scale_[angle_variable(i)] =
            std::max(scale_[angle_variable(i)], at.path.by_angle.segment(each_ * i, each_).norm());
    return true;
}

double PathFit::excess(const PathPlace& at, Index row, double shift) const {
    const Row& limits = program_.rows[rows_[static_cast<std::size_t>(row)]];
    const double value = at.beside.value[row] + shift;
    return value - std::clamp(value, limits.lower, limits.upper);
}

void PathFit::weigh(PathPlace& at) const {
    at.missed.resize(multipliers_.size());
    for (Index r = 0; r < multipliers_.size(); ++r)
        at.missed[r] = excess(at, r, multipliers_[r] / weight_);
    at.merit = at.sum + weight_ * at.missed.squaredNorm();
}

double PathFit::greatest_excess(const PathPlace& at) const {
    double worst = 0;
    for (Index r = 0; r < multipliers_.size(); ++r)
        worst = std::max(worst, std::abs(excess(at, r, 0)));
    return worst;
}

double PathFit::excess_squares(const PathPlace& at) const {
    double sum = 0;
    for (Index r = 0; r < multipliers_.size(); ++r)
        sum += std::pow(excess(at, r, 0), 2);
    return sum;
}

void PathFit::sharpen(PathPlace& at) {
    multipliers_ = weight_ * at.missed;
    const double now = greatest_excess(at);
    if (now > slow * excess_before_) weight_ *= growth_of_weight;
    excess_before_ = now;
    weigh(at);
}

bool PathFit::held(Index variable, double x, double slope) const {
    const Variable& v = program_.variables[static_cast<std::size_t>(variable)];
    return (x <= v.lower && slope > 0) || (x >= v.upper && slope < 0);
}

/// The points at the ends of the stretch, where a row that depends on their angles counts.
std::vector<bool> PathFit::kept_angles(const PathPlace& at) const {
    std::vector<bool> kept(static_cast<std::size_t>(points_), false);
    if (!untimed_ || !depends_on_stretch(program_) || !(at.missed.array() != 0).any()) return kept;
    const StretchEnds ends = stretch_ends(program_, at.x);
    for (const StretchEnd& end : {ends.first, ends.last})
        if (end.point) kept[*end.point] = true;
    return kept;
}

double PathFit::entry(const PathPlace& at, Index residual, Index variable) const {
    if (variable < dimensions_) return at.path.jacobian(residual, variable);
    return angle_variable(residual / each_) == variable ? at.path.by_angle[residual] : 0;
}

PathFit::Columns PathFit::columns(const PathPlace& at) const {
    Columns free;
    const std::vector<bool> kept = kept_angles(at);
    VectorXd slope = at.path.jacobian.transpose() * at.path.value;
    if (multipliers_.size() > 0) slope += weight_ * (at.beside.jacobian.leftCols(dimensions_).transpose() * at.missed);
    for (Index k = 0; k < dimensions_; ++k)
        if (!held(k, at.x[k], slope[k]) && scale_[k] > 0) free.dense.push_back(k);
    for (Index i = 0; untimed_ && i < points_; ++i) {
        const Index v = angle_variable(i);
        double s = at.path.by_angle.segment(each_ * i, each_).dot(at.path.value.segment(each_ * i, each_));
        const bool dense = kept[static_cast<std::size_t>(i)];
        if (dense) s += weight_ * at.beside.jacobian.col(v).dot(at.missed);
        const bool moves = !held(v, at.x[v], s) && scale_[v] > 0;
        if (dense && moves) free.dense.push_back(v);
        free.eliminated.push_back(!dense && moves);
    }
    return free;
}

VectorXd PathFit::step(const PathPlace& at, double damping) { return solved(at, damping, at.path.value, at.missed); }

/// What the residuals change by along a step, as far as they are linear.
VectorXd PathFit::change_of_residuals(const PathPlace& at, const VectorXd& step) const {
    VectorXd change = at.path.jacobian * step.head(dimensions_);
    for (Index i = 0; untimed_ && i < points_; ++i)
        change.segment(each_ * i, each_) += step[angle_variable(i)] * at.path.by_angle.segment(each_ * i, each_);
    return change;
}

VectorXd PathFit::bent(const PathPlace& at, const VectorXd& step, double damping) {
    constexpr double part = 0.1, most_bent = 0.75;
    if (!path_residuals(program_, at.x + part * step, false, ahead_)) return step;
    const VectorXd second = (2 / part) * ((ahead_.value - at.path.value) / part - change_of_residuals(at, step));
    const VectorXd acceleration = solved(at, damping, second, VectorXd::Zero(at.missed.size()));
    if (!(2 * scaled_norm(acceleration) <= most_bent * scaled_norm(step))) return step;
    return step + acceleration / 2;
}

/// The least-squares problem with any right-hand side: residuals, and what the rows beside the path miss.
VectorXd PathFit::solved(const PathPlace& at, double damping, const VectorXd& residuals, const VectorXd& missed) {
    const Columns free = columns(at);
    const auto n = static_cast<Index>(free.dense.size());
    const double root = std::sqrt(damping);
    const Index per_point = untimed_ ? each_ + 1 : each_;
    const auto counting = static_cast<Index>((at.missed.array() != 0).count());
    stacked_.setZero(per_point * points_ + counting + n, n + 1);
    // Rows that give each eliminated angle once the others are known, and what multiplies it there.
    MatrixXd angle_rows(untimed_ ? points_ : 0, n + 1);
    VectorXd angle_pivots(angle_rows.rows());
    const auto variable = [&](Index k) { return free.dense[static_cast<std::size_t>(k)]; };
    for (Index i = 0; i < points_; ++i) {
        auto rows = stacked_.middleRows(per_point * i, per_point);
        for (Index c = 0; c < each_; ++c) {
            for (Index k = 0; k < n; ++k)
                rows(c, k) = entry(at, each_ * i + c, variable(k));
            rows(c, n) = -residuals[each_ * i + c];
        }
        if (!untimed_ || !free.eliminated[static_cast<std::size_t>(i)]) continue;
        // A reflection that turns the column of the angle into its first component; the other rows are rid of it.
        Column column = Column::Zero();
        column.head(each_) = at.path.by_angle.segment(each_ * i, each_);
        column[each_] = root * scale_[angle_variable(i)];
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
    Index next = per_point * points_;
    const double root_of_weight = std::sqrt(weight_);
    for (Index r = 0; r < at.missed.size(); ++r) {
        if (at.missed[r] == 0) continue;
        for (Index k = 0; k < n; ++k)
            stacked_(next, k) = root_of_weight * at.beside.jacobian(r, variable(k));
        stacked_(next++, n) = -root_of_weight * missed[r];
    }
    for (Index k = 0; k < n; ++k)
        stacked_(next + k, k) = root * scale_[variable(k)];

    triangularise(stacked_);
    const VectorXd of_dense =
        stacked_.topLeftCorner(n, n).triangularView<Eigen::Upper>().solve(stacked_.col(n).head(n));

    VectorXd change = VectorXd::Zero(at.x.size());
    for (Index k = 0; k < n; ++k)
        change[variable(k)] = of_dense[k];
    for (Index i = 0; i < angle_rows.rows(); ++i)
        if (free.eliminated[static_cast<std::size_t>(i)])
            change[angle_variable(i)] = (angle_rows(i, n) - angle_rows.row(i).head(n).dot(of_dense)) / angle_pivots[i];
    return change;
}

double PathFit::promised(const PathPlace& at, const VectorXd& change) const {
    double sum = (at.path.value + change_of_residuals(at, change)).squaredNorm();
    for (Index k = 0; k < at.missed.size(); ++k)
        if (at.missed[k] != 0) sum += weight_ * std::pow(at.missed[k] + at.beside.jacobian.row(k).dot(change), 2);
    return sum;
}

}  // namespace mechwright
