#pragma once
/// \file
/// How the quantities of quantities.h are measured. Included where they are made into rows of the registry alone:
/// closed forms ask which quantity it is, and need not compile its measures again for that.

#include "synthesis/mechanism/cam/quantities.h"

namespace mechwright::cam {

/// The greatest of +1, and with two signs also of -1, times a formula in each segment of some kinds: `kept` of each.
template <template <class> class Follower, class Formula>
[[gnu::noinline]] void measure_extremes(const Motion& motion, std::span<const double> dimensions, Kinds kinds,
                                        std::size_t signs, std::size_t kept, const Measurement& out) {
    clear(out, kept * signs * segments_of(motion, kinds), dimension_count<Follower>);
    const auto value = value_by<Formula>();
    std::size_t component = 0;
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i) {
        if (!kinds(program_of(motion).segments[i].kind)) continue;
        const PlacedSegment placed = placed_segment<Follower>(motion, dimensions, i);
        for (std::size_t s = 0; s < signs; ++s) {
            const double sign = s == 0 ? 1 : -1;
            const auto places =
                greatest_places<most_places>(placed.segment, i, placed.start_lift, [&]<class T>(const Lift<T>& lift) {
                    return T(sign) * searched<Follower, Formula, T>(motion, dimensions, lift);
                });
            for (std::size_t k = 0; k < kept; ++k)
                add_term<Follower>(motion, dimensions, {places[k], sign}, value, component++, out);
        }
    }
}

template <template <class> class Follower, class Formula, Kinds kinds, bool both>
void Extremes<Follower, Formula, kinds, both>::measure(const Motion& motion, std::span<const double> dimensions,
                                                       const Measurement& out) {
    if (of_contact<Formula> && !has_contact<Follower>(motion, dimensions)) {
        clear(out, components(motion), dimension_count<Follower>);
        return set_to_nothing(out, components(motion));
    }
    measure_extremes<Follower, Formula>(motion, dimensions, kinds, signs, each(motion), out);
}

template <template <class> class Follower, class Formula>
void measure_at_start(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    clear(out, 1, dimension_count<Follower>);
    const auto value = value_by<Formula>();
    const double begin = break_before(placed_segment<Follower>(motion, dimensions, 0).segment, 0);
    add_term<Follower>(motion, dimensions, {{0, 0, begin, false}, 1}, value, 0, out);
}

template <template <class> class Follower, std::size_t index>
void measure_dimension(const Motion&, std::span<const double> dimensions, const Measurement& out) {
    clear(out, 1, dimension_count<Follower>);
    add_dimension(index, 1, dimensions, out);
}

template <template <class> class Follower>
void ExistenceMargin<Follower>::measure(const Motion& motion, std::span<const double> dimensions,
                                        const Measurement& out) {
    clear(out, components(motion), dimension_count<Follower>);
    const std::size_t count = program_of(motion).segments.size();
    for (std::size_t i = 0; i < count; ++i) {
        const SegmentPlace held = least_place<Follower, FollowMargin>(motion, dimensions, i);
        const SegmentPlace cut = least_place<Follower, UndercutMargin>(motion, dimensions, i);
        add_term<Follower>(motion, dimensions, {held, 1}, follows, 2 * i, out);
        add_term<Follower>(motion, dimensions, {cut, 1}, not_undercut, 2 * i + 1, out);
    }
    if constexpr (has_lever)
        add_term<Follower>(motion, dimensions, {least_place<Follower, LeverMargin>(motion, dimensions), 1}, levers,
                           2 * count, out);
}

}  // namespace mechwright::cam
