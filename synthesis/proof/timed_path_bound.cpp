#include "synthesis/proof/timed_path_bound.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/proof/coupler_turn.h"

namespace mechwright::four_bar {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t parameters = Box::most;
constexpr double pi = std::numbers::pi;
/// What rounding in the linear algebra can do to a distance, in parts of the size of the targets.
constexpr double distance_error = 1e-13;
/// Columns whose length falls below this part in orthogonalisation have no direction of their own.
constexpr double dependent_below = 1e-9;
/// A direction that is known no better than this, in radians, is tried without.
constexpr double unknown_from = 0.1;
/// The range of a free start is cut into so many parts, each with base angles of its own.
constexpr int start_parts = 24;

/// Complex numbers as vectors of real ones: real parts first.
VectorXd stacked(const std::vector<Vector<double>>& z, const VectorXd& root_weights) {
    const auto n = static_cast<Index>(z.size());
    VectorXd v(2 * n);
    for (Index i = 0; i < n; ++i) {
        v[i] = root_weights[i] * z[static_cast<std::size_t>(i)].x;
        v[n + i] = root_weights[i] * z[static_cast<std::size_t>(i)].y;
    }
    return v;
}

/// The numbers turned by a quarter turn.
VectorXd times_i(const VectorXd& v) {
    const Index n = v.size() / 2;
    VectorXd r(v.size());
    r.head(n) = -v.tail(n);
    r.tail(n) = v.head(n);
    return r;
}

/// Takes what lies along orthonormal columns out of a vector, twice for the digits.
void project_out(const MatrixXd& columns, Index count, VectorXd& v) {
    for (int pass = 0; pass < 2; ++pass)
        v -= columns.leftCols(count) * (columns.leftCols(count).transpose() * v);
}

/// Adds a vector's direction to orthonormal columns; returns what was left of its length.
double add_column(MatrixXd& columns, Index& count, VectorXd v) {
    const double length = v.norm();
    project_out(columns, count, v);
    const double left = v.norm();
    if (left > dependent_below * length) columns.col(count++) = v / left;
    return left;
}

/// The distance from the target that no shift within the box can undo: |r - sum d_k g_k| for |d_k| <= half_k, from
/// below, for every choice of parameters that are let free in turn, those that matter most first.
double least_distance(VectorXd r, const std::array<VectorXd, parameters>& g,
                      const std::array<double, parameters>& half) {
    MatrixXd freed(r.size(), static_cast<Index>(parameters));
    Index count = 0;
    std::array<bool, parameters> held{};
    for (std::size_t k = 0; k < parameters; ++k)
        held[k] = half[k] > 0;
    double best = 0;
    while (true) {
        const double length = r.norm();
        if (!(length > 0)) return best;
        double penalty = 0, most = 0;
        std::size_t next = parameters;
        for (std::size_t k = 0; k < parameters; ++k) {
            if (!held[k]) continue;
            const double one = half[k] * std::abs(r.dot(g[k])) / length;
            penalty += one;
            if (one > most) {
                most = one;
                next = k;
            }
        }
        best = std::max(best, length - penalty);
        if (next == parameters) return best;
        held[next] = false;
        // A parameter that does nearly what those let free already do adds no direction of its own.
        if (const double left = add_column(freed, count, g[next]); !(left > dependent_below * g[next].norm()))
            return best;
        r -= freed.col(count - 1) * freed.col(count - 1).dot(r);
    }
}

}  // namespace

std::string TimedPathBound::why_not(const Problem& problem) {
    if (!is_four_bar(*problem.mechanism)) return "bounds are known for four-bars only";
    if (!problem.path || !problem.path->prescribed_timing || problem.path->guides_body())
        return "the problem has no [path] with prescribed timing";
    if (!problem.objective || problem.objective->terms.size() != 1 || problem.objective->terms.front().maximize)
        return "the path's sum of squares is not what is minimised";
    const PathMeasure path = problem.mechanism->quantities[problem.objective->terms.front().quantity].path;
    if (path != PathMeasure::sum_of_squares && path != PathMeasure::root_mean_square)
        return "the path's sum of squares is not what is minimised";
    return {};
}

