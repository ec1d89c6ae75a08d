#pragma once
/// \file
/// Where the links of a linkage are, by running once through its steps (order.h).
///
/// Every dyad is placed by products of its margins (dyads.h). The same steps run with every number type; what depends
/// on dimensions alone is made once per design (sizes.h), and nothing is allocated while placing.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/placing/dyads.h"
#include "analysis/linkage/placing/pose.h"
#include "analysis/linkage/placing/sizes.h"
#include "analysis/linkage/structure/steps.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::linkage {

template <class T>
class GroupSolver;

/// What a pose depends on besides the dimensions.
template <class T>
struct Input {
    std::span<const T> drives;           ///< angles and displacements, in the order of Structure::drives
    std::span<const std::int8_t> sides;  ///< 1 (left, ahead) or -1 (right, behind) for each choice of the order
    std::span<const double> near{};      ///< turns within half a turn of which those of links are; (-pi, pi] if empty
    double shortfall = 0;     ///< by how much margins may fall short of 0 and the dyads still count as closed
    std::size_t last = none;  ///< the margin with whose step placing ends; none: everything is placed
    std::span<GroupSolver<T>> groups{};  ///< for each larger group of the order
    double master = 0;                   ///< the input along which larger groups are followed
};

namespace detail {

template <class T>
PlacedLine<T> line_on(const LinkPlace<T>& link, const Part<T>& part) {
    return {link.at(part.through), turned(part.direction, link.along)};
}

/// Where the place that a locus speaks of can be.
template <class T>
PlacedLine<T> locus_line(const Locus& locus, const Part<T>& part, const Pose<T>& pose) {
    if (locus.kind == Locus::Kind::slot) return line_on(pose.links[locus.tie.base], part);
    const LinkPlace<T>& own = pose.links[locus.link];
    PlacedLine<T> line;
    if (locus.tie.kind == Tie::Kind::slides || locus.tie.kind == Tie::Kind::in_slot)
        line = line_on(pose.links[locus.tie.base], part);
    else if (locus.tie.kind == Tie::Kind::carries)
        line = {pose.links[locus.tie.base].origin, turned(part.direction, own.along)};
    else
        line = {pose.pins[locus.tie.base], turned(part.direction, own.along)};
    line.through = line.through + turned(part.moved, own.along);
    return line;
}

/// A link of known direction by one of its places.
template <class T>
void hang(LinkPlace<T>& link, const Vector<T>& own, const Vector<T>& at) {
    link.origin = at - turned(own, link.along);
}

/// A link that turns about a placed pin, by the direction from there to its other pin.
template <class T>
void swing(Pose<T>& pose, const Locus& locus, const Part<T>& part, const Vector<T>& direction) {
    pose.links[locus.link].along = turned(direction, conjugate(part.direction));
    hang(pose.links[locus.link], part.own, pose.pins[locus.centre]);
}

/// The directions of the links of a dyad, from the pins on which they hang to its own.
template <class T>
struct DyadLinks {
    Vector<T> first{T(1), T(0)};
    Vector<T> second{T(1), T(0)};
};

template <class T>
Circles<T> circles_of(const Step& step, const Sized<T>& size, const T& side, const Pose<T>& pose) {
    if constexpr (goes_round<T>)
        if (step.round.exists())
            return {RoundDyad<T>{size.round.data()}, pose.links[step.round.link].along, size.first.length,
                    size.second.length, side};
    return {pose.pins[step.first.centre], pose.pins[step.second.centre], size.first.length, size.second.length, side};
}

template <class T>
Margin<T> two_circles(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose, DyadLinks<T>& links) {
    const Circles<T> circles = circles_of(step, size, side, pose);
    links = {circles.from_first(), circles.from_second()};
    pose.pins[step.pin] = pose.pins[step.first.centre] + size.first.length * links.first;
    swing(pose, step.first, size.first, links.first);
    swing(pose, step.second, size.second, links.second);
    return circles.margin;
}

template <class T>
Margin<T> circle_and_line(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose, DyadLinks<T>& links) {
    const CircleAndLine<T> met(pose.pins[step.first.centre], locus_line(step.second, size.second, pose),
                               size.first.length, side);
    pose.pins[step.pin] = met.at;
    links.first = met.from_centre;
    swing(pose, step.first, size.first, met.from_centre);
    return met.margin;
}

/// The sizes of a dyad with those radii that follow from inputs.
template <class T>
Sized<T> extended_sizes(const Step& step, Sized<T> size, std::span<const T> drives) {
    if (step.first.extended != none) size.first = extended_to(size.first, drives[step.first.extended]);
    if (step.second.extended != none) size.second = extended_to(size.second, drives[step.second.extended]);
    return size;
}

template <class T>
Margin<T> dyad(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose, DyadLinks<T>& links) {
    if (step.second.kind == Locus::Kind::circle) return two_circles(step, size, side, pose, links);
    const Margin<T> margin = step.first.kind == Locus::Kind::circle
                                 ? circle_and_line(step, size, side, pose, links)
                                 : meet(locus_line(step.first, size.first, pose),
                                        locus_line(step.second, size.second, pose), pose.pins[step.pin]);
    for (const auto& [locus, part] : {std::pair(&step.first, &size.first), std::pair(&step.second, &size.second)})
        if (locus->kind == Locus::Kind::line) hang(pose.links[locus->link], part->own, pose.pins[step.pin]);
    return margin;
}

template <class T>
Margin<T> through(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose) {
    LinkPlace<T>& link = pose.links[step.link];
    const Through<T> passing(pose.pins[step.pin], pose.pins[step.far_pin], size.first.direction, size.first.length,
                             side);
    link.along = passing.along;
    hang(link, size.first.own, pose.pins[step.pin]);
    if (step.other != none) {
        pose.links[step.other].along = turned(size.second.direction, link.along);
        hang(pose.links[step.other], size.second.own, pose.pins[step.far_pin]);
    }
    return passing.margin;
}

/// A link turned by `angle` against another one.
template <class T>
void turn(Pose<T>& pose, const Step& step, const T& angle) {
    pose.links[step.link].along = turned(pose.links[step.other].along, unit_at(angle));
    pose.turns[step.link] = pose.turns[step.other] + angle;
}

/// The turn of the third link of a gear: second - carrier = ratio (first - carrier) + phase.
template <class T>
void turn_by_gear(const Step& step, const Sized<T>& size, Pose<T>& pose) {
    const T &ratio = size.first.length, &phase = size.second.length;
    const T &first = pose.turns[step.first.link], &second = pose.turns[step.second.link],
            &carrier = pose.turns[step.other];
    T turn;
    if (step.link == step.second.link)
        turn = carrier + (ratio * (first - carrier) + phase);
    else if (step.link == step.first.link)
        turn = carrier + ((second - carrier) - phase) / ratio;
    else
        turn = ((ratio * first - second) + phase) / (ratio - T(1));
    pose.turns[step.link] = turn;
    pose.links[step.link].along = unit_at(turn);
}

template <class T>
void turn_by_rack(const Step& step, const Sized<T>& size, Pose<T>& pose) {
    const PlacedLine<T> line = line_on(pose.links[step.second.link], size.first);
    const T displacement = dot(line.direction, pose.links[step.first.link].origin - line.through);
    const T angle = (displacement - size.second.length) / size.first.length;
    turn(pose, step, step.reversed ? T(-angle) : angle);
}

/// A link at a displacement of its slide from the placed link at the other end.
template <class T>
void slide(const Step& step, const Sized<T>& size, const T& displacement, Pose<T>& pose) {
    const Vector<T> own = size.first.through + displacement * size.first.direction;
    LinkPlace<T>& link = pose.links[step.link];
    const LinkPlace<T>& other = pose.links[step.other];
    link.origin = step.reversed ? other.origin - turned(own, link.along) : other.at(own);
}

/// The angle that differs from this one by whole turns and is within half a turn of `near`.
template <class T>
T unwound(const T& angle, double near) {
    constexpr double turn = 2 * std::numbers::pi;
    const double turns = std::round((near - number_as<double>(value_of(angle))) / turn);
    return turns == 0 ? angle : T(angle + T(2 * turns) * pi<T>());
}

template <class T>
void unwind(const Step& step, std::span<const double> near, Pose<T>& pose) {
    using std::atan2;
    const Vector<T>& along = pose.links[step.link].along;
    const T angle = atan2(along.y, along.x);
    pose.turns[step.link] = near.empty() ? angle : unwound(angle, near[step.link]);
}

/// A link that slides, or is slid on, at a constant angle to another one.
template <class T>
void hold(const Step& step, const Sized<T>& size, Pose<T>& pose) {
    pose.links[step.link].along = turned(pose.links[step.other].along, size.first.direction);
    pose.turns[step.link] = pose.turns[step.other] + size.first.length;
}

template <class T>
void carry(const Step& step, const Sized<T>& size, const DyadLinks<T>& links, Pose<T>& pose) {
    const LinkPlace<T>& link = pose.links[step.link];
    if (step.from == CarriedFrom::origin) {
        pose.pins[step.pin] = link.at(size.first.own);
        return;
    }
    const Vector<T>& along = step.from == CarriedFrom::pin     ? link.along
                             : step.from == CarriedFrom::first ? links.first
                                                               : links.second;
    pose.pins[step.pin] = pose.pins[step.first.centre] + turned(size.first.moved, along);
}

/// One step that has no margin. `links`: of the dyad before.
template <class T>
void place_plainly(const Step& step, const Sized<T>& size, const Input<T>& input, const DyadLinks<T>& links,
                   Pose<T>& pose) {
    using Kind = Step::Kind;
    switch (step.kind) {
        case Kind::driven:
            turn(pose, step, step.reversed ? T(-input.drives[step.input]) : input.drives[step.input]);
            break;
        case Kind::held: hold(step, size, pose); break;
        case Kind::geared: turn_by_gear(step, size, pose); break;
        case Kind::wheeled: turn_by_rack(step, size, pose); break;
        case Kind::slid: slide(step, size, input.drives[step.input], pose); break;
        case Kind::racked: {
            const T turn = pose.turns[step.first.link] - pose.turns[step.second.link];
            slide(step, size, T(size.second.own.x * turn + size.second.own.y), pose);
            break;
        }
        case Kind::pinned: hang(pose.links[step.link], size.first.own, pose.pins[step.pin]); break;
        case Kind::carried: carry(step, size, links, pose); break;
        case Kind::unwound: unwind(step, input.near, pose); break;
        case Kind::tied:
        case Kind::dyad:
        case Kind::through:
        case Kind::stopped:
        case Kind::together: break;
    }
}

/// How far what is placed is from a stop.
template <class T>
Margin<T> stop(const Step& step, const Sized<T>& size, const Input<T>& input, const Pose<T>& pose) {
    T value;
    if (step.input != none) {
        value = input.drives[step.input];
    } else {
        const PlacedLine<T> line = line_on(pose.links[step.other], size.first);
        value =
            dot(line.direction, (step.pin == none ? pose.links[step.link].origin : pose.pins[step.pin]) - line.through);
    }
    const T margin = step.reversed ? T(size.second.length - value) : T(value - size.second.length);
    return {margin, margin};
}

}  // namespace detail

