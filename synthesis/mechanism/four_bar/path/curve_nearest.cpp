#include "synthesis/mechanism/four_bar/path/curve_nearest.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/lanes.h"
#include "analysis/numbers/turn_in_lanes.h"
#include "synthesis/mechanism/four_bar/path/guide_in_lanes.h"

namespace mechwright::coupler_curve {

namespace {

/// Steps to the nearest point. One of Newton's below this part of the chord's crank angle is the last: what it leaves
/// is of the order of its square. One that halves an interval leaves as much as it went.
constexpr int most_steps = 16;
constexpr double last_newton_step = 1e-5;
constexpr double last_halving = 1e-6;
/// The nearest point lies within so many chords of the nearest chord's.
constexpr double chords_away = 1.5;
/// At a toggle the sine of the transmission angle is 0, and what is divided by it is taken from the tangent instead.
constexpr double near_toggle = 1e-2;
/// So near to an end of the motion, as a part of it, is at the end.
constexpr double at_end_within = 1e-8;

template <class T>
HalfTurn<T> half_turn_of(const T& crank_angle) {
    const Vector<T> half = unit_vector(T(T(0.5) * crank_angle));
    return {half.x, half.y};
}

/// The coupler point and what it does as the crank turns. `way` is its velocity times the sine of the transmission
/// angle: finite at a toggle, too.
template <class T>
struct Moving {
    FourBarPose<T> pose;
    Vector<T> at;
    Vector<T> arm;  ///< left of the way from crank pin to coupler point
    T turn;         ///< of the coupler, times sine of the transmission angle over crank
    Vector<T> way;
};

template <class T>
Moving<T> moving(const FourBar<T>& m, const CouplerPoint<T>& point, const HalfTurn<T>& half, Assembly assembly) {
    Moving<T> r;
    r.pose = pose(m, half, assembly);
    const Vector<T> swung = turned({point.along, point.across}, r.pose.coupler);
    r.at = m.crank * r.pose.crank + swung;
    r.arm = left_of(swung);
    r.turn = cross(r.pose.rocker, r.pose.crank) / m.coupler;
    r.way = m.crank * (r.pose.transmission_sine * left_of(r.pose.crank) + r.turn * r.arm);
    return r;
}

/// The end of a motion as the crank range that ends there moves with the lengths: the diagonal d from crank pin to
/// rocker pivot is then coupler + rocker or their difference, but for a slack, which is a part of the longest link. The
/// angle a between coupler and diagonal is small, or nearly half a turn; with coupler k, rocker r and slack s
///
///     1 - |cos a| = s (2 r - s) / (2 k d)
///
/// (+ s where that of the coupler folds it beyond the rocker), so that it goes with the lengths as
///
///     da = +-tan(a / 2) (ds / s + dr / r - dk / k - dd / d).
NearestEnd end_of_motion(const Arguments& a, double crank_angle, const Vector<double>& target) {
    const auto& m = a.links;
    const Moving<double> at = moving(m, a.point, half_turn(crank_angle), a.assembly);
    NearestEnd end;
    end.miss = tilted(at.at - target, a.placement.tilt);
    const Vector<double> diagonal = Vector<double>{m.ground, 0} - m.crank * at.pose.crank;
    const double length = std::hypot(diagonal.x, diagonal.y);
    const Vector<double> along = (1 / length) * diagonal;
    const bool stretched =
        std::abs(length - (m.coupler + m.rocker)) < std::abs(length - std::abs(m.coupler - m.rocker));
    const double by_coupler = stretched || m.coupler > m.rocker ? 1 : -1;
    const double by_rocker = stretched ? 1 : -by_coupler;
    // The slack is a part of the longest link.
    const std::array<double, 4> lengths{m.ground, m.crank, m.coupler, m.rocker};
    const auto longest = static_cast<std::size_t>(std::max_element(lengths.begin(), lengths.end()) - lengths.begin());
    const double cosine = dot(at.pose.coupler, along), sine_of_angle = cross(along, at.pose.coupler);
    const double angle = sine_of_angle / (1 + std::abs(cosine)) * (cosine < 0 ? -1 : 1);
    // length^2 = ground^2 + crank^2 - 2 ground crank cos: its differential gives that of the crank angle.
    const double sine = std::copysign(std::max(std::abs(at.pose.crank.y), 1e-6), at.pose.crank.y);
    const double per = 1 / (m.ground * m.crank * sine);
    const std::array<double, 4> turn{-(m.ground - m.crank * at.pose.crank.x) * per,
                                     -(m.crank - m.ground * at.pose.crank.x) * per, length * by_coupler * per,
                                     length * by_rocker * per};
    const auto set = [&](std::size_t i, const Vector<double>& local) {
        const Vector<double> v = tilted(local, a.placement.tilt);
        end.x[i] = v.x;
        end.y[i] = v.y;
    };
    for (std::size_t i = 0; i < 4; ++i) {
        Vector<double> pin = (m.crank * turn[i]) * left_of(at.pose.crank);
        if (i == 1) pin = pin + at.pose.crank;
        const Vector<double> grown = Vector<double>{i == 0 ? 1.0 : 0.0, 0} - pin;
        const double stretch = i == 2 ? by_coupler : i == 3 ? by_rocker : 0;
        const double slack = (i == longest ? 1 / lengths[i] : 0) + (i == 3 ? 1 / m.rocker : 0) -
                             (i == 2 ? 1 / m.coupler : 0) - stretch / length;
        set(i, pin + (cross(along, grown) / length + angle * slack) * at.arm);
    }
    set(4, at.pose.coupler);
    set(5, left_of(at.pose.coupler));
    end.x[6] = end.y[7] = 1;
    set(8, left_of(at.at));
    return end;
}

/// One group of targets, as many at a time as T has lanes.
template <class T>
void nearest_of(const Arguments& a, const SampledCurve& curve, const NearestChords& chords,
                const GroupedTargets& targets, std::size_t group, std::size_t first, NearestOnCurve& out) {
    const FourBar<T> m = in_lanes<T>(a.links);
    const CouplerPoint<T> point{T(a.point.along), T(a.point.across)};
    const Vector<T> target{loaded<T>(targets.x[group], first), loaded<T>(targets.y[group], first)};
    const double side = side_of(a.assembly);
    T angle, low, high, chord_angle;
    std::array<bool, T::count> ends{};
    for (std::size_t k = 0; k < T::count; ++k) {
        const auto chord = static_cast<std::size_t>(chords.chord[group][first + k]);
        const double width = curve.crank_angle[chord + 1] - curve.crank_angle[chord];
        double at = curve.crank_angle[chord] + chords.part[group][first + k] * width;
        double least = at - chords_away * width;
        double most = at + chords_away * width;
        if (!curve.closed) {
            least = std::max(least, curve.from);
            most = std::min(most, curve.to);
            if (at <= curve.from || at >= curve.to) {
                const Moving<double> end = moving(a.links, a.point, half_turn(at), a.assembly);
                const Vector<double> miss{end.at.x - target.x.lane[k], end.at.y - target.y.lane[k]};
                const double slope = side * dot(miss, end.way);
                ends[k] = at <= curve.from ? slope >= 0 : slope <= 0;
                if (!ends[k]) at += (at <= curve.from ? 0.01 : -0.01) * width;
            }
        }
        angle.lane[k] = at;
        low.lane[k] = least;
        high.lane[k] = most;
        chord_angle.lane[k] = width;
    }
    Moving<T> at = moving(m, point, half_turn_of(angle), a.assembly);
    T left(1.0);  // to be moved: 1 or 0
    for (std::size_t k = 0; k < T::count; ++k)
        if (ends[k]) left.lane[k] = 0;
    for (int step = 0; step < most_steps; ++step) {
        const T per = T(1.0) / at.pose.transmission_sine;
        const FourBarVelocity<T> v{T(1.0), m.crank * at.turn * per,
                                   m.crank * per * cross(at.pose.coupler, at.pose.crank) / m.rocker};
        const FourBarAcceleration<T> w = acceleration(m, at.pose, v);
        const Vector<T> miss = at.at - target;
        const Vector<T> first_way = per * at.way;
        const Vector<T> second_way =
            w.coupler * at.arm + (v.coupler * v.coupler) * left_of(at.arm) - m.crank * at.pose.crank;
        const T slope = dot(miss, first_way);
        const T bend = dot(first_way, first_way) + dot(miss, second_way);
        const auto beyond = slope > T(0.0);
        high = select(beyond, angle, high);
        low = select(beyond, low, angle);
        const T newton = angle - slope / bend;
        const auto convex = bend > T(0.0);
        const auto within = both(both(newton > low, newton < high), convex);
        const auto moves = left > T(0.0);
        const T next = select(moves, select(within, newton, T(T(0.5) * (low + high))), angle);
        const T change = abs(T(next - angle));
        angle = next;
        at = moving(m, point, half_turn_of(angle), a.assembly);
        const T last = select(within, T(last_newton_step), T(last_halving)) * chord_angle;
        left = select(change > last, left, T(0.0));
        if (!any(left > T(0.0))) break;
    }
    // The normal, and how far the point goes along it with each argument.
    const Vector<T> miss = at.at - target;
    const T length = sqrt(dot(at.way, at.way));
    const T per_length = T(side) / select(length > T(0.0), length, T(1.0));
    const Vector<T> normal = per_length * left_of(at.way);
    const T sine = at.pose.transmission_sine;
    const T crossing = cross(at.pose.rocker, at.pose.crank);
    const auto clear = abs(sine) > T(near_toggle) * abs(crossing);
    const T turn = select(clear, T(dot(normal, at.arm) / (m.coupler * select(clear, sine, T(1.0)))),
                          T(-dot(normal, left_of(at.pose.crank)) / select(clear, T(1.0), crossing)));
    const double cosine = std::cos(a.placement.tilt), sine_of_tilt = std::sin(a.placement.tilt);
    const std::array<T, most_curve_arguments> gradient{
        turn * at.pose.rocker.x,
        dot(normal, at.pose.crank) - turn * dot(at.pose.crank, at.pose.rocker),
        -turn * at.pose.transmission_cosine,
        turn,
        dot(normal, at.pose.coupler),
        dot(normal, left_of(at.pose.coupler)),
        normal.x * T(cosine) - normal.y * T(sine_of_tilt),
        normal.x * T(sine_of_tilt) + normal.y * T(cosine),
        dot(normal, left_of(at.at))};
    dot(normal, miss).write(out.miss[group].data() + first);
    dot(miss, miss).write(out.square[group].data() + first);
    angle.write(out.crank_angle[group].data() + first);
    for (std::size_t i = 0; i < gradient.size(); ++i)
        gradient[i].write(out.gradient[i][group].data() + first);
    const double close = at_end_within * (curve.to - curve.from);
    for (std::size_t k = 0; k < T::count; ++k) {
        const std::size_t number = group * 8 + first + k;
        const double reached = angle.lane[k];
        if (curve.closed || number >= targets.count) continue;
        if (!ends[k] && reached - curve.from > close && curve.to - reached > close) continue;
        const double end = reached - curve.from < curve.to - reached ? curve.from : curve.to;
        NearestEnd nearest = end_of_motion(a, end, {target.x.lane[k], target.y.lane[k]});
        nearest.target = number;
        out.crank_angle[group][first + k] = end;
        out.square[group][first + k] = dot(nearest.miss, nearest.miss);
        out.miss[group][first + k] = 0;
        for (auto& by_argument : out.gradient)
            by_argument[group][first + k] = 0;
        out.ends.push_back(nearest);
    }
}

template <class T>
void nearest_points(const Arguments& a, const SampledCurve& curve, const NearestChords& chords,
                    const GroupedTargets& targets, NearestOnCurve& out) {
    const std::size_t groups = targets.x.size();
    out.crank_angle.resize(groups);
    out.square.resize(groups);
    out.miss.resize(groups);
    for (auto& by_argument : out.gradient)
        by_argument.resize(groups);
    out.ends.clear();
    for (std::size_t group = 0; group < groups; ++group)
        for (std::size_t first = 0; first < std::tuple_size_v<Group>; first += T::count)
            nearest_of<T>(a, curve, chords, targets, group, first, out);
}

// One body for each instruction set, with everything it calls made part of it.

[[gnu::flatten]] void nearest_baseline(const Arguments& a, const SampledCurve& curve, const NearestChords& chords,
                                       const GroupedTargets& targets, NearestOnCurve& out) {
    nearest_points<BaselineLanes>(a, curve, chords, targets, out);
}

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] void nearest_avx2(const Arguments& a, const SampledCurve& curve,
                                                        const NearestChords& chords, const GroupedTargets& targets,
                                                        NearestOnCurve& out) {
    nearest_points<Avx2Lanes>(a, curve, chords, targets, out);
}

[[gnu::flatten, gnu::target("avx512f")]] void nearest_avx512(const Arguments& a, const SampledCurve& curve,
                                                             const NearestChords& chords, const GroupedTargets& targets,
                                                             NearestOnCurve& out) {
    nearest_points<Avx512Lanes>(a, curve, chords, targets, out);
}

#endif

}  // namespace

void nearest_on_curve(InstructionSet set, std::size_t assembly, std::span<const double> arguments,
                      const SampledCurve& curve, const NearestChords& chords, const GroupedTargets& targets,
                      NearestOnCurve& out) {
    const Arguments a = arguments_of(assembly, arguments);
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return nearest_avx512(a, curve, chords, targets, out);
    if (set == InstructionSet::avx2) return nearest_avx2(a, curve, chords, targets, out);
#endif
    static_cast<void>(set);
    nearest_baseline(a, curve, chords, targets, out);
}

}  // namespace mechwright::coupler_curve
