#include "synthesis/program/alternation/dwell_alternation.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/program/alternation/free_columns.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/standing.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::VectorXd;

constexpr std::size_t most_extremes_listed = 40;
constexpr double at_limit_within = 1e-6;

/// The components of a quantity with their derivatives by the dimensions that are open.
struct Slopes {
    VectorXd value;
    MatrixXd by;
};

Slopes slopes_of(const Problem& problem, const Quantity& quantity, const Motion& motion, const Design& design) {
    const auto count = static_cast<Index>(count_components(quantity, motion)),
               n = static_cast<Index>(quantity.reads.size());
    VectorXd value(count);
    std::vector<double> gradient(static_cast<std::size_t>(count * n));
    measure(quantity, motion, design.dimensions, {{value.data(), static_cast<std::size_t>(count)}, gradient, {}});
    const Eigen::Map<Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>> by(gradient.data(), count,
                                                                                                n);
    return {value, by_free_dimensions(problem, quantity.reads, by)};
}

/// A limit that a design stands at: how what it limits changes, with the sign in which it must not grow.
struct HeldLimit {
    RowVectorXd by;
    bool equality = false;
};

/// The limits that hold a design. Not `known` where one of them has no slope, or several.
struct HeldLimits {
    std::vector<HeldLimit> rows{};
    int count = 0;
    bool known = true;
};

/// Of the components of a limited quantity those that are at the limit: one row, if they change alike.
void hold(const Slopes& slopes, double limit, double within, double sign, bool equality, HeldLimits& held) {
    constexpr double alike = 1e-9;
    std::vector<RowVectorXd> rows;
    for (Index k = 0; k < slopes.value.size(); ++k) {
        if (!(std::abs(slopes.value[k] - limit) <= within)) continue;
        const RowVectorXd row = sign * slopes.by.row(k);
        const bool is_new = std::none_of(rows.begin(), rows.end(), [&](const RowVectorXd& known) {
            return (known - row).norm() <= alike * (known.norm() + row.norm());
        });
        if (is_new) rows.push_back(row);
    }
    held.known = held.known && rows.size() == 1 && rows.front().allFinite();
    if (held.known) held.rows.push_back({rows.front(), equality});
}

HeldLimits held_limits(const Problem& problem, const Design& design) {
    HeldLimits held;
    for (const Requirement& requirement : problem.requirements) {
        const Standing standing = standing_of(problem, requirement, design);
        if (!standing.active) continue;
        ++held.count;
        const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
        if (quantity.measure == nullptr || !standing.value) {
            held.known = false;
            continue;
        }
        const Slopes slopes = slopes_of(problem, quantity, motion_of(problem, quantity, design), design);
        const double within = at_limit_within * standing.scale;
        if (requirement.equal)
            hold(slopes, *requirement.equal, within, 1, true, held);
        else if (requirement.min && is_active(*requirement.min - *standing.value, standing))
            hold(slopes, *requirement.min, within, -1, false, held);
        else
            hold(slopes, *requirement.max, within, 1, false, held);
    }
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const int end = end_of_range(problem, design, i);
        if (end == 0) continue;
        ++held.count;
        RowVectorXd row = RowVectorXd::Zero(static_cast<Index>(problem.dimensions.size()));
        row[static_cast<Index>(i)] = end;
        held.rows.push_back({row, false});
    }
    return held;
}

/// With the change by the middle as a last column.
MatrixXd with_middle(const MatrixXd& by, double of_middle) {
    MatrixXd made(by.rows(), by.cols() + 1);
    made << by, VectorXd::Constant(by.rows(), of_middle);
    return made;
}

/// Those as far from the middle as the farthest, the first of each run on one side.
std::vector<DwellExtreme> alternating_of(const DwellAlternation& dwell, double rounding) {
    double farthest = 0;
    for (const DwellExtreme& e : dwell.extremes)
        farthest = std::max(farthest, std::abs(e.value - dwell.middle));
    std::vector<DwellExtreme> kept;
    for (const DwellExtreme& e : dwell.extremes) {
        const double off = e.value - dwell.middle;
        if (std::abs(off) < (1 - as_far_within) * farthest - rounding) continue;
        if (kept.empty() || (kept.back().value - dwell.middle) * off < 0) kept.push_back(e);
    }
    return kept;
}

/// Whether rows balance with weights that are above 0, or of either sign where they are of equalities, and only so.
bool balance(MatrixXd rows, const std::vector<bool>& equality) {
    constexpr double independent_beyond = 1e-9;
    scale_columns(rows);
    for (Index r = 0; r < rows.rows(); ++r)
        if (const double norm = rows.row(r).norm(); norm > 0) rows.row(r) /= norm;
    Eigen::FullPivLU<MatrixXd> lu(rows.transpose());
    lu.setThreshold(independent_beyond);
    if (lu.dimensionOfKernel() != 1) return false;
    VectorXd weights = lu.kernel().col(0);
    weights /= weights[0];
    for (Index r = 0; r < weights.size(); ++r)
        if (!equality[static_cast<std::size_t>(r)] && !(weights[r] > 0)) return false;
    return true;
}

