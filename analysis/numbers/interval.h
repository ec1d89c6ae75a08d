#pragma once
/// \file
/// Interval arithmetic for bounds that must hold: every operation returns an interval that contains all results, with
/// the rounding of its ends turned outwards (Moore, Kearfott and Cloud, Introduction to Interval Analysis, chapters 2
/// and 5). A division by an interval that holds zero gives the whole line.

#include <algorithm>
#include <cmath>
#include <limits>

namespace mechwright {

struct Interval {
    double low = 0;
    double high = 0;

    constexpr Interval() = default;
    constexpr Interval(double value) : low(value), high(value) {}  // NOLINT(google-explicit-constructor)
    constexpr Interval(double l, double h) : low(l), high(h) {}

    double middle() const { return 0.5 * (low + high); }
    double radius() const { return 0.5 * (high - low); }
    /// The greatest size of a number in it.
    double size() const { return std::max(std::abs(low), std::abs(high)); }
    bool holds(double x) const { return low <= x && x <= high; }
};

namespace detail {

/// Both ends moved outwards by `ulps` rounding units of their own size, and off zero.
inline Interval outward(double low, double high, double ulps = 1) {
    constexpr double unit = std::numeric_limits<double>::epsilon();
    constexpr double least = std::numeric_limits<double>::min();
    return {low - (ulps * unit * std::abs(low) + least), high + (ulps * unit * std::abs(high) + least)};
}

}  // namespace detail

inline Interval whole_line() {
    return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
}

inline Interval operator+(const Interval& a, const Interval& b) {
    return detail::outward(a.low + b.low, a.high + b.high);
}
inline Interval operator-(const Interval& a, const Interval& b) {
    return detail::outward(a.low - b.high, a.high - b.low);
}
inline Interval operator-(const Interval& a) { return {-a.high, -a.low}; }
inline Interval operator*(const Interval& a, const Interval& b) {
    const double p = a.low * b.low, q = a.low * b.high, r = a.high * b.low, s = a.high * b.high;
    return detail::outward(std::min(std::min(p, q), std::min(r, s)), std::max(std::max(p, q), std::max(r, s)));
}
inline Interval operator/(const Interval& a, const Interval& b) {
    if (b.holds(0)) return whole_line();
    return a * detail::outward(1 / b.high, 1 / b.low);
}
inline Interval& operator+=(Interval& a, const Interval& b) { return a = a + b; }
inline Interval& operator-=(Interval& a, const Interval& b) { return a = a - b; }
inline Interval& operator*=(Interval& a, const Interval& b) { return a = a * b; }

inline double square(double x) { return x * x; }
inline Interval square(const Interval& a) {
    const double greatest = a.size();
    const double least = a.holds(0) ? 0 : std::min(std::abs(a.low), std::abs(a.high));
    const Interval r = detail::outward(least * least, greatest * greatest);
    return {std::max(0.0, r.low), r.high};
}

/// Of the part that is not negative.
inline Interval sqrt(const Interval& a) {
    const Interval r = detail::outward(std::sqrt(std::max(0.0, a.low)), std::sqrt(std::max(0.0, a.high)));
    return {std::max(0.0, r.low), r.high};
}

/// Of the part within [-1, 1].
inline Interval acos(const Interval& a) {
    return detail::outward(std::acos(std::clamp(a.high, -1.0, 1.0)), std::acos(std::clamp(a.low, -1.0, 1.0)), 4);
}

/// cos x over an interval: its ends, and the extremes at the multiples of pi between them. The library's cosine is good
/// to an ulp; four are allowed for.
inline Interval cos(const Interval& a) {
    constexpr double pi = 3.141592653589793238;
    if (!(a.high - a.low < 2 * pi)) return {-1, 1};
    const double from = std::ceil(a.low / pi - 1e-12), to = std::floor(a.high / pi + 1e-12);
    double low = std::min(std::cos(a.low), std::cos(a.high)), high = std::max(std::cos(a.low), std::cos(a.high));
    for (double k = from; k <= to; ++k)
        (std::fmod(k, 2) == 0 ? high : low) = std::fmod(k, 2) == 0 ? 1 : -1;
    const Interval r = detail::outward(low, high, 4);
    return {std::max(-1.0, r.low), std::min(1.0, r.high)};
}

inline Interval sin(const Interval& a) {
    const Interval quarter{1.5707963267948963, 1.5707963267948968};
    return cos(a - quarter);
}

}  // namespace mechwright
