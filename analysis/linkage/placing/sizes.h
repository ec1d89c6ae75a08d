#pragma once
/// \file
/// What the steps of a linkage need of its dimensions, made once per design: places on links, lines, radii.

#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/placing/dyads.h"
#include "analysis/linkage/placing/pose.h"
#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::linkage {

/// What one half of a step needs of the dimensions.
template <class T>
struct Part {
    Vector<T> own{};      ///< a pin on the link that is placed by it; of a circle its centre
    Vector<T> moved{};    ///< what leads, on that link, from the base of its tie to the locus; of a pin that is carried
                          ///< from another one from there, against the link of a dyad where it is that
    Vector<T> through{};  ///< a line, on its link
    Vector<T> direction{};  ///< of the line; of a circle from its centre to the pin; unit vectors
    T length{};             ///< a radius, an offset, a ratio
};

template <class T>
struct Sized {
    Part<T> first{};
    Part<T> second{};
    std::array<T, detail::goes_round<T> ? std::size_t{detail::RoundDyad<T>::count} : 0>
        round{};  ///< of a dyad that is carried round
};

namespace detail {

/// A line that slides or slots have, in the frame of its link: of a slide moved by the offset, so that the origin of
/// what slides is on it.
template <class T>
Part<T> line_part(const Structure& s, bool of_slide, std::size_t joint, std::span<const T> numbers) {
    const Line& line = of_slide ? s.slides[joint].line : s.slots[joint].line;
    Part<T> part;
    part.direction = direction_of(line, numbers);
    part.through = place_of(line.through, numbers);
    if (of_slide) part.through = part.through + numbers[s.slides[joint].offset] * left_of(part.direction);
    return part;
}

/// The locus of a place `own` of a link that has a tie.
template <class T>
Part<T> tie_part(const Structure& s, const Tie& tie, std::size_t link, const Vector<T>& own,
                 std::span<const T> numbers) {
    const bool slide = tie.kind <= Tie::Kind::carries;
    Part<T> part = line_part(s, slide, tie.joint, numbers);
    part.own = part.moved = own;
    if (tie.kind == Tie::Kind::in_slot)
        part.moved = own - place_of(coordinates_on(s.pins[s.slots[tie.joint].pin], link), numbers);
    else if (tie.kind != Tie::Kind::slides)
        part.moved = own - part.through;
    return part;
}

/// The circle of a pin `at` on the outer link of a telescope (Locus::extended), from a pin of the inner one: from its
/// centre to the pin leads `moved` plus the displacement times `direction`. The length is that without displacement.
template <class T>
Part<T> extended_part(const Structure& s, const Locus& locus, std::size_t pin, std::span<const T> numbers) {
    const Slide& slide = s.slides[locus.tie.joint];
    const Part<T> line = line_part(s, true, locus.tie.joint, numbers);
    const Vector<T> turn = unit_at(numbers[slide.angle]),
                    at = place_of(coordinates_on(s.pins[pin], locus.tie.base), numbers);
    Part<T> part;
    part.own = place_of(coordinates_on(s.pins[locus.centre], locus.link), numbers);
    if (slide.link == locus.tie.base) {
        part.moved = line.through + turned(at, turn) - part.own;
        part.direction = line.direction;
    } else {
        part.moved = turned(at - line.through, conjugate(turn)) - part.own;
        part.direction = -turned(line.direction, conjugate(turn));
    }
    part.length = hypotenuse(part.moved.x, part.moved.y);
    return part;
}

/// That circle at an input.
template <class T>
Part<T> extended_to(Part<T> part, const T& displacement) {
    const Vector<T> arm = part.moved + displacement * part.direction;
    part.length = hypotenuse(arm.x, arm.y);
    part.direction = (T(1) / part.length) * arm;
    return part;
}

template <class T>
Part<T> locus_part(const Structure& s, const Locus& locus, std::size_t pin, std::span<const T> numbers) {
    if (locus.extended != none) return extended_part(s, locus, pin, numbers);
    if (locus.kind == Locus::Kind::slot) return line_part(s, false, locus.tie.joint, numbers);
    const Vector<T> own =
        pin == none ? Vector<T>{T(0), T(0)} : place_of(coordinates_on(s.pins[pin], locus.link), numbers);
    if (locus.kind == Locus::Kind::line) return tie_part(s, locus.tie, locus.link, own, numbers);
    Part<T> part;
    part.own = place_of(coordinates_on(s.pins[locus.centre], locus.link), numbers);
    const Vector<T> arm = own - part.own;
    part.length = hypotenuse(arm.x, arm.y);
    part.direction = (T(1) / part.length) * arm;
    return part;
}

/// A pin of a link, and from where it is carried.
template <class T>
Part<T> carried_part(const Structure& s, const Step& step, std::span<const T> numbers) {
    const auto on_link = [&](std::size_t pin) { return place_of(coordinates_on(s.pins[pin], step.link), numbers); };
    Part<T> part;
    part.own = on_link(step.pin);
    if (step.from == CarriedFrom::origin) return part;
    part.moved = part.own - on_link(step.first.centre);
    if (step.from == CarriedFrom::pin) return part;
    part.moved = turned(part.moved, conjugate(locus_part(s, step.first, step.far_pin, numbers).direction));
    return part;
}

template <class T>
Sized<T> dyad_sizes(const Structure& s, const Step& step, std::span<const T> numbers) {
    Sized<T> sized{locus_part(s, step.first, step.pin, numbers), locus_part(s, step.second, step.pin, numbers)};
    if constexpr (goes_round<T>) {
        const CarriedRound& round = step.round;
        if (!round.exists()) return sized;
        const auto on_link = [&](std::size_t pin, std::size_t link) {
            return place_of(coordinates_on(s.pins[pin], link), numbers);
        };
        const Vector<T> arm = on_link(round.pin, round.link) - on_link(round.centre, round.link),
                        base = on_link(round.fixed, 0) - on_link(round.centre, 0);
        put_round_dyad(arm, base, sized.first.length, sized.second.length, step.first.centre == round.fixed,
                       sized.round.data());
    }
    return sized;
}

template <class T>
Sized<T> through_sizes(const Structure& s, const Step& step, std::span<const T> numbers) {
    Sized<T> sized;
    sized.first = line_part(s, !step.reversed, step.joint, numbers);
    const Vector<T> left = left_of(sized.first.direction);
    sized.first.own = place_of(coordinates_on(s.pins[step.pin], step.link), numbers);
    sized.first.length = dot(left, sized.first.through - sized.first.own);
    if (step.other == none) return sized;
    sized.second.own = place_of(coordinates_on(s.pins[step.far_pin], step.other), numbers);
    sized.second.direction = unit_at(numbers[s.slides[step.joint].angle]);
    sized.first.length = sized.first.length + dot(left, turned(sized.second.own, sized.second.direction));
    return sized;
}

inline const Stops& stops_of(const Structure& s, const Step& step) {
    if (step.input != none) return s.drives[step.input].stops;
    if (step.far_pin != none) return s.circular[step.joint].ends->stops;
    return step.pin != none ? s.slots[step.joint].stops : s.slides[step.joint].stops;
}

template <class T>
Sized<T> stopped_sizes(const Structure& s, const Step& step, std::span<const T> numbers) {
    const Stops& stops = stops_of(s, step);
    Sized<T> sized;
    if (step.far_pin != none) {
        const Line& line = s.circular[step.joint].ends->line;
        sized.first.direction = direction_of(line, numbers);
        sized.first.through = place_of(line.through, numbers);
    } else if (step.input == none) {
        sized.first = line_part(s, step.pin == none, step.joint, numbers);
    }
    sized.second.length = numbers[step.reversed ? *stops.max : *stops.min];
    return sized;
}

template <class T>
Sized<T> sized(const Structure& s, const Step& step, std::span<const T> numbers) {
    using Kind = Step::Kind;
    Sized<T> made;
    switch (step.kind) {
        case Kind::driven:
        case Kind::unwound:
        case Kind::together: break;
        case Kind::held:
            made.first.length = numbers[s.slides[step.joint].angle];
            if (step.reversed) made.first.length = -made.first.length;
            made.first.direction = unit_at(made.first.length);
            break;
        case Kind::geared:
            made.first.length = numbers[s.gears[step.joint].ratio];
            made.second.length = numbers[s.gears[step.joint].phase];
            break;
        case Kind::wheeled:
            made.first = line_part(s, true, s.racks[step.joint].slide, numbers);
            made.first.length = numbers[s.racks[step.joint].radius];
            made.second.length = numbers[s.racks[step.joint].phase];
            break;
        case Kind::racked:
            made.second.own = {numbers[s.racks[step.input].radius], numbers[s.racks[step.input].phase]};
            [[fallthrough]];
        case Kind::slid: made.first = line_part(s, true, step.joint, numbers); break;
        case Kind::pinned: made.first.own = place_of(coordinates_on(s.pins[step.pin], step.link), numbers); break;
        case Kind::carried: made.first = carried_part(s, step, numbers); break;
        case Kind::tied:
        case Kind::dyad: return dyad_sizes(s, step, numbers);
        case Kind::through: return through_sizes(s, step, numbers);
        case Kind::stopped: return stopped_sizes(s, step, numbers);
    }
    return made;
}

}  // namespace detail

/// What the steps need of the dimensions, one for each.
template <class T>
std::vector<Sized<T>> sizes_of(const Structure& s, const Order& order, std::span<const T> numbers) {
    std::vector<Sized<T>> sizes;
    for (const Step& step : order.steps)
        sizes.push_back(detail::sized(s, step, numbers));
    return sizes;
}

}  // namespace mechwright::linkage
