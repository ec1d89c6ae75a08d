#pragma once
/// \file
/// Signals of a linkage from poses by the equations of its joints (loop.h): plain values, and derivatives by
/// differences. In doubles for a first look, in fifty digits to measure with.

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/follow.h"

namespace mechwright {

/// Signals of a linkage at poses of its joints' equations.
template <class T>
class SignalsAgain {
public:
    /// `start_turns`: those of all links at the start of motion.
    SignalsAgain(const LinkageModel& model, std::span<const T> dimensions, std::vector<double> start_turns)
        : model_(model),
          start_turns_(std::move(start_turns)),
          follower(model, numbers_of(model, dimensions)),
          origin_{model.placement[0].at(dimensions), model.placement[1].at(dimensions)},
          tilt_(linkage::detail::unit_at(model.placement[2].at(dimensions))),
          scale_(model.scale.at(dimensions)),
          rate_(model.drives.front().speed ? *model.drives.front().speed * std::numbers::pi / 30 : 1) {}

    /// At the pose of an input near that where the follower stands, which it leaves as it was.
    T value(std::size_t signal, const T& input) { return by_input(signal, 0, input); }

    /// The derivative of some order by the time, in which the input grows by its speed.
    T by_input(std::size_t signal, int order, const T& input) {
        const linkage::Signal& s = model_.signals[signal];
        if (s.kind == linkage::Signal::Kind::sum) {
            T sum(0);
            for (const linkage::Signal::Term& term : s.terms)
                sum += T(term.factor) * by_input(term.signal, order, input);
            return sum;
        }
        T by = difference([&](const T& at) { return plain_value(s, at); }, order, input);
        for (int i = 0; i < order; ++i)
            by *= rate_;
        return by;
    }

    /// A pin in the drawing.
    Vector<T> in_drawing(std::size_t pin, const LoopPose<T>& pose) const {
        return origin_ + scale_ * turned(follower.loop.pin(pin, pose), tilt_);
    }

    /// The angle at which a dyad passes its force on, in [0, pi].
    T transmission_angle(const linkage::Group& group, const LoopPose<T>& pose) const {
        using std::abs, std::acos, std::atan2;
        using Kind = linkage::Group::Kind;
        const Loop<T>& loop = follower.loop;
        if (group.pin == linkage::none || group.outer[0] == linkage::none) {
            const auto [a, b] = two_lines(group, pose);
            return atan2(T(abs(cross(a, b))), dot(a, b));
        }
        const Vector<T> inner = loop.pin(group.pin, pose), first = inner - loop.pin(group.outer[0], pose);
        Vector<T> other;
        if (group.kind == Kind::rrr) {
            other = inner - loop.pin(group.outer[1], pose);
        } else {
            const linkage::Structure& s = model_.structure;
            other =
                left_of(loop.direction(group.by_slide ? s.slides[group.joint].line : s.slots[group.joint].line, pose));
        }
        return atan2(T(abs(cross(first, other))), dot(first, other));
    }

    /// Calls use(at, pose) with the pose at an input near that of the follower; false where there is none.
    template <class Use>
    bool at_pose(const T& input, const Use& use) {
        Follower<T> there = follower;
        there.heeds_stops = false;
        if (there.pose.turns.empty()) return false;
        if (!(there.at == input) && !there.step(input) && !there.start(input, follower.pose)) return false;
        use(there.pose);
        return true;
    }

    const T& rate() const { return rate_; }
    /// How far apart the inputs of a difference stand: in doubles for a first look, in fifty digits for all of them.
    T difference_step() const { return T(std::is_same_v<T, double> ? 1e-2 : 1e-9) * follower.unit(); }
    T distance(std::size_t a, std::size_t b, const LoopPose<T>& pose) const {
        const Vector<T> apart = follower.loop.pin(a, pose) - follower.loop.pin(b, pose);
        return scale_ * hypotenuse(apart.x, apart.y);
    }
    const T& scale() const { return scale_; }

private:
    /// The central difference of some order.
    template <class Function>
    T difference(const Function& f, int order, const T& at) const {
        const T h = difference_step();
        T sum(0), power(1);
        double binomial = 1;
        for (int k = 0; k <= order; ++k) {
            const T there = order == 0 ? at : T(at + T(0.5 * order - k) * h);
            sum += T(k % 2 == 0 ? binomial : -binomial) * f(there);
            binomial = binomial * (order - k) / (k + 1);
        }
        for (int k = 0; k < order; ++k)
            power *= h;
        return sum / power;
    }

