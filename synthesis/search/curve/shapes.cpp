#include "synthesis/search/curve/shapes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <complex>

#include "analysis/numbers/low_discrepancy.h"
#include "analysis/numbers/scalar.h"
#include "synthesis/program/condition_margin.h"
#include "synthesis/search/curve/chords.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;

/// Lengths are drawn over this range, evenly in their logarithm; and the distance of the guided point from a pin or the
/// middle of its link, in parts of the link or of the linkage.
constexpr double least_ratio = 1e-2;
constexpr double least_margin_drawn = 1e-3;
constexpr double nearest_point_drawn = 0.025;
constexpr double farthest_point_drawn = 5;
constexpr int most_shapes_drawn = 16;
/// Chords of the curve that is laid over the targets, and how often that is done.
constexpr std::size_t chords_laid = 48;
constexpr int layings = 4;
constexpr int layings_of_variation = 3;

/// How often a variation takes the other side of a border close by, and the other assembly; and what close is, as a
/// part of all lengths together.
constexpr double other_side = 0.15;
constexpr double other_assembly = 0.1;
constexpr double close_by = 0.1;
/// A variation multiplies a margin, or, less often, adds to it; and no margin becomes less than this: laid over the
/// targets, which may make it smaller, the design still keeps from the border.
constexpr double multiplied = 0.7;
constexpr double least_margin = 2 * condition_margin;

/// A similarity of the plane, z -> shift + factor z.
struct Laying {
    Complex shift{0, 0};
    Complex factor{1, 0};
};

struct Moments {
    Complex middle;
    double spread;
    Complex second;
};

/// Of the chords of a curve, by their length. Nothing where it is a point.
std::optional<Moments> moments_of(const SampledCurve& c) {
    double length = 0, square = 0;
    Complex middle = 0, second = 0;
    const auto at = [&](std::size_t k) { return Complex(c.x[k], c.y[k]); };
    for (std::size_t k = 0; k + 1 < c.count; ++k) {
        const double chord = std::abs(at(k + 1) - at(k));
        length += chord;
        middle += chord * 0.5 * (at(k) + at(k + 1));
    }
    if (!(length > 0)) return std::nullopt;
    middle /= length;
    for (std::size_t k = 0; k + 1 < c.count; ++k) {
        const double chord = std::abs(at(k + 1) - at(k));
        const Complex from = 0.5 * (at(k) + at(k + 1)) - middle;
        square += chord * std::norm(from);
        second += chord * from * from;
    }
    if (!(square > 0)) return std::nullopt;
    return Moments{middle, std::sqrt(square / length), second / length};
}

void lay(SampledCurve& c, const Laying& laying) {
    for (std::size_t k = 0; k < c.count; ++k) {
        const Complex z = laying.shift + laying.factor * Complex(c.x[k], c.y[k]);
        c.x[k] = z.real();
        c.y[k] = z.imag();
    }
}

/// The similarity that brings the nearest points of a curve closest to the targets (Procrustes), of unit size where the
/// size is given; and what the curve missed before.
struct NextLaying {
    Laying laying;
    double sum;
};

NextLaying next_laying(const CurveProblem& p, const SampledCurve& curve, CurveWork& work) {
    nearest_chords(p.set, curve, p.targets, work.chords);
    Complex points = 0, targets = 0, product = 0;
    double square = 0, sum = 0;
    for (std::size_t g = 0; g < p.targets.x.size(); ++g)
        for (std::size_t k = 0; k < std::tuple_size_v<Group>; ++k) {
            const double w = p.targets.weight[g][k];
            if (!(w > 0)) continue;
            const auto chord = static_cast<std::size_t>(work.chords.chord[g][k]);
            const double part = work.chords.part[g][k];
            const Complex z{curve.x[chord] + part * (curve.x[chord + 1] - curve.x[chord]),
                            curve.y[chord] + part * (curve.y[chord + 1] - curve.y[chord])};
            const Complex target{p.targets.x[g][k], p.targets.y[g][k]};
            points += w * z;
            targets += w * target;
            product += w * std::conj(z) * target;
            square += w * std::norm(z);
            sum += w * work.chords.square[g][k];
        }
    const Complex along = product - std::conj(points) * targets / p.weight;
    const double own = square - std::norm(points) / p.weight;
    if (!(own > 0) || !(std::abs(along) > 0)) return {{}, sum};
    const Complex factor = p.free_size ? along / own : along / std::abs(along);
    return {{(targets - factor * points) / p.weight, factor}, sum};
}

