#include "synthesis/search/curve/laying.h"

#include <algorithm>
#include <cmath>
#include <complex>

#include "analysis/numbers/scalar.h"
#include "synthesis/search/curve/chords.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;

/// Chords of a curve that is laid.
constexpr std::size_t chords_laid = 48;
/// Against the greatest a sum of squares below this part is none.
constexpr double none_within = 1e-12;

/// The link of the guided point: its pin and its direction.
struct LinkPosition {
    Complex pin;
    Complex direction;
};

LinkPosition between(const LinkPosition& a, const LinkPosition& b, double part) {
    return {a.pin + part * (b.pin - a.pin), a.direction + part * (b.direction - a.direction)};
}

/// Positions at the crank angles of a curve.
struct LinkPositions {
    std::array<LinkPosition, SampledCurve::most> at;

    LinkPosition on_chord(std::size_t k, double part) const { return between(at[k], at[k + 1], part); }
};

Complex target_of(const CurveProblem& p, std::size_t i) {
    return {p.targets.x[i / 8][i % 8], p.targets.y[i / 8][i % 8]};
}
double weight_of(const CurveProblem& p, std::size_t i) { return p.targets.weight[i / 8][i % 8]; }

bool sample(const CurveProblem& p, const FittedCurve& design, CurveWork& work) {
    return p.fit->sample(p.set, design.assembly, std::span(design.arguments).first(p.arguments), chords_laid,
                         work.curve);
}

void set_positions(const CurveProblem& p, const FittedCurve& design, const SampledCurve& curve, LinkPositions& out) {
    CurveArguments a = design.arguments;
    SampledCurve pins = curve, ends = curve;
    a[p.lengths] = a[p.lengths + 1] = 0;
    p.fit->points(p.set, design.assembly, std::span(a).first(p.arguments), pins);
    a[p.lengths] = 1;
    p.fit->points(p.set, design.assembly, std::span(a).first(p.arguments), ends);
    for (std::size_t k = 0; k < curve.count; ++k) {
        const Complex pin{pins.x[k], pins.y[k]};
        out.at[k] = {pin, Complex(ends.x[k], ends.y[k]) - pin};
    }
}

/// O, A and B of laying.h.
struct Laying {
    Complex origin;
    Complex factor;
    Complex point;

    Complex operator()(const LinkPosition& link) const { return origin + factor * link.pin + point * link.direction; }
};

/// Weighted sums over the targets about the means: conj(a) b of positions and targets.
struct Moments {
    Complex pin, direction, target;  ///< means
    double of_pins = 0, of_directions = 0;
    Complex direction_pin, direction_target, pin_target;
};

Moments moments_of(const CurveProblem& p, const std::vector<LinkPosition>& links) {
    Moments m{};
    for (std::size_t i = 0; i < links.size(); ++i) {
        const double part = weight_of(p, i) / p.weight;
        m.pin += part * links[i].pin;
        m.direction += part * links[i].direction;
        m.target += part * target_of(p, i);
    }
    for (std::size_t i = 0; i < links.size(); ++i) {
        const double weight = weight_of(p, i);
        const Complex pin = links[i].pin - m.pin, direction = links[i].direction - m.direction;
        const Complex target = target_of(p, i) - m.target;
        m.of_pins += weight * std::norm(pin);
        m.of_directions += weight * std::norm(direction);
        m.direction_pin += weight * std::conj(direction) * pin;
        m.direction_target += weight * std::conj(direction) * target;
        m.pin_target += weight * std::conj(pin) * target;
    }
    return m;
}

/// How many times as long the lengths may become.
double most_growth(const CurveProblem& p, const CurveArguments& a) {
    double growth = unlimited;
    for (std::size_t i = 0; i < p.lengths; ++i)
        growth = std::min(growth, p.upper[i] / a[i]);
    return growth;
}

bool point_is_free(const CurveProblem& p) { return p.is_free(p.lengths) && p.is_free(p.lengths + 1); }

/// The size that is allowed, in the direction that fits best.
Complex allowed(const CurveProblem& p, const CurveArguments& a, Complex factor) {
    const double size = std::abs(factor);
    return (p.free_size ? std::min(size, most_growth(p, a)) : 1.0) / size * factor;
}

/// Brought into the ranges of the point on its link.
Complex point_within(const CurveProblem& p, Complex factor, Complex point) {
    const double size = std::abs(factor);
    const Complex place = point / factor * size;
    const Complex within{std::clamp(place.real(), p.lower[p.lengths], p.upper[p.lengths]),
                         std::clamp(place.imag(), p.lower[p.lengths + 1], p.upper[p.lengths + 1])};
    return within / size * factor;
}

