#pragma once
/// \file
/// What is measured along the motion of a linkage: smooth functions of the master's input, as plain values, and their
/// value in a pose of any number type. Speeds need a pose in a series (numbers/series.h) of the time.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/linkage/measuring/rest.h"
#include "analysis/linkage/motion/driven.h"
#include "analysis/numbers/chebyshev.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

struct Signal {
    enum class Kind : std::uint8_t {
        angle,               ///< turn of the link `of` against the link `to`, radians
        x,                   ///< coordinates of the pin `of`, in the axes of `on`
        y,                   ///<
        along,               ///< the same in a direction
        radius,              ///< distance of the pin `of` from the drawing's origin
        from_place,          ///< distance of the pin `of` from `place`
        distance,            ///< of the pins `of` and `to`
        from_line,           ///< distance of the pin `of` to the left of the line from the pin `to` to the pin `end`
        place_from_line,     ///< distance of `place` to the left of that line
        slide,               ///< displacement of the slide `of`
        speed,               ///< magnitude of the velocity of the pin `of`
        acceleration,        ///< of its acceleration
        curvature,           ///< of the path of the pin `of`, positive where it bends to the left of its direction
        transmission_angle,  ///< of the dyad that has the margin `of` (margin_of), in (0, pi)
        sum,                 ///< of signals times factors
        ratio,               ///< of the signal `of` to the signal `to`
        error                ///< the signal `of` less what is asked of it (Wanted)
    };
    Kind kind = Kind::angle;
    std::size_t of = none;
    std::size_t to = 0;
    std::size_t end = none;
    std::size_t on = none;  ///< a link; none: the drawing's axes, after placement
    double number = 0;      ///< of an angle what it is near at the start of motion; of `along` the direction; radians
    struct Term {
        std::size_t signal = 0;
        double factor = 1;
    };
    std::vector<Term> terms{};  ///< of a sum
    Vector<double> place{};     ///< that stands still, in the drawing's axes
};

/// The whole turns that bring an angle at the start of motion into (near - pi, near + pi]. Close to an end it is at the
/// upper one: of a motion that starts at a limit doubles know the first angle to half their digits only.
inline double whole_turns_to(double angle, double near) {
    constexpr double turn = 2 * std::numbers::pi, close = 1e-4;
    return -std::ceil((angle - near) / turn - 0.5 - close);
}

/// How many derivatives of the pose a signal takes itself. Signals may be made of any others but not of themselves.
inline std::size_t order_of(std::span<const Signal> signals, std::size_t signal) {
    const Signal& s = signals[signal];
    switch (s.kind) {
        case Signal::Kind::speed: return 1;
        case Signal::Kind::acceleration:
        case Signal::Kind::curvature: return 2;
        case Signal::Kind::ratio: return std::max(order_of(signals, s.of), order_of(signals, s.to));
        case Signal::Kind::error: return order_of(signals, s.of);
        case Signal::Kind::sum: {
            std::size_t most = 0;
            for (const Signal::Term& term : s.terms)
                most = std::max(most, order_of(signals, term.signal));
            return most;
        }
        default: return 0;
    }
}

/// Whether a signal is the size of a vector that moves: where that vanishes the signal has a corner.
inline bool is_size(const Signal& s) {
    switch (s.kind) {
        case Signal::Kind::radius:
        case Signal::Kind::from_place:
        case Signal::Kind::distance:
        case Signal::Kind::speed:
        case Signal::Kind::acceleration: return true;
        default: return false;
    }
}

/// Whether a test holds of any of the signals by which a signal, or one that it is made of, is divided.
template <class Test>
bool any_divisor(std::span<const Signal> signals, std::size_t signal, const Test& test) {
    const Signal& s = signals[signal];
    const auto in = [&](std::size_t of) { return any_divisor(signals, of, test); };
    switch (s.kind) {
        case Signal::Kind::ratio: return in(s.of) || in(s.to) || test(s.to);
        case Signal::Kind::error: return in(s.of);
        case Signal::Kind::sum:
            return std::any_of(s.terms.begin(), s.terms.end(),
                               [&](const Signal::Term& term) { return in(term.signal); });
        default: return false;
    }
}

/// Whether a test holds of any curvature that a signal is, or is made of: such are divided by a velocity.
template <class Test>
bool any_curvature(std::span<const Signal> signals, std::size_t signal, const Test& test) {
    const Signal& s = signals[signal];
    const auto in = [&](std::size_t of) { return any_curvature(signals, of, test); };
    switch (s.kind) {
        case Signal::Kind::curvature: return test(signal);
        case Signal::Kind::ratio: return in(s.of) || in(s.to);
        case Signal::Kind::error: return in(s.of);
        case Signal::Kind::sum:
            return std::any_of(s.terms.begin(), s.terms.end(),
                               [&](const Signal::Term& term) { return in(term.signal); });
        default: return false;
    }
}

