#pragma once
/// \file
/// A planar linkage as it is described: rigid links, their points, and what joins them. The numbers themselves (places
/// of points, offsets, ratios) are in a list of their own, of which the structure holds positions, so that one
/// structure serves every design and every number type. Link 0 is the frame. Angles are radians.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/scalar.h"
#include "analysis/numbers/unit_vector.h"

namespace mechwright::linkage {

/// A position in the list of numbers.
using Number = std::size_t;

/// Two numbers that say a place in the frame of a link: x and y, or (polar) length and angle.
struct Coordinates {
    Number first = 0;
    Number second = 0;
    bool polar = false;
};

/// A place on a link.
struct Point {
    std::size_t link = 0;
    Coordinates at{};
};

/// All points that coincide by a name, at most one of each link: a pin of k links is k - 1 joints; with one point it is
/// no joint.
struct Pin {
    std::vector<Point> points;
};

/// A directed straight line fixed to a link: through a place, towards a second one or at an angle to the link's x axis.
struct Line {
    std::size_t on = 0;
    Coordinates through{};
    Coordinates towards{};
    Number angle = 0;
    bool by_angle = false;
};

/// Between which values a joint or a drive stays.
struct Stops {
    std::optional<Number> min{};
    std::optional<Number> max{};

    bool any() const { return min || max; }
};

/// The link slides along the line without turning: its x axis at `angle` to that of the line's link, its origin at
/// `offset` to the left of the line. Its displacement runs from `through` to the foot of its origin.
struct Slide {
    std::size_t link = 0;
    Line line{};
    Number angle = 0;
    Number offset = 0;
    Stops stops{};  ///< of its displacement
};

/// A pin that stays on the line. Its displacement runs from `through` to the pin.
struct Slot {
    std::size_t pin = 0;
    Line line{};
    bool loose = false;  ///< stands for the second pin of a redundant link, which needs not hold
    Stops stops{};       ///< of its displacement
};

/// A circular slot is a link like others, from its centre on the link that has it to its pin; it looks otherwise.
struct CircularSlot {
    std::size_t link = 0;    ///< what stands for it
    std::size_t on = 0;      ///< what has it
    std::size_t centre = 0;  ///< a pin of both
    std::size_t pin = 0;
    /// Its ends, where it has some: from the centre in the direction of its middle the pin's displacement has a least
    /// value, the radius times the cosine of half the arc. No joint.
    std::optional<Slot> ends{};
};

/// The turn of `second` against `carrier` is `ratio` times that of `first`, plus `phase`: gears, and belts, which
/// differ in nothing but how they look.
struct Gear {
    std::size_t first = 0;
    std::size_t second = 0;
    std::size_t carrier = 0;
    Number ratio = 0;
    Number phase = 0;
    bool belt = false;
    bool parallel = false;  ///< stands for redundant links that keep the second parallel to the carrier
};

/// The displacement of a slide is `radius` times the turn of `wheel` against `carrier`, plus `phase` (a length).
struct Rack {
    std::size_t slide = 0;
    std::size_t wheel = 0;
    std::size_t carrier = 0;
    Number radius = 0;
    Number phase = 0;
};

/// An input: the angle from the x axis of `on` to that of `link`, or the displacement of a slide.
struct Drive {
    bool of_slide = false;
    std::size_t link = 0;
    std::size_t on = 0;
    std::size_t slide = 0;
    Stops stops{};  ///< of the input, in radians where it turns
};

struct Structure {
    std::size_t links = 1;  ///< with the frame
    std::vector<Pin> pins{};
    std::vector<Slide> slides{};
    std::vector<Slot> slots{};
    std::vector<CircularSlot> circular{};
    std::vector<Gear> gears{};
    std::vector<Rack> racks{};
    std::vector<Drive> drives{};
};

/// A place in the frame of its link.
template <class T>
Vector<T> place_of(const Coordinates& at, std::span<const T> numbers) {
    const T &a = numbers[at.first], &b = numbers[at.second];
    return at.polar ? a * unit_at(b) : Vector<T>{a, b};
}

/// The direction of a line in the frame of its link, a unit vector; (0, 0) where its two places coincide.
template <class T>
Vector<T> direction_of(const Line& line, std::span<const T> numbers) {
    if (line.by_angle) return unit_at(numbers[line.angle]);
    const Vector<T> along = place_of(line.towards, numbers) - place_of(line.through, numbers);
    const T length = hypotenuse(along.x, along.y);
    return length > T(0) ? (T(1) / length) * along : along;
}

/// The place of a pin on a link that it has a point of.
inline const Coordinates& coordinates_on(const Pin& pin, std::size_t link) {
    for (const Point& point : pin.points)
        if (point.link == link) return point.at;
    return pin.points.front().at;
}

/// The greatest distance of a point from its link's origin: what is small against it is nothing.
inline double farthest_point(const Structure& s, std::span<const double> numbers) {
    double greatest = 0;
    for (const Pin& pin : s.pins)
        for (const Point& point : pin.points) {
            const Vector<double> at = place_of(point.at, numbers);
            greatest = std::max(greatest, std::hypot(at.x, at.y));
        }
    return greatest;
}

inline bool is_on(const Pin& pin, std::size_t link) {
    for (const Point& point : pin.points)
        if (point.link == link) return true;
    return false;
}

inline bool share_link(const Pin& a, const Pin& b) {
    for (const Point& point : a.points)
        if (is_on(b, point.link)) return true;
    return false;
}

/// Whether a pin joins links, or is in a slot; else it is a point of a link.
inline bool is_joint(const Structure& s, std::size_t pin) {
    if (s.pins[pin].points.size() > 1) return true;
    for (const Slot& slot : s.slots)
        if (slot.pin == pin) return true;
    return false;
}

}  // namespace mechwright::linkage
