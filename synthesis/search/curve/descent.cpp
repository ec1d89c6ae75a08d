#include "synthesis/search/curve/descent.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <boost/container/static_vector.hpp>
#include <cmath>

#include "synthesis/program/condition_margin.h"

namespace mechwright {

namespace {

constexpr int most_arguments = static_cast<int>(most_curve_arguments);
using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most_arguments, most_arguments>;
using Column = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_arguments, 1>;

/// Chords of the curve, before those that are long are divided.
constexpr std::size_t coarse_chords = 96;
constexpr double first_damping = 1e-3;
constexpr double least_damping = 1e-12;
constexpr double most_damping = 1e12;
/// A step that moves no argument by more than this, as a part of it, is none.
constexpr double no_step = 1e-11;
constexpr int most_small_gains = 3;
/// What damping is measured by falls behind the size of a derivative that was great once.
constexpr double scale_kept = 0.7;
/// A design keeps this far from a border, as programs have it (condition_margin), or as close as it is; to rounding.
constexpr double border_rounding = 1e-13;
constexpr std::size_t most_borders = 3;
/// Against the spread of the targets a sum of squares below this part is rounding.
constexpr double zero_within = 1e-26;

using Indices = boost::container::static_vector<Eigen::Index, most_curve_arguments>;
using Borders = boost::container::static_vector<std::size_t, most_borders>;

/// Sums over the targets at a design: half gradient and Gauss-Newton matrix.
struct Sums {
    FittedCurve at;
    Column slope;
    Square matrix;
};

double side_of_border(double value) { return value < 0 ? -1 : 1; }

/// How far a design has to stay from a border that it is so far from.
double kept_margin(double value) { return std::min(std::abs(value), condition_margin); }

/// What the requirements that are missed add. False: one has no value.
bool add_requirements(const CurveProblem& p, Sums& s, CurveWork& work) {
    const std::size_t k = program_of(*p.programs, s.at.arguments, s.at.assembly);
    if (k == p.programs->size()) return false;
    const Program& program = (*p.programs)[k];
    const Eigen::VectorXd x = point_with(program, s.at.arguments);
    if (!evaluate_beside_path(program, p.rows[k], x, true, work.beside)) return false;
    const auto& reads = program.problem->mechanism->point->reads;
    Column row = Column::Zero(s.slope.size());
    for (std::size_t r = 0; r < p.rows[k].size(); ++r) {
        const Row& limits = program.rows[p.rows[k][r]];
        const auto at = static_cast<Eigen::Index>(r);
        const double value = work.beside.value[at];
        const double missed = value - std::clamp(value, limits.lower, limits.upper);
        if (missed == 0) continue;
        for (Eigen::Index i = 0; i < row.size(); ++i) {
            const std::ptrdiff_t v = program.variable_of[reads[static_cast<std::size_t>(i)]];
            row[i] = v >= 0 ? work.beside.jacobian(at, v) : 0;
        }
        s.at.sum += p.weight_of_rows * missed * missed;
        s.slope += p.weight_of_rows * missed * row;
        s.matrix += p.weight_of_rows * row * row.transpose();
    }
    return true;
}

double& lane_of(std::vector<Group>& groups, std::size_t i) {
    constexpr std::size_t lanes = std::tuple_size_v<Group>;
    return groups[i / lanes][i % lanes];
}

/// Takes over what is nearer at another chord.
void take_nearer(const std::vector<std::size_t>& targets, NearestOnCurve& others, NearestOnCurve& nearest) {
    auto end = others.ends.begin();
    for (std::size_t i = 0; i < targets.size(); ++i) {
        const bool at_end = end != others.ends.end() && end->target == i;
        const std::size_t target = targets[i];
        if (lane_of(others.square, i) < lane_of(nearest.square, target)) {
            lane_of(nearest.square, target) = lane_of(others.square, i);
            lane_of(nearest.crank_angle, target) = lane_of(others.crank_angle, i);
            lane_of(nearest.miss, target) = lane_of(others.miss, i);
            for (std::size_t k = 0; k < most_curve_arguments; ++k)
                lane_of(nearest.gradient[k], target) = lane_of(others.gradient[k], i);
            std::erase_if(nearest.ends, [&](const NearestEnd& known) { return known.target == target; });
            if (at_end) {
                nearest.ends.push_back(*end);
                nearest.ends.back().target = target;
            }
        }
        if (at_end) ++end;
    }
}

bool evaluate(const CurveProblem& p, Sums& s, CurveWork& work) {
    ++work.evaluations;
    const CurveArguments& a = s.at.arguments;
    s.at.sum = unlimited;
    if (!find_nearest_points(p, p.set, s.at.assembly, a, work)) return false;
    const auto n = static_cast<Eigen::Index>(p.arguments);
    const auto padded = static_cast<Eigen::Index>(8 * p.targets.x.size());
    const auto lanes = [&](const std::vector<Group>& groups) {
        return Eigen::Map<const Eigen::ArrayXd>(groups.front().data(), padded);
    };
    const auto weight = lanes(p.targets.weight);
    s.slope.resize(n);
    s.matrix.resize(n, n);
    s.at.sum = (weight * lanes(work.nearest.square)).sum();
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto row = lanes(work.nearest.gradient[static_cast<std::size_t>(i)]);
        s.slope[i] = (weight * row * lanes(work.nearest.miss)).sum();
        for (Eigen::Index j = 0; j <= i; ++j)
            s.matrix(i, j) = (weight * row * lanes(work.nearest.gradient[static_cast<std::size_t>(j)])).sum();
    }
    for (const NearestEnd& end : work.nearest.ends) {
        const double w = p.targets.weight[end.target / 8][end.target % 8];
        for (Eigen::Index i = 0; i < n; ++i) {
            const auto k = static_cast<std::size_t>(i);
            s.slope[i] += w * (end.x[k] * end.miss.x + end.y[k] * end.miss.y);
            for (Eigen::Index j = 0; j <= i; ++j) {
                const auto l = static_cast<std::size_t>(j);
                s.matrix(i, j) += w * (end.x[k] * end.x[l] + end.y[k] * end.y[l]);
            }
        }
    }
    for (Eigen::Index i = 0; i < n; ++i)
        for (Eigen::Index j = i + 1; j < n; ++j)
            s.matrix(i, j) = s.matrix(j, i);
    const bool judged = !p.has_requirements() || add_requirements(p, s, work);
    if (judged && std::isfinite(s.at.sum) && s.slope.allFinite() && s.matrix.allFinite()) return true;
    s.at.sum = unlimited;
    return false;
}

/// The arguments that a step from here may move.
Indices moving(const CurveProblem& p, const Sums& s) {
    Indices all;
    for (std::size_t i = 0; i < p.arguments; ++i) {
        const auto k = static_cast<Eigen::Index>(i);
        const double x = s.at.arguments[i];
        const bool held = (x <= p.lower[i] && s.slope[k] > 0) || (x >= p.upper[i] && s.slope[k] < 0);
        if (p.is_free(i) && !held && s.matrix(k, k) > 0) all.push_back(k);
    }
    return all;
}

/// Steps from a design whose arguments `free` move, and whose borders are not passed.
struct Step {
    const CurveProblem& p;
    const Sums& s;
    const Indices& free;
    Eigen::LLT<Square> factors;

