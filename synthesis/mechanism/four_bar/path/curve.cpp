#include "synthesis/mechanism/four_bar/path/curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "analysis/four_bar.h"
#include "analysis/numbers/lanes.h"
#include "analysis/numbers/turn_in_lanes.h"
#include "synthesis/mechanism/four_bar/cognates.h"
#include "synthesis/mechanism/four_bar/path/curve_nearest.h"
#include "synthesis/mechanism/mechanism.h"
#include "synthesis/mechanism/sure_part.h"

namespace mechwright {

namespace {

using coupler_curve::Arguments;
using coupler_curve::arguments_of;
using coupler_curve::in_lanes;

/// A chord longer than this many times the mean one is divided, into no more than so many; what is still as long then,
/// into so many, so many times.
constexpr double long_chord = 2;
constexpr std::size_t most_parts = 16;
constexpr std::size_t parts_again = 4;
constexpr int most_times_divided = 12;
/// The coupler point at a crank angle, from where the circles about crank pin and rocker pivot meet. Next to toggles
/// half of the digits are lost: enough to tell which part of a curve is the nearest.
template <class T>
Vector<T> quick_position(const FourBar<T>& m, const CouplerPoint<T>& point, const T& crank_angle, double side) {
    const Vector<T> pin = m.crank * unit_vector(crank_angle);
    const Vector<T> diagonal{m.ground - pin.x, -pin.y};
    const T square = dot(diagonal, diagonal);
    const T along = T(0.5) * (square + m.coupler * m.coupler - m.rocker * m.rocker);
    const T across = T(side) * root_or_zero(T(square * m.coupler * m.coupler - along * along));
    const T per = T(1.0) / (square * m.coupler);
    const Vector<T> coupler = per * (along * diagonal + across * left_of(diagonal));
    return pin + point.along * coupler + point.across * left_of(coupler);
}

/// Points at the crank angles first, first + 1, ... of a curve.
template <class T>
void placed_points(const Arguments& a, SampledCurve& curve, std::size_t first, std::size_t end) {
    const FourBar<T> links = in_lanes<T>(a.links);
    const CouplerPoint<T> point{T(a.point.along), T(a.point.across)};
    const double side = side_of(a.assembly);
    for (; first < end; first += T::count) {
        T angle;
        for (std::size_t k = 0; k < T::count; ++k)
            angle.lane[k] = curve.crank_angle[std::min(first + k, end - 1)];
        const Vector<T> at = quick_position(links, point, angle, side);
        for (std::size_t k = 0; k < std::min(T::count, end - first); ++k) {
            curve.x[first + k] = at.x.lane[k];
            curve.y[first + k] = at.y.lane[k];
        }
    }
}

/// The lengths of all chords; after them may stand anything.
template <class T>
void chord_lengths(const SampledCurve& c, std::array<double, SampledCurve::most>& out) {
    for (std::size_t k = 0; k + 1 < c.count; k += T::count) {
        T x, y, next_x, next_y;
        x.read(c.x.data() + k);
        y.read(c.y.data() + k);
        next_x.read(c.x.data() + k + 1);
        next_y.read(c.y.data() + k + 1);
        hypotenuse(T(next_x - x), T(next_y - y)).write(out.data() + k);
    }
}

/// Evenly over a full turn; towards the ends of a limited motion, where the point is quick, in smaller steps. After the
/// last may stand anything.
template <class T>
void set_crank_angles(const CrankRange<double>& range, SampledCurve& curve) {
    const double middle = (range.from + range.to) / 2;
    const double half = (range.to - range.from) / 2;
    for (std::size_t first = 0; first < curve.count; first += T::count) {
        T part;
        for (std::size_t k = 0; k < T::count; ++k)
            part.lane[k] = static_cast<double>(first + k) / static_cast<double>(curve.count - 1);
        const T angle = range.full_turn ? T(T(range.from) + T(2 * half) * part)
                                        : T(T(middle) - T(half) * unit_vector(T(T(pi<double>()) * part)).x);
        angle.write(curve.crank_angle.data() + first);
    }
}

/// A curve with its chords that are longer than `longest` divided, into no more than so many parts, as far as there is
/// room. False: there is none, or no room.
template <class T>
bool divide(const Arguments& a, double longest, std::size_t most, const SampledCurve& from, SampledCurve& to) {
    std::array<double, SampledCurve::most> chord;
    chord_lengths<T>(from, chord);
    const std::size_t last = from.count - 1;
    to.count = 0;
    for (std::size_t k = 0; k < last; ++k) {
        const std::size_t room = SampledCurve::most - to.count - (from.count - k);
        const double wanted = chord[k] > longest ? chord[k] / longest : 0;
        const std::size_t parts = 1 + std::min({static_cast<std::size_t>(wanted), most - 1, room});
        const double step = (from.crank_angle[k + 1] - from.crank_angle[k]) / static_cast<double>(parts);
        const std::size_t first = to.count;
        for (std::size_t i = 0; i < parts; ++i)
            to.crank_angle[to.count++] = from.crank_angle[k] + static_cast<double>(i) * step;
        to.x[first] = from.x[k];
        to.y[first] = from.y[k];
        if (parts > 1) placed_points<T>(a, to, first + 1, to.count);
    }
    to.crank_angle[to.count] = from.crank_angle[last];
    to.x[to.count] = from.x[last];
    to.y[to.count] = from.y[last];
    return ++to.count > from.count;
}

/// The crank angles at which a linkage whose motion ends assembles by `judged_part` of its longest link: of the two
/// links that meet at the rocker pin the shorter one made shorter by so much, both together stretch so much less and
/// fold so much less.
CrankRange<double> sure_range(FourBar<double> m) {
    const CrankRange<double> all = assembled_range(m);
    if (all.full_turn || !(all.from <= all.to)) return all;
    double& shorter = m.coupler < m.rocker ? m.coupler : m.rocker;
    shorter -= judged_part * std::max({m.ground, m.crank, m.coupler, m.rocker});
    return assembled_range(m);
}

template <class T>
bool sampled(const Arguments& a, std::size_t coarse, SampledCurve& curve) {
    const CrankRange<double> range = sure_range(a.links);
    if (!(range.from <= range.to)) return false;
    SampledCurve even;
    even.count = std::min(coarse, SampledCurve::most / 2) + 1;
    set_crank_angles<T>(range, even);
    placed_points<T>(a, even, 0, even.count);
    std::array<double, SampledCurve::most> chord;
    chord_lengths<T>(even, chord);
    const double length = std::accumulate(chord.data(), chord.data() + even.count - 1, 0.0);
    const double longest = long_chord * length / static_cast<double>(even.count - 1);
    if (!divide<T>(a, longest, most_parts, even, curve)) curve = even;
    // Next to a change point the point goes round a corner in a moment: what is still long is divided again.
    for (int times = 0; times < most_times_divided && divide<T>(a, longest, parts_again, curve, even); ++times)
        std::swap(curve, even);
    curve.closed = range.full_turn;
    curve.from = range.from;
    curve.to = range.to;
    return true;
}

// One body for each instruction set, with everything it calls made part of it.

[[gnu::flatten]] bool sampled_baseline(const Arguments& a, std::size_t coarse, SampledCurve& out) {
    return sampled<BaselineLanes>(a, coarse, out);
}

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] bool sampled_avx2(const Arguments& a, std::size_t coarse, SampledCurve& out) {
    return sampled<Avx2Lanes>(a, coarse, out);
}

[[gnu::flatten, gnu::target("avx2")]] void points_avx2(const Arguments& a, SampledCurve& curve) {
    placed_points<Avx2Lanes>(a, curve, 0, curve.count);
}

[[gnu::flatten, gnu::target("avx512f")]] void points_avx512(const Arguments& a, SampledCurve& curve) {
    placed_points<Avx512Lanes>(a, curve, 0, curve.count);
}

[[gnu::flatten, gnu::target("avx512f")]] bool sampled_avx512(const Arguments& a, std::size_t coarse,
                                                             SampledCurve& out) {
    return sampled<Avx512Lanes>(a, coarse, out);
}

#endif

bool sampled_curve(InstructionSet set, std::size_t assembly, std::span<const double> arguments, std::size_t coarse,
                   SampledCurve& out) {
    const Arguments a = arguments_of(assembly, arguments);
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return sampled_avx512(a, coarse, out);
    if (set == InstructionSet::avx2) return sampled_avx2(a, coarse, out);
#endif
    static_cast<void>(set);
    return sampled_baseline(a, coarse, out);
}

void points_on_curve(InstructionSet set, std::size_t assembly, std::span<const double> arguments, SampledCurve& curve) {
    const Arguments a = arguments_of(assembly, arguments);
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return points_avx512(a, curve);
    if (set == InstructionSet::avx2) return points_avx2(a, curve);
#endif
    static_cast<void>(set);
    placed_points<BaselineLanes>(a, curve, 0, curve.count);
}

/// The two positions in which the links of the triangle at the rocker can be in line with the crank on the ground line.
const std::vector<LinearCondition>& borders() {
    static const std::vector<LinearCondition> all{
        {"stretched, with the crank away from the rocker pivot", {-1, -1, 1, 1}},
        {"folded, with the crank towards the rocker pivot", {1, -1, -1, 1}},
        {"folded, with the crank towards the rocker pivot", {1, -1, 1, -1}}};
    return all;
}

/// The cognate with the crank angles of the original, or the same linkage from its other pivot.
bool to_relative(bool other_drive, std::size_t& assembly, std::span<double> arguments) {
    const auto [links, point, placement, side] = arguments_of(assembly, arguments);
    const PathLinkage<double> own{links, point, placement, side};
    const PathLinkage<double> other = other_drive ? four_bar::from_other_pivot(own) : cognates(own)[1];
    const auto& [ground, crank, coupler, rocker] = other.links;
    if (!(std::min({ground, crank, coupler, rocker}) > 0)) return false;
    assembly = other.assembly == Assembly::open ? 0 : 1;
    const auto& [along, across] = other.point;
    const auto& [x, y] = other.placement.origin;
    std::ranges::copy(std::array{ground, crank, coupler, rocker, along, across, x, y, other.placement.tilt},
                      arguments.begin());
    return true;
}

}  // namespace

CurveFit four_bar_curve_fit() {
    static constexpr CurveKin kin{borders, to_relative};
    return {sampled_curve, points_on_curve, coupler_curve::nearest_on_curve, &kin};
}

}  // namespace mechwright
