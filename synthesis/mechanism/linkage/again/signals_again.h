#pragma once
/// \file
/// Signals of a linkage from poses by the equations of its joints (loop.h): plain values, and derivatives by
/// differences, in fifty digits.

#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "analysis/numbers/series.h"
#include "synthesis/mechanism/linkage/again/follow.h"
#include "synthesis/mechanism/linkage/again/pose_signals.h"

namespace mechwright {

/// Signals of a linkage at poses of its joints' equations.
template <class T>
class SignalsAgain {
public:
    /// `start_turns`: those of all links at the start of motion.
    SignalsAgain(const LinkageModel& model, std::span<const T> dimensions, std::vector<double> start_turns)
        : model_(model),
          follower(model, numbers_of(model, dimensions)),
          standing_(model, dimensions, std::move(start_turns)),
          rate_(model.drives.front().speed ? *model.drives.front().speed * std::numbers::pi / 30 : 1) {}

    /// At the pose of an input near that where the follower stands, which it leaves as it was.
    T value(std::size_t signal, const T& input) { return by_input(model_.signals[signal], 0, input); }

    /// The derivative of some order by the time, in which the input grows by its speed.
    T by_input(const linkage::Signal& s, int order, const T& input) {
        T by(0);
        if (order == 0 || !is_limit(input)) {
            by = series(s, order, input).derivative(static_cast<std::size_t>(order));
        } else if (s.kind == linkage::Signal::Kind::sum) {
            for (const linkage::Signal::Term& term : s.terms)
                by += T(term.factor) * by_input(model_.signals[term.signal], order, input);
            return by;
        } else {
            by = difference([&](const T& at) { return series(s, 0, at).c[0]; }, order, input);
        }
        for (int i = 0; i < order; ++i)
            by *= rate_;
        return by;
    }

    /// The derivative of some order by the input of something that a pose has, a number or a vector.
    template <class OfPose>
    auto of_pose(const OfPose& of, int order, const T& input) {
        return difference([&](const T& x) { return at_pose(x, of); }, order, input);
    }

    const T& rate() const { return rate_; }

private:
    /// Something that the pose at an input near that of the follower has; not a number where there is no pose.
    template <class OfPose>
    auto at_pose(const T& input, const OfPose& of) {
        const Follower<T>& here = from_inside_ && inside ? *inside : follower;
        Follower<T> there = here;
        there.heeds_stops = false;
        constexpr double least = 1e-9;
        const bool found = !there.pose.turns.empty() &&
                           (there.at == input || there.step(input) || there.follow(input, least, [](const auto&) {}));
        using Found = decltype(of(PoseSignals<T>{model_, there.loop, standing_, there.pose}));
        if (found) return Found(of(PoseSignals<T>{model_, there.loop, standing_, there.pose}));
        const T missing(std::numeric_limits<double>::quiet_NaN());
        if constexpr (std::is_same_v<Found, Vector<T>>)
            return Found{missing, missing};
        else
            return Found(missing);
    }

    /// Whether an input is one at which the motion ends, with no more known beyond.
    bool is_limit(const T& input) const {
        return (!first_regular && !(input > first_input)) || (!last_regular && !(input < last_input));
    }

    /// The derivative of some order: from values about an input, at a limit from inside.
    template <class Function>
    auto difference(const Function& f, int order, const T& at) {
        if (order == 0) return f(at);
        auto by = is_limit(at) ? from_inside(f, order, at) : taylor(f, order, at).back();
        for (int k = 2; k <= order; ++k)
            by = T(k) * by;
        return by;
    }

    /// Taylor coefficients up to some order, from values at a few inputs about one: so close together as the nearest
    /// limit of the motion lets them be, and inside other ends, beyond which the formulas are others.
    template <class Function>
    auto taylor(const Function& f, int order, const T& at) {
        if (order == 0) return std::vector<decltype(f(at))>{f(at)};
        constexpr double longest = 1e-7, of_way = 1e-5;
        const T before = at - first_input, after = last_input - at;
        const int count = order + 3;
        T h = T(longest) * follower.unit();
        const auto shorten = [&h](const T& to) {
            if (to < h) h = to;
        };
        if (!first_regular) shorten(T(of_way) * before);
        if (!last_regular) shorten(T(of_way) * after);
        shorten(T(before + after) / T(count + 2));
        T shift = T(0.5 * (count - 1));
        if (const T most = before / h - T(1); first_regular && most < shift) shift = most;
        if (const T least = T(count) - after / h; last_regular && least > shift) shift = least;
        return taylor_of_polynomial(f, order, at, h, count, shift);
    }

