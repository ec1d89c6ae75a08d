#pragma once
/// \file
/// Quantities of the registry from the formulas of a cam: how many components each has over a motion program, and how
/// they are measured.

#include <algorithm>
#include <array>
#include <type_traits>

#include "synthesis/mechanism/cam/formulas.h"

namespace mechwright::cam {

using Kinds = bool (*)(SegmentKind);

inline std::size_t segments_of(const Motion& motion, Kinds kinds) {
    const auto& segments = program_of(motion).segments;
    return static_cast<std::size_t>(
        std::count_if(segments.begin(), segments.end(), [&](const SegmentPlan& s) { return kinds(s.kind); }));
}

inline bool has_program(const Motion& motion) { return motion.model != nullptr && model_of(motion).program != nullptr; }

template <Kinds kinds>
bool has_segments(const Motion& motion) {
    return has_program(motion) && segments_of(motion, kinds) > 0;
}

/// The value of a formula as a function of follower, lift and, where it needs it, load.
template <class Formula>
auto value_by() {
    return []<class F, class L, class... Load>(const F& f, const L& lift, const Load&... load) requires requires {
        Formula::value(f, lift, load...);
    }
    { return Formula::value(f, lift, load...); };
}

/// What a formula looks for, at a lift in numbers of type T, the dimensions constant.
template <template <class> class Follower, class Formula, class T>
T searched(const Motion& motion, std::span<const double> dimensions, const Lift<T>& lift) {
    const auto geometry = geometry_of<Follower, T>(dimensions);
    const auto follower = Layout<Follower>::make(geometry, sense_of(motion.assembly));
    const auto load = [&] { return load_of<Follower>(geometry, motion); };
    if constexpr (requires { Formula::search(follower, lift); })
        return Formula::search(follower, lift);
    else if constexpr (requires { Formula::search(follower, lift, load()); })
        return Formula::search(follower, lift, load());
    else if constexpr (requires { Formula::value(follower, lift); })
        return Formula::value(follower, lift);
    else
        return Formula::value(follower, lift, load());
}

/// The places where a formula is greatest, or least too (`both` signs), in the segments of some kinds: up to four
/// in each segment, as there is room for them. A component is the value there, of a least one the negative value.
template <template <class> class Follower, class Formula, Kinds kinds, bool both>
struct Extremes {
    static constexpr std::size_t signs = both ? 2 : 1;

    static std::size_t each(const Motion& motion) {
        return std::clamp<std::size_t>(Quantity::most_components / (signs * segments_of(motion, kinds)), 1,
                                       most_places);
    }
    static std::size_t components(const Motion& motion) { return each(motion) * signs * segments_of(motion, kinds); }

    static void measure(const Motion& motion, std::span<const double> dimensions, const Measurement& out);
};

struct SegmentList {
    std::array<std::size_t, MotionProgram::most_segments> index{};
    std::size_t count = 0;

    void add(std::size_t i) { index[count++] = i; }
};

/// The segment after one, round the turn.
inline std::size_t following(const Motion& motion, std::size_t index) {
    return index + 1 == program_of(motion).segments.size() ? 0 : index + 1;
}

/// Whether a derivative of the lift differs from zero at an end of a segment for some sizes and coefficients of it.
template <class Derivative>
bool moves_at(const Motion& motion, std::size_t index, bool end) {
    if (program_of(motion).segments[index].contour != ContourKind::none) return true;
    SegmentParameters<double> some{.lift = 1, .angle = 1};
    some.start.fill(0.3);
    some.end.fill(0.7);
    some.shape.fill(0.9);
    const Segment<double> segment = segment_of(program_of(motion), motion.assembly, index, some);
    const std::size_t piece = end ? pieces(segment) - 1 : 0;
    const double u = break_before(segment, end ? piece + 1 : 0);
    constexpr double least_lift = 1e-9;
    return std::abs(Derivative::of(lift_at(segment, piece, u, 0.0))) > least_lift;
}

/// The segments at whose ends a derivative of the lift can jump at all; one, where it can at none.
template <class Derivative>
SegmentList jumping(const Motion& motion) {
    SegmentList found;
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i)
        if (moves_at<Derivative>(motion, i, true) || moves_at<Derivative>(motion, following(motion, i), false))
            found.add(i);
    if (found.count == 0) found.add(0);
    return found;
}

/// A jump of a derivative of the lift where segments meet: what comes after less what was before, and the reverse.
template <template <class> class Follower, class Derivative>
struct Jumps {
    static std::size_t components(const Motion& motion) { return 2 * jumping<Derivative>(motion).count; }

