#pragma once
/// \file
/// What is asked of a linkage along its motion, and the inputs at which it has corners because something by whose size
/// it goes vanishes, or at which curvatures have no value because a velocity does.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/linkage/measuring/measured.h"
#include "analysis/linkage/measuring/rest.h"
#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/motion/motion_breaks.h"
#include "analysis/linkage/motion/travel.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage {

/// A signal, or a derivative of it by the time.
struct Asked {
    std::size_t signal = 0;
    std::size_t derivative = 0;
};

/// The derivatives of the pose that `Measured` needs to find the extremes of what is asked, and for their second
/// derivatives by the dimensions.
inline std::size_t order_for(std::span<const Signal> signals, const Asked& asked) {
    return order_of(signals, asked.signal) + asked.derivative + 2;
}

namespace detail {

inline Stretch stretch_of(const Course& course, double from, double to) {
    return {from, to, course.travel.first.is_singular() && from == course.travel.from,
            course.travel.last.is_singular() && to == course.travel.to};
}

/// Parts of a stretch between breaks are short.
inline std::size_t first_panels(const Stretch& stretch, bool part = false) {
    return std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(stretch.length() / std::numbers::pi * 2)),
                                   part ? 1 : 2, 4 * most_turns);
}

/// Calls use(signal) for the sizes of vectors that what is asked goes by, and at whose corners it has one itself. A
/// distance alone is no more than least there.
template <class Use>
void for_each_size(std::span<const Signal> signals, const Asked& asked, const Use& use) {
    const Signal& s = signals[asked.signal];
    if (is_size(s) && asked.derivative + order_of(signals, asked.signal) > 0) use(asked.signal);
    const auto go_on = [&](std::size_t signal) { for_each_size(signals, {signal, asked.derivative + 1}, use); };
    if (s.kind == Signal::Kind::ratio || s.kind == Signal::Kind::error) go_on(s.of);
    if (s.kind == Signal::Kind::ratio) go_on(s.to);
    for (const Signal::Term& term : s.terms)
        go_on(term.signal);
}

/// So near to a rest, or to an end of the motion, an input is at it.
template <std::size_t K>
double near_rest(const Measured<double, K>& measured) {
    return 1e-9 * measured.unit_of_input();
}

/// Whether a vector may vanish in a part of a stretch, as samples show: its size and by how much it changes from one to
/// the next.
template <class VectorAt>
bool may_vanish(const VectorAt& vector_at, const Stretch& stretch, double rate) {
    constexpr double safe = 4;
    const auto samples = static_cast<int>(16 * first_panels(stretch));
    double least = std::numeric_limits<double>::infinity(), steepest = 0;
    for (int i = 0; i < samples; ++i) {
        const auto v = vector_at(stretch.at((i + 0.5) / samples));
        least = std::min(least, std::hypot(v.x.c[0], v.y.c[0]));
        steepest = std::max(steepest, std::hypot(v.x.c[1], v.y.c[1]));
    }
    return least <= safe * steepest * stretch.length() / samples / std::abs(rate);
}

/// Where the vector whose size a signal is, which is not constant, vanishes inside a part of a stretch: there the
/// square of its size is stationary.
template <std::size_t K>
void find_rests(Measured<double, K>& measured, std::size_t signal, const Course& course, const MotionPart& part,
                std::vector<double>& rests) {
    constexpr double moves = 1e-6;  // of the greatest
    const WithinPiece in_part(measured, part.within);
    const Stretch& stretch = part.stretch;
    const auto vector_at = [&](double at) { return measured.vector(signal, at, course.turns.near(at)); };
    const auto slope_at = [&](const auto& v) { return std::hypot(v.x.c[1], v.y.c[1]); };
    const int order = static_cast<int>(order_of(measured.signals(), signal));
    // Many distances never vanish, and that is soon seen of places, which do not grow beyond all bounds.
    if (order == 0 && !may_vanish(vector_at, stretch, measured.rate())) return;
    const int powers = order == 0 ? 1 : 4 * order;
    const auto share = [&](double s) { return stretch.speed(s) / stretch.length(); };
    double greatest = 0;
    const auto growth = [&](double s) {
        const auto v = vector_at(stretch.at(s));
        if (s > 0.01 && s < 0.99) greatest = std::max(greatest, slope_at(v));
        return (v.x.c[0] * v.x.c[1] + v.y.c[0] * v.y.c[1]) * std::pow(share(s), powers);
    };
    const std::size_t first = first_panels(stretch, true);
    const Panels panels(growth, stretch.first(), stretch.last(),
                        {.first = first, .floor = 0, .most = first + 64, .everywhere = true});
    if (!panels.finite()) return;
    panels.zeros(growth, [&](double s) {
        const double at = stretch.at(s), near = near_rest(measured);
        const auto v = vector_at(at);
        const bool inside = at - stretch.from > near && stretch.to - at > near;
        if (inside && is_at_rest(v, near / std::abs(measured.rate())) && slope_at(v) > moves * greatest)
            rests.push_back(at);
    });
}

/// Inputs at which what is asked goes by the size of something that vanishes, in order: it has corners there.
template <std::size_t K>
std::vector<double> rests_of(Measured<double, K>& measured, const Asked& asked, const Course& course,
                             const Stretch& stretch) {
    std::vector<double> rests;
    for_each_size(measured.signals(), asked, [&](std::size_t signal) {
        for (const MotionPart& part : parts_of(measured.driven().laws, stretch))
            find_rests(measured, signal, course, part, rests);
    });
    std::sort(rests.begin(), rests.end());
    return rests;
}

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

}  // namespace mechwright::linkage