    /// The last of these at a limit. Infinite where shorter steps make it much steeper, as what goes like the root of
    /// the distance.
    template <class Function>
    auto from_inside(const Function& f, int order, const T& at) {
        from_inside_ = true;
        const bool first = at - first_input < last_input - at;
        // Short beside the distance of a limit beyond the end; each order takes as many digits as the step has.
        const T step = T(first ? 1 : -1) * T(order == 1 ? 1e-10 : 1e-7) * follower.unit();
        auto by = unless_it_grows(taylor_of_polynomial(f, order, at, step, order + 5, T(-1)).back(),
                                  taylor_of_polynomial(f, order, at, T(step / T(10)), order + 5, T(-1)).back());
        from_inside_ = false;
        return by;
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

    /// Those of the polynomial through the values at some inputs that are h apart, of which the first lies `shift`
    /// steps before `at`: by Newton's forward differences.
    template <class Function>
    static auto taylor_of_polynomial(const Function& f, int order, const T& at, const T& h, int count, const T& shift) {
        std::vector<decltype(f(at))> differences;
        for (int i = 0; i < count; ++i)
            differences.push_back(f(T(at + (T(i) - shift) * h)));
        for (int level = 1; level < count; ++level)
            for (int i = count - 1; i >= level; --i)
                differences[i] = differences[i] - differences[i - 1];
        // Coefficients by powers of s of (s + shift) (s + shift - 1) ... (s + shift - j + 1) / j!.
        std::vector<T> power(count + 1, T(0));
        power[0] = T(1);
        std::vector<decltype(f(at))> sums(order + 1, T(0) * differences[0]);
        for (int j = 0; j < count; ++j) {
            for (int k = 0; k <= order; ++k)
                sums[k] = sums[k] + power[k] * differences[j];
            for (int k = j + 1; k >= 0; --k)
                power[k] = ((k > 0 ? power[k - 1] : T(0)) + (shift - T(j)) * power[k]) / T(j + 1);
        }
        T per_step(1);
        for (int k = 1; k <= order; ++k) {
            per_step /= h;
            sums[k] = per_step * sums[k];
        }
        return sums;
    }

    /// A signal as a series of the input about one, whose coefficients are known up to some order.
    Series<T, powers_of_input> series(const linkage::Signal& s, int order, const T& input) {
        using Kind = linkage::Signal::Kind;
        using Value = Series<T, powers_of_input>;
        if (s.kind == Kind::ratio)
            return series(model_.signals[s.of], order, input) / series(model_.signals[s.to], order, input);
        if (s.kind == Kind::sum) {
            Value sum(T(0));
            for (const linkage::Signal::Term& term : s.terms)
                sum += T(term.factor) * series(model_.signals[term.signal], order, input);
            return sum;
        }
        if (s.kind == Kind::curvature) {
            const std::vector<Vector<T>> c = vector_by_input(s, 2 + order, input);
            const Value x = Value::by_powers([&](std::size_t k) { return k < c.size() ? c[k].x : T(0); }),
                        y = Value::by_powers([&](std::size_t k) { return k < c.size() ? c[k].y : T(0); });
            return rate_ * curvature_again(Vector<Value>{rate_ * slope_of(x), rate_ * slope_of(y)});
        }
        if (!linkage::is_size(s)) {
            const std::vector<T> c =
                taylor([&](const T& x) { return at_pose(x, [&](const auto& p) { return p.value(s); }); }, order, input);
            return Value::by_powers([&](std::size_t k) { return k < c.size() ? c[k] : T(0); });
        }
        const int own = s.kind == Kind::distance ? 0 : s.kind == Kind::speed ? 1 : 2;
        const std::vector<Vector<T>> c = vector_by_input(s, own + order, input);
        Value x = Value::by_powers([&](std::size_t k) { return k < c.size() ? c[k].x : T(0); }),
              y = Value::by_powers([&](std::size_t k) { return k < c.size() ? c[k].y : T(0); });
        for (int i = 0; i < own; ++i) {
            x = rate_ * slope_of(x);
            y = rate_ * slope_of(y);
        }
        const bool first = first_regular && !(input > first_input), last = last_regular && !(input < last_input);
        return first || last ? size_beside(x, y, first) : hypotenuse(x, y);
    }
    /// The size of a vector beside an end at which it may vanish: after it, else before it. Then it is that of what the
    /// vector is over the way from there, times the way.
    Series<T, powers_of_input> size_beside(const Series<T, powers_of_input>& x, const Series<T, powers_of_input>& y,
                                           bool after) const {
        using Value = Series<T, powers_of_input>;
        const T vanishes = T(1e-9) * follower.unit();
        if (!(hypotenuse(x.c[0], y.c[0]) < vanishes * hypotenuse(x.c[1], y.c[1]))) return hypotenuse(x, y);
        const auto over_way = [](const Value& v) {
            return Value::by_powers([&](std::size_t k) { return k < powers_of_input ? v.c[k + 1] : T(0); });
        };
        const Value size = hypotenuse(over_way(x), over_way(y));
        return Value::by_powers([&](std::size_t k) {
            return k == 0 ? T(0) : after ? size.c[k - 1] : T(-size.c[k - 1]);
        });
    }
    /// Taylor coefficients of a pin's place, or of how far two pins are apart; at a limit those of derivatives that a
    /// signal goes by.
    std::vector<Vector<T>> vector_by_input(const linkage::Signal& s, int order, const T& input) {
        const bool apart = s.kind == linkage::Signal::Kind::distance;
        const auto place = [&](const T& x) {
            return at_pose(x, [&](const auto& p) { return apart ? p.apart(s) : p.in_drawing(s.of); });
        };
        if (!is_limit(input)) return taylor(place, order, input);
        std::vector<Vector<T>> c(order + 1, Vector<T>{T(0), T(0)});
        T factorial(1);
        for (int k = 1; k <= order; ++k) {
            factorial *= T(k);
            if (k == order || s.kind == linkage::Signal::Kind::curvature)
                c[k] = T(T(1) / factorial) * difference(place, k, input);
        }
        if (order == 0) c[0] = place(input);
        return c;
    }

    const LinkageModel& model_;

public:
    Follower<T> follower;
    /// Between these inputs there are poses, as far as that is known.
    T first_input{-std::numeric_limits<double>::infinity()}, last_input{std::numeric_limits<double>::infinity()};
    /// Whether what is measured goes on beyond them by the same formulas, so that they are no limits.
    bool first_regular = false, last_regular = false;
    /// Where the follower stands at an end: one that stands before it.
    std::optional<Follower<T>> inside{};

private:
    Standing<T> standing_;
    T rate_;  ///< of the input, by time
    bool from_inside_ = false;
};

}  // namespace mechwright
