#include "synthesis/search/curve/chords.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "analysis/numbers/lanes.h"

namespace mechwright {

namespace {

/// A chord as what the distance from it takes.
struct Chord {
    double x, y;  ///< where it begins
    double way_x, way_y;
    double per_square;  ///< 1 over its squared length; 0 where it has none
    double bulge;       ///< how far the curve may be from it
};

/// So many chords one after the other are passed over together where none of them can be the nearest.
constexpr std::size_t chords_of_stretch = 8;
/// How far a curve may be from its chord, as a part of the chord: that of an arc that turns by half a radian.
constexpr double bulge = 1.0 / 16;

/// A point of a stretch, and how far others are from there at most.
struct Stretch {
    std::size_t first, end;  ///< chords
    double x, y;
    double square;  ///< of the radius, and what rounding may add
};

struct Chords {
    std::size_t count = 0;
    std::size_t stretches = 0;
    bool closed = false;
    double bulge = 0;  ///< the greatest
    std::array<Chord, SampledCurve::most> all;
    std::array<Stretch, SampledCurve::most / chords_of_stretch> stretch;
};

Stretch stretch_of(const SampledCurve& curve, std::size_t first, std::size_t end) {
    const std::size_t middle = (first + end) / 2;
    Stretch s{first, end, curve.x[middle], curve.y[middle], 0};
    for (std::size_t k = first; k <= end; ++k) {
        const double x = curve.x[k] - s.x;
        const double y = curve.y[k] - s.y;
        s.square = std::max(s.square, x * x + y * y);
    }
    s.square *= 1 + 1e-9;
    return s;
}

void set_chords(const SampledCurve& curve, Chords& out) {
    out.count = curve.count - 1;
    out.closed = curve.closed;
    out.bulge = 0;
    for (std::size_t k = 0; k < out.count; ++k) {
        const double x = curve.x[k + 1] - curve.x[k];
        const double y = curve.y[k + 1] - curve.y[k];
        const double square = x * x + y * y;
        out.all[k] = {curve.x[k], curve.y[k], x, y, square > 0 ? 1 / square : 0, bulge * std::sqrt(square)};
        out.bulge = std::max(out.bulge, out.all[k].bulge);
    }
    out.stretches = 0;
    for (std::size_t first = 0; first < out.count; first += chords_of_stretch)
        out.stretch[out.stretches++] = stretch_of(curve, first, std::min(first + chords_of_stretch, out.count));
}

/// Of each lane a chord, its nearest point and the squared distance of that.
template <class T>
struct Near {
    T square{std::numeric_limits<double>::infinity()};
    T chord{-1.0};
    T part{0.0};

