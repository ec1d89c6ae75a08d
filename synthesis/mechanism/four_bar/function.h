#pragma once
/// \file
/// The four-bar as a function generator: its rocker angle against the function asked for. Angles are counted from the
/// ground link.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>

#include "analysis/four_bar.h"
#include "analysis/numbers/unit_vector.h"
#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/mechanism/four_bar/linkage_again.h"
#include "synthesis/target/function/formulas.h"
#include "synthesis/target/function/loop_row.h"

namespace mechwright::four_bar {

/// The arguments of what is judged over the input range: the links, then its start and the range.
inline constexpr std::size_t read_over_input_count = links + 2;

/// The generator of target/function/formulas.h: the rocker angle less the angle that the function asks for, in (-pi,
/// pi].
struct RockerAngle {
    static constexpr std::size_t reads = links + 4;
    static constexpr bool wraps = true;
    template <class T>
    static T error(const std::array<T, reads>& x, std::size_t assembly, const T& share, const T& part) {
        using std::atan2;
        const auto p = pose(FourBar<T>{x[0], x[1], x[2], x[3]}, T(x[4] + x[5] * share),
                            assembly == 0 ? Assembly::open : Assembly::crossed);
        const T asked = x[6] + x[7] * part;
        const Vector<T> direction = unit_at(asked);
        return atan2(cross(direction, p.rocker), dot(direction, p.rocker));
    }
};

/// The half crank angles at which margins and transmission angle can be extreme: both ends of the input range, and
/// where the crank passes the ground line; where it does not pass, the end nearer to it, so that nothing jumps when it
/// begins to.
template <class T>
std::array<HalfTurn<T>, 4> input_places(const std::array<T, read_over_input_count>& x) {
    const T first = x[4], last = x[4] + x[5];
    const auto nearest = [&](double angle, const HalfTurn<T>& there) {
        if (passes(value_of(first), value_of(last), angle)) return there;
        return half_turn(nearer_to_first(value_of(first), value_of(last), angle) ? first : last);
    };
    return {half_turn(first), half_turn(last), nearest(0, {T(1), T(0)}), nearest(std::numbers::pi, {T(0), T(1)})};
}

/// What must be >= 0 for the linkage to assemble over the whole input range: both margins at its ends; where crank pin
/// and rocker pivot are nearest the one, where they are farthest the other can be less between them.
struct InputMargin {
    static constexpr std::size_t reads = read_over_input_count;
    static constexpr std::size_t most = 6;
    template <class T>
    static std::size_t components(const Motion&, const std::array<T, reads>& x, Components<T> out) {
        const auto [first, last, nearest, farthest] = input_places(x);
        const auto at = [&](const HalfTurn<T>& place) {
            return assembly_margins(FourBar<T>{x[0], x[1], x[2], x[3]}, place);
        };
        const auto at_first = at(first), at_last = at(last);
        out[0] = at_first.stretch;
        out[1] = at_first.fold;
        out[2] = at_last.stretch;
        out[3] = at_last.fold;
        out[4] = at(nearest).fold;
        out[5] = at(farthest).stretch;
        return most;
    }
};

/// The transmission angles of InputTransmission.
struct RockerTransmission {
    static constexpr std::size_t reads = read_over_input_count;
    template <class T>
    static std::array<T, 4> angles(std::size_t, const std::array<T, reads>& x) {
        const auto at = input_places(x);
        std::array<T, 4> all;
        for (std::size_t k = 0; k < at.size(); ++k)
            all[k] = transmission_angle(FourBar<T>{x[0], x[1], x[2], x[3]}, at[k]);
        return all;
    }
};

/// Freudenstein's equation
///
///     k1 cos(output) - k2 cos(input) + k3 = cos(input - output),  k1 = ground / crank, k2 = ground / rocker,
///
/// with k3 = (ground^2 + crank^2 - coupler^2 + rocker^2) / (2 crank rocker).
template <class T>
LoopRow<T> rocker_loop_row(const T& input, const T& output) {
    using std::cos, std::sin;
    const T difference = input - output, none(0.0);
    return {{cos(output), -cos(input), T(1.0), cos(difference)},
            {none, sin(input), none, -sin(difference)},
            {-sin(output), none, none, sin(difference)}};
}

/// Lengths for given scales by least squares of Freudenstein's equation. A negative k means that crank or rocker point
/// the other way: its scale is then turned by half a turn where `turns_input` or `turns_output` allow. The ground link
/// is kept. Returns false where no lengths follow.
bool fit_function(const FunctionTarget& f, std::span<double> dimensions, std::span<double, 4> scales, bool turns_input,
                  bool turns_output);

/// The rocker angle by the pose of linkage_again.h (target/function/formulas_again.h).
struct RockerAngleAgain {
    again::Linkage<Digits50> fine;
    again::Linkage<double> rough;

    RockerAngleAgain(const Motion& motion, std::span<const Digits50> arguments)
        : fine(again::linkage(motion.assembly, arguments)), rough(again::rounded<double>(fine)) {}

    template <class T>
    T error(const T& input, const T& asked) const {
        using std::atan2;
        again::Pose<T> p;
        if constexpr (std::is_same_v<T, double>)
            p = again::pose(rough, input);
        else
            p = again::pose(fine, input);
        if (!p.assembled()) return std::numeric_limits<T>::quiet_NaN();
        const Vector<T> direction = unit_at(asked);
        return atan2(cross(direction, p.rocker), dot(direction, p.rocker));
    }
};

}  // namespace mechwright::four_bar
