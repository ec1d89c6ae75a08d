#include "synthesis/search/curve/shapes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "analysis/numbers/scalar.h"
#include "synthesis/program/condition_margin.h"
#include "synthesis/search/curve/laying.h"

namespace mechwright {

namespace {

/// Lengths are drawn from this part of the longest on, evenly in their logarithm; or, so often, margins to the borders
/// from that part of it on; and the distance of the guided point from a pin or the middle of its link, in parts of the
/// link or of the linkage.
constexpr double least_ratio = 1e-2;
constexpr double by_margins = 0.7;
constexpr double least_margin_drawn = 1e-5;
constexpr double nearest_point_drawn = 0.025;
constexpr double farthest_point_drawn = 5;
constexpr int most_shapes_drawn = 16;
/// How often a curve is laid over the targets by nearest points.
constexpr int layings = 8;
constexpr int layings_of_variation = 3;
/// By which part of the motion a variation moves the times at the targets, for a spread of 1.
constexpr double time_spread = 0.3;
/// How often a closed path is served by parts of the motion, as open ones are: the best curve may be much greater and
/// have such a loop. How often the way through the targets is cut once more into parts, each with a stretch of the
/// motion; how many there are at most, and the least of the motion that is one.
constexpr double closed_by_parts = 0.3;
constexpr double one_more_stretch = 0.4;
constexpr std::size_t most_stretches = 3;
constexpr double least_motion = 0.08;
/// Places of curves: spreads from this to that part of the targets', middles off by so much of their spread.
constexpr double least_size = 0.7;
constexpr double greatest_size = 4;
constexpr double off_middle = 0.3;

/// How often a variation takes the other side of a border close by, and the other assembly; and what close is, as a
/// part of all lengths together.
constexpr double other_side = 0.15;
constexpr double other_assembly = 0.1;
/// How often a variation begins at a relative, which draws the same curve, or another part of it: its lengths and
/// margins come to other limits.
constexpr double of_relative = 0.3;
constexpr double close_by = 0.1;
/// A variation multiplies a margin, or, less often, adds to it; and no margin becomes less than this: laid over the
/// targets, which may make it smaller, the design still keeps from the border.
constexpr double multiplied = 0.7;
constexpr double least_margin = 2 * condition_margin;

/// All lengths together, then the margins to the borders, as linear functions of the lengths.
Eigen::MatrixXd margins_of_lengths(const CurveProblem& p) {
    const auto& borders = p.fit->kin->borders();
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(borders.size()) + 1, static_cast<Eigen::Index>(p.lengths));
    rows.row(0).setOnes();
    for (std::size_t b = 0; b < borders.size(); ++b)
        for (std::size_t i = 0; i < p.lengths; ++i)
            rows(static_cast<Eigen::Index>(b) + 1, static_cast<Eigen::Index>(i)) = borders[b].coefficients[i];
    return rows;
}

double of_logarithm(double low, double high, double part) { return low * std::pow(high / low, part); }

/// Lengths in their ranges; any proportions where the size is free. More often one link is drawn and the margins to the
/// borders, on any side of them, which reaches what is next to several: there many of the best designs are.
void draw_lengths(const CurveProblem& p, RandomNumbers& random, CurveArguments& a) {
    for (std::size_t i = 0; i < p.lengths; ++i) {
        const double high = p.free_size ? 1 : p.upper[i];
        const double low = p.free_size ? least_ratio : std::max(p.lower[i], least_ratio * high);
        a[i] = low < high ? of_logarithm(low, high, random.even()) : high;
    }
    if (!p.free_size || p.lengths != p.fit->kin->borders().size() + 1 || random.even() > by_margins) return;
    const Eigen::MatrixXd rows = margins_of_lengths(p);
    Eigen::VectorXd margins(rows.rows());
    double sizes = 0;
    for (Eigen::Index b = 1; b < margins.size(); ++b) {
        const double size = of_logarithm(least_margin_drawn, 1, random.even());
        margins[b] = random.even() < 0.5 ? size : -size;
        sizes += size;
    }
    // With so much in all lengths together none is less than the one drawn first.
    margins[0] = static_cast<double>(p.lengths) * a[0] + sizes;
    const Eigen::VectorXd lengths = rows.partialPivLu().solve(margins);
    for (std::size_t i = 0; i < p.lengths; ++i)
        a[i] = lengths[static_cast<Eigen::Index>(i)];
}

void draw_point(const CurveProblem& p, RandomNumbers& random, CurveArguments& a) {
    const std::size_t along = p.lengths, across = along + 1;
    const double link = a[2];
    const double size = random.even() < 0.5 ? link : std::max(link, (a[0] + a[1]) / 2);
    const double distance = size * of_logarithm(nearest_point_drawn, farthest_point_drawn, random.even());
    const double angle = 2 * pi<double>() * random.even();
    const double about = link * std::floor(3 * random.even()) / 2;
    if (p.is_free(along)) a[along] = about + distance * std::cos(angle);
    if (p.is_free(across)) a[across] = distance * std::sin(angle);
}

/// A stretch of the motion that serves targets, at an even speed in either direction.
struct Stretch {
    double first;
    double part;
    bool backwards;

