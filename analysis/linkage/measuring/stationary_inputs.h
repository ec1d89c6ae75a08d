#pragma once
/// \file
/// Where a signal along the motion of a linkage, or a derivative of it, is stationary.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/measuring/at_limit.h"
#include "analysis/linkage/measuring/corners.h"
#include "analysis/linkage/measuring/in_line.h"
#include "analysis/linkage/measuring/measured.h"
#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/motion/motion_breaks.h"
#include "analysis/linkage/motion/travel.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage::detail {

/// Of the size of what goes into a value.
inline constexpr double one_rounding = 2e-15;

/// What rounding makes of a derivative where it is 0 itself, of a value along a stretch whose inputs are of that size.
template <class Value>
double rounding_of(const Value& value, std::size_t derivative, double size, double rate, const Stretch& stretch) {
    constexpr int samples = 8;
    double greatest = size * std::pow(std::abs(rate), static_cast<double>(derivative));
    for (int i = 0; i < samples; ++i) {
        const auto sample = value(stretch.at((i + 0.5) / samples));
        for (std::size_t k = 0; k <= derivative; ++k)
            if (std::isfinite(sample.c[k])) greatest = std::max(greatest, std::abs(sample.derivative(k)));
    }
    return one_rounding * greatest;
}

/// The size of what goes into a signal, or into what it is the error of.
template <std::size_t K>
double size_of_inputs(const Measured<double, K>& measured, std::size_t signal) {
    const Signal& s = measured.signals()[signal];
    const Signal::Kind kind = s.kind == Signal::Kind::error ? measured.signals()[s.of].kind : s.kind;
    const bool angle = kind == Signal::Kind::angle || kind == Signal::Kind::transmission_angle;
    const double size = size_of(measured.driven());
    return angle ? 1 : kind == Signal::Kind::curvature ? 1 / size : size;
}

/// The dyad whose margins are stationary where what is asked is: the transmission angle of one is a monotonic function
/// of each of its margins, unless it is of lines or its radii follow from inputs. None of anything else.
inline std::size_t stationary_with(std::span<const Signal> signals, const Asked& asked, const Order& order) {
    const Signal& signal = signals[asked.signal];
    if (signal.kind != Signal::Kind::transmission_angle || asked.derivative != 0) return none;
    return is_of_lines(order, signal.of) || step_of(order, signal.of).is_extended() ? none : signal.of;
}

/// Where the transmission angle of a dyad between the frame and a driven link is extreme; nothing of any other signal.
template <std::size_t K>
std::optional<std::vector<double>> inputs_in_line(Measured<double, K>& measured, const Asked& asked,
                                                  const Course& course, const Stretch& stretch) {
    const Signal& signal = measured.signals()[asked.signal];
    if (signal.kind != Signal::Kind::transmission_angle || asked.derivative != 0) return {};
    const auto& driven = measured.driven();
    const CarriedRound& round = step_of(driven.order, signal.of).round;
    if (!round.exists() || driven.laws[round.input].motion) return {};
    const double from = stretch.at(0), to = stretch.at(1);
    measured.margins(signal.of, from, course.turns.near(from));
    const InLine found =
        in_line(round, driven.laws[round.input].ratio, from, to, size_of(driven), [&](std::size_t pin) {
            const auto& at = driven.pose.pins[pin];
            return Vector<double>{at.x.c[0], at.y.c[0]};
        });
    std::vector<double> inputs;
    for (const InLine::Input& input : found.inputs)
        inputs.push_back(input.at);
    return inputs;
}

/// Where the slope of what is asked vanishes in a stretch, or a `part` of one between breaks, in order; one that is not
/// a number where the linkage does not close over all of it.
template <std::size_t K>
std::vector<double> stationary_inputs_in(Measured<double, K>& measured, const Asked& asked, const Course& course,
                                         const Stretch& stretch, bool part) {
    const std::size_t order = asked.derivative + 1;
    const std::size_t dyad = stationary_with(measured.signals(), asked, measured.driven().order);
    const auto value_at = [&](double at) {
        const auto near = course.turns.near(at);
        return dyad == none ? measured.value(asked.signal, at, near) : measured.closed_margin(dyad, at, near);
    };
    const double size = dyad == none ? size_of_inputs(measured, asked.signal) : size_of(measured.driven());
    const double floor = rounding_of(value_at, order, size, measured.rate(), stretch);
    // At limits each derivative goes like two powers less of the share: as many of its speed make that finite. Where
    // several dyads are at their limits, two more for each make rounding finite, too.
    const int derivatives = static_cast<int>(order + order_of(measured.signals(), asked.signal));
    const int powers = (ends_in_several_limits(measured, asked.signal, course) ? 4 : 2) * derivatives - 1;
    const auto share = [&](double s) { return stretch.speed(s) / stretch.length(); };
    const auto slope = [&](double s) { return value_at(stretch.at(s)).derivative(order) * std::pow(share(s), powers); };
    const auto curvature = [&](double s) {
        const auto f = value_at(stretch.at(s));
        return f.derivative(order + 1) / measured.rate() * stretch.speed(s) * share(s) +
               f.derivative(order) * powers * (stretch.speed_slope(s) / stretch.length());
    };
    const std::size_t first = first_panels(stretch, part);
    const Panels panels(slope, stretch.first(), stretch.last(),
                        {.first = first, .floor = floor, .most = first + 256, .everywhere = true});
    std::vector<double> found;
    if (!panels.finite()) return {std::numeric_limits<double>::quiet_NaN()};
    if (panels.greatest() > 4 * floor)
        panels.zeros(slope, curvature, [&](double s) { found.push_back(stretch.at(s)); });
    return found;
}

/// The same in all of a stretch, of which the rests are given. They and breaks of drives' motions are not looked at.
template <std::size_t K>
std::vector<double> stationary_inputs(Measured<double, K>& measured, const Asked& asked, const Course& course,
                                      const Stretch& stretch, std::span<const double> rests) {
    if (auto known = inputs_in_line(measured, asked, course, stretch)) return *std::move(known);
    const auto parts = parts_of(measured.driven().laws, stretch, rests);
    std::vector<double> found;
    for (const MotionPart& part : parts) {
        const WithinPiece in_part(measured, part.within);
        const auto more = stationary_inputs_in(measured, asked, course, part.stretch, parts.size() > 1);
        found.insert(found.end(), more.begin(), more.end());
    }
    return found;
}

}  // namespace mechwright::linkage::detail
