#pragma once
/// \file
/// Numbers of twice the digits: the unevaluated sum of two, over any number type with IEEE arithmetic, lanes among
/// them. About 31 digits over doubles. The formulas are those of Dekker (1971) and Knuth: every operation is correct
/// but for a few units of the last place of both parts together.

#include <cstddef>
#include <type_traits>

#include "analysis/numbers/lanes.h"
#include "analysis/numbers/scalar.h"

namespace mechwright::homotopy {

template <class T>
struct Doubled {
    T high;
    T low;

    Doubled() = default;
    Doubled(double value) : high(value), low(0.0) {}  // NOLINT(google-explicit-constructor): constants mix freely
    Doubled(const T& h, const T& l) : high(h), low(l) {}

    friend Doubled operator+(const Doubled& a, const Doubled& b) {
        const Doubled s = sum(a.high, b.high), t = sum(a.low, b.low);
        const Doubled r = ordered_sum(s.high, s.low + t.high);
        return ordered_sum(r.high, r.low + t.low);
    }
    friend Doubled operator-(const Doubled& a) { return {-a.high, -a.low}; }
    friend Doubled operator-(const Doubled& a, const Doubled& b) { return a + (-b); }
    friend Doubled operator*(const Doubled& a, const Doubled& b) {
        const Doubled p = product(a.high, b.high);
        return ordered_sum(p.high, p.low + (a.high * b.low + a.low * b.high));
    }
    friend Doubled operator/(const Doubled& a, const Doubled& b) {
        const T first = a.high / b.high;
        const Doubled rest = a - b * Doubled(first, T(0.0));
        const T second = rest.high / b.high;
        const Doubled more = rest - b * Doubled(second, T(0.0));
        return ordered_sum(first, second) + Doubled(more.high / b.high, T(0.0));
    }
    friend auto operator<(const Doubled& a, const Doubled& b) { return a.high < b.high; }  // to the digits of one

private:
    /// a + b, and what rounding takes from it.
    static Doubled sum(const T& a, const T& b) {
        const T s = a + b, of_b = s - a;
        return {s, (a - (s - of_b)) + (b - of_b)};
    }
    /// The same for |a| >= |b|.
    static Doubled ordered_sum(const T& a, const T& b) {
        const T s = a + b;
        return {s, b - (s - a)};
    }
    /// a in two parts of at most 26 bits.
    static Doubled halves(const T& a) {
        const T scaled = T(134217729.0) * a;  // 2^27 + 1
        const T high = scaled - (scaled - a);
        return {high, a - high};
    }
    static Doubled product(const T& a, const T& b) {
        const T p = a * b;
        const Doubled x = halves(a), y = halves(b);
        return {p, ((x.high * y.high - p) + x.high * y.low + x.low * y.high) + x.low * y.low};
    }
};

using mechwright::select;

template <class Mask, class T>
requires(!std::is_same_v<Mask, bool>) Doubled<T> select(const Mask& condition, const Doubled<T>& yes,
                                                        const Doubled<T>& no) {
    return {select(condition, yes.high, no.high), select(condition, yes.low, no.low)};
}

// Single lanes.

template <std::size_t N>
double lane_of(const Lanes<N>& value, std::size_t lane) {
    return value.lane[lane];
}
template <std::size_t N>
void set_lane(Lanes<N>& value, std::size_t lane, double to) {
    value.lane[lane] = to;
}
template <std::size_t N>
void copy_lane(Lanes<N>& to, const Lanes<N>& from, std::size_t lane) {
    to.lane[lane] = from.lane[lane];
}
template <class T>
double lane_of(const Doubled<T>& value, std::size_t lane) {
    return lane_of(value.high, lane);
}
template <class T>
void set_lane(Doubled<T>& value, std::size_t lane, double to) {
    set_lane(value.high, lane, to);
    set_lane(value.low, lane, 0);
}
template <class T>
void copy_lane(Doubled<T>& to, const Doubled<T>& from, std::size_t lane) {
    copy_lane(to.high, from.high, lane);
    copy_lane(to.low, from.low, lane);
}

}  // namespace mechwright::homotopy
