#pragma once
/// \file
/// Where the links of a linkage are, by running once through its steps (order.h).
///
/// Every dyad is placed by products of its margins, as the four-bar and the slider-crank are: no inverse cosine, no
/// difference of squares. A margin is a length that is negative by what is missing where the dyad does not close. The
/// same steps run with every number type; what depends on dimensions alone is made once per design (`sizes_of`), and
/// nothing is allocated while placing.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "analysis/geometry/half_angle.h"
#include "analysis/geometry/vector.h"
#include "analysis/linkage/steps.h"
#include "analysis/linkage/structure.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::linkage {

/// A link in the frame of the linkage.
template <class T>
struct LinkPlace {
    Vector<T> origin{};
    Vector<T> along{T(1), T(0)};  ///< its x axis, a unit vector

    Vector<T> at(const Vector<T>& own) const { return origin + turned(own, along); }
};

/// How far a dyad is from its two limits; it closes where both are >= 0.
/// rrr: stretched out (the sum of its lengths less the distance of its outer pins), folded (that distance less their
/// difference); rrp: the link's length less the distance of its pin from the line, to its left and to its right; rpr:
/// the distance of the pins less that of line and pin, the same; two lines: the
/// sine of the angle between them, and -1 where they are parallel; a stop: how far it is, twice. Not a number where the
/// outer pins of a dyad coincide.
template <class T>
struct Margin {
    T outer{};
    T inner{};
};

/// Where everything is. Made once, written at every crank angle.
template <class T>
struct Pose {
    std::vector<LinkPlace<T>> links;
    std::vector<Vector<T>> pins;
    std::vector<T> turns;  ///< of links whose turn is asked for by a gear or known anyway
    std::vector<Margin<T>> margins;
};

template <class T>
Pose<T> empty_pose(const Structure& s, const Order& order) {
    return {std::vector<LinkPlace<T>>(s.links), std::vector<Vector<T>>(s.pins.size(), Vector<T>{T(0), T(0)}),
            std::vector<T>(s.links, T(0)), std::vector<Margin<T>>(order.margins)};
}

/// What one half of a step needs of the dimensions.
template <class T>
struct Part {
    Vector<T> own{};        ///< a pin on the link that is placed by it; of a circle its centre
    Vector<T> moved{};      ///< what leads, on that link, from the base of its tie to the locus
    Vector<T> through{};    ///< a line, on its link
    Vector<T> direction{};  ///< of the line; of a circle from its centre to the pin; unit vectors
    T length{};             ///< a radius, an offset, a ratio
};

