#pragma once
/// \file
/// Where a quantity of a linkage has its least and greatest values, found for one design: what its components are of.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <span>
#include <vector>

#include "analysis/linkage/measuring/jumps.h"
#include "analysis/linkage/measuring/margins.h"
#include "synthesis/mechanism/linkage/measured_over.h"
#include "synthesis/mechanism/linkage/rooms/contacts.h"
#include "synthesis/mechanism/linkage/rooms/swept/outline.h"

namespace mechwright::measuring {

using linkage::Asked;
using linkage::Course;
using linkage::Extreme;

inline constexpr std::size_t most_extremes = 6;  ///< components of a least or greatest value
inline constexpr std::size_t most_of_range = 3;  ///< extremes of either sort in a range
/// The same in a deviation: where that is least, so many are equal as there are free numbers, and one.
inline constexpr std::size_t most_of_deviation = 5;

inline constexpr std::size_t most_samples = 32;  ///< of a signal along a stretch

/// One smooth part of a component: what is asked at an extreme, times a factor, plus a constant.
struct Term {
    Asked asked{};
    Extreme place{};
    double factor = 1;
    double constant = 0;
    std::size_t sample = 0;  ///< of a function: which of its samples, or of its extremes along the motion
    /// Another signal that says the same at the place, which is where both do.
    std::optional<linkage::Scaled> also{};

