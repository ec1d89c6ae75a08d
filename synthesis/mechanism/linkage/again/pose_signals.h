#pragma once
/// \file
/// Signals of a linkage in one pose, however it was found: those that follow from where its links are.

#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/loop.h"
#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

/// By which powers of the input signals go: enough for the jerk of a point's acceleration, its slope and curvature.
inline constexpr std::size_t powers_of_input = 7;

/// How a linkage of some dimensions stands in its drawing, and from where its angles are counted.
template <class T>
struct Standing {
    Vector<T> origin, tilt;
    T scale;
    std::vector<double> start_turns{};  ///< of all links at the start of motion

    Standing(const LinkageModel& model, std::span<const T> dimensions, std::vector<double> turns)
        : origin{model.placement[0].at(dimensions), model.placement[1].at(dimensions)},
          tilt(unit_at(model.placement[2].at(dimensions))),
          scale(model.scale.at(dimensions)),
          start_turns(std::move(turns)) {}
};

/// The turn of the direction of a velocity, a series of the input, over the way: times the input's growth by the time
/// the curvature of the path.
template <class Value>
Value curvature_again(const Vector<Value>& velocity) {
    return slope_of(atan2(velocity.y, velocity.x)) / hypotenuse(velocity.x, velocity.y);
}

/// A linkage in a pose.
template <class T>
struct PoseSignals {
    const LinkageModel& model;
    const Loop<T>& loop;
    const Standing<T>& standing;
    const LoopPose<T>& pose;

    /// A pin in the drawing.
    Vector<T> in_drawing(std::size_t pin) const {
        return standing.origin + standing.scale * turned(loop.pin(pin, pose), standing.tilt);
    }
    /// From one pin of a distance to the other, in the drawing.
    Vector<T> apart(const linkage::Signal& s) const { return in_drawing(s.to) - in_drawing(s.of); }
    /// Between two pins, in the drawing.
    T distance(std::size_t a, std::size_t b) const {
        const Vector<T> apart = loop.pin(a, pose) - loop.pin(b, pose);
        return standing.scale * hypotenuse(apart.x, apart.y);
    }
    /// The angle at which a dyad passes its force on, in [0, pi].
    T transmission_angle(const linkage::Group& group) const {
        using std::abs, std::atan2;
        if (group.pin == linkage::none || group.outer[0] == linkage::none) {
            const auto [a, b] = two_lines(group);
            return atan2(T(abs(cross(a, b))), dot(a, b));
        }
        const linkage::Structure& s = model.structure;
        const Vector<T> inner = loop.pin(group.pin, pose), first = inner - loop.pin(group.outer[0], pose);
        const Vector<T> other =
            group.kind == linkage::Group::Kind::rrr
                ? inner - loop.pin(group.outer[1], pose)
                : left_of(
                      loop.direction(group.by_slide ? s.slides[group.joint].line : s.slots[group.joint].line, pose));
        return atan2(T(abs(cross(first, other))), dot(first, other));
    }
    /// A signal that is no speed, no acceleration, no curvature, no sum and no ratio of others.
    T value(const linkage::Signal& s) const {
        using Kind = linkage::Signal::Kind;
        switch (s.kind) {
            case Kind::angle: return pose.turns[s.of] - pose.turns[s.to] + T(2) * pi<T>() * T(whole_turns_of(s));
            case Kind::x: return coordinates(s).x;
            case Kind::y: return coordinates(s).y;
            case Kind::along: return dot(coordinates(s), unit_at(T(s.number)));
            case Kind::distance: return distance(s.of, s.to);
            case Kind::from_line: {
                const Vector<T> start = loop.pin(s.to, pose), line = loop.pin(s.end, pose) - start;
                return standing.scale * cross(line, loop.pin(s.of, pose) - start) / hypotenuse(line.x, line.y);
            }
            case Kind::slide: return standing.scale * loop.displacement(s.of, pose);
            case Kind::transmission_angle:
                for (const linkage::Group& group : model.order.groups)
                    if (linkage::margin_of(model.order, group) == s.of) return transmission_angle(group);
                break;
            default: break;
        }
        return T(std::numeric_limits<double>::quiet_NaN());
    }

private:
    Vector<T> coordinates(const linkage::Signal& s) const {
        if (s.on == linkage::none) return in_drawing(s.of);
        const T back = -pose.turns[s.on];
        return standing.scale * turned(loop.pin(s.of, pose) - pose.origins[s.on], unit_at(back));
    }
    std::pair<Vector<T>, Vector<T>> two_lines(const linkage::Group& group) const {
        const std::size_t margin = linkage::margin_of(model.order, group);
        const linkage::Structure& s = model.structure;
        const auto line = [&](const linkage::Locus& locus) {
            const bool slide =
                locus.kind != linkage::Locus::Kind::slot &&
                (locus.tie.kind == linkage::Tie::Kind::slides || locus.tie.kind == linkage::Tie::Kind::carries);
            return loop.direction(slide ? s.slides[locus.tie.joint].line : s.slots[locus.tie.joint].line, pose);
        };
        for (const linkage::Step& step : model.order.steps)
            if (step.margin == margin) return {line(step.first), line(step.second)};
        return {};
    }
    double whole_turns_of(const linkage::Signal& s) const {
        if (standing.start_turns.empty()) return 0;
        return linkage::whole_turns_to(standing.start_turns[s.of] - standing.start_turns[s.to], s.number);
    }
};

}  // namespace mechwright