    double time(double along) const { return first + part * (backwards ? 1 - along : along); }
};

Stretch drawn_stretch(bool whole, RandomNumbers& random) {
    const double part = whole ? 1 : of_logarithm(least_motion, 1, random.even());
    return {random.even() * (whole ? 1 : 1 - part), part, random.even() < 0.5};
}

/// Times at the targets, in order along the way through them: all of the motion, for most closed paths; or a stretch of
/// it, or one for each of several parts of the way, as curves that go to and fro between ends of the motion have them.
std::vector<double> drawn_times(const CurveProblem& p, RandomNumbers& random) {
    const bool whole = p.closed && random.even() > closed_by_parts;
    const double shift = p.closed && !whole ? random.even() : 0;
    std::vector<double> cuts{0, 1};
    while (!whole && cuts.size() <= most_stretches && random.even() < one_more_stretch)
        cuts.push_back(random.even());
    std::sort(cuts.begin(), cuts.end());
    std::vector<Stretch> stretches;
    for (std::size_t k = 1; k < cuts.size(); ++k)
        stretches.push_back(drawn_stretch(whole, random));
    std::vector<double> times;
    for (const double from_first : p.way) {
        const double along = from_first + shift - std::floor(from_first + shift);
        const auto after = std::upper_bound(cuts.begin() + 1, cuts.end() - 1, along);
        const double before = *(after - 1);
        const Stretch& stretch = stretches[static_cast<std::size_t>(after - cuts.begin()) - 1];
        const double time = stretch.time(*after > before ? (along - before) / (*after - before) : 0);
        times.push_back(time - std::floor(time));
    }
    return times;
}

/// Times at which a design is at the targets, a little earlier or later, slower or quicker.
std::vector<double> varied_times(const CurveProblem& p, const FittedCurve& design, double spread, RandomNumbers& random,
                                 CurveWork& work) {
    std::vector<double> times = times_at_targets(p, design, work);
    const double later = time_spread * spread * random.normal(), slower = time_spread * spread * random.normal();
    for (double& time : times) {
        time += later + slower * (time - 0.5);
        time = p.closed ? time - std::floor(time) : std::clamp(time, 0.0, 1.0);
    }
    return times;
}

CurvePlace drawn_place(RandomNumbers& random) {
    CurvePlace place;
    place.size = of_logarithm(least_size, greatest_size, random.even());
    place.turn = 2 * pi<double>() * random.even();
    place.off.x = off_middle * random.normal();
    place.off.y = off_middle * random.normal();
    return place;
}

/// Values for what is given, and for what is not where a design begins.
CurveArguments given(const CurveProblem& p) {
    CurveArguments a{};
    for (std::size_t i = 0; i < p.arguments; ++i)
        a[i] = std::clamp(0.0, p.lower[i], p.upper[i]);
    return a;
}

}  // namespace

double RandomNumbers::even() {
    state_ = mixed(state_);
    return std::ldexp(static_cast<double>(state_ >> 11) + 0.5, -53);
}

double RandomNumbers::normal() {
    // Box and Muller's transformation.
    const double radius = std::sqrt(-2 * std::log(even()));
    return radius * std::cos(2 * pi<double>() * even());
}