/// Whether a signal is an angle that is the same where it is a whole turn more: of a link, or a sum of such with whole
/// factors.
inline bool turns_are_alike(std::span<const Signal> signals, std::size_t signal) {
    const Signal& s = signals[signal];
    if (s.kind == Signal::Kind::angle) return true;
    return s.kind == Signal::Kind::sum && std::all_of(s.terms.begin(), s.terms.end(), [&](const Signal::Term& term) {
               return term.factor == std::round(term.factor) && turns_are_alike(signals, term.signal);
           });
}

/// What a signal is asked to be over a stretch of the master's inputs: start + range part(share), where share is the
/// part of the stretch that is passed, and part a sum of Chebyshev polynomials of 2 share - 1.
template <class T>
struct Wanted {
    T from = T(0);  ///< the input at which the stretch begins
    T way = T(1);   ///< how far it goes, of either sign
    T start = T(0);
    T range = T(0);
    std::span<const double> part{};  ///< as long as this is used

    T at(const T& input) const {
        const T share = (input - from) / way;
        return start + range * chebyshev_value(part, T(T(2.0) * share - T(1.0)));
    }
};

/// How a linkage stands in the drawing: its frame's origin there, the angle of its x axis, the size of its unit.
template <class T>
struct Placing {
    Vector<T> origin{T(0), T(0)};
    T tilt = T(0);
    T scale = T(1);
};

/// The transmission angle of a dyad, in [0, pi]: between two links, 90 degrees less the angle of rod and line, of a
/// line that passes a pin the angle whose cosine is offset over distance, of two lines the angle between them. From the
/// margins, whose products are the squares of its half-angle functions. Exact at a limit (Driven::sides 0).
template <class T>
T transmission_angle(const Driven<T>& driven, std::size_t margin) {
    using std::abs, std::atan2;
    std::size_t i = 0;
    while (driven.order.steps[i].margin != margin)
        ++i;
    const Step& step = driven.order.steps[i];
    const Sized<T>& size =
        step.is_extended() ? detail::extended_sizes(step, driven.sizes[i], driven.inputs()) : driven.sizes[i];
    const bool circles = step.kind == Step::Kind::dyad && step.second.kind == Locus::Kind::circle;
    const bool lines =
        step.kind == Step::Kind::tied || (step.kind == Step::Kind::dyad && step.first.kind != Locus::Kind::circle);
    if (lines) {
        const Vector<T> a = detail::locus_line(step.first, size.first, driven.pose).direction,
                        b = detail::locus_line(step.second, size.second, driven.pose).direction;
        return atan2(T(abs(cross(a, b))), dot(a, b));
    }
    T sine = driven.pose.margins[margin].outer, cosine = driven.pose.margins[margin].inner;
    if (circles) std::swap(sine, cosine);
    if (step.choice != none && driven.sides[step.choice] == 0) return sine < cosine ? T(0) : pi<T>();
    if (circles) {
        const Vector<T> apart = driven.pose.pins[step.second.centre] - driven.pose.pins[step.first.centre];
        const T d = hypotenuse(apart.x, apart.y);
        sine = sine * T(d + abs(T(size.first.length - size.second.length)));
        cosine = cosine * T(d + size.first.length + size.second.length);
    }
    return T(2) * atan2(root_or_zero(sine), root_or_zero(cosine));
}

/// The signals of a linkage of given dimensions.
template <class T>
class SignalValues {
    static constexpr bool is_series = requires(const T& number) { slope_of(number); };

public:
    /// The signals must outlive this. `lines` of slides are taken from the structure and its numbers.
    SignalValues(const Structure& s, std::span<const Signal> all, std::span<const T> numbers, const Placing<T>& placing)
        : signals(all), placing_(placing), tilt_(unit_at(placing.tilt)), whole_turns(all.size(), 0.0) {
        for (const Slide& slide : s.slides)
            slides_.push_back(
                {slide.link, slide.line.on, direction_of(slide.line, numbers), place_of(slide.line.through, numbers)});
    }

