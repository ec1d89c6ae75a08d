#pragma once
/// \file
/// The geometry of the ram-driving mechanisms rebuilt from the problem format's definitions, for verification alone:
/// the direction of the arm (or crank) that pulls the rod, in the frame of the slide, and from it the ram. Numbers are
/// Taylor series in the crank angle, so that no formula for a velocity stands here. Differences that would lose digits
/// in double are formed in fifty digits first, so that the samples that look for brackets can be trusted.

#include <fmt/format.h>

#include <span>
#include <string>
#include <vector>

#include "synthesis/mechanism/mechanism.h"
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

/// Each kind's geometry stands in its folder: the numbers that its arm's direction follows from, `arm_direction`
/// itself, and the rod, all of dimensions whose lengths are divided by `unit`; whether it works, what is checked of its
/// input, and what must be >= 0 there.

/// What a kind of mechanism leaves out where it has nothing of its own.
struct UsualGeometry {
    static constexpr std::size_t input_margins = 0;
    static constexpr bool has_four_bar = false;
    static std::vector<Check> checks_of_input(const Motion&, std::span<const Digits50>) { return {}; }
    /// The detail of a check of two lengths.
    static std::string by(const Digits50& length) {
        return fmt::format("by {:.9g} (length)", length.convert_to<double>());
    }
};

/// A mechanism in fifty digits and in double, lengths over a power of two.
template <class Geometry>
struct Rebuilt {
    static constexpr double dead_within = 8e-15;  ///< of margins, relative to the links
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
        return !(std::min(s.right.c[0], s.left.c[0]) > dead_within * (rod.arm + rod.rod + abs(rod.offset)));
    }
    /// Whether that is so, or the input is at a toggle: the ram is infinitely fast.
    bool is_dead_position(const RamState<Digits50>& s, const Digits50& crank_angle) const {
        if constexpr (Geometry::input_margins > 0)
            for (const Digits50& margin : Geometry::margins_of_input(input, crank_angle))
                if (abs(margin) < dead_within) return true;
        return rod_is_square(s);
    }

    RamState<double> at(double crank_angle) const {
        return ram_state(plain_rod, Geometry::arm_direction(plain_input, Jet<double>::crank_angle(crank_angle)));
    }
};

}  // namespace mechwright::quick_return::again
