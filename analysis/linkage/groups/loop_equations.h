#pragma once
/// \file
/// The equations of a larger group (steps.h): by how much each is missed in a pose, and its derivatives by the places
/// of the links. Pins, slides and slots are as mobility.h has them for velocities. Angles between directions are
/// measured by their sines, so that whole turns do not matter; gears and racks count turns.

#include <array>
#include <span>
#include <vector>

#include "analysis/linkage/placing/place.h"
#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright::linkage {

/// What an equation needs of the dimensions: of a pin `own` and `moved`, its places on both links; of a slot `own` of
/// its pin and the line; of a slide the line and `moved`, a unit vector at its angle; of a gear `length` the ratio and
/// `own.x` the phase; of a rack the same with its radius, and the line.
template <class T>
Part<T> equation_part(const Structure& s, const LoopEquation& e, std::span<const T> numbers) {
    using Kind = LoopEquation::Kind;
    const auto place = [&](std::size_t pin, std::size_t link) {
        return place_of(coordinates_on(s.pins[pin], link), numbers);
    };
    Part<T> part;
    switch (e.kind) {
        case Kind::pin_x:
        case Kind::pin_y:
            part.own = place(e.joint, e.links[0]);
            part.moved = place(e.joint, e.links[1]);
            break;
        case Kind::slide_turn: part.moved = unit_at(numbers[s.slides[e.joint].angle]); break;
        case Kind::slide_line: return detail::line_part(s, true, e.joint, numbers);
        case Kind::slot:
            part = detail::line_part(s, false, e.joint, numbers);
            part.own = place(s.slots[e.joint].pin, e.links[0]);
            break;
        case Kind::gear:
            part.length = numbers[s.gears[e.joint].ratio];
            part.own.x = numbers[s.gears[e.joint].phase];
            break;
        case Kind::rack:
            part = detail::line_part(s, true, s.racks[e.joint].slide, numbers);
            part.length = numbers[s.racks[e.joint].radius];
            part.own.x = numbers[s.racks[e.joint].phase];
            break;
        case Kind::drive_turn: break;
        case Kind::drive_slide: return detail::line_part(s, true, s.drives[e.joint].slide, numbers);
    }
    return part;
}

namespace detail {

/// The direction at which the first link is to be: that of the second, turned by a slide's angle or an input.
template <class T>
Vector<T> wanted_direction(const LoopEquation& e, const Part<T>& part, const Pose<T>& pose, std::span<const T> drives) {
    const Vector<T>& on = pose.links[e.links[1]].along;
    return turned(on, e.kind == LoopEquation::Kind::slide_turn ? part.moved : unit_at(drives[e.joint]));
}

/// From the line's place to what is on it, and the line's direction.
template <class T>
std::array<Vector<T>, 2> way_and_line(const LoopEquation& e, const Part<T>& part, const Pose<T>& pose) {
    const LinkPlace<T>&first = pose.links[e.links[0]], &on = pose.links[e.links[1]];
    const Vector<T> at = e.kind == LoopEquation::Kind::slot ? first.at(part.own) : first.origin;
    return {at - on.at(part.through), turned(part.direction, on.along)};
}

}  // namespace detail

