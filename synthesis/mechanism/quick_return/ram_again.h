#pragma once
/// \file
/// The geometry of the ram-driving mechanisms rebuilt from the problem format's definitions, for verification alone:
/// the direction of the arm (or crank) that pulls the rod, in the frame of the slide, and from it the ram. Numbers are
/// Taylor series in the crank angle, so that no formula for a velocity stands here. Differences that would lose digits
/// in double are formed in fifty digits first, so that the samples that look for brackets can be trusted.

#include <span>

#include "synthesis/mechanism/four_bar/linkage_again.h"
#include "synthesis/mechanism/quick_return/jet.h"

namespace mechwright::quick_return::again {

/// Arm, rod and slide line, whatever turns the arm.
template <class T>
struct Rod {
    T arm, rod, offset;
    T spare_right;  ///< rod - offset - arm
    T spare_left;   ///< rod + offset - arm
};

template <class To, class From>
Rod<To> rounded(const Rod<From>& m) {
    return {To(m.arm), To(m.rod), To(m.offset), To(m.spare_right), To(m.spare_left)};
}

inline Rod<Digits50> rod_of(const Digits50& arm, const Digits50& rod, const Digits50& offset) {
    return {arm, rod, offset, rod - offset - arm, rod + offset - arm};
}

/// At one crank angle; `height` is that of the ram over the rod pin, `right` and `left` the rod less and plus it.
template <class T>
struct RamState {
    Jet<T> position;
    Jet<T> height;
    Jet<T> right, left;
    Jet<T> pin;  ///< along the slide, from the pivot of the arm to the rod pin
    Jet<T> run;  ///< along the slide, from rod pin to ram
};

/// `arm` is a unit vector.
template <class T>
RamState<T> ram_state(const Rod<T>& m, const Vector<Jet<T>>& arm) {
    using J = Jet<T>;
    const J one(T(1));
    // 1 + y and 1 - y; where one of them is small it follows from x^2 = (1 + y)(1 - y).
    const bool down = arm.y.c[0] < 0;
    const J far = down ? one - arm.y : one + arm.y;
    const J near = arm.x * arm.x / far;
    RamState<T> s;
    s.height = J(m.offset) - J(m.arm) * arm.y;
    s.right = J(m.spare_right) + J(m.arm) * (down ? near : far);
    s.left = J(m.spare_left) + J(m.arm) * (down ? far : near);
    s.run = sqrt(s.right * s.left);
    s.pin = J(m.arm) * arm.x;
    s.position = s.pin + s.run;
    return s;
}

/// A vector seen from a frame that is turned by an angle with this cosine and sine.
template <class T>
Vector<Jet<T>> seen_from(const Vector<Jet<T>>& v, const T& cosine, const T& sine) {
    return turned(v, Vector<Jet<T>>{Jet<T>(cosine), Jet<T>(T(-sine))});
}

/// Unit vector from the pivot of a slotted arm to the block, counted from the line of centres.
template <class T>
Vector<Jet<T>> slot_direction(const T& difference, const T& crank, const Jet<T>& crank_angle) {
    const auto half = sine_cosine(crank_angle / Jet<T>(2));
    const Jet<T> along = Jet<T>(difference) + Jet<T>(T(2 * crank)) * half.cosine * half.cosine;
    const Jet<T> across = Jet<T>(T(2 * crank)) * half.sine * half.cosine;
    const Jet<T> reach = sqrt(along * along + across * across);
    return {along / reach, across / reach};
}

/// Each geometry: the numbers that its arm's direction follows from, `arm_direction` itself, and the rod, all of
/// dimensions whose lengths are divided by `unit`.
struct SliderCrankGeometry {
    static constexpr std::array<std::size_t, 2> links{0, 1};
    static constexpr std::array<std::size_t, 2> lengths{0, 1};

    template <class T>
    struct Input {};
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>&) {
        return {};
    }
    static Input<Digits50> input(std::size_t, std::span<const Digits50>, const Digits50&) { return {}; }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[0] / unit, d[1] / unit, d[2] / unit);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>&, const Jet<T>& crank_angle) {
        const auto angle = sine_cosine(crank_angle);
        return {angle.cosine, angle.sine};
    }
};

/// The slide points to the left of the line of centres.
struct CrankShaperGeometry {
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    static constexpr std::array<std::size_t, 5> lengths{0, 1, 2, 3, 4};

    template <class T>
    struct Input {
        T difference, crank;
    };
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>& m) {
        return {To(m.difference), To(m.crank)};
    }
    static Input<Digits50> input(std::size_t, std::span<const Digits50> d, const Digits50& unit) {
        return {(d[0] - d[1]) / unit, d[1] / unit};
    }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[2] / unit, d[3] / unit, -d[4] / unit);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>& m, const Jet<T>& crank_angle) {
        const auto slot = slot_direction(m.difference, m.crank, crank_angle);
        return {slot.y, -slot.x};
    }
};

