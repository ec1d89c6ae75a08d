#include "synthesis/search/curve/chords.h"

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

using Chords = std::array<Chord, SampledCurve::most>;

std::size_t chords_of(const SampledCurve& curve, Chords& out) {
    for (std::size_t k = 0; k + 1 < curve.count; ++k) {
        const double x = curve.x[k + 1] - curve.x[k];
        const double y = curve.y[k + 1] - curve.y[k];
        const double square = x * x + y * y;
        out[k] = {curve.x[k], curve.y[k], x, y, square > 0 ? 1 / square : 0};
    }
    return curve.count - 1;
}

template <class T>
void nearest(const Chords& chords, std::size_t count, const GroupedTargets& targets, NearestChords& out) {
    const T none(0.0), whole(1.0);
    for (std::size_t group = 0; group < targets.x.size(); ++group)
        for (std::size_t first = 0; first < std::tuple_size_v<Group>; first += T::count) {
            T x, y;
            x.read(targets.x[group].data() + first);
            y.read(targets.y[group].data() + first);
            T least(std::numeric_limits<double>::infinity()), number(0.0), part(0.0);
            for (std::size_t k = 0; k < count; ++k) {
                const Chord& c = chords[k];
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
            least.write(out.square[group].data() + first);
            number.write(out.chord[group].data() + first);
            part.write(out.part[group].data() + first);
        }
}

[[gnu::flatten]] void nearest_baseline(const Chords& chords, std::size_t count, const GroupedTargets& targets,
                                       NearestChords& out) {
    nearest<BaselineLanes>(chords, count, targets, out);
}

#if defined(__x86_64__)

[[gnu::flatten, gnu::target("avx2")]] void nearest_avx2(const Chords& chords, std::size_t count,
                                                        const GroupedTargets& targets, NearestChords& out) {
    nearest<Avx2Lanes>(chords, count, targets, out);
}

[[gnu::flatten, gnu::target("avx512f")]] void nearest_avx512(const Chords& chords, std::size_t count,
                                                             const GroupedTargets& targets, NearestChords& out) {
    nearest<Avx512Lanes>(chords, count, targets, out);
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
    const std::size_t count = chords_of(curve, chords);
    out.square.resize(targets.x.size());
    out.chord.resize(targets.x.size());
    out.part.resize(targets.x.size());
#if defined(__x86_64__)
    if (set == InstructionSet::avx512) return nearest_avx512(chords, count, targets, out);
    if (set == InstructionSet::avx2) return nearest_avx2(chords, count, targets, out);
#endif
    static_cast<void>(set);
    nearest_baseline(chords, count, targets, out);
}

}  // namespace mechwright
