#include "synthesis/search/curve/descent.h"

#include <algorithm>
#include <cmath>

#include "synthesis/program/condition_margin.h"
#include "synthesis/search/curve/bounded_step.h"

namespace mechwright {

namespace {

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
/// Bends count where with them the last step was promised by so much better; they are learnt from steps along which the
/// slope grows at all.
constexpr double much_better = 0.5;
constexpr double least_cosine = 1e-3;
/// Against the spread of the targets a sum of squares below this part is rounding.
constexpr double zero_within = 1e-26;

using Indices = boost::container::static_vector<Eigen::Index, most_curve_arguments>;

/// Sums over the targets at a design: half gradient and Gauss-Newton matrix.
struct Sums {
    FittedCurve at;
    StepVector slope;
    StepMatrix matrix;
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
    StepVector row = StepVector::Zero(s.slope.size());
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

/// The arguments that steps from here may move.
Indices moving(const CurveProblem& p, const Sums& s) {
    Indices all;
    for (std::size_t i = 0; i < p.arguments; ++i)
        if (const auto k = static_cast<Eigen::Index>(i); p.is_free(i) && s.matrix(k, k) > 0) all.push_back(k);
    return all;
}

/// The limits of such steps: ranges, and borders as far as they may be gone up to.
StepLimits limits_of_step(const CurveProblem& p, const CurveArguments& a, const Indices& free) {
    StepLimits limits;
    const auto n = static_cast<Eigen::Index>(free.size());
    const auto add = [&](const StepVector& normal, double least) { limits.push_back({normal, std::min(least, 0.0)}); };
    for (Eigen::Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
        add(StepVector::Unit(n, i), p.lower[k] - a[k]);
        add(-StepVector::Unit(n, i), a[k] - p.upper[k]);
    }
    for (const LinearCondition& border : p.fit->kin->borders()) {
        const double here = margin_of(border, a);
        StepVector normal = StepVector::Zero(n);
        for (Eigen::Index i = 0; i < n; ++i)
            if (const auto k = static_cast<std::size_t>(free[static_cast<std::size_t>(i)]);
                k < border.coefficients.size())
                normal[i] = side_of_border(here) * border.coefficients[k];
        if (!normal.isZero(0)) add(normal, kept_margin(here) - std::abs(here));
    }
    return limits;
}

bool passes_border(const CurveProblem& p, const CurveArguments& from, const CurveArguments& to) {
    const auto& borders = p.fit->kin->borders();
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

StepVector change_to(const Sums& s, const CurveArguments& to) {
    const auto n = s.slope.size();
    return Eigen::Map<const StepVector>(to.data(), n) - Eigen::Map<const StepVector>(s.at.arguments.data(), n);
}

/// What the sum would be after a change with such half second derivatives.
double promised(const Sums& s, const StepMatrix& second, const StepVector& change) {
    return s.at.sum + 2 * s.slope.dot(change) + change.dot(second * change);
}

/// What Gauss's and Newton's matrix leaves out of half the second derivatives: where targets are missed by much, the
/// bends of their distances. It is learnt from how slopes change (Dennis, Gay and Welsch, ACM TOMS 7, 1981).
struct Bends {
    StepMatrix matrix;
    bool count = false;  ///< with them the last step was promised much better

    void learn(const Sums& from, const Sums& to, const StepVector& step) {
        const double off_without = std::abs(to.at.sum - promised(from, from.matrix, step));
        const double off_with = std::abs(to.at.sum - promised(from, from.matrix + matrix, step));
        count = off_with < much_better * off_without;
        const StepVector change = to.slope - from.slope;
        const double along = change.dot(step);
        if (!(along > least_cosine * step.norm() * change.norm())) return;
        const StepVector of_bends = change - to.matrix * step;
        const double known = std::abs(step.dot(matrix * step));
        if (known > 0) matrix *= std::min(1.0, std::abs(step.dot(of_bends)) / known);
        const StepVector left = of_bends - matrix * step;
        matrix += (left * change.transpose() + change * left.transpose()) / along -
                  (step.dot(left) / (along * along)) * change * change.transpose();
    }
};

}  // namespace

bool is_rounding(const CurveProblem& p, double sum) { return sum <= zero_within * p.weight * p.spread * p.spread; }

bool find_nearest_points(const CurveProblem& p, InstructionSet set, std::size_t assembly, const CurveArguments& a,
                         CurveWork& work) {
    const std::span<const double> arguments = std::span(a).first(p.arguments);
    const std::size_t chords = work.roughly ? coarse_chords / 2 : coarse_chords;
    if (!p.fit->sample(set, assembly, arguments, chords, work.curve)) return false;
    const std::size_t placement = p.lengths + 2;
    targets_in_frame(p.targets, {a[placement], a[placement + 1]}, a[placement + 2], work.local);
    if (work.roughly)
        nearest_chords(set, work.curve, work.local, work.chords);
    else
        nearest_chords(set, work.curve, work.local, work.chords, work.others);
    p.fit->nearest(set, assembly, arguments, work.curve, work.chords, work.local, work.nearest);
    if (work.roughly || work.others.target.empty()) return true;
    p.fit->nearest(set, assembly, arguments, work.curve, work.others.chords, work.others.targets, work.of_others);
    take_nearer(work.others.target, work.of_others, work.nearest);
    return true;
}

bool descend(const CurveProblem& p, FittedCurve& from, int most_evaluations, double tolerance, CurveWork& work) {
    Sums at{from, {}, {}}, next;
    if (!evaluate(p, at, work)) return false;
    StepVector scale = StepVector::Zero(static_cast<Eigen::Index>(p.arguments));
    const auto all = static_cast<Eigen::Index>(p.arguments);
    Bends bends{StepMatrix::Zero(all, all)};
    double damping = first_damping, growth = 2;
    int small_gains = 0;
    for (int evaluations = 1;
         evaluations < most_evaluations && small_gains < most_small_gains && !is_rounding(p, at.at.sum);) {
        const Indices free = moving(p, at);
        if (free.empty()) break;
        const StepLimits limits = limits_of_step(p, at.at.arguments, free);
        scale = (scale_kept * scale).cwiseMax(at.matrix.diagonal().cwiseSqrt());
        bool better = false;
        const StepMatrix second = bends.count ? StepMatrix(at.matrix + bends.matrix) : at.matrix;
        while (evaluations < most_evaluations && damping < most_damping) {
            const auto n = static_cast<Eigen::Index>(free.size());
            StepMatrix damped(n, n);
            StepVector slope(n);
            for (Eigen::Index i = 0; i < n; ++i) {
                const auto k = free[static_cast<std::size_t>(i)];
                for (Eigen::Index j = 0; j < n; ++j)
                    damped(i, j) = second(k, free[static_cast<std::size_t>(j)]);
                damped(i, i) += damping * scale[k] * scale[k];
                slope[i] = at.slope[k];
            }
            const Eigen::LLT<StepMatrix> factors(damped);
            CurveArguments to = at.at.arguments;
            if (factors.info() == Eigen::Success) {
                const StepVector change = bounded_step(factors, slope, limits);
                for (Eigen::Index i = 0; i < n; ++i)
                    to[static_cast<std::size_t>(free[static_cast<std::size_t>(i)])] += change[i];
                for (std::size_t i = 0; i < p.arguments; ++i)
                    to[i] = std::clamp(to[i], p.lower[i], p.upper[i]);
                if (length_of_step(at.at.arguments, to) < no_step) break;
                const double sum = promised(at, second, change_to(at, to));
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
        bends.learn(at, next, change_to(at, next.at.arguments));
        std::swap(at, next);
    }
    from = at.at;
    return true;
}

}  // namespace mechwright