    /// In the pose of `driven`; angles are those near turns of links (turns.h), in (-pi, pi] where there are none.
    T value(std::size_t signal, const Driven<T>& driven, std::span<const double> near = {}) const {
        using Kind = Signal::Kind;
        const Signal& s = signals[signal];
        const Pose<T>& pose = driven.pose;
        switch (s.kind) {
            case Kind::angle: return angle(signal, pose, near);
            case Kind::x: return coordinates(s, pose).x;
            case Kind::y: return coordinates(s, pose).y;
            case Kind::along: return dot(coordinates(s, pose), unit_at(T(s.number)));
            case Kind::radius:
            case Kind::from_place: return size(vector(signal, pose));
            case Kind::distance: return placing_.scale * size(vector(signal, pose));
            case Kind::from_line: {
                const Vector<T> line = pose.pins[s.end] - pose.pins[s.to];
                const T height = cross(line, pose.pins[s.of] - pose.pins[s.to]);
                return placing_.scale * T(height / hypotenuse(line.x, line.y));
            }
            case Kind::place_from_line: {
                const Vector<T> line = turned(pose.pins[s.end] - pose.pins[s.to], tilt_);
                const T height = cross(line, place_of_signal(s) - in_drawing(pose.pins[s.to]));
                return height / hypotenuse(line.x, line.y);
            }
            case Kind::slide: {
                const Line& line = slides_[s.of];
                const LinkPlace<T>& on = pose.links[line.on];
                const Vector<T> way = pose.links[line.link].origin - on.at(line.through);
                return placing_.scale * dot(turned(line.direction, on.along), way);
            }
            case Kind::speed:
            case Kind::acceleration:
                if constexpr (is_series) return placing_.scale * size(vector(signal, pose));
                return T(std::numeric_limits<double>::quiet_NaN());
            case Kind::curvature:
                if constexpr (is_series) return curvature(vector(signal, pose)) / placing_.scale;
                return T(std::numeric_limits<double>::quiet_NaN());
            case Kind::transmission_angle: return transmission_angle(driven, s.of);
            case Kind::sum: {
                T sum(0);
                for (const Signal::Term& term : s.terms)
                    sum = sum + T(term.factor) * value(term.signal, driven, near);
                return sum;
            }
            case Kind::ratio: return value(s.of, driven, near) / value(s.to, driven, near);
            case Kind::error: return value(s.of, driven, near) - wanted.at(driven.inputs().front());
        }
        return T(0);
    }

    /// The vector whose size, in lengths of its own, such a signal is (is_size); of a curvature the velocity. Speeds
    /// need a series.
    Vector<T> vector(std::size_t signal, const Pose<T>& pose) const {
        const Signal& s = signals[signal];
        if (s.kind == Signal::Kind::radius) return coordinates(s, pose);
        if (s.kind == Signal::Kind::from_place) return coordinates(s, pose) - place_of_signal(s);
        if (s.kind == Signal::Kind::distance) return pose.pins[s.to] - pose.pins[s.of];
        Vector<T> by = pose.pins[s.of];
        if constexpr (is_series)
            for (int order = s.kind == Signal::Kind::acceleration ? 2 : 1; order > 0; --order)
                by = {slope_of(by.x), slope_of(by.y)};
        return by;
    }

    /// Angles are counted so that at turns of links at the start of motion each is in (near - pi, near + pi].
    void start_at(std::span<const double> turns) {
        for (std::size_t i = 0; i < signals.size(); ++i)
            if (signals[i].kind == Signal::Kind::angle)
                whole_turns[i] = whole_turns_to(turns[signals[i].of] - turns[signals[i].to], signals[i].number);
    }

    std::span<const Signal> signals;
    Wanted<T> wanted{};  ///< of signals that are errors
    BesideRest beside_rest{};

private:
    struct Line {
        std::size_t link, on;
        Vector<T> direction, through;
    };

    T angle(std::size_t signal, const Pose<T>& pose, std::span<const double> near) const {
        using std::atan2;
        const Signal& s = signals[signal];
        const Vector<T> along = turned(pose.links[s.of].along, detail::conjugate(pose.links[s.to].along));
        const T principal = atan2(along.y, along.x);
        if (near.empty()) return principal;
        const T turn = detail::unwound(principal, near[s.of] - near[s.to]);
        return whole_turns[signal] == 0 ? turn : T(turn + T(2 * whole_turns[signal]) * pi<T>());
    }
    Vector<T> in_drawing(const Vector<T>& at) const { return placing_.origin + placing_.scale * turned(at, tilt_); }
    static Vector<T> place_of_signal(const Signal& s) { return {T(s.place.x), T(s.place.y)}; }
    Vector<T> coordinates(const Signal& s, const Pose<T>& pose) const {
        const Vector<T>& at = pose.pins[s.of];
        if (s.on == none) return in_drawing(at);
        const LinkPlace<T>& link = pose.links[s.on];
        return placing_.scale * turned(at - link.origin, detail::conjugate(link.along));
    }
    /// Of the path that is passed with a velocity v: (x' y'' - y' x'') / (x'^2 + y'^2)^(3/2) (do Carmo, Differential
    /// Geometry of Curves and Surfaces, section 1-5, exercise 12).
    static T curvature(const Vector<T>& v) {
        const T speed = hypotenuse(v.x, v.y);
        return cross(v, {slope_of(v.x), slope_of(v.y)}) / (speed * speed * speed);
    }
    T size(const Vector<T>& v) const {
        if constexpr (is_series)
            if (beside_rest.time != 0 && is_at_rest(v, beside_rest.near))
                return size_beside_rest(v, beside_rest.time > 0);
        return hypotenuse(v.x, v.y);
    }

    Placing<T> placing_;
    Vector<T> tilt_;
    std::vector<double> whole_turns;
    std::vector<Line> slides_;
};

}  // namespace mechwright::linkage