std::optional<FittedCurve> drawn_shape(const CurveProblem& p, LaidFirst by, RandomNumbers& random, CurveWork& work) {
    FittedCurve shape{given(p), 0, unlimited};
    bool drawn = false;
    for (int i = 0; i < most_shapes_drawn && !drawn; ++i) {
        const auto kind = static_cast<std::size_t>(random.even() * static_cast<double>(p.kinds.size()));
        shape.assembly = p.kinds[kind].assembly;
        draw_lengths(p, random, shape.arguments);
        drawn = p.allows(shape.assembly, shape.arguments);
    }
    if (!drawn) return std::nullopt;
    draw_point(p, random, shape.arguments);
    if (!p.free_placement) {
        for (std::size_t i = p.lengths + 2; i < p.arguments; ++i)
            if (p.is_free(i)) shape.arguments[i] = p.lower[i] + random.even() * (p.upper[i] - p.lower[i]);
        return shape;
    }
    if (by == LaidFirst::by_place) return laid(p, shape, drawn_place(random), layings, work);
    return laid(p, shape, drawn_times(p, random), layings, work);
}

std::optional<FittedCurve> varied(const CurveProblem& p, const FittedCurve& known, double spread, RandomNumbers& random,
                                  CurveWork& work) {
    const auto& borders = p.fit->kin->borders();
    FittedCurve from = known;
    if (p.free_placement && random.even() < of_relative)
        p.fit->kin->to_relative(random.even() < 0.5, from.assembly, std::span(from.arguments).first(p.arguments));
    FittedCurve r = from;
    CurveArguments& a = r.arguments;
    const Eigen::MatrixXd rows = margins_of_lengths(p);
    Eigen::VectorXd margins(rows.rows());
    double all = 0;
    for (std::size_t i = 0; i < p.lengths; ++i)
        all += a[i];
    bool possible = false;
    for (int tries = 0; tries < most_shapes_drawn && !possible; ++tries) {
        margins[0] = all * std::exp(0.5 * spread * random.normal());
        for (std::size_t b = 0; b < borders.size(); ++b) {
            const double old = margin_of(borders[b], from.arguments);
            double size = std::abs(old);
            if (random.even() < multiplied)
                size *= std::exp(2 * spread * random.normal());
            else
                size = std::abs(size + 0.3 * spread * spread * all * random.normal());
            // What is beyond a border may be far from it: next to it many motions end at a target.
            const bool changes_side = random.even() < other_side && std::abs(old) < close_by * all;
            if (changes_side) size = of_logarithm(least_margin, close_by * all, random.even());
            margins[static_cast<Eigen::Index>(b) + 1] =
                std::max(size, least_margin) * ((old < 0) != changes_side ? -1 : 1);
        }
        const Eigen::VectorXd lengths = rows.partialPivLu().solve(margins);
        possible = (lengths.array() > 0).all();
        if (!possible) continue;
        for (std::size_t i = 0; i < p.lengths; ++i)
            if (p.is_free(i)) a[i] = lengths[static_cast<Eigen::Index>(i)];
        r.assembly = from.assembly;
        const CurveKind& other = p.kinds[static_cast<std::size_t>(random.even() * static_cast<double>(p.kinds.size()))];
        if (random.even() < 2 * other_assembly) r.assembly = other.assembly;
        possible = p.allows(r.assembly, within_ranges(p, a));
    }
    if (!possible) return std::nullopt;
    const std::size_t along = p.lengths, across = along + 1, tilt = along + 4;
    const double grown = a[2] / from.arguments[2];
    const double size = std::max(p.spread, std::hypot(from.arguments[along], from.arguments[across]));
    for (const std::size_t i : {along, across})
        if (p.is_free(i)) a[i] = from.arguments[i] * grown + 0.5 * spread * size * random.normal();
    if (p.is_free(tilt)) a[tilt] += 0.3 * spread * random.normal();
    a = within_ranges(p, a);
    if (p.free_placement) return laid(p, r, varied_times(p, from, spread, random, work), layings_of_variation, work);
    if (!p.allows(r.assembly, r.arguments)) return std::nullopt;
    return r;
}

}  // namespace mechwright