/// The arm lies opposite the slot.
struct WhitworthGeometry {
    static constexpr std::array<std::size_t, 4> links{0, 1, 2, 3};
    static constexpr std::array<std::size_t, 4> lengths{0, 1, 2, 3};

    template <class T>
    struct Input {
        T difference, crank, slide_cosine, slide_sine;
    };
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>& m) {
        return {To(m.difference), To(m.crank), To(m.slide_cosine), To(m.slide_sine)};
    }
    static Input<Digits50> input(std::size_t, std::span<const Digits50> d, const Digits50& unit) {
        return {(d[0] - d[1]) / unit, d[1] / unit, cos(d[4]), sin(d[4])};
    }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[2] / unit, d[3] / unit, 0);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>& m, const Jet<T>& crank_angle) {
        return seen_from(-slot_direction(m.difference, m.crank, crank_angle), m.slide_cosine, m.slide_sine);
    }
};

/// The arm turns with the rocker of a four-bar.
struct DragLinkGeometry {
    static constexpr std::array<std::size_t, 6> links{0, 1, 2, 3, 4, 6};
    static constexpr std::array<std::size_t, 6> lengths{0, 1, 2, 3, 4, 6};

    template <class T>
    struct Input {
        four_bar::again::Linkage<T> linkage;
        T turn_cosine, turn_sine;  ///< from arm angle to slide angle
    };
    template <class To, class From>
    static Input<To> rounded_input(const Input<From>& m) {
        return {four_bar::again::rounded<To>(m.linkage), To(m.turn_cosine), To(m.turn_sine)};
    }
    static Input<Digits50> input(std::size_t assembly, std::span<const Digits50> d, const Digits50&) {
        const Digits50 turn = d[7] - d[5];
        return {four_bar::again::linkage(assembly, d.first(4)), cos(turn), sin(turn)};
    }
    static Rod<Digits50> rod(std::span<const Digits50> d, const Digits50& unit) {
        return rod_of(d[4] / unit, d[6] / unit, d[8] / unit);
    }
    template <class T>
    static Vector<Jet<T>> arm_direction(const Input<T>& m, const Jet<T>& crank_angle) {
        const auto p = four_bar::again::pose(four_bar::again::rounded<Jet<T>>(m.linkage), crank_angle);
        const Jet<T> per_follower = Jet<T>(T(1)) / Jet<T>(m.linkage.rocker);
        return seen_from(per_follower * p.rocker, m.turn_cosine, m.turn_sine);
    }
};

/// A mechanism in fifty digits and in double, lengths over a power of two.
template <class Geometry>
struct Rebuilt {
    static constexpr double rounding = 8e-15;  ///< of margins, relative to the links
    Digits50 unit;
    typename Geometry::template Input<Digits50> input;
    Rod<Digits50> rod;
    typename Geometry::template Input<double> plain_input;
    Rod<double> plain_rod;

    Rebuilt(std::size_t assembly, std::span<const Digits50> dimensions) {
        Digits50 longest = 0;
        for (const std::size_t i : Geometry::lengths)
            longest = std::max(longest, dimensions[i]);
        int exponent = 0;
        frexp(longest, &exponent);
        unit = ldexp(Digits50(1), exponent);
        input = Geometry::input(assembly, dimensions, unit);
        rod = Geometry::rod(dimensions, unit);
        plain_input = Geometry::template rounded_input<double>(input);
        plain_rod = rounded<double>(rod);
    }

    RamState<Digits50> at(const Digits50& crank_angle) const {
        return ram_state(rod, Geometry::arm_direction(input, Jet<Digits50>::crank_angle(crank_angle)));
    }
    /// Whether the rod stands square to the slide, but for the rounding of a crank angle.
    bool rod_is_square(const RamState<Digits50>& s) const {
        return !(std::min(s.right.c[0], s.left.c[0]) > rounding * (rod.arm + rod.rod + abs(rod.offset)));
    }
    /// Whether that is so, or the four-bar of a drag link is at a toggle: the ram is infinitely fast.
    bool is_dead_position(const RamState<Digits50>& s, const Digits50& crank_angle) const {
        if constexpr (std::is_same_v<Geometry, DragLinkGeometry>) {
            const auto p = four_bar::again::pose(input.linkage, crank_angle);
            if (abs(p.stretch) < rounding || abs(p.fold) < rounding) return true;
        }
        return rod_is_square(s);
    }

    RamState<double> at(double crank_angle) const {
        return ram_state(plain_rod, Geometry::arm_direction(plain_input, Jet<double>::crank_angle(crank_angle)));
    }
};

}  // namespace mechwright::quick_return::again