/// Whether as many of the extremes as it takes balance with the limits that hold the design.
bool is_balanced(const Problem& problem, const Motion& motion, const Design& design, const DwellAlternation& dwell,
                 const std::vector<DwellExtreme>& equal, const MatrixXd& samples) {
    const HeldLimits held = held_limits(problem, design);
    if (!held.known) return false;
    const auto limits = static_cast<Index>(held.rows.size());
    MatrixXd rows(limits, samples.cols());
    std::vector<bool> equality;
    for (Index r = 0; r < limits; ++r) {
        rows.row(r) = with_middle(held.rows[static_cast<std::size_t>(r)].by, 0);
        equality.push_back(held.rows[static_cast<std::size_t>(r)].equality);
    }
    MatrixXd all(samples.rows() + limits, samples.cols());
    all << samples, rows;
    const auto needed = static_cast<Index>(independent_columns(all)) + 1 - limits;
    const auto count = static_cast<Index>(equal.size());
    if (needed < 1 || count < needed) return false;
    MatrixXd extremes(count, samples.cols());
    for (Index i = 0; i < count; ++i) {
        const DwellExtreme& e = equal[static_cast<std::size_t>(i)];
        const Quantity at = dwell_at(*dwell.quantity, e.input);
        extremes.row(i) =
            (e.value > dwell.middle ? 1 : -1) * with_middle(slopes_of(problem, at, motion, design).by.topRows(1), -1);
    }
    if (!extremes.allFinite()) return false;
    std::vector<bool> of_rows(static_cast<std::size_t>(needed), false);
    of_rows.insert(of_rows.end(), equality.begin(), equality.end());
    for (Index first = 0; first + needed <= count; ++first) {
        MatrixXd some(needed + limits, samples.cols());
        some << extremes.middleRows(first, needed), rows;
        if (balance(std::move(some), of_rows)) return true;
    }
    return false;
}

DwellAlternation alternation_of(const Problem& problem, const Quantity& quantity, const Design& design, bool alone) {
    DwellAlternation dwell{&quantity, 0, {}};
    const Motion motion = motion_of(problem, quantity, design);
    dwell.extremes = dwell_extremes(quantity, motion, design.dimensions);
    if (dwell.extremes.empty()) return dwell;
    const auto [least, greatest] =
        std::minmax_element(dwell.extremes.begin(), dwell.extremes.end(),
                            [](const DwellExtreme& a, const DwellExtreme& b) { return a.value < b.value; });
    dwell.middle = 0.5 * (least->value + greatest->value);
    const std::vector<DwellExtreme> equal = alternating_of(dwell, rounding_of_dwell(problem, quantity, design));
    dwell.alternating = static_cast<int>(equal.size());
    dwell.held = held_limits(problem, design).count;
    const MatrixXd samples = with_middle(slopes_of(problem, dwell_samples(quantity), motion, design).by, -1);
    if (samples.allFinite()) {
        dwell.free = independent_columns(samples);
        // Where the ends of the motion follow from the dimensions more than these limits hold a design.
        const bool is_given = motion.full_turn || problem.crank_range;
        dwell.balanced = alone && is_given && is_balanced(problem, motion, design, dwell, equal, samples);
    }
    if (dwell.extremes.size() > most_extremes_listed) dwell.extremes.resize(most_extremes_listed);
    return dwell;
}

}  // namespace

int end_of_range(const Problem& problem, const Design& design, std::size_t dimension) {
    const DimensionRange& range = problem.dimensions[dimension];
    if (range.tied() || range.fixed() || range.discrete()) return 0;
    const bool is_length = problem.mechanism->dimensions[dimension].kind == DimensionKind::length;
    const double size = is_length ? longest_length(*problem.mechanism, design.dimensions) : 1;
    const auto is_at = [&](double limit) {
        const double scale = std::max(std::abs(limit), std::min(size, range.max - range.min));
        return std::abs(design.dimensions[dimension] - limit) <= at_limit_within * scale;
    };
    return is_at(range.min) ? -1 : is_at(range.max) ? 1 : 0;
}

double rounding_of_dwell(const Problem& problem, const Quantity& quantity, const Design& design) {
    constexpr double units = 8;
    const double size = quantity.unit == Unit::angle ? 1 : longest_length(*problem.mechanism, design.dimensions);
    return units * std::numeric_limits<double>::epsilon() * size;
}

std::vector<DwellAlternation> dwell_alternations(const Problem& problem, const Design& design) {
    std::vector<DwellAlternation> all;
    if (!problem.objective) return all;
    const auto& terms = problem.objective->terms;
    const bool alone = terms.size() == 1 && problem.wishes.empty();
    for (const ObjectiveTerm& term : terms) {
        const Quantity& quantity = problem.mechanism->quantities[term.quantity];
        if (term.maximize || !is_of_dwell(quantity)) continue;
        DwellAlternation one = alternation_of(problem, quantity, design, alone);
        if (!one.extremes.empty()) all.push_back(std::move(one));
    }
    return all;
}

}  // namespace mechwright
