#pragma once
/// \file
/// Signals along the motion of a linkage: all their extremes and those of their derivatives.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <span>
#include <tuple>
#include <vector>

#include "analysis/linkage/measuring/corners.h"
#include "analysis/linkage/measuring/in_line.h"
#include "analysis/linkage/measuring/measured.h"
#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/motion/motion_breaks.h"
#include "analysis/linkage/motion/travel.h"
#include "analysis/numbers/resolved.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

/// Where something can be extreme along a motion.
struct Extreme {
    double at = 0;
    double value = 0;
    bool stationary = true;     ///< else it is an end of the motion, or of the stretch that was asked for
    Limit limit{};              ///< an end that moves with the dimensions
    double within = by_itself;  ///< an input beside it, on the side of a rest, or of the piece of drives' motions, on
                                ///< which it has this value
};

namespace detail {

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

/// Whether another dyad is at its limit, to rounding, where one has just been placed at its own: pins may meet there,
/// and what hangs on them has no place by itself.
template <class T, std::size_t K>
bool others_at_limit(const Measured<T, K>& measured, const Limit& limit) {
    constexpr double rounding = 1e-14;
    const double within = rounding * size_of(measured.driven());
    const auto& margins = measured.driven().pose.margins;
    for (std::size_t i = 0; i < measured.driven().order.margins_of_dyads(); ++i)
        for (const auto& margin : {margins[i].outer, margins[i].inner})
            if (i != limit.margin && number_as<double>(value_of(margin.c[0])) < within) return true;
    return false;
}

/// Whether the motion ends where several dyads are at their limits at once: what rounding makes of a place beside such
/// an end grows like the square of one over the root of the distance.
template <std::size_t K>
bool ends_in_several_limits(Measured<double, K>& measured, std::size_t signal, const Course& course) {
    const Travel& travel = course.travel;
    const auto at = [&](double end, const Limit& limit) {
        if (!limit.is_singular() || limit.parallel) return false;
        measured.value(signal, end, course.turns.near(end), limit);
        return others_at_limit(measured, limit);
    };
    return at(travel.from, travel.first) || at(travel.to, travel.last);
}

/// Where the transmission angle of a dyad between the frame and a driven link is extreme; nothing of any other signal.
template <std::size_t K>
std::optional<std::vector<double>> inputs_in_line(Measured<double, K>& measured, const Asked& asked,
                                                  const Course& course, const Stretch& stretch) {
    const Signal& signal = measured.signals()[asked.signal];
    if (signal.kind != Signal::Kind::transmission_angle || asked.derivative != 0) return {};
    const auto& driven = measured.driven();
    const auto round = carried_round(driven.order, step_of(driven.order, signal.of));
    if (!round || driven.laws[round->input].motion) return {};
    const double from = stretch.at(0), to = stretch.at(1);
    measured.margins(signal.of, from, course.turns.near(from));
    const InLine found =
        in_line(*round, driven.laws[round->input].ratio, from, to, size_of(driven), [&](std::size_t pin) {
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

/// What is asked at the breaks of drives' motions in [from, to), where it can be extreme: where its slope changes its
/// sense, or it jumps itself; then it has two values.
template <std::size_t K>
void add_breaks(Measured<double, K>& measured, const Asked& asked, const Course& course, double from, double to,
                std::vector<Extreme>& found) {
    const std::span<const DriveLaw> laws = measured.driven().laws;
    const std::vector<double> breaks = breaks_between(laws, from, to);
    if (breaks.empty()) return;
    constexpr double turn = 2 * std::numbers::pi;
    const std::vector<double> around = breaks_between(laws, from - turn, to + turn);
    const Stretch all{from, to};
    const auto value_at = [&](double at) { return measured.value(asked.signal, at, course.turns.near(at)); };
    const double size = size_of_inputs(measured, asked.signal);
    const double floor = 4 * rounding_of(value_at, asked.derivative, size, measured.rate(), all),
                 flat = 4 * rounding_of(value_at, asked.derivative + 1, size, measured.rate(), all);
    for (const double at : breaks) {
        if (at >= to) continue;
        const auto here = std::lower_bound(around.begin(), around.end(), at);
        const auto beside = [&](double other) {
            const double within = 0.5 * (at + other);
            const WithinPiece in_piece(measured, within);
            const auto f = measured.value(asked.signal, at, course.turns.near(at));
            return std::tuple(f.derivative(asked.derivative), f.derivative(asked.derivative + 1), within);
        };
        if (here == around.begin() || here + 1 == around.end()) continue;
        const auto [before, slope_before, within_before] = beside(*(here - 1));
        const auto [after, slope_after, within_after] = beside(*(here + 1));
        const bool jumps = !(std::abs(after - before) <= floor);
        const auto sense = [&](double slope) { return slope > flat ? 1 : slope < -flat ? -1 : 0; };
        if (!jumps && sense(slope_before) == sense(slope_after) && sense(slope_before) != 0) continue;
        found.push_back({at, before, false, {}, within_before});
        if (jumps) found.push_back({at, after, false, {}, within_after});
    }
}

/// What is asked on both sides of rests, at which parts of a stretch meet.
template <std::size_t K>
void add_rests(Measured<double, K>& measured, const Asked& asked, const Course& course,
               std::span<const MotionPart> parts, std::span<const double> rests, std::vector<Extreme>& found) {
    for (std::size_t i = 0; i + 1 < parts.size(); ++i) {
        const double at = parts[i].stretch.to;
        if (!std::binary_search(rests.begin(), rests.end(), at)) continue;
        for (const double within : {parts[i].within, parts[i + 1].within}) {
            const WithinPiece on_side(measured, within);
            const double value = measured.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
            found.push_back({at, value, false, {}, within});
        }
    }
}

/// The limit of a signal at an end of the motion, from the places beside it: smooth in the root of the distance, it is
/// that of the polynomial through its values at Chebyshev nodes (Berrut and Trefethen, Barycentric Lagrange
/// interpolation, SIAM Review 46 (2004), 501-517). Far from the end a polynomial follows less well, near it rounding is
/// greater: of panels that halve, the first with which the next one agrees, or does best. Off by 1e-11 of the size or
/// so: what is nearer to 0 is 0.
template <std::size_t K>
double from_beside(Measured<double, K>& measured, std::size_t signal, const Course& course, bool last) {
    constexpr int halvings = 6;
    constexpr double agrees = 1e-12;  // of the linkage's size
    const Stretch stretch = stretch_of(course, course.travel.from, course.travel.to);
    const auto by_panel = [&](double width) {
        const Panel panel{0, width};
        double sum = 0, weights = 0;
        for (std::size_t k = 0; k < Panel::nodes; ++k) {
            const double s = panel.at(k), at = stretch.at(last ? 1 - s : s);
            const double root = std::sin((2.0 * static_cast<double>(k) + 1) * std::numbers::pi / (2 * Panel::nodes));
            const double weight = (k % 2 == 0 ? root : -root) / s;
            sum += weight * measured.value(signal, at, course.turns.near(at)).c[0];
            weights += weight;
        }
        return sum / weights;
    };
    double width = 0.5, value = by_panel(width), best = value, apart = std::numeric_limits<double>::infinity();
    for (int i = 0; i < halvings && !(apart <= agrees * size_of(measured.driven())); ++i) {
        const double nearer = by_panel(width /= 2);
        if (std::abs(nearer - value) < apart) {
            apart = std::abs(nearer - value);
            best = value;
        }
        value = nearer;
    }
    constexpr double off = 1e-11;
    return std::abs(best) <= off * size_of(measured.driven()) ? 0 : best;
}

}  // namespace detail

/// What is asked at an end of the motion that is a limit: derivatives are infinite there, unless the signal does not
/// depend on the dyad that ends it. Curvatures of paths whose points become infinitely fast are not known there.
template <std::size_t K>
double value_at_limit(Measured<double, K>& measured, const Asked& asked, const Course& course, bool last) {
    const Travel& travel = course.travel;
    const double end = last ? travel.to : travel.from;
    const Limit& limit = last ? travel.last : travel.first;
    const auto near = course.turns.near(end);
    if (limit.parallel) return std::numeric_limits<double>::infinity();
    if (limit.stop) return measured.value(asked.signal, end, near).derivative(asked.derivative);
    if (asked.derivative + order_of(measured.signals(), asked.signal) == 0) {
        const double value = measured.value(asked.signal, end, near, limit).c[0];
        return detail::others_at_limit(measured, limit) ? detail::from_beside(measured, asked.signal, course, last)
                                                        : value;
    }
    const Stretch stretch = detail::stretch_of(course, travel.from, travel.to);
    const auto place_beside = [&](double s) { return stretch.at(last ? 1 - s : s); };
    const auto beside = [&](double s) {
        const double at = place_beside(s);
        return measured.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
    };
    const auto becomes_infinite = [&](std::size_t curvature) {
        const auto speed = [&](double s) {
            const double at = place_beside(s);
            const auto v = measured.vector(curvature, at, course.turns.near(at));
            return std::hypot(v.x.c[0], v.y.c[0]);
        };
        return !(speed(0x1p-13) <= 1.5 * speed(0x1p-12));
    };
    if (any_curvature(measured.signals(), asked.signal, becomes_infinite))
        return std::numeric_limits<double>::quiet_NaN();
    // What goes like the inverse root of the distance or steeper at least doubles when that is quartered.
    const double nearer = beside(0x1p-13), farther = beside(0x1p-12);
    if (std::abs(nearer) > 1.5 * std::abs(farther))
        return std::copysign(std::numeric_limits<double>::infinity(), nearer);
    return measured.value(asked.signal, end, near).derivative(asked.derivative);
}

/// All places in [from, to] at which what is asked can be extreme: where it is stationary, rests, and the ends. Of a
/// whole motion that is asked for whole the ends are none, unless the signal does not come back. Where the linkage does
/// not close over all of it, or something is divided by zero, one of them is not a number. K must be at least
/// `order_for` it.
template <std::size_t K>
std::vector<Extreme> extremes(Measured<double, K>& measured, const Asked& asked, const Course& course, double from,
                              double to);

namespace detail {

/// Whether the velocity by which a curvature is divided vanishes at an input.
template <std::size_t K>
bool rests_at(Measured<double, K>& measured, std::size_t signal, const Course& course, double input) {
    const auto v = measured.vector(signal, input, course.turns.near(input));
    return is_at_rest(v, near_rest(measured) / std::abs(measured.rate())) || std::hypot(v.x.c[0], v.y.c[0]) == 0;
}

/// Whether it does somewhere in [from, to].
template <std::size_t K>
bool rests_between(Measured<double, K>& measured, std::size_t signal, const Course& course, double from, double to) {
    std::vector<double> rests;
    for (const MotionPart& part : parts_of(measured.driven().laws, stretch_of(course, from, to))) {
        const WithinPiece in_part(measured, part.within);
        if (rests_at(measured, signal, course, part.stretch.from) ||
            rests_at(measured, signal, course, part.stretch.to))
            return true;
        find_rests(measured, signal, course, part, rests);
    }
    return !rests.empty();
}

}  // namespace detail

/// Whether something that a signal is divided by vanishes somewhere in [from, to], to rounding. There the signal has no
/// value and beside there, where the divisor passes zero, values without bounds. K must be at least 2 more than the
/// order of the signal.
template <std::size_t K>
bool divides_by_zero(Measured<double, K>& measured, std::size_t signal, const Course& course, double from, double to) {
    constexpr double rounding = 1e-12;  // of the greatest
    const auto rests = [&](std::size_t curvature) {
        return detail::rests_between(measured, curvature, course, from, to);
    };
    return any_curvature(measured.signals(), signal, rests) ||
           any_divisor(measured.signals(), signal, [&](std::size_t divisor) {
               double least = std::numeric_limits<double>::infinity(), greatest = -least, size = 0;
               const auto see = [&](double value) {
                   least = std::min(least, value);
                   greatest = std::max(greatest, value);
                   if (std::isfinite(value)) size = std::max(size, std::abs(value));
               };
               see(measured.value(divisor, 0.5 * (from + to), course.turns.near(0.5 * (from + to))).c[0]);
               for (const Extreme& each : extremes(measured, {divisor, 0}, course, from, to))
                   see(each.value);
               return !(least > rounding * size) && !(greatest < -rounding * size);
           });
}

/// Whether a derivative that is asked for has two values at an input, one on each side: what it goes by the size of
/// vanishes there.
template <std::size_t K>
bool has_two_values_at(Measured<double, K>& measured, const Asked& asked, const Course& course, double input) {
    bool vanishes = false;
    if (asked.derivative > 0)
        detail::for_each_size(measured.signals(), asked, [&](std::size_t signal) {
            const auto v = measured.vector(signal, input, course.turns.near(input));
            vanishes = vanishes || is_at_rest(v, detail::near_rest(measured) / std::abs(measured.rate()));
        });
    return vanishes;
}

/// Whether something that a signal is divided by vanishes at an input, to the rounding of that.
template <std::size_t K>
bool divides_by_zero_at(Measured<double, K>& measured, std::size_t signal, const Course& course, double input) {
    constexpr double rounding = 1e-12;
    const double near = rounding * measured.unit_of_input() / std::abs(measured.rate());
    const auto rests = [&](std::size_t curvature) { return detail::rests_at(measured, curvature, course, input); };
    return any_curvature(measured.signals(), signal, rests) ||
           any_divisor(measured.signals(), signal, [&](std::size_t divisor) {
               const auto f = measured.value(divisor, input, course.turns.near(input));
               return !(std::abs(f.c[0]) > near * std::abs(f.derivative(K > 0 ? 1 : 0)));
           });
}

template <std::size_t K>
std::vector<Extreme> extremes(Measured<double, K>& measured, const Asked& asked, const Course& course, double from,
                              double to) {
    constexpr double overlap = detail::overlap_of_cycle, same_within = 1e-6;
    const Travel& travel = course.travel;
    if (divides_by_zero(measured, asked.signal, course, from, to))
        return {{from, std::numeric_limits<double>::quiet_NaN(), false}};
    const auto at = [&](double x) {
        return measured.value(asked.signal, x, course.turns.near(x)).derivative(asked.derivative);
    };
    bool by_sizes = false;
    detail::for_each_size(measured.signals(), asked, [&](std::size_t) { by_sizes = true; });
    std::vector<Extreme> found;
    bool comes_back = travel.whole && from == travel.from && to == travel.to;
    if (comes_back) {
        const double first = at(from), last = at(to);
        comes_back = std::abs(last - first) <= 1e-9 * (std::abs(first) + std::abs(last)) ||
                     std::abs(last - first) <= 1e-9 * size_of(measured.driven());
    }
    const std::span<const DriveLaw> laws = measured.driven().laws;
    if (!comes_back) {
        const Stretch stretch = detail::stretch_of(course, from, to);
        const std::vector<double> rests = detail::rests_of(measured, asked, course, stretch);
        const auto parts = parts_of(laws, stretch, rests), pieces = parts_of(laws, stretch);
        const auto end = [&](double x, const Limit& limit, bool last) {
            const bool is_limit = limit.exists() && x == (last ? travel.to : travel.from);
            // What goes by a size may have a corner at the very end: it is the value on this side of it.
            const MotionPart& part = last ? parts.back() : parts.front();
            const double within = by_sizes && std::isnan(part.within) ? part.stretch.at(0.5) : part.within;
            const WithinPiece in_piece(measured, within);
            if (!is_limit) return found.push_back({x, at(x), false, {}, within});
            found.push_back({x, value_at_limit(measured, asked, course, last), false, limit, within});
        };
        end(from, travel.first, false);
        for (const double x : detail::stationary_inputs(measured, asked, course, stretch, rests))
            if (!(x <= from) && !(x >= to)) found.push_back({x, at(x)});
        detail::add_rests(measured, asked, course, parts, rests, found);
        if (pieces.size() > 1) detail::add_breaks(measured, asked, course, pieces.front().stretch.to, to, found);
        end(to, travel.last, true);
        return found;
    }
    // One cycle and a little more, from a place where extremes seldom are; what is seen again does not count.
    const double period = course.period(), start = from + detail::seam_of_cycle;
    const Stretch stretch{start, start + period + overlap};
    const std::vector<double> rests = detail::rests_of(measured, asked, course, stretch);
    std::vector<Extreme> seen;
    for (const double x : detail::stationary_inputs(measured, asked, course, stretch, rests))
        seen.push_back({x, 0});
    detail::add_rests(measured, asked, course, parts_of(laws, stretch, rests), rests, seen);
    const auto is_known = [&](double x) {
        return std::any_of(found.begin(), found.end(),
                           [&](const Extreme& f) { return std::abs(f.at - x) < same_within; });
    };
    const auto beyond =
        std::stable_partition(seen.begin(), seen.end(), [&](const Extreme& one) { return one.at < start + period; });
    found.assign(seen.begin(), beyond);
    std::vector<Extreme> again(beyond, seen.end());
    for (Extreme& one : again) {
        one.at -= period;
        one.within -= period;
    }
    std::erase_if(again, [&](const Extreme& one) { return is_known(one.at); });
    found.insert(found.end(), again.begin(), again.end());
    for (Extreme& each : found) {
        if (each.at >= to) {
            each.at -= period;
            each.within -= period;
        }
        if (each.stationary) each.value = at(each.at);
    }
    detail::add_breaks(measured, asked, course, from, to, found);
    std::sort(found.begin(), found.end(), [](const Extreme& a, const Extreme& b) { return a.at < b.at; });
    return found;
}

}  // namespace mechwright::linkage