    Vector<T> pin_at(std::size_t pin, const T& input) {
        Vector<T> at{T(std::numeric_limits<double>::quiet_NaN()), T(0)};
        at_pose(input, [&](const LoopPose<T>& pose) { at = follower.loop.pin(pin, pose); });
        return at;
    }
    T magnitude(std::size_t pin, int order, const T& input) {
        Vector<T> by;
        by.x = difference([&](const T& x) { return pin_at(pin, x).x; }, order, input);
        by.y = difference([&](const T& x) { return pin_at(pin, x).y; }, order, input);
        return scale_ * hypotenuse(by.x, by.y);
    }

    T plain_value(const linkage::Signal& s, const T& input) {
        using Kind = linkage::Signal::Kind;
        if (s.kind == Kind::speed) return rate_ * magnitude(s.of, 1, input);
        if (s.kind == Kind::acceleration) return rate_ * rate_ * magnitude(s.of, 2, input);
        if (s.kind == Kind::ratio) return value(s.of, input) / value(s.to, input);
        T found(std::numeric_limits<double>::quiet_NaN());
        at_pose(input, [&](const LoopPose<T>& pose) { found = of_pose(s, pose); });
        return found;
    }

    Vector<T> coordinates(const linkage::Signal& s, const LoopPose<T>& pose) const {
        using std::cos, std::sin;
        const Vector<T> at = follower.loop.pin(s.of, pose);
        if (s.on == linkage::none) return origin_ + scale_ * turned(at, tilt_);
        const T back = -pose.turns[s.on];
        return scale_ * turned(at - pose.origins[s.on], Vector<T>{cos(back), sin(back)});
    }

    T of_pose(const linkage::Signal& s, const LoopPose<T>& pose) const {
        using std::cos, std::sin;
        using Kind = linkage::Signal::Kind;
        const Loop<T>& loop = follower.loop;
        switch (s.kind) {
            case Kind::angle: return pose.turns[s.of] - pose.turns[s.to] + T(2) * pi<T>() * T(whole_turns_of(s));
            case Kind::x: return coordinates(s, pose).x;
            case Kind::y: return coordinates(s, pose).y;
            case Kind::along: return dot(coordinates(s, pose), Vector<T>{cos(T(s.number)), sin(T(s.number))});
            case Kind::distance: return distance(s.of, s.to, pose);
            case Kind::from_line: {
                const Vector<T> start = loop.pin(s.to, pose), line = loop.pin(s.end, pose) - start;
                return scale_ * cross(line, loop.pin(s.of, pose) - start) / hypotenuse(line.x, line.y);
            }
            case Kind::slide: return scale_ * loop.displacement(s.of, pose);
            case Kind::transmission_angle:
                for (const linkage::Group& group : model_.order.groups)
                    if (linkage::margin_of(model_.order, group) == s.of) return transmission_angle(group, pose);
                break;
            default: break;
        }
        return T(std::numeric_limits<double>::quiet_NaN());
    }

    std::pair<Vector<T>, Vector<T>> two_lines(const linkage::Group& group, const LoopPose<T>& pose) const {
        const std::size_t margin = linkage::margin_of(model_.order, group);
        const linkage::Structure& s = model_.structure;
        const auto line = [&](const linkage::Locus& locus) {
            const bool slide =
                locus.kind != linkage::Locus::Kind::slot &&
                (locus.tie.kind == linkage::Tie::Kind::slides || locus.tie.kind == linkage::Tie::Kind::carries);
            return follower.loop.direction(slide ? s.slides[locus.tie.joint].line : s.slots[locus.tie.joint].line,
                                           pose);
        };
        for (const linkage::Step& step : model_.order.steps)
            if (step.margin == margin) return {line(step.first), line(step.second)};
        return {};
    }

    /// Angles are counted so that at the start of motion each is in (near - pi, near + pi].
    double whole_turns_of(const linkage::Signal& s) const {
        if (start_turns_.empty()) return 0;
        const double angle = start_turns_[s.of] - start_turns_[s.to];
        return -std::ceil((angle - s.number) / (2 * std::numbers::pi) - 0.5);
    }

    const LinkageModel& model_;
    std::vector<double> start_turns_;

public:
    Follower<T> follower;

private:
    Vector<T> origin_, tilt_;
    T scale_;
    T rate_;  ///< of the input, by time
};

}  // namespace mechwright