/// Places all links. Returns whether every dyad and larger group closes; where one does not,
/// `pose.margins` of the dyads up to and with it are right, and nothing after it is placed.
template <class T>
bool place(const Order& order, std::span<const Sized<T>> sizes, const Input<T>& input, Pose<T>& pose) {
    detail::DyadLinks<T> links;
    for (std::size_t i = 0; i < order.steps.size(); ++i) {
        const Step& step = order.steps[i];
        if (step.margin == none) {
            detail::place_plainly(step, sizes[i], input, links, pose);
            continue;
        }
        const T side = step.choice == none ? T(1) : T(static_cast<int>(input.sides[step.choice]));
        Margin<T>& margin = pose.margins[step.margin];
        if (step.kind == Step::Kind::together) {
            if (!input.groups[step.joint].place(input.master, input.drives, pose, margin)) return false;
        } else if (step.kind == Step::Kind::dyad)
            margin = step.is_extended()
                         ? detail::dyad(step, detail::extended_sizes(step, sizes[i], input.drives), side, pose, links)
                         : detail::dyad(step, sizes[i], side, pose, links);
        else if (step.kind == Step::Kind::through)
            margin = detail::through(step, sizes[i], side, pose);
        else if (step.kind == Step::Kind::stopped)
            margin = detail::stop(step, sizes[i], input, pose);
        else
            margin = detail::meet(detail::locus_line(step.first, sizes[i].first, pose),
                                  detail::locus_line(step.second, sizes[i].second, pose), pose.links[step.link].origin);
        if (!(value_of(margin.outer) >= -input.shortfall) || !(value_of(margin.inner) >= -input.shortfall))
            return false;
        if (step.margin == input.last) return true;
    }
    return true;
}

}  // namespace mechwright::linkage