TimedPathBound::TimedPathBound(const Problem& problem) {
    const PathTarget& path = *problem.path;
    const PathRoles& roles = problem.mechanism->point->roles;
    const auto range = [&](std::size_t i) -> const DimensionRange& { return problem.dimensions[i]; };
    const auto reach = [&](std::size_t i) { return std::max(std::abs(range(i).min), std::abs(range(i).max)); };
    const auto n = static_cast<Index>(path.points.size());
    VectorXd root_weights(n);
    for (Index i = 0; i < n; ++i)
        root_weights[i] = std::sqrt(path.weights[static_cast<std::size_t>(i)]);
    free_start_ = !range(roles.start).fixed();
    start_from_ = range(roles.start).min;
    start_to_ = std::min(range(roles.start).max, start_from_ + 2 * pi);
    angles_ = path.crank_angles;
    if (!free_start_)
        for (double& angle : angles_)
            angle += start_from_;
    // With a free start the crank may be turned as a whole: its tilt is then taken for free too.
    free_tilt_ = free_start_ || !range(roles.tilt).fixed();
    free_origin_ = !range(roles.origin_x).fixed() || !range(roles.origin_y).fixed();
    const double tilt = free_tilt_ ? 0 : range(roles.tilt).min;
    points_ = path.points;
    if (!free_origin_)
        for (Vector<double>& p : points_)
            p = p - Vector<double>{range(roles.origin_x).min, range(roles.origin_y).min};
    for (const double angle : angles_)
        cranks_.push_back({std::cos(angle + tilt), std::sin(angle + tilt)});
    plane_ = plane_of(root_weights);

    greatest_point_ = std::hypot(reach(roles.along), reach(roles.across));
    greatest_ground_ = range(0).max;
    greatest_crank_ = range(1).max;

    const int cuts = free_start_ ? start_parts : 1;
    for (const std::size_t assembly : problem.assemblies)
        for (int cut = 0; cut < cuts; ++cut) {
            Box box;
            box.part = parts_.size();
            box.middle = {0.5, 0.5 * pi, 0.5 * pi, 0};
            box.half = {0.5, 0.5 * pi, 0.5 * pi, 0};
            if (free_start_) {
                box.half[3] = 0.5 * (start_to_ - start_from_) / cuts;
                box.middle[3] = start_from_ + (2 * cut + 1) * box.half[3];
            }
            const auto cosine = [&](double angle) { return std::cos(box.middle[3] + angle); };
            const auto [least, greatest] = std::minmax_element(
                angles_.begin(), angles_.end(), [&](double a, double b) { return cosine(a) < cosine(b); });
            parts_.push_back({assembly == 0 ? 1.0 : -1.0, static_cast<std::size_t>(least - angles_.begin()),
                              static_cast<std::size_t>(greatest - angles_.begin())});
            boxes_.push_back(box);
        }
}

TimedPathBound::Plane TimedPathBound::plane_of(const VectorXd& root_weights) const {
    Plane plane;
    plane.root_weights = root_weights;
    const std::vector<Vector<double>> ones(points_.size(), {1, 0});
    const VectorXd one = stacked(ones, root_weights), crank = stacked(cranks_, root_weights);
    MatrixXd columns(crank.size(), 4);
    Index count = 0;
    if (free_origin_) {
        add_column(columns, count, one);
        add_column(columns, count, times_i(one));
    }
    plane.origin = columns.leftCols(count);
    plane.target_beyond_origin = stacked(points_, root_weights);
    project_out(columns, count, plane.target_beyond_origin);
    VectorXd beyond = crank;
    project_out(columns, count, beyond);
    plane.crank_beyond_origin = beyond.norm();
    add_column(columns, count, crank);
    if (free_tilt_) add_column(columns, count, times_i(crank));
    plane.fixed = columns.leftCols(count);
    plane.target = plane.target_beyond_origin;
    project_out(columns, count, plane.target);
    return plane;
}

std::vector<Box> TimedPathBound::boxes() const { return boxes_; }