/// The best laying for link positions at the targets.
std::optional<Laying> best_laying(const CurveProblem& p, const CurveArguments& a,
                                  const std::vector<LinkPosition>& links) {
    const Moments m = moments_of(p, links);
    Laying r;
    if (point_is_free(p)) {
        const Complex per = m.of_directions > none_within * p.weight ? 1 / m.of_directions : 0;
        const Complex of_factor = m.pin_target - std::conj(m.direction_pin) * m.direction_target * per;
        const double pins = m.of_pins - std::norm(m.direction_pin) * per.real();
        if (!(pins > none_within * m.of_pins) || of_factor == 0.0) return std::nullopt;
        r.factor = allowed(p, a, of_factor / pins);
        r.point = point_within(p, r.factor, (m.direction_target - r.factor * m.direction_pin) * per);
    } else {
        const Complex place{a[p.lengths], a[p.lengths + 1]};
        const Complex along = m.pin_target + std::conj(place) * m.direction_target;
        const double square =
            m.of_pins + std::norm(place) * m.of_directions + 2 * (std::conj(place) * m.direction_pin).real();
        if (!(square > 0) || along == 0.0) return std::nullopt;
        r.factor = allowed(p, a, along / square);
        r.point = r.factor * place;
    }
    r.origin = m.target - r.factor * m.pin - r.point * m.direction;
    return r;
}

/// The part of the motion after which it is at a crank angle, and the other way round: counted evenly over a full turn,
/// towards the ends of a limited motion in smaller steps, as the point is quick there.
double time_at(const SampledCurve& c, double crank_angle) {
    const double part = c.to > c.from ? std::clamp((crank_angle - c.from) / (c.to - c.from), 0.0, 1.0) : 0;
    return c.closed ? part : std::acos(1 - 2 * part) / pi<double>();
}

double crank_angle_at(const SampledCurve& c, double time) {
    const double part = c.closed ? time : (1 - std::cos(pi<double>() * time)) / 2;
    return c.from + part * (c.to - c.from);
}

/// Positions of the link after such parts of the motion.
std::vector<LinkPosition> positions_at(const SampledCurve& curve, const LinkPositions& links,
                                       const std::vector<double>& times) {
    std::vector<LinkPosition> all;
    const auto first = curve.crank_angle.begin();
    for (const double time : times) {
        const double angle = crank_angle_at(curve, time);
        const auto after = std::upper_bound(first + 1, first + static_cast<std::ptrdiff_t>(curve.count) - 1, angle);
        const double before = *(after - 1);
        const double part = *after > before ? std::clamp((angle - before) / (*after - before), 0.0, 1.0) : 0;
        all.push_back(links.on_chord(static_cast<std::size_t>(after - first - 1), part));
    }
    return all;
}

/// Mean and spread of points with weights.
struct Spread {
    double weight = 0;
    Complex sum = 0;
    double square = 0;

    void add(Complex point, double of_point) {
        weight += of_point;
        sum += of_point * point;
        square += of_point * std::norm(point);
    }
    Complex middle() const { return sum / weight; }
    double size() const { return std::sqrt(std::max(0.0, square / weight - std::norm(middle()))); }
};

Spread spread_of_targets(const CurveProblem& p) {
    Spread spread;
    for (std::size_t i = 0; i < p.targets.count; ++i)
        spread.add(target_of(p, i), weight_of(p, i));
    return spread;
}

/// By the length of the curve.
Spread spread_of(const SampledCurve& c) {
    Spread spread;
    for (std::size_t k = 1; k < c.count; ++k) {
        const Complex from{c.x[k - 1], c.y[k - 1]}, to{c.x[k], c.y[k]};
        spread.add((from + to) / 2.0, std::abs(to - from));
    }
    return spread;
}

/// Moves the curve to its place. False: it is a point.
bool move(const CurveProblem& p, const CurveArguments& a, const CurvePlace& place, SampledCurve& curve) {
    const Spread targets = spread_of_targets(p), drawn = spread_of(curve);
    if (!(drawn.weight > 0 && drawn.size() > 0)) return false;
    const Complex factor = allowed(p, a, std::polar(place.size * targets.size() / drawn.size(), place.turn));
    const Complex middle = targets.middle() + std::abs(factor) * drawn.size() * Complex(place.off.x, place.off.y);
    for (std::size_t k = 0; k < curve.count; ++k) {
        const Complex z = middle + factor * (Complex(curve.x[k], curve.y[k]) - drawn.middle());
        curve.x[k] = z.real();
        curve.y[k] = z.imag();
    }
    return true;
}

