#pragma once
/// \file
/// What a quantity of a linkage is measured on: the linkage, its motion and its signals; and the lengths of its links.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/linkage/measuring/course.h"
#include "analysis/linkage/measuring/margins.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/quantities.h"
#include "synthesis/target/followed/arc.h"
#include "synthesis/target/followed/line.h"

namespace mechwright::measuring {

using Kind = LinkageMeasure::Kind;
using linkage::Signal;

inline constexpr double turn = 2 * std::numbers::pi;

/// What is asked over an input range, where a quantity is of that.
inline const LinkageInputTarget& target_of(const LinkageModel& model, const LinkageMeasure& measure) {
    return model.over_input[measure.over_input];
}

/// The linkage and the motion that a quantity is measured over.
struct Over {
    const LinkageModel& model;
    const LinkageMeasure& measure;
    const Motion& motion;
    std::vector<linkage::DriveLaw> laws = laws_of(model);
    double rate = 1;          ///< of the angle or displacement by the time
    bool over_input = false;  ///< start and range of the motion are the last arguments

    explicit Over(const Motion& over, bool by_arguments = false)
        : model(linkage_of(over.model)),
          measure(*static_cast<const LinkageMeasure*>(over.of)),
          motion(over),
          over_input(by_arguments) {
        if (!model.driven_by_slide() && model.drives.front().speed) rate = *model.drives.front().speed * turn / 60;
    }
    bool is_followed() const { return measure.kind == Kind::distance_greatest || measure.kind == Kind::extent; }
    bool is_of_function() const {
        return measure.kind == Kind::function_greatest || measure.kind == Kind::function_rms;
    }
    /// Of the arguments those that are numbers of what is followed.
    std::size_t shape_numbers() const {
        if (!is_followed()) return 0;
        return target_of(model, measure).followed == Followed::line ? LineShape::parameters : ArcShape::parameters;
    }
    template <class T>
    std::span<const T> dimensions_of(std::span<const T> arguments) const {
        return arguments.first(arguments.size() - shape_numbers() - (is_of_function() ? 2 : 0) - (over_input ? 2 : 0));
    }
    template <class T>
    std::span<const T> shape_of(std::span<const T> arguments) const {
        return arguments.last(shape_numbers());
    }
    /// What is asked of the output of a function whose arguments end with start and range of the input and the output;
    /// it is counted on by so many whole turns.
    template <class T>
    linkage::Wanted<T> wanted_of(std::span<const T> arguments, double whole_turns, std::span<const double> part) const {
        const std::span<const T> scales = arguments.last(4);
        return {scales[0], scales[1], scales[2] + T(turn * whole_turns), scales[3], part};
    }
    /// The input of the analysis for one among the arguments of a quantity.
    double input_at(double argument) const { return model.input_of(argument * model.unit_of_input()); }
    const std::vector<std::int8_t>& sides() const { return model.sides[motion.assembly]; }
    linkage::Driven<double> driven(std::span<const double> dimensions) const {
        return mechwright::driven(model, dimensions, motion.assembly);
    }
    /// Whether larger groups, if there are any, are on their branch all over a travel, and lines are never parallel.
    bool stays(std::span<const double> dimensions, const linkage::Travel& travel) const {
        bool any_lines = false;
        for (std::size_t margin = 0; margin < model.order.margins; ++margin)
            any_lines = any_lines || linkage::is_of_lines(model.order, margin);
        if (any_lines && !linkage::lines_meet(driven(dimensions), travel)) return false;
        if (model.order.larger.empty()) return true;
        const Ways all = ways_of(model, dimensions, motion.assembly);
        return !all.empty() && std::all_of(all.begin(), all.end(),
                                           [&](const auto& way) { return way && way->covers(travel.from, travel.to); });
    }
    double period() const { return turn * model.turns; }
    linkage::Travel travel() const {
        return {model.input_of(motion.from), motion.full_turn ? motion.from + period() : model.input_of(motion.to),
                motion.full_turn};
    }
    /// Values that are no lengths, as velocities by a length are, are those in the file's lengths.
    double length_of_values() const {
        const bool plain = model.driven_by_slide() && !measure.signals.empty() && unit_of(model, measure) == Unit::none;
        return plain ? model.unit : 1;
    }
};

inline bool is_of_room(Kind kind) {
    return kind == Kind::room_width || kind == Kind::room_height || kind == Kind::room_area;
}

inline bool is_of_turned_box(Kind kind) { return kind == Kind::turned_width || kind == Kind::turned_area; }

inline bool is_of_swept_area(Kind kind) { return kind == Kind::swept_area || kind == Kind::uncovered; }

/// Whether it goes by the places of a room's pins, and not by how far they are along something.
inline bool is_of_coordinates(Kind kind) {
    return is_of_turned_box(kind) || is_of_swept_area(kind) || kind == Kind::self_distance;
}

/// Whether it is of a room or a region.
inline bool is_of_parts(Kind kind) {
    return is_of_room(kind) || is_of_coordinates(kind) || kind == Kind::region_margin;
}

/// The orders of the time series that quantities without signals of a file are measured by: most go by places that are
/// stationary, the width of a box that turns and the envelope of a line by slopes of such places.
inline constexpr std::size_t order_of_places = 2, order_of_slopes = 4;

/// The screen of the room that is measured, in the lengths of its model.
inline std::vector<Vector<double>> screen_of(const Over& over) {
    std::vector<Vector<double>> corners;
    for (const Vector<double>& corner : over.model.rooms[over.measure.of_room].screen)
        corners.push_back((1 / over.model.unit) * corner);
    return corners;
}

/// How far all pins of a room are along its width, or its height; of its area all along the one, then along the other.
/// Of a box that turns, and of a path, the coordinates of each.
inline std::vector<Signal> signals_of_room(const LinkageRoom& room, Kind kind) {
    std::vector<Signal> signals;
    for (const std::size_t pin : room.pins) {
        if (!is_of_coordinates(kind)) break;
        signals.push_back({Signal::Kind::x, pin});
        signals.push_back({Signal::Kind::y, pin});
    }
    if (is_of_coordinates(kind)) return signals;
    for (const bool across : {false, true}) {
        if (kind == (across ? Kind::room_width : Kind::room_height)) continue;
        for (const std::size_t pin : room.pins)
            signals.push_back({.kind = Signal::Kind::along,
                               .of = pin,
                               .number = room.direction + (across ? std::numbers::pi / 2 : 0)});
    }
    return signals;
}

/// All pins of the parts of a region, each once.
inline std::vector<std::size_t> pins_of(const LinkageRegion& region) {
    std::vector<std::size_t> pins;
    for (const auto& part : region.parts)
        pins.insert(pins.end(), part.begin(), part.end());
    std::sort(pins.begin(), pins.end());
    pins.erase(std::unique(pins.begin(), pins.end()), pins.end());
    return pins;
}

/// Where the margin of a region is that of points: the distance of each from the centre, or along each border's normal.
inline std::vector<Signal> signals_of_region(const LinkageRegion& region, double unit) {
    std::vector<Signal> signals;
    if (!region.is_by_points()) return signals;
    for (const std::size_t pin : pins_of(region))
        if (region.shape == LinkageRegion::Shape::circle)
            signals.push_back(
                {.kind = Signal::Kind::from_place, .of = pin, .place = (1 / unit) * region.places.front()});
        else
            for (const StraightBorder& border : borders_of(region))
                signals.push_back(
                    {.kind = Signal::Kind::along, .of = pin, .number = std::atan2(border.inward.y, border.inward.x)});
    return signals;
}

/// The signals that a ready-made quantity is of.
inline std::vector<Signal> own_signals(const LinkageModel& model, const LinkageMeasure& measure) {
    const Kind kind = measure.kind;
    const linkage::Structure& s = model.structure;
    std::vector<Signal> signals;
    if (kind == Kind::distance_greatest || kind == Kind::extent) {
        const LinkageInputTarget& target = target_of(model, measure);
        const std::size_t pin = model.guided[target.of].pin;
        const auto distance = target.followed == Followed::line ? Signal::Kind::y : Signal::Kind::radius;
        return {{distance, pin}, {Signal::Kind::x, pin}, {Signal::Kind::y, pin}};
    }
    if (is_of_room(kind) || is_of_coordinates(kind)) return signals_of_room(model.rooms[measure.of_room], kind);
    if (kind == Kind::region_margin) return signals_of_region(model.regions[measure.of_room], model.unit);
    if (kind == Kind::transmission_angle_worst)
        for (std::size_t margin = 0; margin < model.order.margins_of_dyads(); ++margin)
            if (linkage::step_together(model.order, margin) == nullptr)
                signals.push_back({Signal::Kind::transmission_angle, margin});
    if (kind != Kind::joint_distance_least) return signals;
    for (std::size_t a = 0; a < s.pins.size(); ++a)
        for (std::size_t b = a + 1; b < s.pins.size(); ++b)
            if (linkage::is_joint(s, a) && linkage::is_joint(s, b) && !linkage::share_link(s.pins[a], s.pins[b]))
                signals.push_back({Signal::Kind::distance, a, b});
    return signals;
}

/// How the linkage stands in the axes in which it is measured: those of the drawing; those of the line that its point
/// follows, so that y is the distance from it; or axes about the centre of an arc.
template <class T>
linkage::Placing<T> placing_of(const Over& over, std::span<const T> dimensions, std::span<const T> shape) {
    const LinkageModel& m = over.model;
    linkage::Placing<T> placing{{m.placement[0].at(dimensions), m.placement[1].at(dimensions)},
                                m.placement[2].at(dimensions),
                                m.scale.at(dimensions)};
    if (const double length = over.length_of_values(); length != 1) {
        placing.origin = T(length) * placing.origin;
        placing.scale = T(length) * placing.scale;
    }
    if (shape.size() == ArcShape::parameters) placing.origin = placing.origin - Vector<T>{shape[0], shape[1]};
    if (shape.size() != LineShape::parameters) return placing;
    placing.origin = turned(placing.origin, unit_at(T(-shape[0])));
    placing.origin.y = placing.origin.y - shape[1];
    placing.tilt = placing.tilt - shape[0];
    return placing;
}

template <class T, std::size_t K>
linkage::Measured<T, K> measured(const Over& over, std::span<const T> arguments, std::span<const Signal> signals) {
    const LinkageModel& m = over.model;
    const std::span<const T> dimensions = over.dimensions_of(arguments);
    std::vector<double> plain;
    for (std::size_t i = 0; !m.order.larger.empty() && i < dimensions.size(); ++i)
        plain.push_back(number_as<double>(value_of(dimensions[i])));
    return {m.structure,
            m.order,
            numbers_of(m, dimensions),
            over.sides(),
            over.laws,
            signals,
            placing_of(over, dimensions, over.shape_of(arguments)),
            m.input_of(over.rate),
            ways_of(m, plain, over.motion.assembly)};
}

/// Distances of links' origins to their pins, but those that are 0, in the drawing: clearance makes no link longer.
template <class T>
std::vector<T> link_lengths(const LinkageModel& model, std::span<const T> dimensions) {
    const linkage::Structure& s = model.structure;
    std::vector<T> numbers;
    for (const Affine& number : model.as_drawn.empty() ? model.numbers : model.as_drawn)
        numbers.push_back(number.at(dimensions));
    const T scale = model.scale.at(dimensions);
    std::vector<T> lengths;
    for (std::size_t pin = 0; pin < s.pins.size(); ++pin) {
        if (!linkage::is_joint(s, pin)) continue;
        for (const linkage::Point& point : s.pins[pin].points) {
            const Vector<T> at = linkage::place_of(point.at, std::span<const T>(numbers));
            const T length = hypotenuse(at.x, at.y);
            if (length > T(0)) lengths.push_back(scale * length);
        }
    }
    return lengths;
}

}  // namespace mechwright::measuring
