#pragma once
/// \file
/// The stationary points of a measure over a continuous motion, for verification: samples in double that find every
/// change of sign of its slope, then a bracketed solution in fifty digits (method of Alefeld, Potra and Shi, ACM TOMS
/// algorithm 748). The searches of the analysis are not used here, so that verification does not share their mistakes.

#include <algorithm>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The part of a motion that its extremes are sought in: at most one turn of the crank, radians.
struct Sweep {
    double from;
    double to;
};

/// A full turn, or the range of the motion; of a range of more than a turn the first turn says everything.
inline Sweep sweep_of(const Motion& motion) {
    constexpr double turn = 2 * std::numbers::pi;
    // Half a degree more than the turn, so that what lies on its seam is seen too.
    if (motion.full_turn) return {-1, turn - 1 + std::numbers::pi / 360};
    return {motion.from, std::min(motion.to, motion.from + turn)};
}

/// Whether a motion is one at all: finite, not empty, and not so far from zero that angles have lost their digits.
inline bool is_motion(const Motion& motion) {
    constexpr double far = 1e6;
    return motion.full_turn || (motion.from <= motion.to && std::abs(motion.from) < far && std::abs(motion.to) < far);
}

/// Crank angles in increasing order over a sweep: even steps of half a degree, and steps that shrink by halves towards
/// the ends, the multiples of pi, where a linkage close to a change point or a toggle has its fast motion, and other
/// such places.
std::vector<double> sample_angles(const Sweep& sweep, const std::vector<double>& fast = {});

/// An interval in which a function changes its sign.
struct Bracket {
    double left;
    double right;
};

namespace detail {

/// Sixteen steps into an interval in which |f| dips, again and again around the lowest, until f changes its sign there.
template <class Function>
void search_dip(const Function& f, Bracket dip, bool positive, std::vector<Bracket>& found) {
    constexpr int steps = 16;
    constexpr int depth = 10;
    for (int level = 0; level < depth; ++level) {
        const double step = (dip.right - dip.left) / steps;
        double lowest_at = dip.left, lowest = std::numeric_limits<double>::infinity();
        for (int i = 1; i < steps; ++i) {
            const double x = dip.left + i * step;
            const double value = f(x);
            if ((value > 0) != positive) {
                found.push_back({dip.left, x});
                found.push_back({x, dip.right});
                return;
            }
            if (std::abs(value) < lowest) {
                lowest = std::abs(value);
                lowest_at = x;
            }
        }
        dip = {lowest_at - step, lowest_at + step};
    }
}

/// A zero between a and b, where f has the values fa and fb of different signs (zero counts as negative), to `error`
/// times the crank angle or one radian, whichever is greater. Where f has no value it counts as negative; with values
/// that bracket nothing the middle.
template <class T, class Function>
T zero_between_signs(const Function& f, const T& a, const T& b, const T& fa, const T& fb, double error) {
    using std::abs, std::isfinite, std::max;
    if (fa == 0) return a;
    if (fb == 0) return b;
    if (!(a < b) || !isfinite(fa) || !isfinite(fb) || (fa > 0) == (fb > 0)) return (a + b) / 2;
    // The method interpolates: it must meet no number that is not finite.
    const auto finite = [&](const T& x) {
        const T y = f(x);
        return isfinite(y) ? y : T(y > 0 ? 1 : -1);
    };
    const auto near = [&](const T& x, const T& y) { return y - x <= error * max(T(1), T(abs(x))); };
    std::uintmax_t most = 300;
    const auto [left, right] = boost::math::tools::toms748_solve(finite, a, b, fa, fb, near, most);
    return (left + right) / 2;
}

}  // namespace detail

/// All brackets of zeros of f between samples (increasing): changes of sign (zero counts as negative), and pairs of
/// zeros between samples where |f| dips without changing its sign. Where f has no finite value at a sample, as at the
/// very end of a motion, nothing is bracketed there.
template <class Function>
std::vector<Bracket> brackets_of_zeros(const Function& f, const std::vector<double>& samples) {
    std::vector<Bracket> found;
    std::vector<double> values;
    values.reserve(samples.size());
    for (const double x : samples)
        values.push_back(f(x));
    for (std::size_t i = 1; i < samples.size(); ++i) {
        if (!std::isfinite(values[i - 1]) || !std::isfinite(values[i])) continue;
        const bool positive = values[i] > 0;
        if ((values[i - 1] > 0) != positive) {
            found.push_back({samples[i - 1], samples[i]});
            continue;
        }
        if (i + 1 == samples.size() || !std::isfinite(values[i + 1]) || (values[i + 1] > 0) != positive) continue;
        const double size = std::abs(values[i]);
        if (size <= std::abs(values[i - 1]) && size <= std::abs(values[i + 1]))
            detail::search_dip(f, {samples[i - 1], samples[i + 1]}, positive, found);
    }
    return found;
}

/// A zero in a bracket: first in double, then to about forty digits, in the bracket or close to it. Where fifty digits
/// show no change of sign (the one seen in double was rounding) the place found in double.
template <class Rough, class Fine>
Digits50 polished_zero(const Rough& rough, const Fine& fine, const Bracket& bracket) {
    using std::isfinite;
    const auto changes = [](const auto& a, const auto& b) { return isfinite(a) && isfinite(b) && (a > 0) != (b > 0); };
    double middle = 0.5 * (bracket.left + bracket.right);
    const double rough_left = rough(bracket.left), rough_right = rough(bracket.right);
    if (changes(rough_left, rough_right))
        middle = detail::zero_between_signs(rough, bracket.left, bracket.right, rough_left, rough_right, 4e-16);

    const auto zero_in = [&](double from, double to) -> std::optional<Digits50> {
        const Digits50 left(from), right(to);
        const Digits50 value_left = fine(left), value_right = fine(right);
        if (!changes(value_left, value_right)) return std::nullopt;
        return detail::zero_between_signs(fine, left, right, value_left, value_right, 1e-42);
    };
    // Where the function is flat in double, the zero that its rounding hides is farther away.
    constexpr double farthest = 1e-6;
    for (double reach = 1e-12; reach < farthest; reach *= 16)
        if (const auto zero = zero_in(middle - reach, middle + reach)) return *zero;
    return zero_in(bracket.left, bracket.right).value_or(Digits50(middle));
}

/// All zeros of a slope over a sweep. `rough` is the slope in double, `fine` in fifty digits. No mechanism has as many
/// stationary points as make a slope rounding noise; those where the measure is constant are left in double.
template <class Rough, class Fine>
std::vector<Digits50> stationary_points(const Sweep& sweep, const Rough& rough, const Fine& fine,
                                        const std::vector<double>& fast = {}) {
    constexpr std::size_t noise = 64;
    const auto brackets = brackets_of_zeros(rough, sample_angles(sweep, fast));
    std::vector<Digits50> points;
    points.reserve(brackets.size());
    const auto is_flat = [&](double x) { return abs(fine(Digits50(x))) < 1e-40; };
    for (const Bracket& bracket : brackets) {
        const bool is_noise = brackets.size() >= noise && is_flat(bracket.left) && is_flat(bracket.right);
        points.push_back(is_noise ? Digits50(bracket.right) : polished_zero(rough, fine, bracket));
    }
    return points;
}

}  // namespace mechwright