    template <class Mask>
    void replace(const Mask& where, const Near& by) {
        square = select(where, by.square, square);
        chord = select(where, by.chord, chord);
        part = select(where, by.part, part);
    }
};

template <class T>
Near<T> near(const Chords& chords, std::size_t k, const T& x, const T& y) {
    const T none(0.0), whole(1.0);
    const Chord& c = chords.all[k];
    const T from_x = x - T(c.x);
    const T from_y = y - T(c.y);
    T along = (from_x * T(c.way_x) + from_y * T(c.way_y)) * T(c.per_square);
    along = select(along < none, none, select(along > whole, whole, along));
    const T off_x = from_x - along * T(c.way_x);
    const T off_y = from_y - along * T(c.way_y);
    return {off_x * off_x + off_y * off_y, T(static_cast<double>(k)), along};
}

/// The nearest chord of each stretch that can have the nearest of all, or the second nearest that is looked for.
template <class T>
struct Approaches {
    std::size_t count = 0;
    std::array<Near<T>, SampledCurve::most / chords_of_stretch> of;
    std::array<std::size_t, SampledCurve::most / chords_of_stretch> stretch;
};

/// As far away as the second nearest that is looked for may be: (d + t)^2 <= 1.5 d^2 + 3 t^2.
constexpr double times_square = 1.5;
double beside(const Chords& chords) { return 3 * 4 * chords.bulge * chords.bulge; }

template <class T>
void find_approaches(const Chords& chords, const T& x, const T& y, bool second, Approaches<T>& r) {
    const T two(2.0);
    std::array<T, SampledCurve::most / chords_of_stretch> away;
    T least(std::numeric_limits<double>::infinity());
    for (std::size_t s = 0; s < chords.stretches; ++s) {
        const T from_x = x - T(chords.stretch[s].x);
        const T from_y = y - T(chords.stretch[s].y);
        away[s] = from_x * from_x + from_y * from_y;
        least = select(away[s] < least, away[s], least);
    }
    least = least * T(1 + 1e-9) + T(1e-300);  // so that the chords at those points are nearer
    const T times(second ? times_square : 1.0), more(second ? beside(chords) : 0);
    r.count = 0;
    for (std::size_t s = 0; s < chords.stretches; ++s) {
        // (a + b)^2 <= 2 (a^2 + b^2): what is farther away than that and the radius together.
        const T looked_for = times * least + more + T(chords.stretch[s].square);
        if (!any(away[s] < two * looked_for)) continue;
        Near<T> nearest;
        for (std::size_t k = chords.stretch[s].first; k < chords.stretch[s].end; ++k) {
            const Near<T> chord = near(chords, k, x, y);
            nearest.replace(chord.square < nearest.square, chord);
        }
        least = select(nearest.square < least, nearest.square, least);
        r.stretch[r.count] = s;
        r.of[r.count++] = nearest;
    }
}

/// The nearest chord of the other stretches at which the curve comes near and goes away again: where it is the first or
/// the last of its stretch, the one beside that is no nearer.
template <class T>
Near<T> second_of(const Chords& chords, const Approaches<T>& all, const Near<T>& nearest) {
    const T none(std::numeric_limits<double>::infinity());
    const T looked_for = T(times_square) * nearest.square + T(beside(chords));
    Near<T> second;
    for (std::size_t i = 0; i < all.count; ++i) {
        if (!any(both(all.of[i].square<looked_for, all.of[i].square> nearest.square))) continue;
        const std::size_t s = all.stretch[i];
        Near<T> here = all.of[i];
        const auto leave_out_beside = [&](std::size_t chord, std::size_t neighbour, std::size_t k, double times) {
            if (k >= all.count || all.stretch[k] != neighbour) return;
            const T at(static_cast<double>(chord));
            const auto is_there = both(here.chord >= at, at >= here.chord);
            here.square = select(both(is_there, all.of[k].square < T(times) * here.square), none, here.square);
        };
        const bool is_first = s == 0, is_last = s + 1 == chords.stretches;
        // Chords that meet at the nearest point are equally near: it is that of the one before.
        if (!is_first) leave_out_beside(chords.stretch[s].first, s - 1, i - 1, 1 + 1e-9);
        if (is_first && chords.closed) leave_out_beside(0, chords.stretches - 1, all.count - 1, 1 + 1e-9);
        if (!is_last) leave_out_beside(chords.stretch[s].end - 1, s + 1, i + 1, 1 - 1e-9);
        if (is_last && chords.closed) leave_out_beside(chords.count - 1, 0, 0, 1 - 1e-9);
        here.square = select(both(here.chord >= nearest.chord, nearest.chord >= here.chord), none, here.square);
        second.replace(here.square < second.square, here);
    }
    return second;
}

/// Whether the curve may be nearer at the second chord than at the nearest.
bool may_be_nearer(const Chords& chords, double nearest, double square, double second, double second_square) {
    if (!(second_square < std::numeric_limits<double>::infinity())) return false;
    const auto bulge_of = [&](double chord) { return chords.all[static_cast<std::size_t>(chord)].bulge; };
    return std::sqrt(second_square) < std::sqrt(square) + bulge_of(nearest) + bulge_of(second);
}

/// One more of the other chords; the last group is filled up with copies of it.
void add(OtherChords& others, std::size_t target, double x, double y, double chord, double part) {
    constexpr std::size_t lanes = std::tuple_size_v<Group>;
    const std::array groups{&others.targets.x, &others.targets.y, &others.chords.chord, &others.chords.part};
    const std::array values{x, y, chord, part};
    const std::size_t first = others.target.size() % lanes;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (first == 0) groups[i]->emplace_back();
        std::fill(groups[i]->back().begin() + first, groups[i]->back().end(), values[i]);
    }
    others.target.push_back(target);
    others.targets.count = others.target.size();
}

template <class T>
void nearest(const Chords& chords, const GroupedTargets& targets, NearestChords& out, OtherChords* others) {
    constexpr std::size_t lanes = std::tuple_size_v<Group>;
    Approaches<T> all;
    for (std::size_t group = 0; group < targets.x.size(); ++group)
        for (std::size_t first = 0; first < lanes; first += T::count) {
            T x, y;
            x.read(targets.x[group].data() + first);
            y.read(targets.y[group].data() + first);
            find_approaches(chords, x, y, others != nullptr, all);
            Near<T> nearest;
            for (std::size_t i = 0; i < all.count; ++i)
                nearest.replace(all.of[i].square < nearest.square, all.of[i]);
            nearest.square.write(out.square[group].data() + first);
            nearest.chord.write(out.chord[group].data() + first);
            nearest.part.write(out.part[group].data() + first);
            if (others == nullptr) continue;
            const Near<T> second = second_of(chords, all, nearest);
            for (std::size_t k = 0; k < T::count; ++k) {
                const std::size_t target = group * lanes + first + k;
                if (target < targets.count && may_be_nearer(chords, nearest.chord.lane[k], nearest.square.lane[k],
                                                            second.chord.lane[k], second.square.lane[k]))
                    add(*others, target, x.lane[k], y.lane[k], second.chord.lane[k], second.part.lane[k]);
            }
        }
}

[[gnu::flatten]] void nearest_baseline(const Chords& chords, const GroupedTargets& targets, NearestChords& out,
                                       OtherChords* others) {
    nearest<BaselineLanes>(chords, targets, out, others);
}

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] void nearest_avx2(const Chords& chords, const GroupedTargets& targets,
                                                        NearestChords& out, OtherChords* others) {
    nearest<Avx2Lanes>(chords, targets, out, others);
}