    double value() const { return constant + factor * place.value; }
};

/// What the components of a quantity are of, found for one design.
struct Found {
    std::vector<Term> plus{};
    std::vector<Term> minus{};                        ///< of a range: those that are taken away
    std::vector<Term> plus_across{}, minus_across{};  ///< of an area: those of the other range
    std::vector<linkage::MarginPlace> margins{};
    TurnedBox box{};                     ///< of a box that turns
    SweptOutline swept{};                ///< by a blade
    std::vector<Approach> approaches{};  ///< of a path to itself
    bool possible = true;
    double whole_turns = 0;  ///< by which the output of a function is counted on
    bool samples = false;    ///< of a function, not extremes: they keep their share of the motion
};

/// The least first; not a number before all.
inline bool is_less(double a, double b) { return std::isnan(a) ? !std::isnan(b) : a < b; }

inline bool needs_turns(const Over& over, std::span<const Signal> signals) {
    return std::any_of(signals.begin(), signals.end(), [](const Signal& s) { return s.kind == Signal::Kind::angle; }) ||
           std::any_of(over.model.order.steps.begin(), over.model.order.steps.end(),
                       [](const auto& step) { return step.kind == linkage::Step::Kind::unwound; });
}

/// The motion with its limits, and the turns of links where they are needed.
template <std::size_t K>
Course course_of(const Over& over, std::span<const double> dimensions, linkage::Measured<double, K>& plain,
                 std::span<const Signal> signals) {
    Course course{over.travel()};
    if (needs_turns(over, signals)) {
        course = linkage::course_along(over.driven(dimensions), course.travel,
                                       over.measure.stretch || over.measure.kind == Kind::at);
        if (course.turns.empty()) return course;
    }
    if (!course.travel.whole) {
        course.travel.first = limit_at(plain, course.travel.from, course.turns.near(course.travel.from));
        course.travel.last = limit_at(plain, course.travel.to, course.turns.near(course.travel.to));
    }
    return course;
}

/// Whether it closes here and there over the motion: what does not at all is not looked at closely.
inline bool closes_at_samples(const Over& over, std::span<const double> dimensions) {
    constexpr int samples = 36;
    const linkage::Travel travel = over.travel();
    if (travel.from > travel.to) return false;
    linkage::Driven<double> driven = over.driven(dimensions);
    for (int i = 0; i < samples; ++i)
        if (!driven.place(travel.from + (travel.to - travel.from) * (i + 0.5) / samples)) return false;
    return true;
}

/// A stretch of the motion as inputs that lie in it, or in its second cycle; absent where it does not.
inline std::optional<std::array<double, 2>> stretch_in(const Over& over, std::array<double, 2> stretch) {
    constexpr double rounding = 1e-12;
    const linkage::Travel travel = over.travel();
    for (double& end : stretch)
        end = over.model.input_of(end);
    if (!over.model.driven_by_slide()) {
        if (stretch[1] < stretch[0]) stretch[1] += turn * std::ceil((stretch[0] - stretch[1]) / turn);
        // A cycle, or a limited motion, may be of several turns: what lies in it is left where it is.
        const bool inside = stretch[0] >= travel.from - rounding && stretch[0] <= travel.to + rounding;
        const double unit = travel.whole ? over.period() : turn;
        const double shift = inside ? 0 : unit * std::ceil((travel.from - stretch[0]) / unit - rounding);
        for (double& end : stretch)
            end += shift;
    }
    const double last = travel.whole ? travel.to + over.period() : travel.to;
    if (stretch[1] < stretch[0] || stretch[0] < travel.from - rounding || stretch[1] > last + rounding) return {};
    return std::array{std::max(stretch[0], travel.from), std::min(stretch[1], last)};
}

inline void add_extremes(Found& found, const std::vector<Extreme>& places, const Asked& asked, double factor,
                         double constant) {
    for (const Extreme& place : places)
        found.plus.push_back({asked, place, factor, constant});
}

inline bool closes(const std::vector<Extreme>& places) {
    return !places.empty() &&
           std::none_of(places.begin(), places.end(), [](const Extreme& p) { return std::isnan(p.value); });
}

inline void keep_least(std::vector<Term>& terms, std::size_t count) {
    std::stable_sort(terms.begin(), terms.end(),
                     [](const Term& a, const Term& b) { return is_less(a.value(), b.value()); });
    if (terms.size() > count) terms.resize(count);
}

inline void keep_greatest(std::vector<Term>& terms, std::size_t count) {
    std::stable_sort(terms.begin(), terms.end(),
                     [](const Term& a, const Term& b) { return is_less(b.value(), a.value()); });
    if (terms.size() > count) terms.resize(count);
}

template <std::size_t K>
Found found_of_all(const Over& over, linkage::Measured<double, K>& plain, const Course& course) {
    Found found;
    const bool folded = over.measure.kind == Kind::transmission_angle_worst;
    for (std::size_t i = 0; i < plain.signals().size(); ++i) {
        const auto places = linkage::extremes(plain, {i, 0}, course, course.travel.from, course.travel.to);
        // A constant has no extremes on a whole motion.
        const std::vector<Extreme> start{
            {course.travel.from, plain.value(i, course.travel.from, course.turns.near(course.travel.from)).c[0],
             false}};
        add_extremes(found, places.empty() ? start : places, {i, 0}, 1, 0);
        if (folded) add_extremes(found, places.empty() ? start : places, {i, 0}, -1, std::numbers::pi);
        found.possible = found.possible && closes(places.empty() ? start : places);
    }
    found.possible = found.possible && !found.plus.empty();
    keep_least(found.plus, most_extremes);
    return found;
}

/// What is asked at inputs all along a stretch, closer together towards its ends; evenly over a whole cycle.
template <std::size_t K>
Found found_of_samples(const Over& over, linkage::Measured<double, K>& plain, const Course& course, double from,
                       double to) {
    const Asked& asked = over.measure.asked;
    const bool whole = course.travel.whole && !over.measure.stretch;
    Found found;
    for (std::size_t i = 0; i < most_samples; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(most_samples - (whole ? 0 : 1));
        const double share = whole ? part : 0.5 - 0.5 * std::cos(std::numbers::pi * part);
        const double at = from + (to - from) * share;
        const double value = plain.value(asked.signal, at, course.turns.near(at)).derivative(asked.derivative);
        found.plus.push_back({asked, {at, value, false}});
        found.possible = found.possible && std::isfinite(value);
    }
    return found;
}

/// `radius`: of the arc whose centre the signal is a distance from. Not possible where what is asked jumps at a
/// singular position inside the motion: beside it the linkage goes on in more than one way.
template <std::size_t K>
Found found_of_signal(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                      std::span<const double> dimensions, double from, double to, double radius) {
    const LinkageMeasure& m = over.measure;
    if (m.kind == Kind::sampled) return found_of_samples(over, plain, course, from, to);
    Found found;
    const bool of_mean = m.kind == Kind::mean || m.kind == Kind::rms;
    const Asked whole{m.asked.signal, of_mean ? 0 : m.asked.derivative};
    if (from < to && linkage::jumps_between(plain, whole, over.driven(dimensions), course, from, to)) {
        found.possible = false;
        return found;
    }
    if (of_mean) {
        found.possible = !linkage::divides_by_zero(plain, m.asked.signal, course, from, to);
        return found;
    }
    if (m.kind == Kind::at) {
        const auto laws = std::span<const linkage::DriveLaw>(plain.driven().laws);
        const bool end = !course.travel.whole && from == course.travel.to;
        const double within =
            end ? linkage::parts_of(laws, {course.travel.from, from}).back().within : linkage::within_after(laws, from);
        const linkage::WithinPiece in_piece(plain, within);
        const double value = plain.value(m.asked.signal, from, course.turns.near(from)).derivative(m.asked.derivative);
        found.plus.push_back({m.asked, {from, value, false, {}, within}});
        // Of drives that move by pieces it is the value after.
        const bool of_two = std::isnan(within) && linkage::has_two_values_at(plain, m.asked, course, from);
        found.possible =
            !std::isnan(value) && !of_two && !linkage::divides_by_zero_at(plain, m.asked.signal, course, from);
        return found;
    }
    if (m.kind == Kind::extent) return found;
    std::vector<Extreme> places = linkage::extremes(plain, m.asked, course, from, to);
    if (places.empty())
        places.push_back(
            {from, plain.value(m.asked.signal, from, course.turns.near(from)).derivative(m.asked.derivative), false});
    found.possible = closes(places);
    add_extremes(found, places, m.asked, 1, -radius);
    if (m.kind == Kind::distance_greatest) {
        add_extremes(found, places, m.asked, -1, radius);
        keep_greatest(found.plus, most_extremes);
    } else if (m.kind == Kind::least) {
        keep_least(found.plus, most_extremes);
    } else if (m.kind == Kind::greatest) {
        keep_greatest(found.plus, most_extremes);
    } else {
        found.minus = found.plus;
        const std::size_t count = m.kind == Kind::time_ratio  ? 1
                                  : m.kind == Kind::deviation ? most_of_deviation
                                                              : most_of_range;
        keep_greatest(found.plus, count);
        keep_least(found.minus, count);
    }
    return found;
}

}  // namespace mechwright::measuring