    Column coefficients(std::size_t b) const {
        const LinearCondition& c = p.fit->borders()[b];
        Column row(static_cast<Eigen::Index>(free.size()));
        for (std::size_t i = 0; i < free.size(); ++i) {
            const auto argument = static_cast<std::size_t>(free[i]);
            row[static_cast<Eigen::Index>(i)] = argument < c.coefficients.size() ? c.coefficients[argument] : 0;
        }
        return row;
    }

    /// The border that a step passes the farthest.
    std::optional<std::size_t> passed(const Column& step, const Borders& kept) const {
        std::optional<std::size_t> worst;
        double farthest = -border_rounding;
        for (std::size_t b = 0; b < p.fit->borders().size(); ++b) {
            if (std::find(kept.begin(), kept.end(), b) != kept.end()) continue;
            const double here = margin_of(p.fit->borders()[b], s.at.arguments);
            const double there = side_of_border(here) * (here + coefficients(b).dot(step)) - kept_margin(here);
            if (there < farthest) {
                farthest = there;
                worst = b;
            }
        }
        return worst;
    }

    /// The damped step; where it would pass borders, the one that ends on them.
    Column operator()() const {
        Column slope(static_cast<Eigen::Index>(free.size()));
        for (std::size_t i = 0; i < free.size(); ++i)
            slope[static_cast<Eigen::Index>(i)] = s.slope[free[i]];
        const Column straight = -factors.solve(slope);
        Column step = straight;
        Borders kept;
        while (kept.size() < most_borders) {
            const std::optional<std::size_t> next = passed(step, kept);
            if (!next) break;
            kept.push_back(*next);
            const auto k = static_cast<Eigen::Index>(kept.size());
            Square rows(k, straight.size());
            Column wanted(k);
            for (Eigen::Index i = 0; i < k; ++i) {
                const std::size_t b = kept[static_cast<std::size_t>(i)];
                rows.row(i) = coefficients(b).transpose();
                const double here = margin_of(p.fit->borders()[b], s.at.arguments);
                wanted[i] = side_of_border(here) * kept_margin(here) - here - rows.row(i).dot(straight);
            }
            const Square columns = factors.solve(Square(rows.transpose()));
            const Column multipliers = Square(rows * columns).llt().solve(wanted);
            if (!multipliers.allFinite()) break;
            step = straight + columns * multipliers;
        }
        return step;
    }
};

bool passes_border(const CurveProblem& p, const CurveArguments& from, const CurveArguments& to) {
    const auto& borders = p.fit->borders();
    return std::any_of(borders.begin(), borders.end(), [&](const LinearCondition& c) {
        const double here = margin_of(c, from);
        return side_of_border(here) * margin_of(c, to) < kept_margin(here) - border_rounding;
    });
}

/// Greatest change of an argument, as a part of it.
double length_of_step(const CurveArguments& from, const CurveArguments& to) {
    double greatest = 0;
    for (std::size_t i = 0; i < from.size(); ++i)
        greatest = std::max(greatest, std::abs(to[i] - from[i]) / std::max(1.0, std::abs(to[i])));
    return greatest;
}

/// What the sum would be if misses were linear.
double promised(const Sums& s, const CurveArguments& to) {
    const auto n = s.slope.size();
    const Column change = Eigen::Map<const Column>(to.data(), n) - Eigen::Map<const Column>(s.at.arguments.data(), n);
    return s.at.sum + 2 * s.slope.dot(change) + change.dot(s.matrix * change);
}

}  // namespace