[[gnu::flatten, gnu::target("avx512f")]] void nearest_avx512(const Chords& chords, const GroupedTargets& targets,
                                                             NearestChords& out, OtherChords* others) {
    nearest<Avx512Lanes>(chords, targets, out, others);
}

#endif

void find_nearest(InstructionSet set, const SampledCurve& curve, const GroupedTargets& targets, NearestChords& out,
                  OtherChords* others) {
    Chords chords;
    set_chords(curve, chords);
    out.square.resize(targets.x.size());
    out.chord.resize(targets.x.size());
    out.part.resize(targets.x.size());
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return nearest_avx512(chords, targets, out, others);
    if (set == InstructionSet::avx2) return nearest_avx2(chords, targets, out, others);
#endif
    static_cast<void>(set);
    nearest_baseline(chords, targets, out, others);
}

}  // namespace

void targets_in_frame(const GroupedTargets& targets, const Vector<double>& origin, double tilt, GroupedTargets& out) {
    const double cosine = std::cos(tilt), sine = std::sin(tilt);
    const std::size_t groups = targets.x.size();
    out.count = targets.count;
    out.x.resize(groups);
    out.y.resize(groups);
    for (std::size_t g = 0; g < groups; ++g)
        for (std::size_t k = 0; k < std::tuple_size_v<Group>; ++k) {
            const double x = targets.x[g][k] - origin.x;
            const double y = targets.y[g][k] - origin.y;
            out.x[g][k] = x * cosine + y * sine;
            out.y[g][k] = y * cosine - x * sine;
        }
}

void nearest_chords(InstructionSet set, const SampledCurve& curve, const GroupedTargets& targets, NearestChords& out) {
    find_nearest(set, curve, targets, out, nullptr);
}

void nearest_chords(InstructionSet set, const SampledCurve& curve, const GroupedTargets& targets, NearestChords& out,
                    OtherChords& others) {
    others.target.clear();
    for (auto* groups : {&others.targets.x, &others.targets.y, &others.chords.chord, &others.chords.part})
        groups->clear();
    others.targets.count = 0;
    find_nearest(set, curve, targets, out, &others);
}

}  // namespace mechwright