template <class T>
struct Sized {
    Part<T> first{};
    Part<T> second{};
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

template <class T>
Vector<T> unit_at(const T& angle) {
    using std::cos, std::sin;
    return {cos(angle), sin(angle)};
}

template <class T>
Vector<T> conjugate(const Vector<T>& a) {
    return {a.x, -a.y};
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
    return step.pin != none ? s.slots[step.joint].stops : s.slides[step.joint].stops;
}

template <class T>
Sized<T> stopped_sizes(const Structure& s, const Step& step, std::span<const T> numbers) {
    const Stops& stops = stops_of(s, step);
    Sized<T> sized;
    if (step.input == none) sized.first = line_part(s, step.pin == none, step.joint, numbers);
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
        case Kind::pinned:
        case Kind::carried: made.first.own = place_of(coordinates_on(s.pins[step.pin], step.link), numbers); break;
        case Kind::tied:
        case Kind::dyad:
            made.first = locus_part(s, step.first, step.pin, numbers);
            made.second = locus_part(s, step.second, step.pin, numbers);
            break;
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

/// A line in the frame of the linkage.
template <class T>
struct PlacedLine {
    Vector<T> through;
    Vector<T> direction;
};

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

/// Where two lines meet.
template <class T>
Margin<T> meet(const PlacedLine<T>& a, const PlacedLine<T>& b, Vector<T>& at) {
    using std::abs;
    const T sine = cross(a.direction, b.direction);
    at = a.through + T(cross(b.through - a.through, b.direction) / sine) * a.direction;
    const T margin = abs(sine) > T(0) ? T(abs(sine)) : T(-1);
    return {margin, margin};
}

/// A margin, and not a number where two outer pins coincide, so that the dyad could stand anywhere: zero times the
/// inverse of their distance.
template <class T>
T determined(const T& margin, const T& inverse_distance) {
    return margin + T(0) * inverse_distance;
}

/// Two circles: the law of cosines with every factor of its half-angle formulas taken from the margins, as in
/// four_bar/pose_formulas.h. `side` 1: the pin lies to the left of the line from the first centre to the second.
template <class T>
Margin<T> two_circles(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose) {
    using std::abs;
    const T &a = size.first.length, &b = size.second.length;
    const Vector<T> apart = pose.pins[step.second.centre] - pose.pins[step.first.centre];
    const T d = hypotenuse(apart.x, apart.y);
    const T difference = abs(T(a - b)), total = a + b, sum = total + d, other = d + difference;
    const T inverse = T(1) / d;
    const Margin<T> margin{total - d, determined(T(d - difference), inverse)};
    const auto longer = a >= b;
    const T a_side = select(longer, other, margin.inner), b_side = select(longer, margin.inner, other);
    const T double_root = T(2) * root_or_zero(T((margin.outer * sum) * (margin.inner * other)));
    const Vector<T> along = inverse * apart, across = side * left_of(along);
    const T per_a = inverse / (T(4) * a), per_b = inverse / (T(4) * b);
    const T a_cosine = (sum * a_side - margin.outer * b_side) * per_a;
    const T b_cosine = (sum * b_side - margin.outer * a_side) * per_b;
    const Vector<T> from_first = a_cosine * along + T(double_root * per_a) * across;
    pose.pins[step.pin] = pose.pins[step.first.centre] + a * from_first;
    swing(pose, step.first, size.first, from_first);
    swing(pose, step.second, size.second, T(double_root * per_b) * across - b_cosine * along);
    return margin;
}

/// A circle and a line. `side` 1: the pin lies ahead of the foot of the perpendicular from the centre.
template <class T>
Margin<T> circle_and_line(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose) {
    const PlacedLine<T> line = locus_line(step.second, size.second, pose);
    const Vector<T> centre = pose.pins[step.first.centre], left = left_of(line.direction);
    const T& length = size.first.length;
    const T height = dot(left, line.through - centre), per_length = T(1) / length;
    const Margin<T> margin{length - height, length + height};
    const T run = side * root_or_zero(T(margin.outer * margin.inner));
    pose.pins[step.pin] = centre + (run * line.direction + height * left);
    swing(pose, step.first, size.first, T(run * per_length) * line.direction + T(height * per_length) * left);
    return margin;
}

/// The sizes of a dyad with those radii that follow from inputs.
template <class T>
Sized<T> extended_sizes(const Step& step, Sized<T> size, std::span<const T> drives) {
    if (step.first.extended != none) size.first = extended_to(size.first, drives[step.first.extended]);
    if (step.second.extended != none) size.second = extended_to(size.second, drives[step.second.extended]);
    return size;
}

template <class T>
Margin<T> dyad(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose) {
    if (step.second.kind == Locus::Kind::circle) return two_circles(step, size, side, pose);
    const Margin<T> margin = step.first.kind == Locus::Kind::circle
                                 ? circle_and_line(step, size, side, pose)
                                 : meet(locus_line(step.first, size.first, pose),
                                        locus_line(step.second, size.second, pose), pose.pins[step.pin]);
    for (const auto& [locus, part] : {std::pair(&step.first, &size.first), std::pair(&step.second, &size.second)})
        if (locus->kind == Locus::Kind::line) hang(pose.links[locus->link], part->own, pose.pins[step.pin]);
    return margin;
}

/// A link on a placed pin whose line passes another placed pin at the distance `length`, to its left. `side` 1: that
/// pin lies ahead of the foot of the perpendicular from the first.
template <class T>
Margin<T> through(const Step& step, const Sized<T>& size, const T& side, Pose<T>& pose) {
    const Vector<T> apart = pose.pins[step.far_pin] - pose.pins[step.pin];
    const T d = hypotenuse(apart.x, apart.y), inverse = T(1) / d;
    const T& height = size.first.length;
    const Margin<T> margin{determined(T(d - height), inverse), d + height};
    const T run = side * root_or_zero(T(margin.outer * margin.inner));
    const Vector<T> own = T(run * inverse) * size.first.direction + T(height * inverse) * left_of(size.first.direction);
    LinkPlace<T>& link = pose.links[step.link];
    link.along = turned(inverse * apart, conjugate(own));
    hang(link, size.first.own, pose.pins[step.pin]);
    if (step.other != none) {
        pose.links[step.other].along = turned(size.second.direction, link.along);
        hang(pose.links[step.other], size.second.own, pose.pins[step.far_pin]);
    }
    return margin;
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

/// One step that has no margin.
template <class T>
void place_plainly(const Step& step, const Sized<T>& size, const Input<T>& input, Pose<T>& pose) {
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
        case Kind::carried: pose.pins[step.pin] = pose.links[step.link].at(size.first.own); break;
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
    for (std::size_t i = 0; i < order.steps.size(); ++i) {
        const Step& step = order.steps[i];
        if (step.margin == none) {
            detail::place_plainly(step, sizes[i], input, pose);
            continue;
        }
        const T side = step.choice == none ? T(1) : T(static_cast<int>(input.sides[step.choice]));
        Margin<T>& margin = pose.margins[step.margin];
        if (step.kind == Step::Kind::together) {
            if (!input.groups[step.joint].place(input.master, input.drives, pose, margin)) return false;
        } else if (step.kind == Step::Kind::dyad)
            margin = step.is_extended()
                         ? detail::dyad(step, detail::extended_sizes(step, sizes[i], input.drives), side, pose)
                         : detail::dyad(step, sizes[i], side, pose);
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
