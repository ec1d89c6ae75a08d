#pragma once
/// \file
/// The slider-crank as a function generator: the position of its ram against the function asked for. The output's scale
/// is a length along the slide, counted from the crank pivot.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

#include "analysis/slider_crank.h"
#include "synthesis/target/function/formulas.h"
#include "synthesis/target/function/loop_row.h"

namespace mechwright::quick_return {

/// How many of the first dimensions are crank, rod and offset.
inline constexpr std::size_t ram_links = 3;

/// The arguments of what is judged over the input range: these, then its start and the range.
inline constexpr std::size_t read_over_input_count = ram_links + 2;

/// The generator of target/function/formulas.h: the position of the ram less the one that the function asks for.
struct RamPosition {
    static constexpr std::size_t reads = ram_links + 4;
    template <class T>
    static T error(const std::array<T, reads>& x, std::size_t, const T& share, const T& part) {
        const SliderCrank<T> m{x[0], x[1], x[2]};
        return pose(m, T(x[3] + x[4] * share)).position - (x[5] + x[6] * part);
    }
};

/// The crank directions in which margins and transmission angle can be extreme: both ends of the input range, and where
/// the crank stands square to the slide; where it does not pass there, the end nearer to that.
template <class T>
std::array<Vector<T>, 4> input_places(const std::array<T, read_over_input_count>& x) {
    using std::cos, std::sin;
    const T first = x[3], last = x[3] + x[4];
    const auto end = [&](const T& angle) { return Vector<T>{cos(angle), sin(angle)}; };
    const auto nearest = [&](double angle, const Vector<T>& there) {
        if (passes(value_of(first), value_of(last), angle)) return there;
        return end(nearer_to_first(value_of(first), value_of(last), angle) ? first : last);
    };
    return {end(first), end(last), nearest(std::numbers::pi / 2, {T(0), T(1)}),
            nearest(-std::numbers::pi / 2, {T(0), T(-1)})};
}

/// What must be >= 0 for the rod to reach the slide over the whole input range: both margins at its ends; where the
/// crank pin is farthest to the left of the slide the one, where it is farthest to the right the other can be less.
struct RamInputMargin {
    static constexpr std::size_t reads = read_over_input_count;
    static constexpr std::size_t most = 6;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, reads>& x, Components<T> out) {
        const auto [first, last, leftmost, rightmost] = input_places(x);
        const auto at = [&](const Vector<T>& place) { return pose(SliderCrank<T>{x[0], x[1], x[2]}, place); };
        const auto at_first = at(first), at_last = at(last);
        out[0] = at_first.left;
        out[1] = at_first.right;
        out[2] = at_last.left;
        out[3] = at_last.right;
        out[4] = at(leftmost).right;
        out[5] = at(rightmost).left;
        return most;
    }
};

/// The transmission angles of InputTransmission, wherever they can be least.
struct RodTransmission {
    static constexpr std::size_t reads = read_over_input_count;
    template <class T>
    static std::array<T, 4> angles(std::size_t, const std::array<T, reads>& x) {
        const auto at = input_places(x);
        std::array<T, 4> all;
        for (std::size_t k = 0; k < at.size(); ++k)
            all[k] = transmission_angle(pose(SliderCrank<T>{x[0], x[1], x[2]}, at[k]));
        return all;
    }
};

/// The position of the ram from the right triangle of rod and slide (target/function/formulas_again.h).
struct RamPositionAgain {
    std::span<const Digits50> arguments;

    RamPositionAgain(const Motion&, std::span<const Digits50> all) : arguments(all) {}

    template <class T>
    T error(const T& input, const T& asked) const {
        using std::cos, std::sin, std::sqrt;
        const T crank(arguments[0]), rod(arguments[1]), offset(arguments[2]);
        const T height = offset - crank * sin(input);
        const T run_square = (rod - height) * (rod + height);
        if (!(run_square >= 0)) return std::numeric_limits<T>::quiet_NaN();
        return crank * cos(input) + sqrt(run_square) - asked;
    }
};

/// The loop equation of the slider-crank, s being the position of its ram:
///
///     k1 s cos(input) + k2 sin(input) + k3 = s^2,  k1 = 2 crank, k2 = 2 crank offset, k3 = rod^2 - crank^2 - offset^2.
template <class T>
LoopRow<T> ram_loop_row(const T& input, const T& s) {
    using std::cos, std::sin;
    const T none(0.0);
    return {{s * cos(input), sin(input), T(1.0), s * s},
            {-(s * sin(input)), cos(input), none, none},
            {cos(input), none, none, T(2.0) * s}};
}

/// Crank, rod and offset for given scales by least squares of the loop equation. A negative crank points the other way:
/// the input's scale is then turned by half a turn where `turns_input` allows. Returns false where no lengths follow.
bool fit_ram_function(const FunctionTarget& f, std::span<double> dimensions, std::span<double, 4> scales,
                      bool turns_input, bool turns_output);

}  // namespace mechwright::quick_return
