#pragma once
/// \file
/// function-max and function-rms measured again, for verification: by scanning and golden section in place of zeros of
/// the slope, by the adaptive rule of Gauss and Kronrod over another variable in fifty digits, and by the expression
/// itself in place of its Chebyshev series.
///
/// `Again` is the generator by formulas of its own: a constructor from the motion and the arguments, of which the last
/// four are the scales, or four from `static constexpr std::size_t scales` on; and `template <class T> T error(const T&
/// input, const T& asked) const`, its output less the one asked for, in double and in fifty digits; NaN where it does
/// not assemble.

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <cmath>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "analysis/numbers/golden_section.h"
#include "synthesis/mechanism/mechanism.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

namespace detail {

template <class Again>
std::span<const Digits50> scales_of(std::span<const Digits50> arguments) {
    if constexpr (requires { Again::scales; }) return arguments.subspan(Again::scales, 4);
    return arguments.last(4);
}

/// The structural error at shares of the range, by the expression itself.
template <class Again>
struct ErrorAgain {
    const FunctionTarget* f;  ///< null: the output asked for stays the same
    std::span<const Digits50> scales;
    Again generator;
    std::unique_ptr<ExpressionValues> y;
    double y_from = 0;
    double height = 1;

    ErrorAgain(const Motion& motion, std::span<const Digits50> d)
        : f(motion.function), scales(scales_of<Again>(d)), generator(motion, d) {
        if (f == nullptr || !f->parts.empty()) return;
        y = std::make_unique<ExpressionValues>(f->expression);
        y_from = (*y)(f->from);
        height = (*y)(f->to) - y_from;
    }

    std::span<const Vector<double>> samples() const {
        return f != nullptr ? std::span<const Vector<double>>(f->parts) : std::span<const Vector<double>>();
    }
    double part(double share) { return y ? ((*y)(f->from + share * (f->to - f->from)) - y_from) / height : 0; }

    template <class T>
    T error_as(double share, double part_of_way) const {
        return generator.error(T(T(scales[0]) + T(scales[1]) * T(share)),
                               T(T(scales[2]) + T(scales[3]) * T(part_of_way)));
    }
    template <class T>
    T size_as(double share, double part_of_way) const {
        using std::abs;
        return abs(error_as<T>(share, part_of_way));
    }

    double rough_size(double share) { return size_as<double>(share, part(share)); }

    /// The shares between which the error does not jump by a turn, ends included: its size has a kink where it does.
    std::vector<double> smooth_between() {
        constexpr int samples = 1024;
        constexpr double half_a_turn = boost::math::constants::pi<double>();
        const auto rough = [&](double share) { return error_as<double>(share, part(share)); };
        std::vector<double> ends{0};
        double last = rough(0);
        for (int i = 1; i <= samples; ++i) {
            double before = (i - 1.0) / samples, after = static_cast<double>(i) / samples;
            const double first = last;
            last = rough(after);
            if (!(std::abs(last - first) > half_a_turn)) continue;
            for (double middle = 0.5 * (before + after); before < middle && middle < after;
                 middle = 0.5 * (before + after))
                (std::abs(rough(middle) - first) > half_a_turn ? after : before) = middle;
            // What is no angle may change by as much on the way, but not at one place.
            if (std::abs(rough(after) - rough(before)) > half_a_turn) ends.push_back(after);
        }
        ends.push_back(1);
        return ends;
    }

    /// How far the square of the error is off, next to its mean: the expression is known in doubles alone, and of an
    /// error that is small against the output's range little is left.
    double relative_noise() {
        constexpr double units = 16 * std::numeric_limits<double>::epsilon();
        constexpr int steps = 64;
        double mean = 0;
        for (int i = 0; i < steps; ++i)
            mean += rough_size((i + 0.5) / steps) / steps;
        const double range = std::abs(scales[3].template convert_to<double>());
        const double noise = units * range * (1 + (y ? std::abs(y_from / height) : 0));
        return mean > noise ? 2 * noise / mean : 1;
    }
    Digits50 size(double share, double part_of_way) const { return size_as<Digits50>(share, part_of_way); }
};

}  // namespace detail

template <class Again>
Digits50 function_max_again(const Motion& motion, std::span<const Digits50> dimensions) {
    detail::ErrorAgain<Again> e(motion, dimensions);
    Digits50 greatest = 0;
    const auto consider = [&](const Digits50& size) {
        if (!(size <= greatest)) greatest = size;  // NaN stays
    };
    for (const Vector<double>& s : e.samples())
        consider(e.size(s.x, s.y));
    if (!e.samples().empty()) return greatest;
    constexpr int steps = 1000;
    std::vector<double> sizes(steps + 1);
    for (int i = 0; i <= steps; ++i)
        sizes[static_cast<std::size_t>(i)] = e.rough_size(static_cast<double>(i) / steps);
    const double scanned = *std::max_element(sizes.begin(), sizes.end());
    for (std::size_t i = 0; i < sizes.size(); ++i) {
        // What falls short of the greatest by more than neighbours differ cannot become the greatest.
        const double before = i > 0 ? sizes[i - 1] : -1, after = i < steps ? sizes[i + 1] : -1;
        if (std::isnan(sizes[i])) return std::numeric_limits<Digits50>::quiet_NaN();
        if (sizes[i] < before || sizes[i] < after || sizes[i] < 0.9 * scanned) continue;
        const double here = static_cast<double>(i) / steps;
        const double share = greatest_between([&](double s) { return e.rough_size(s); },
                                              std::max(0.0, here - 1.0 / steps), std::min(1.0, here + 1.0 / steps));
        for (const double s : {here, share})
            consider(e.size(s, e.part(s)));
    }
    return greatest;
}

template <class Again>
Digits50 function_rms_again(const Motion& motion, std::span<const Digits50> dimensions) {
    detail::ErrorAgain<Again> e(motion, dimensions);
    Digits50 sum = 0;
    if (!e.samples().empty()) {
        for (const Vector<double>& s : e.samples())
            sum += e.size(s.x, s.y) * e.size(s.x, s.y) / static_cast<double>(e.samples().size());
        return sqrt(sum);
    }
    using Rule = boost::math::quadrature::gauss_kronrod<Digits50, 31>;
    constexpr int most_halvings = 10;  // four do for what is smooth; what is not would go on for ever
    const Digits50 precision = std::max(1e-11, e.relative_noise());
    // With share = sin^2 a, square roots at the ends of the range are smooth in a.
    const auto square = [&](const Digits50& a) {
        const auto at = Digits50(sin(a) * sin(a)).convert_to<double>();
        const Digits50 size = e.size(at, e.part(at));
        return Digits50(size * size * sin(2 * a));
    };
    const std::vector<double> ends = e.smooth_between();
    const auto angle_at = [](double share) { return Digits50(asin(sqrt(Digits50(share)))); };
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        sum += Rule::integrate(square, angle_at(ends[i]), angle_at(ends[i + 1]), most_halvings, precision);
    return sqrt(sum);
}

}  // namespace mechwright