void lay(const Laying& laying, const LinkPositions& links, SampledCurve& curve) {
    for (std::size_t k = 0; k < curve.count; ++k) {
        const Complex z = laying(links.at[k]);
        curve.x[k] = z.real();
        curve.y[k] = z.imag();
    }
}

/// Finds the nearest points of the laid curve; positions of the link there.
void set_nearest(const CurveProblem& p, const LinkPositions& links, CurveWork& work, std::vector<LinkPosition>& out) {
    nearest_chords(p.set, work.curve, p.targets, work.chords);
    for (std::size_t i = 0; i < out.size(); ++i)
        out[i] =
            links.on_chord(static_cast<std::size_t>(work.chords.chord[i / 8][i % 8]), work.chords.part[i / 8][i % 8]);
}

double sum_of(const CurveProblem& p, const NearestChords& chords) {
    double sum = 0;
    for (std::size_t i = 0; i < p.targets.count; ++i)
        sum += weight_of(p, i) * chords.square[i / 8][i % 8];
    return sum;
}

void place(const CurveProblem& p, const Laying& laying, CurveArguments& a) {
    const double size = std::abs(laying.factor);
    const Complex point = laying.point / laying.factor * size;
    for (std::size_t i = 0; p.free_size && i < p.lengths; ++i)
        a[i] *= size;
    a[p.lengths] = point.real();
    a[p.lengths + 1] = point.imag();
    a[p.lengths + 2] = laying.origin.real();
    a[p.lengths + 3] = laying.origin.imag();
    a[p.lengths + 4] = std::arg(laying.factor);
}

/// Laid for positions of the link at the targets, then by nearest points again and again.
std::optional<FittedCurve> laid_from(const CurveProblem& p, FittedCurve design, const LinkPositions& links,
                                     std::vector<LinkPosition> at_targets, int repetitions, CurveWork& work) {
    std::optional<Laying> laying;
    for (int i = 0; i <= repetitions; ++i) {
        laying = best_laying(p, design.arguments, at_targets);
        if (!laying) return std::nullopt;
        lay(*laying, links, work.curve);
        set_nearest(p, links, work, at_targets);
    }
    design.sum = sum_of(p, work.chords);
    place(p, *laying, design.arguments);
    design.arguments = within_ranges(p, design.arguments);
    if (!p.allows(design.assembly, design.arguments)) return std::nullopt;
    return design;
}

}  // namespace

std::vector<double> times_at_targets(const CurveProblem& p, const FittedCurve& design, CurveWork& work) {
    if (!sample(p, design, work)) return {};
    const std::size_t x = p.lengths + 2;
    targets_in_frame(p.targets, {design.arguments[x], design.arguments[x + 1]}, design.arguments[x + 2], work.local);
    nearest_chords(p.set, work.curve, work.local, work.chords);
    const SampledCurve& c = work.curve;
    std::vector<double> times;
    for (std::size_t i = 0; i < p.targets.count; ++i) {
        const auto k = static_cast<std::size_t>(work.chords.chord[i / 8][i % 8]);
        const double part = work.chords.part[i / 8][i % 8];
        times.push_back(time_at(c, c.crank_angle[k] + part * (c.crank_angle[k + 1] - c.crank_angle[k])));
    }
    return times;
}

std::optional<FittedCurve> laid(const CurveProblem& p, FittedCurve design, const std::vector<double>& times,
                                int repetitions, CurveWork& work) {
    if (!sample(p, design, work)) return std::nullopt;
    LinkPositions links;
    set_positions(p, design, work.curve, links);
    return laid_from(p, std::move(design), links, positions_at(work.curve, links, times), repetitions, work);
}

std::optional<FittedCurve> laid(const CurveProblem& p, FittedCurve design, const CurvePlace& first, int repetitions,
                                CurveWork& work) {
    if (!sample(p, design, work)) return std::nullopt;
    LinkPositions links;
    set_positions(p, design, work.curve, links);
    if (!move(p, design.arguments, first, work.curve)) return std::nullopt;
    std::vector<LinkPosition> at_targets(p.targets.count);
    set_nearest(p, links, work, at_targets);
    return laid_from(p, std::move(design), links, std::move(at_targets), repetitions, work);
}

}  // namespace mechwright