    static void measure(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
        const SegmentList segments = jumping<Derivative>(motion);
        clear(out, 2 * segments.count, dimension_count<Follower>);
        const auto value = [](const auto& f, const auto& lift) { return Derivative::value(f, lift); };
        for (std::size_t k = 0; k < segments.count; ++k) {
            const std::size_t i = segments.index[k], next = following(motion, i);
            const Segment<double> before = placed_segment<Follower>(motion, dimensions, i).segment;
            const std::size_t last = pieces(before) - 1;
            const double end = break_before(before, last + 1);
            const double begin = break_before(placed_segment<Follower>(motion, dimensions, next).segment, 0);
            for (const double sign : {1.0, -1.0}) {
                const std::size_t component = 2 * k + (sign > 0 ? 0 : 1);
                add_term<Follower>(motion, dimensions, {{next, 0, begin, false}, sign}, value, component, out);
                add_term<Follower>(motion, dimensions, {{i, last, end, false}, -sign}, value, component, out);
            }
        }
    }
};

/// The place of a segment at which a margin is least.
template <template <class> class Follower, class Margin>
SegmentPlace least_place(const Motion& motion, std::span<const double> dimensions, std::size_t segment) {
    const PlacedSegment placed = placed_segment<Follower>(motion, dimensions, segment);
    return greatest_places<1>(placed.segment, segment, placed.start_lift, [&]<class T>(const Lift<T>& lift) {
        return Margin::search(follower_of<Follower, T>(dimensions, motion.assembly), lift);
    })[0];
}

/// A margin at a place.
template <template <class> class Follower, class Margin>
double value_at(const Motion& motion, std::span<const double> dimensions, const SegmentPlace& place) {
    const PlacedSegment placed = placed_segment<Follower>(motion, dimensions, place.segment);
    return Margin::value(follower_of<Follower, double>(dimensions, motion.assembly),
                         lift_at(placed.segment, place.piece, place.u, placed.start_lift));
}

/// The place of the whole turn at which a margin is least.
template <template <class> class Follower, class Margin>
SegmentPlace least_place(const Motion& motion, std::span<const double> dimensions) {
    SegmentPlace least = least_place<Follower, Margin>(motion, dimensions, 0);
    for (std::size_t i = 1; i < program_of(motion).segments.size(); ++i) {
        const SegmentPlace place = least_place<Follower, Margin>(motion, dimensions, i);
        if (value_at<Follower, Margin>(motion, dimensions, place) <
            value_at<Follower, Margin>(motion, dimensions, least))
            least = place;
    }
    return least;
}

/// Whether there is a contact: of an oscillating face where it turns against the cam everywhere. Else there is no
/// envelope, and on the way there the contact passes infinity.
template <template <class> class Follower>
bool has_contact(const Motion& motion, std::span<const double> dimensions) {
    if constexpr (!std::is_same_v<Follower<double>, OscillatingFlat<double>>)
        return true;
    else
        return value_at<Follower, FollowMargin>(motion, dimensions,
                                                least_place<Follower, FollowMargin>(motion, dimensions)) > 0;
}

/// Measures of the contact, which have no value where there is none.
template <class Formula>
inline constexpr bool of_contact = std::is_same_v<Formula, PressureAngle> || std::is_same_v<Formula, ProfileRadius> ||
                                   std::is_same_v<Formula, UndercutMargin> || std::is_same_v<Formula, ContactDistance>;

/// Greatest less least place of the contact along the face: every difference of the five greatest and the five least
/// of the segments.
template <template <class> class Follower>
struct FaceLength {
    static constexpr std::size_t most = 5;

    static std::size_t kept(const Motion& motion) { return std::min(most, program_of(motion).segments.size()); }
    static std::size_t components(const Motion& motion) { return kept(motion) * kept(motion); }

