#pragma once
/// \file
/// Extremes of signals of a linkage, limits of its motion and its given ends as functions of the dimensions: where they
/// are moves with these, and what is asked there follows by Taylor's series of the implicit function.

#include <cmath>
#include <cstddef>

#include "analysis/linkage/measuring/course.h"
#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

namespace detail {

/// The derivatives of a number alone.
template <class T>
T change_of(T x) {
    if constexpr (requires { x.value; })
        x.value = 0;
    else
        x = T(0);
    return x;
}

/// By how much the time changes with the dimensions at which a derivative of f vanishes, up to second derivatives
/// (Newton's method; each step has one order more). Zero where that place is not settled, at this rate of the input by
/// the time.
template <class T, std::size_t K>
T shift_of_zero(const Series<T, K>& f, std::size_t derivative, double rate) {
    constexpr double settled = 1e-12;
    const T slope = derivative < K ? f.derivative(derivative + 1) : T(0);
    double size = 0, power = 1;
    for (std::size_t k = 0; k <= K; ++k, power *= std::abs(rate))
        size = std::max(size, std::abs(value_of(f.derivative(k))) / power);
    power = std::pow(std::abs(rate), static_cast<double>(derivative + 1));
    if (!(std::abs(value_of(slope)) > settled * size * power)) return T(0);
    const T value = change_of(f.derivative(derivative));
    const T first = change_of(T(-(value / slope)));
    const T curvature = derivative + 2 <= K ? f.derivative(derivative + 2) : T(0);
    return change_of(T(first - T(0.5) * curvature * (first * first) / slope));
}

/// A derivative of f where the time has changed by derivatives alone, up to second ones.
template <class T, std::size_t K>
T after_shift(const Series<T, K>& f, std::size_t derivative, const T& shift) {
    T sum = f.derivative(derivative);
    if (derivative + 1 <= K) sum = sum + f.derivative(derivative + 1) * shift;
    if (derivative + 2 <= K) sum = sum + T(0.5) * f.derivative(derivative + 2) * (shift * shift);
    return sum;
}

}  // namespace detail

/// By how much the time of the ends of a motion changes with what is seeded, where these are given by it: derivatives
/// of 0.
template <class T>
struct MovingEnds {
    T from = T(0);
    T to = T(0);

    /// That of a place which is an end of a motion, and no limit.
    T at(const Extreme& place, const Travel& travel) const {
        return place.stationary ? T(0) : place.at == travel.from ? from : place.at == travel.to ? to : T(0);
    }
};

/// How the time at which a place is passed changes with the dimensions, as derivatives of 0: of a limit, of a
/// stationary place of what is asked, or of an end. K must be `order_for` it, and one more for second derivatives.
template <class T, std::size_t K>
T shift_of(Measured<T, K>& measured, const Asked& asked, const Course& course, const Extreme& place,
           const MovingEnds<T>& ends = {}) {
    const auto near = course.turns.near(place.at);
    const WithinPiece in_piece(measured, place.within);
    if (place.limit.exists())
        return detail::shift_of_zero(measured.margin(place.limit, place.at, near), 0, measured.rate());
    if (!place.stationary) return ends.at(place, course.travel);
    return detail::shift_of_zero(measured.value(asked.signal, place.at, near), asked.derivative + 1, measured.rate());
}

/// What is asked at one of its extremes as a function of the dimensions: the place moves with them, or is given. K must
/// be `order_for` it.
template <class T, std::size_t K>
T value_at(Measured<T, K>& measured, const Asked& asked, const Course& course, const Extreme& place,
           const MovingEnds<T>& ends = {}) {
    if (!std::isfinite(place.value)) return T(place.value);
    const auto near = course.turns.near(place.at);
    if (!place.limit.exists()) {
        const WithinPiece in_piece(measured, place.within);
        const auto f = measured.value(asked.signal, place.at, near);
        const T shift = place.stationary ? detail::shift_of_zero(f, asked.derivative + 1, measured.rate())
                                         : ends.at(place, course.travel);
        return detail::after_shift(f, asked.derivative, shift);
    }
    const T shift = shift_of(measured, asked, course, place);
    const WithinPiece in_piece(measured, place.within);
    const bool exactly = !place.limit.stop && asked.derivative + order_of(measured.signals(), asked.signal) == 0;
    const auto f = measured.value(asked.signal, place.at, near, exactly ? place.limit : Limit{});
    const T value = detail::after_shift(f, asked.derivative, shift);
    if (!exactly || !detail::others_at_limit(measured, place.limit)) return value;
    return value + T(place.value - number_as<double>(value_of(value)));
}

/// A signal, with a factor and a constant.
struct Scaled {
    std::size_t signal = 0;
    double factor = 1;
    double constant = 0;
};

/// Where two signals say the same, what both say as a function of the dimensions. K must be 2 at least.
template <class T, std::size_t K>
T value_where_equal(Measured<T, K>& measured, const Scaled& one, const Scaled& other, const Course& course,
                    const Extreme& place) {
    const auto near = course.turns.near(place.at);
    const WithinPiece in_piece(measured, place.within);
    using Value = Series<T, K>;
    const auto scaled = [&](const Scaled& by) {
        return Value(T(by.constant)) + Value(T(by.factor)) * measured.value(by.signal, place.at, near);
    };
    const Value f = scaled(one);
    return detail::after_shift(f, 0, detail::shift_of_zero(f - scaled(other), 0, measured.rate()));
}

/// What is asked at a place that keeps its share of the motion where the ends move. K must be `order_for` it.
template <class T, std::size_t K>
T value_at_share(Measured<T, K>& measured, const Asked& asked, const Course& course, const Extreme& place,
                 const MovingEnds<T>& ends) {
    const Travel& travel = course.travel;
    if (place.at == travel.from || place.at == travel.to) return value_at(measured, asked, course, place, ends);
    const double share = (place.at - travel.from) / (travel.to - travel.from);
    const T shift = T(1 - share) * ends.from + T(share) * ends.to;
    const WithinPiece in_piece(measured, place.within);
    return detail::after_shift(measured.value(asked.signal, place.at, course.turns.near(place.at)), asked.derivative,
                               shift);
}

}  // namespace mechwright::linkage