namespace {

/// How the w_i move over a box beside a turn that is common to all.
struct Movement {
    VectorXd w;                           ///< in the middle
    std::array<VectorXd, parameters> by;  ///< derivatives, of parameters that are free
    double strayed = 0;                   ///< norm of what the derivatives leave out
    double moved = 0;                     ///< norm of the whole movement
    std::size_t split = 0;                ///< the parameter that moves them most
};

Movement movement_of(const std::vector<CouplerTurn>& turns, const Box& box, const VectorXd& root_weights) {
    const std::size_t n = turns.size();
    const auto weight = [&](std::size_t i) { return square(root_weights[static_cast<Index>(i)]); };
    std::array<double, parameters> common{};
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < parameters; ++k)
            common[k] += weight(i) / root_weights.squaredNorm() * turns[i].slope[k];

    Movement m;
    std::vector<Vector<double>> directions;
    std::array<std::vector<Vector<double>>, parameters> shifts;
    std::array<double, parameters> influence{};
    double strayed = 0, moved = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Vector<double> w{std::cos(turns[i].angle), std::sin(turns[i].angle)};
        directions.push_back(w);
        double first = 0;
        for (std::size_t k = 0; k < parameters; ++k) {
            const double slope = box.half[k] > 0 ? turns[i].slope[k] - common[k] : 0;
            shifts[k].push_back(slope * left_of(w));
            first += box.half[k] * std::abs(slope);
            influence[k] += weight(i) * (square(box.half[k] * slope) + square(turns[i].doubt[k]));
        }
        const double second = turns[i].astray + 0.5 * square(first + turns[i].astray);
        strayed += weight(i) * square(second);
        moved += weight(i) * square(first + second);
    }
    m.w = stacked(directions, root_weights);
    for (std::size_t k = 0; k < parameters; ++k) {
        if (box.half[k] > 0) m.by[k] = stacked(shifts[k], root_weights);
        if (influence[k] > influence[m.split]) m.split = k;
    }
    m.strayed = std::sqrt(strayed);
    m.moved = std::sqrt(moved);
    return m;
}

}  // namespace

double TimedPathBound::distance_over(const Plane& plane, const std::vector<CouplerTurn>& turns, const Box& box,
                                     double greatest_crank, std::size_t& split) const {
    const Movement m = movement_of(turns, box, plane.root_weights);
    split = m.split;

    // Where A is small: the plane of B w alone.
    double distance = 0;
    VectorXd beyond = m.w;
    project_out(plane.origin, plane.origin.cols(), beyond);
    if (const double length = beyond.norm(); length > 1.001 * m.moved) {
        const VectorXd along = beyond / length, across = times_i(along);
        const VectorXd& p = plane.target_beyond_origin;
        const double by_crank = greatest_crank * plane.crank_beyond_origin;
        const double point = std::min(greatest_point_, (p.norm() + by_crank) / (length - m.moved));
        distance = (p - p.dot(along) * along - p.dot(across) * across).norm() - by_crank - point * m.moved;
    }

    // The plane of B w beyond what O and A can do.
    MatrixXd columns(m.w.size(), plane.fixed.cols() + 2);
    columns.leftCols(plane.fixed.cols()) = plane.fixed;
    Index count = plane.fixed.cols();
    VectorXd a = m.w, b = times_i(m.w);
    project_out(columns, count, a);
    project_out(columns, count, b);
    const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b);
    const double widest = std::sqrt(0.5 * (aa + bb) + std::sqrt(square(0.5 * (aa - bb)) + square(ab)));
    const double determinant = aa * bb - ab * ab;
    const double narrowest = widest > 0 ? std::sqrt(std::max(0.0, determinant)) / widest : 0;
    const double size = plane.target.norm();

    // Where it nearly vanishes: B as far as the point may stand, along both axes or along the narrower one.
    distance = std::max(distance, size - greatest_point_ * (widest + m.moved));
    if (widest > 0) {
        const double turn = 0.5 * std::atan2(2 * ab, aa - bb);
        const VectorXd axis = std::cos(turn) * a + std::sin(turn) * b;
        if (const double square_length = axis.squaredNorm(); square_length > 0)
            distance = std::max(distance, (plane.target - (plane.target.dot(axis) / square_length) * axis).norm() -
                                              greatest_point_ * (narrowest + m.moved));
    }

    // Else along the derivatives.
    if (!(narrowest > 1.001 * m.moved) || !(determinant > 1e-12 * aa * bb)) return distance;
    const double pa = a.dot(plane.target), pb = b.dot(plane.target);
    const double x = (bb * pa - ab * pb) / determinant, y = (aa * pb - ab * pa) / determinant;
    const VectorXd r = plane.target - x * a - y * b;
    const double point = std::hypot(x, y), inverse = 1 / (narrowest - m.moved);
    // Both are of the B that least squares would choose, whatever the problem allows.
    const double change = point * m.moved * inverse + m.moved * r.norm() * inverse * inverse;
    const double greatest = std::min(size * inverse, point + change);
    add_column(columns, count, a);
    add_column(columns, count, b);
    double remainder = greatest * m.strayed;
    std::array<VectorXd, parameters> g;
    for (std::size_t k = 0; k < parameters; ++k) {
        if (!(box.half[k] > 0)) continue;
        remainder += change * box.half[k] * m.by[k].norm();
        g[k] = x * m.by[k] + y * times_i(m.by[k]);
        project_out(columns, count, g[k]);
    }
    return std::max(distance, least_distance(r, g, box.half) - remainder);
}