    static void measure(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
        clear(out, components(motion), dimension_count<Follower>);
        if (!has_contact<Follower>(motion, dimensions)) return set_to_nothing(out, components(motion));
        const auto value = [](const auto& f, const auto& lift) { return ContactAlongFace::value(f, lift); };
        const auto greatest = ends(motion, dimensions, 1), least = ends(motion, dimensions, -1);
        std::size_t component = 0;
        for (std::size_t i = 0; i < kept(motion); ++i)
            for (std::size_t j = 0; j < kept(motion); ++j, ++component) {
                add_term<Follower>(motion, dimensions, {greatest[i], 1}, value, component, out);
                add_term<Follower>(motion, dimensions, {least[j], -1}, value, component, out);
            }
    }

private:
    /// One place in each segment, the farthest first.
    static std::array<SegmentPlace, most> ends(const Motion& motion, std::span<const double> dimensions, double sign) {
        struct Found {
            SegmentPlace place;
            double along;
        };
        std::array<Found, MotionProgram::most_segments> all;
        const std::size_t count = program_of(motion).segments.size();
        for (std::size_t i = 0; i < count; ++i) {
            const PlacedSegment placed = placed_segment<Follower>(motion, dimensions, i);
            const auto along = [&]<class T>(const Lift<T>& lift) {
                return T(sign) * ContactAlongFace::value(follower_of<Follower, T>(dimensions, motion.assembly), lift);
            };
            const SegmentPlace place = greatest_places<1>(placed.segment, i, placed.start_lift, along)[0];
            all[i] = {place, along(lift_at(placed.segment, place.piece, place.u, placed.start_lift))};
        }
        std::sort(all.begin(), all.begin() + count, [](const Found& a, const Found& b) {
            return a.along != b.along ? a.along > b.along : a.place.segment < b.place.segment;
        });
        std::array<SegmentPlace, most> places{};
        for (std::size_t i = 0; i < std::min(most, count); ++i)
            places[i] = all[i].place;
        return places;
    }
};

/// A formula at the beginning of the motion.
template <template <class> class Follower, class Formula>
void measure_at_start(const Motion& motion, std::span<const double> dimensions, const Measurement& out);

/// Measures of a contour itself.
struct WholeLift {
    template <class T>
    static T value(const Contour<T>& c) {
        return total_lift(c);
    }
};
struct ActionAngle {
    template <class T>
    static T value(const Contour<T>& c) {
        return T(2) * c.rise;
    }
};
struct FlankAngle {
    template <class T>
    static T value(const Contour<T>& c) {
        return c.flank;
    }
};

inline bool has_contour(const Motion& motion) {
    return has_program(motion) && program_of(motion).segments[0].contour != ContourKind::none;
}
inline bool has_flanks(const Motion& motion) {
    return has_contour(motion) && program_of(motion).segments[0].contour != ContourKind::eccentric;
}

template <template <class> class Follower, class Formula>
void measure_contour(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    clear(out, 1, dimension_count<Follower>);
    const auto value = []<class T>(const Contour<T>& c) { return Formula::value(c); };
    add_term<Follower>(motion, dimensions, {{0, 0, 0, false}, 1}, value, 0, out);
}

/// Adds a dimension, times a factor, to a component that is a sum of such.
inline void add_dimension(std::size_t index, double factor, std::span<const double> dimensions,
                          const Measurement& out) {
    out.value[0] += factor * dimensions[index];
    if (!out.gradient.empty()) out.gradient[index] += factor;
}

inline std::size_t one_component(const Motion&) { return 1; }

/// A dimension as a quantity of its own.
template <template <class> class Follower, std::size_t index>
void measure_dimension(const Motion&, std::span<const double> dimensions, const Measurement& out);

/// All segment angles together.
template <template <class> class Follower>
void measure_turn(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    clear(out, 1, dimension_count<Follower>);
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i)
        add_dimension(slots<Follower>.angle(i), 1, dimensions, out);
}

/// All rises less all returns.
template <template <class> class Follower>
void measure_lift_balance(const Motion& motion, std::span<const double> dimensions, const Measurement& out) {
    clear(out, 1, dimension_count<Follower>);
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i)
        if (const int sign = lift_sign(program_of(motion).segments[i].kind); sign != 0)
            add_dimension(slots<Follower>.lift(i), sign, dimensions, out);
}

/// What must be >= 0 for a cam to exist, as lengths: in each segment the follower is held and the cam is not undercut,
/// and over the whole turn the contact of an oscillating face stays on one side of the pivot.
template <template <class> class Follower>
struct ExistenceMargin {
    static constexpr auto follows = [](const auto& f, const auto& lift) { return FollowMargin::value(f, lift); };
    static constexpr auto not_undercut = [](const auto& f, const auto& lift) {
        const auto margin = UndercutMargin::value(f, lift);
        if constexpr (requires { f.prime_radius; })
            return decltype(margin)(margin * f.prime_radius);
        else
            return decltype(margin)(margin * f.base_radius);
    };

    static constexpr auto levers = [](const auto& f, const auto& lift) { return LeverMargin::value(f, lift); };
    static constexpr bool has_lever = std::is_same_v<Follower<double>, OscillatingFlat<double>>;

    /// Two for each segment, then that of the lever.
    static std::size_t components(const Motion& motion) {
        return 2 * program_of(motion).segments.size() + (has_lever ? 1 : 0);
    }

    static void measure(const Motion& motion, std::span<const double> dimensions, const Measurement& out);
};

}  // namespace mechwright::cam
