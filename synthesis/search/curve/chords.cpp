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
};

/// So many chords one after the other are passed over together where none of them can be the nearest.
constexpr std::size_t chords_of_stretch = 8;

/// A point of a stretch, and how far others are from there at most.
struct Stretch {
    std::size_t first, end;  ///< chords
    double x, y;
    double square;  ///< of the radius, and what rounding may add
};

struct Chords {
    std::size_t count = 0;
    std::size_t stretches = 0;
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
    for (std::size_t k = 0; k < out.count; ++k) {
        const double x = curve.x[k + 1] - curve.x[k];
        const double y = curve.y[k + 1] - curve.y[k];
        const double square = x * x + y * y;
        out.all[k] = {curve.x[k], curve.y[k], x, y, square > 0 ? 1 / square : 0};
    }
    out.stretches = 0;
    for (std::size_t first = 0; first < out.count; first += chords_of_stretch)
        out.stretch[out.stretches++] = stretch_of(curve, first, std::min(first + chords_of_stretch, out.count));
}

template <class T>
void nearest(const Chords& chords, const GroupedTargets& targets, NearestChords& out) {
    const T none(0.0), whole(1.0), two(2.0);
    std::array<T, SampledCurve::most / chords_of_stretch> away;
    for (std::size_t group = 0; group < targets.x.size(); ++group)
        for (std::size_t first = 0; first < std::tuple_size_v<Group>; first += T::count) {
            T x, y;
            x.read(targets.x[group].data() + first);
            y.read(targets.y[group].data() + first);
            T least(std::numeric_limits<double>::infinity()), number(0.0), part(0.0);
            for (std::size_t s = 0; s < chords.stretches; ++s) {
                const T from_x = x - T(chords.stretch[s].x);
                const T from_y = y - T(chords.stretch[s].y);
                away[s] = from_x * from_x + from_y * from_y;
                least = select(away[s] < least, away[s], least);
            }
            least = least * T(1 + 1e-9) + T(1e-300);  // so that the chords at those points are nearer
            for (std::size_t s = 0; s < chords.stretches; ++s) {
                // (a + b)^2 <= 2 (a^2 + b^2): what is farther away than radius and nearest point together.
                if (!any(away[s] < two * (least + T(chords.stretch[s].square)))) continue;
                for (std::size_t k = chords.stretch[s].first; k < chords.stretch[s].end; ++k) {
                    const Chord& c = chords.all[k];
                    const T from_x = x - T(c.x);
                    const T from_y = y - T(c.y);
                    T along = (from_x * T(c.way_x) + from_y * T(c.way_y)) * T(c.per_square);
                    along = select(along < none, none, select(along > whole, whole, along));
                    const T off_x = from_x - along * T(c.way_x);
                    const T off_y = from_y - along * T(c.way_y);
                    const T square = off_x * off_x + off_y * off_y;
                    const auto nearer = square < least;
                    least = select(nearer, square, least);
                    number = select(nearer, T(static_cast<double>(k)), number);
                    part = select(nearer, along, part);
                }
            }
            least.write(out.square[group].data() + first);
            number.write(out.chord[group].data() + first);
            part.write(out.part[group].data() + first);
        }
}

[[gnu::flatten]] void nearest_baseline(const Chords& chords, const GroupedTargets& targets, NearestChords& out) {
    nearest<BaselineLanes>(chords, targets, out);
}

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] void nearest_avx2(const Chords& chords, const GroupedTargets& targets,
                                                        NearestChords& out) {
    nearest<Avx2Lanes>(chords, targets, out);
}

[[gnu::flatten, gnu::target("avx512f")]] void nearest_avx512(const Chords& chords, const GroupedTargets& targets,
                                                             NearestChords& out) {
    nearest<Avx512Lanes>(chords, targets, out);
}

#endif

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
    Chords chords;
    set_chords(curve, chords);
    out.square.resize(targets.x.size());
    out.chord.resize(targets.x.size());
    out.part.resize(targets.x.size());
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return nearest_avx512(chords, targets, out);
    if (set == InstructionSet::avx2) return nearest_avx2(chords, targets, out);
#endif
    static_cast<void>(set);
    nearest_baseline(chords, targets, out);
}

}  // namespace mechwright
