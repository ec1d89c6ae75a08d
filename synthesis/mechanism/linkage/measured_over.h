#pragma once
/// \file
/// What a quantity of a linkage is measured on: the linkage, its motion and its signals; and the lengths of its links.

#include <cstddef>
#include <cstdint>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/linkage/course.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright::measuring {

using Kind = LinkageMeasure::Kind;
using linkage::Signal;

inline constexpr double turn = 2 * std::numbers::pi;

/// The linkage and the motion that a quantity is measured over.
struct Over {
    const LinkageModel& model;
    const LinkageMeasure& measure;
    const Motion& motion;
    std::vector<linkage::DriveLaw> laws = laws_of(model.drives);
    double rate = 1;
    bool over_input = false;  ///< start and range of the motion are the last arguments

    explicit Over(const Motion& over, bool by_arguments = false)
        : model(linkage_of(over.model)),
          measure(*static_cast<const LinkageMeasure*>(over.of)),
          motion(over),
          over_input(by_arguments) {
        if (!model.driven_by_slide() && model.drives.front().speed) rate = *model.drives.front().speed * turn / 60;
    }
    std::span<const double> dimensions_of(std::span<const double> arguments) const {
        return arguments.first(arguments.size() - (over_input ? 2 : 0));
    }
    const std::vector<std::int8_t>& sides() const { return model.sides[motion.assembly]; }
    linkage::Driven<double> driven(std::span<const double> dimensions) const {
        return mechwright::driven(model, dimensions, motion.assembly);
    }
    double period() const { return turn * model.turns; }
    linkage::Travel travel() const {
        return {motion.from, motion.full_turn ? motion.from + period() : motion.to, motion.full_turn};
    }
};

/// The signals that a ready-made quantity is of.
inline std::vector<Signal> own_signals(const LinkageModel& model, Kind kind) {
    const linkage::Structure& s = model.structure;
    std::vector<Signal> signals;
    if (kind == Kind::transmission_angle_worst)
        for (std::size_t margin = 0; margin < model.order.margins; ++margin)
            signals.push_back({Signal::Kind::transmission_angle, margin});
    if (kind != Kind::joint_distance_least) return signals;
    for (std::size_t a = 0; a < s.pins.size(); ++a)
        for (std::size_t b = a + 1; b < s.pins.size(); ++b)
            if (linkage::is_joint(s, a) && linkage::is_joint(s, b) && !linkage::share_link(s.pins[a], s.pins[b]))
                signals.push_back({Signal::Kind::distance, a, b});
    return signals;
}

template <class T, std::size_t K>
linkage::Measured<T, K> measured(const Over& over, std::span<const T> dimensions, std::span<const Signal> signals) {
    const LinkageModel& m = over.model;
    return {m.structure,
            m.order,
            numbers_of(m, dimensions),
            over.sides(),
            over.laws,
            signals,
            {{m.placement[0].at(dimensions), m.placement[1].at(dimensions)},
             m.placement[2].at(dimensions),
             m.scale.at(dimensions)},
            over.rate};
}

/// Distances of links' origins to their pins, but those that are 0, in the drawing.
template <class T>
std::vector<T> link_lengths(const LinkageModel& model, std::span<const T> dimensions) {
    const linkage::Structure& s = model.structure;
    const std::vector<T> numbers = numbers_of(model, dimensions);
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
