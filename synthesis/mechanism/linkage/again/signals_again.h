#pragma once
/// \file
/// Signals of a linkage from poses by the equations of its joints (loop.h): plain values, and derivatives by
/// differences. In doubles for a first look, in fifty digits to measure with.

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/again/follow.h"

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
        const Follower<T>& here = from_inside_ && inside ? *inside : follower;
        Follower<T> there = here;
        there.heeds_stops = false;
        if (there.pose.turns.empty()) return false;
        constexpr double least = 1e-9;
        if (!(there.at == input) && !there.step(input) && !there.follow(input, least, [](const auto&) {})) return false;
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
    /// The derivative of some order from values at a few inputs about one, so close together as the nearest end of the
    /// motion lets them be; at an end, beyond which there is no pose, from inside.
    template <class Function>
    auto difference(const Function& f, int order, const T& at) {
        if (order == 0) return f(at);
        constexpr bool doubles = std::is_same_v<T, double>;
        const T before = at - first_input, after = last_input - at, nearest = before < after ? before : after;
        const int count = order + (finely ? 7 : 1);
        const T farthest = (!doubles ? T(1e-5) : finely ? T(0.25) / T(count) : T(1) / T(count)) * nearest;
        if (doubles && !finely ? nearest < T(count) * difference_step() : !(nearest > T(0))) {
            from_inside_ = true;
            auto slope = from_inside(f, order, at, before < after ? follower.unit() : T(-follower.unit()));
            from_inside_ = false;
            return slope;
        }
        const T h = farthest < difference_step() ? farthest : difference_step();
        return slope_of_polynomial(f, order, at, h, count, 0.5 * (count - 1));
    }

    /// The same at an end, with a `way` towards the motion of the size of inputs. Infinite where shorter steps make it
    /// much steeper, as what goes like the root of the distance.
    template <class Function>
    static auto from_inside(const Function& f, int order, const T& at, const T& way) {
        // Differences of doubles are for a first look.
        if constexpr (std::is_same_v<T, double>) {
            return slope_of_polynomial(f, order, at, way * 1e-3, order + 1, -1);
        } else {
            // Short beside the distance of a limit beyond the end; each order takes as many digits as the step has.
            const T step = way * T(order == 1 ? 1e-10 : 1e-7);
            return unless_it_grows(slope_of_polynomial(f, order, at, step, order + 5, -1),
                                   slope_of_polynomial(f, order, at, T(step / T(10)), order + 5, -1));
        }
    }
    static T unless_it_grows(const T& longer, const T& shorter) {
        using std::abs;
        constexpr double steep = 1e-6;
        if (!(abs(shorter) > T(2) * abs(longer)) || !(abs(shorter) > T(steep))) return longer;
        return T(shorter > T(0) ? 1 : -1) * T(std::numeric_limits<double>::infinity());
    }
    static Vector<T> unless_it_grows(const Vector<T>& longer, const Vector<T>& shorter) {
        return {unless_it_grows(longer.x, shorter.x), unless_it_grows(longer.y, shorter.y)};
    }

    /// The derivative of the polynomial through the values at some inputs that are h apart, of which the first lies
    /// `shift` steps before `at`: by Newton's forward differences.
    template <class Function>
    static auto slope_of_polynomial(const Function& f, int order, const T& at, const T& h, int count, double shift) {
        std::vector<decltype(f(at))> differences;
        for (int i = 0; i < count; ++i)
            differences.push_back(f(T(at + T(i - shift) * h)));
        for (int level = 1; level < count; ++level)
            for (int i = count - 1; i >= level; --i)
                differences[i] = differences[i] - differences[i - 1];
        // Coefficients by powers of s of (s + shift) (s + shift - 1) ... (s + shift - j + 1) / j!.
        std::vector<T> power(count + 1, T(0));
        power[0] = T(1);
        auto sum = T(0) * differences[0];
        for (int j = 0; j < count; ++j) {
            sum = sum + power[order] * differences[j];
            for (int k = j + 1; k >= 0; --k)
                power[k] = ((k > 0 ? power[k - 1] : T(0)) + T(shift - j) * power[k]) / T(j + 1);
        }
        for (int k = 1; k <= order; ++k)
            sum = T(T(k) / h) * sum;
        return sum;
    }

    Vector<T> pin_at(std::size_t pin, const T& input) {
        Vector<T> at{T(std::numeric_limits<double>::quiet_NaN()), T(0)};
        at_pose(input, [&](const LoopPose<T>& pose) { at = follower.loop.pin(pin, pose); });
        return at;
    }
    T magnitude(std::size_t pin, int order, const T& input) {
        const Vector<T> by = difference([&](const T& x) { return pin_at(pin, x); }, order, input);
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
    /// Between these inputs there are poses, as far as that is known.
    T first_input{-std::numeric_limits<double>::infinity()}, last_input{std::numeric_limits<double>::infinity()};
    bool finely = false;  ///< whether derivatives in doubles are to have as many digits as there can be
    /// Where the follower stands at an end: one that stands before it.
    std::optional<Follower<T>> inside{};

private:
    Vector<T> origin_, tilt_;
    T scale_;
    T rate_;  ///< of the input, by time
    bool from_inside_ = false;
};

}  // namespace mechwright