bool is_rounding(const CurveProblem& p, double sum) { return sum <= zero_within * p.weight * p.spread * p.spread; }

bool find_nearest_points(const CurveProblem& p, InstructionSet set, std::size_t assembly, const CurveArguments& a,
                         CurveWork& work) {
    const std::span<const double> arguments = std::span(a).first(p.arguments);
    if (!p.fit->sample(set, assembly, arguments, coarse_chords, work.curve)) return false;
    const std::size_t placement = p.lengths + 2;
    targets_in_frame(p.targets, {a[placement], a[placement + 1]}, a[placement + 2], work.local);
    nearest_chords(set, work.curve, work.local, work.chords, work.others);
    p.fit->nearest(set, assembly, arguments, work.curve, work.chords, work.local, work.nearest);
    if (work.others.target.empty()) return true;
    p.fit->nearest(set, assembly, arguments, work.curve, work.others.chords, work.others.targets, work.of_others);
    take_nearer(work.others.target, work.of_others, work.nearest);
    return true;
}

bool descend(const CurveProblem& p, FittedCurve& from, int most_evaluations, double tolerance, CurveWork& work) {
    Sums at{from, {}, {}}, next;
    if (!evaluate(p, at, work)) return false;
    Column scale = Column::Zero(static_cast<Eigen::Index>(p.arguments));
    double damping = first_damping, growth = 2;
    int small_gains = 0;
    for (int evaluations = 1;
         evaluations < most_evaluations && small_gains < most_small_gains && !is_rounding(p, at.at.sum);) {
        const Indices free = moving(p, at);
        if (free.empty()) break;
        scale = (scale_kept * scale).cwiseMax(at.matrix.diagonal().cwiseSqrt());
        bool better = false;
        while (evaluations < most_evaluations && damping < most_damping) {
            const auto n = static_cast<Eigen::Index>(free.size());
            Square damped(n, n);
            for (Eigen::Index i = 0; i < n; ++i) {
                const auto k = free[static_cast<std::size_t>(i)];
                for (Eigen::Index j = 0; j < n; ++j)
                    damped(i, j) = at.matrix(k, free[static_cast<std::size_t>(j)]);
                damped(i, i) += damping * scale[k] * scale[k];
            }
            const Step step{p, at, free, Eigen::LLT<Square>(damped)};
            CurveArguments to = at.at.arguments;
            if (step.factors.info() == Eigen::Success) {
                const Column change = step();
                for (Eigen::Index i = 0; i < n; ++i)
                    to[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] += change[i];
                for (std::size_t i = 0; i < p.arguments; ++i)
                    to[i] = std::clamp(to[i], p.lower[i], p.upper[i]);
                if (length_of_step(at.at.arguments, to) < no_step) break;
                const double sum = promised(at, to);
                if (sum < at.at.sum && !passes_border(p, at.at.arguments, to)) {
                    ++evaluations;
                    next.at = {to, at.at.assembly, unlimited};
                    better = evaluate(p, next, work) && next.at.sum < at.at.sum;
                    if (better) {
                        const double gain = (at.at.sum - next.at.sum) / (at.at.sum - sum);
                        damping =
                            std::max(damping * std::clamp(1 - std::pow(2 * gain - 1, 3), 1.0 / 9, 2.0), least_damping);
                        growth = 2;
                        break;
                    }
                }
            }
            damping *= growth;
            growth *= 2;
        }
        if (!better) break;
        small_gains = at.at.sum - next.at.sum <= tolerance * at.at.sum ? small_gains + 1 : 0;
        std::swap(at, next);
    }
    from = at.at;
    return true;
}

}  // namespace mechwright