/// By how much an equation is missed: a length, or the sine of an angle, or an angle.
template <class T>
T missed(const LoopEquation& e, const Part<T>& part, const Pose<T>& pose, std::span<const T> drives) {
    using Kind = LoopEquation::Kind;
    switch (e.kind) {
        case Kind::pin_x:
        case Kind::pin_y: {
            const Vector<T> apart = pose.links[e.links[0]].at(part.own) - pose.links[e.links[1]].at(part.moved);
            return e.kind == Kind::pin_x ? apart.x : apart.y;
        }
        case Kind::slide_turn:
        case Kind::drive_turn:
            return cross(detail::wanted_direction(e, part, pose, drives), pose.links[e.links[0]].along);
        case Kind::slide_line:
        case Kind::slot: {
            const auto [way, line] = detail::way_and_line(e, part, pose);
            return dot(left_of(line), way);
        }
        case Kind::gear: {
            const T& carrier = pose.turns[e.links[2]];
            return (pose.turns[e.links[1]] - carrier) - part.length * (pose.turns[e.links[0]] - carrier) - part.own.x;
        }
        case Kind::rack: {
            const auto [way, line] = detail::way_and_line(e, part, pose);
            return dot(line, way) - part.length * (pose.turns[e.links[2]] - pose.turns[e.links[3]]) - part.own.x;
        }
        case Kind::drive_slide: {
            const auto [way, line] = detail::way_and_line(e, part, pose);
            return dot(line, way) - drives[e.joint];
        }
    }
    return T(0);
}

/// Calls put(link, part, slope) with the derivatives of an equation by x, y and turn (0, 1, 2) of its links; those of
/// one coordinate add up.
template <class T, class Put>
void slopes(const LoopEquation& e, const Part<T>& part, const Pose<T>& pose, std::span<const T> drives,
            const Put& put) {
    using Kind = LoopEquation::Kind;
    // The velocity along a direction of a place that a link carries.
    const auto carried = [&](std::size_t link, const Vector<T>& at, const Vector<T>& direction, bool minus) {
        const T turn = cross(at - pose.links[link].origin, direction);
        put(link, 0, minus ? T(-direction.x) : direction.x);
        put(link, 1, minus ? T(-direction.y) : direction.y);
        put(link, 2, minus ? T(-turn) : turn);
    };
    const auto against = [&](const Vector<T>& direction) {
        const LinkPlace<T>& first = pose.links[e.links[0]];
        const Vector<T> at = e.kind == Kind::slot ? first.at(part.own) : first.origin;
        carried(e.links[0], at, direction, false);
        carried(e.links[1], at, direction, true);
    };
    switch (e.kind) {
        case Kind::pin_x:
        case Kind::pin_y: {
            const Vector<T> direction{T(e.kind == Kind::pin_x ? 1 : 0), T(e.kind == Kind::pin_x ? 0 : 1)};
            carried(e.links[0], pose.links[e.links[0]].at(part.own), direction, false);
            carried(e.links[1], pose.links[e.links[1]].at(part.moved), direction, true);
            break;
        }
        case Kind::slide_turn:
        case Kind::drive_turn: {
            const T cosine = dot(detail::wanted_direction(e, part, pose, drives), pose.links[e.links[0]].along);
            put(e.links[0], 2, cosine);
            put(e.links[1], 2, T(-cosine));
            break;
        }
        case Kind::slide_line:
        case Kind::slot: against(left_of(detail::way_and_line(e, part, pose)[1])); break;
        case Kind::gear:
            put(e.links[1], 2, T(1));
            put(e.links[0], 2, T(-part.length));
            put(e.links[2], 2, T(part.length - T(1)));
            break;
        case Kind::rack:
            against(detail::way_and_line(e, part, pose)[1]);
            put(e.links[2], 2, T(-part.length));
            put(e.links[3], 2, part.length);
            break;
        case Kind::drive_slide: against(detail::way_and_line(e, part, pose)[1]); break;
    }
}

/// Whether all angles between directions are the ones that are wanted, not those on the other side: their sines are
/// the same.
inline bool faces_right(const LargerGroup& group, std::span<const Part<double>> parts, const Pose<double>& pose,
                        std::span<const double> drives) {
    for (std::size_t i = 0; i < group.equations.size(); ++i) {
        const LoopEquation& e = group.equations[i];
        if (e.kind != LoopEquation::Kind::slide_turn && e.kind != LoopEquation::Kind::drive_turn) continue;
        if (dot(detail::wanted_direction(e, parts[i], pose, drives), pose.links[e.links[0]].along) < 0) return false;
    }
    return true;
}

}  // namespace mechwright::linkage