BoxBound TimedPathBound::operator()(const Box& box) const {
    constexpr double none = std::numeric_limits<double>::infinity();
    const Part& part = parts_[box.part];
    const auto enclosing = [&](std::size_t k) {
        return detail::outward(box.middle[k] - box.half[k], box.middle[k] + box.half[k], 2);
    };
    const Interval start = box.half[3] > 0 ? enclosing(3) : Interval(0);
    const Interval t{std::max(enclosing(0).low, 0.0), std::min(enclosing(0).high, 1.0)};
    const double angle_least = angles_[part.least], angle_greatest = angles_[part.greatest];
    const auto base = [&](double angle, std::size_t alpha) {
        return base_at(diagonal_at(t, Interval(start + Interval(angle))), enclosing(alpha));
    };
    const auto base_here = [&](double angle, std::size_t alpha) {
        return base_at(diagonal_at(box.middle[0], box.middle[3] + angle), box.middle[alpha]);
    };
    const Ranges over{part.side,
                      t,
                      start,
                      base(angle_least, 1),
                      base(angle_greatest, 2),
                      box.middle,
                      box.half,
                      base_here(angle_least, 1),
                      base_here(angle_greatest, 2),
                      box.middle[1] + box.middle[2] > pi};
    // The coupler is longer than nothing: L falls as the cosine of the crank angle rises.
    const Interval fall =
        over.least.diagonal.length * over.least.cosine - over.greatest.diagonal.length * over.greatest.cosine;
    if (fall.high < 0) return {none, 0};

    std::vector<CouplerTurn> turns;
    VectorXd known = plane_.root_weights;
    for (std::size_t i = 0; i < angles_.size(); ++i) {
        const Role role = i == part.greatest ? Role::greatest : i == part.least ? Role::least : Role::between;
        turns.push_back(coupler_turn(over, angles_[i], role));
        if (turns.back().astray > unknown_from) known[static_cast<Index>(i)] = 0;
    }
    const double crank =
        t.low > 0 ? std::min(greatest_crank_, greatest_ground_ * (1 - t.low) / t.low) : greatest_crank_;
    BoxBound result{0, 0};
    double distance = distance_over(plane_, turns, box, crank, result.split);
    // Targets at which the coupler may point anywhere are left out: the sum over the others is not greater.
    if (known != plane_.root_weights && known.squaredNorm() > 0) {
        std::size_t other = 0;
        distance = std::max(distance, distance_over(plane_of(known), turns, box, crank, other));
    }
    distance -= distance_error * plane_.target_beyond_origin.norm();
    result.least = distance > 0 ? distance * distance : 0;
    return result;
}

}  // namespace mechwright::four_bar