/// Laid over the targets again and again, by nearest points; the design with it, and what it misses in the end.
FittedCurve laid(const CurveProblem& p, const FittedCurve& design, SampledCurve curve, Laying all, int times,
                 CurveWork& work) {
    lay(curve, all);
    FittedCurve r = design;
    for (int i = 0; i <= times; ++i) {
        const NextLaying next = next_laying(p, curve, work);
        r.sum = next.sum;
        if (i == times) break;
        lay(curve, next.laying);
        all = {next.laying.shift + next.laying.factor * all.shift, next.laying.factor * all.factor};
    }
    const std::size_t x = p.lengths + 2, y = x + 1, tilt = x + 2;
    if (p.free_size)
        for (std::size_t i = 0; i < x; ++i)
            r.arguments[i] *= std::abs(all.factor);
    const Complex origin = all.shift + all.factor * Complex(r.arguments[x], r.arguments[y]);
    r.arguments[x] = origin.real();
    r.arguments[y] = origin.imag();
    r.arguments[tilt] += std::arg(all.factor);
    return r;
}

/// The curve of a design in the drawing.
bool drawn_curve(const CurveProblem& p, const FittedCurve& design, CurveWork& work) {
    const CurveArguments& a = design.arguments;
    if (!p.fit->sample(p.set, design.assembly, std::span(a).first(p.arguments), chords_laid, work.curve)) return false;
    const std::size_t x = p.lengths + 2;
    lay(work.curve, {{a[x], a[x + 1]}, std::polar(1.0, a[x + 2])});
    return true;
}

/// All lengths together, then the margins to the borders, as linear functions of the lengths.
Eigen::MatrixXd margins_of_lengths(const CurveProblem& p) {
    const auto& borders = p.fit->borders();
    Eigen::MatrixXd rows(static_cast<Eigen::Index>(borders.size()) + 1, static_cast<Eigen::Index>(p.lengths));
    rows.row(0).setOnes();
    for (std::size_t b = 0; b < borders.size(); ++b)
        for (std::size_t i = 0; i < p.lengths; ++i)
            rows(static_cast<Eigen::Index>(b) + 1, static_cast<Eigen::Index>(i)) = borders[b].coefficients[i];
    return rows;
}

double of_logarithm(double low, double high, double part) { return low * std::pow(high / low, part); }

/// Lengths in their ranges; any proportions where the size is free. Every second time one link is given and the margins
/// to the borders are drawn, on any side of them, which reaches what is next to several: there many of the best designs
/// are.
void draw_lengths(const CurveProblem& p, RandomNumbers& random, CurveArguments& a) {
    for (std::size_t i = 0; i < p.lengths; ++i) {
        const double high = p.free_size ? 1 : p.upper[i];
        const double low = p.free_size ? least_ratio : std::max(p.lower[i], least_ratio * high);
        a[i] = low < high ? of_logarithm(low, high, random.even()) : high;
    }
    if (!p.free_size || p.lengths != p.fit->borders().size() + 1 || random.even() < 0.5) return;
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

std::optional<FittedCurve> drawn_shape(const CurveProblem& p, RandomNumbers& random, CurveWork& work) {
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
    if (!drawn_curve(p, shape, work)) return std::nullopt;
    const std::optional<Moments> own = moments_of(work.curve);
    if (!own) return std::nullopt;
    const SampledCurve curve = work.curve;
    const Complex middle(p.middle.x, p.middle.y);
    const double turn = (std::arg(Complex(p.second.x, p.second.y)) - std::arg(own->second)) / 2;
    FittedCurve best;
    for (const double flip : {0.0, pi<double>()}) {
        const Complex factor = std::polar(p.free_size ? p.spread / own->spread : 1.0, turn + flip);
        const FittedCurve one = laid(p, shape, curve, {middle - factor * own->middle, factor}, layings, work);
        if (one.sum < best.sum) best = one;
    }
    if (!(best.sum < unlimited)) return std::nullopt;
    best.arguments = within_ranges(p, best.arguments);
    if (!p.allows(best.assembly, best.arguments)) return std::nullopt;
    return best;
}

std::optional<FittedCurve> varied(const CurveProblem& p, const FittedCurve& from, double spread, RandomNumbers& random,
                                  CurveWork& work) {
    const auto& borders = p.fit->borders();
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
    if (p.free_placement) {
        if (!drawn_curve(p, r, work)) return std::nullopt;
        r = laid(p, r, work.curve, {}, layings_of_variation, work);
        r.arguments = within_ranges(p, r.arguments);
    }
    if (!p.allows(r.assembly, r.arguments)) return std::nullopt;
    return r;
}

}  // namespace mechwright
