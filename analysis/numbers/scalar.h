#pragma once
/// \file
/// What the kinematic templates ask of a number type besides + - * / and comparison, for plain floating-point types.
/// Dual numbers add their own overloads in dual.h and second_dual.h; a batch or interval type would do the same.

#include <cmath>
#include <numbers>
#include <type_traits>

namespace mechwright {

/// The number below all derivatives: what comparisons and branches look at.
template <class T>
constexpr const T& value_of(const T& x) {
    return x;
}

namespace detail {

template <class T>
struct Underlying {
    using type = T;
};
template <class T>
requires requires { typename T::Value; }
struct Underlying<T> {
    using type = typename Underlying<typename T::Value>::type;
};

}  // namespace detail

/// The plain type beneath a number: that of its constants.
template <class T>
using Constant = typename detail::Underlying<T>::type;

/// A number in another type; where derivatives have no place in it, they are left out.
template <class To, class From>
constexpr To number_as(const From& x) {
    if constexpr (std::is_constructible_v<To, From>)
        return static_cast<To>(x);
    else
        return static_cast<To>(value_of(x));
}

/// `yes` where the condition holds, else `no`. Branches in formulas are written with it, so that a batch of numbers
/// can answer lane by lane.
template <class T>
constexpr T select(bool condition, const T& yes, const T& no) {
    return condition ? yes : no;
}

/// pi to the precision of T.
template <class T>
T pi() {
    if constexpr (std::is_same_v<T, double>) {
        return std::numbers::pi;
    } else if constexpr (requires { typename T::Value; }) {
        return T(pi<typename T::Value>());
    } else {
        using std::atan2;
        return atan2(T(0), T(-1));
    }
}

template <class T>
struct SineAndCosine {
    T sine, cosine;
};

/// Both of one angle, which together take hardly longer than one of them.
template <class T>
SineAndCosine<T> sine_and_cosine(const T& angle) {
    using std::cos, std::sin;
    return {sin(angle), cos(angle)};
}

/// Whether both hold.
constexpr bool both(bool a, bool b) { return a && b; }

/// sqrt(a^2 + b^2). The plain formula is right to a unit of the last place where no square leaves the range of double.
template <class T>
T hypotenuse(const T& a, const T& b) {
    using std::hypot;
    if constexpr (std::is_same_v<T, double>) {
        const double square = a * a + b * b;
        const bool plain = square > 1e-280 && square < 1e280;
        return plain ? std::sqrt(square) : std::hypot(a, b);
    } else {
        return hypot(a, b);
    }
}

namespace detail {

template <class T>
struct TwoSum {
    T sum;
    T error;
};

/// Knuth's error-free sum: sum + error == a + b exactly.
template <class T>
TwoSum<T> two_sum(const T& a, const T& b) {
    const T sum = a + b;
    const T b_part = sum - a;
    return {sum, (a - (sum - b_part)) + (b - b_part)};
}

}  // namespace detail

/// Whether T is double or lanes of doubles (lanes.h): arithmetic of 53 bits and nothing else.
template <class T>
inline constexpr bool plain_doubles = std::is_same_v<T, double> || requires(const T& x) {
    x.lane[0];
};

/// (a + b) - (c + d) with one compensation pass. This is the shape of every Grashof margin; written out plainly it
/// loses all digits where the margin is small against the lengths.
template <class T>
T sum_difference(const T& a, const T& b, const T& c, const T& d) {
    if constexpr (plain_doubles<T>) {
        const auto [left, left_error] = detail::two_sum(a, b);
        const auto [right, right_error] = detail::two_sum(c, d);
        const auto [difference, error] = detail::two_sum(left, T(-right));
        return difference + (error + (left_error - right_error));
    } else {
        return (a + b) - (c + d);
    }
}

}  // namespace mechwright
