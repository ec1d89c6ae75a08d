#pragma once
/// \file
/// Laws of motion of a cam follower, normalised: a rise from 0 to 1 while u goes from 0 to 1. Each law is analytic on
/// each of its pieces; at the breaks between them an acceleration or jerk may jump, so that a piece is asked for.
/// Formulas: Norton, Cam Design and Manufacturing Handbook, ch. 2 to 4; Neklutin for the modified laws; Kloomok and
/// Muffley, Product Engineering 1955. T is the type of u, R the type of constants beneath it (double, or fifty digits).

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "analysis/numbers/dual.h"
#include "analysis/numbers/second_dual.h"
#include "analysis/numbers/series.h"

namespace mechwright::cam {

/// A lift and its first three derivatives.
template <class T>
struct Lift {
    T s{};
    T v{};
    T a{};
    T j{};
};

enum class Law {
    constant_velocity,
    parabolic,
    harmonic,
    double_harmonic,
    cycloidal,
    modified_trapezoid,
    modified_sine,
    modified_constant_velocity,
    polynomial_345,
    polynomial_4567,
    kloomok_muffley,
    half_parabolic,
    half_harmonic,
    half_cycloidal
};

namespace detail {

/// A stretch of a law whose acceleration is sign * sin(w t), sign * cos(w t) or sign, t counted from its start.
struct Arc {
    enum class Shape { constant, sine, cosine };
    int to;  ///< in sixteenths
    Shape shape;
    int sign;
    int frequency;  ///< w is pi times this over 3
};

using Shape = Arc::Shape;

inline constexpr std::array parabolic_arcs{Arc{8, Shape::constant, 1, 0}, Arc{16, Shape::constant, -1, 0}};
inline constexpr std::array modified_trapezoid_arcs{Arc{2, Shape::sine, 1, 12}, Arc{6, Shape::constant, 1, 0},
                                                    Arc{10, Shape::cosine, 1, 12}, Arc{14, Shape::constant, -1, 0},
                                                    Arc{16, Shape::cosine, -1, 12}};
inline constexpr std::array modified_sine_arcs{Arc{2, Shape::sine, 1, 12}, Arc{14, Shape::cosine, 1, 4},
                                               Arc{16, Shape::cosine, -1, 12}};
inline constexpr std::array modified_constant_velocity_arcs{Arc{1, Shape::sine, 1, 24}, Arc{4, Shape::cosine, 1, 8},
                                                            Arc{12, Shape::constant, 0, 0}, Arc{15, Shape::sine, -1, 8},
                                                            Arc{16, Shape::cosine, -1, 24}};

/// The arcs of a law that is made of them; empty for the others.
inline std::span<const Arc> arcs_of(Law law) {
    switch (law) {
        case Law::parabolic: return parabolic_arcs;
        case Law::modified_trapezoid: return modified_trapezoid_arcs;
        case Law::modified_sine: return modified_sine_arcs;
        case Law::modified_constant_velocity: return modified_constant_velocity_arcs;
        default: return {};
    }
}

/// The peak acceleration of a law made of arcs, that makes its rise 1.
template <class R>
R peak_acceleration(Law law) {
    const R p = pi<R>();
    switch (law) {
        case Law::modified_trapezoid: return R(8) * p / (R(2) + p);
        case Law::modified_sine: return R(4) * p * p / (R(4) + p);
        case Law::modified_constant_velocity: return R(1) / (R(5) / (R(16) * p) + R(1) / (R(4) * p * p));
        default: return R(4);
    }
}

/// Lift, velocity, acceleration and jerk at t after the start of an arc that begins at lift s and velocity v.
template <class T, class R>
Lift<T> along(const Arc& arc, const R& peak, const R& s, const R& v, const T& t) {
    using std::cos, std::sin;
    const R a = R(arc.sign) * peak;
    if (arc.shape == Shape::constant) return {T(s) + (T(v) + T(a / R(2)) * t) * t, T(v) + T(a) * t, T(a), T(0)};
    const R w = R(arc.frequency) * pi<R>() / R(3);
    const T sine = sin(T(w) * t), cosine = cos(T(w) * t);
    if (arc.shape == Shape::sine)
        return {T(s) + T(v + a / w) * t - T(a / (w * w)) * sine, T(v) + T(a / w) * (T(R(1)) - cosine), T(a) * sine,
                T(a * w) * cosine};
    return {T(s) + T(v) * t + T(a / (w * w)) * (T(R(1)) - cosine), T(v) + T(a / w) * sine, T(a) * cosine,
            T(-(a * w)) * sine};
}

template <class T>
Lift<T> on_arcs(Law law, std::size_t piece, const T& u) {
    using R = Constant<T>;
    const auto arcs = arcs_of(law);
    const R peak = peak_acceleration<R>(law);
    R from(0), s(0), v(0);
    for (std::size_t i = 0; i < piece; ++i) {
        const R to = R(arcs[i].to) / R(16);
        const Lift<R> end = along<R, R>(arcs[i], peak, s, v, to - from);
        from = to;
        s = end.s;
        v = end.v;
    }
    return along<T, R>(arcs[piece], peak, s, v, u - T(from));
}

/// A polynomial with coefficients of u^0, u^1, ...
template <class T, std::size_t N>
Lift<T> on_polynomial(const std::array<Constant<T>, N>& coefficient, const T& u) {
    Lift<T> f;
    for (std::size_t i = N; i-- > 0;) {
        f.j = f.j * u + T(Constant<T>(3)) * f.a;
        f.a = f.a * u + T(Constant<T>(2)) * f.v;
        f.v = f.v * u + f.s;
        f.s = f.s * u + T(coefficient[i]);
    }
    return f;
}

/// f(u) seen backward: 1 - f(1 - u).
template <class T>
Lift<T> reversed(const Lift<T>& f) {
    return {T(Constant<T>(1)) - f.s, f.v, -f.a, f.j};
}

/// A polynomial from the nearer end, where its terms do not cancel. The coefficients, times `unit`: of u^0, u^1, ...,
/// and of the same seen backward.
template <class T, std::size_t N>
Lift<T> on_polynomial(const std::array<int, N>& from_start, const std::array<int, N>& from_end, int unit, const T& u) {
    using R = Constant<T>;
    const auto on = [&](const std::array<int, N>& times_unit, const T& at) {
        std::array<R, N> coefficient;
        for (std::size_t i = 0; i < N; ++i)
            coefficient[i] = R(times_unit[i]) / R(unit);
        return on_polynomial<T, N>(coefficient, at);
    };
    return u > T(R(0.5)) ? reversed(on(from_end, T(R(1)) - u)) : on(from_start, u);
}

/// Sine and cosine of an angle from those of its half.
template <class T>
struct Doubled {
    T half_sine;
    T sine;
    T cosine;
};

template <class T>
Doubled<T> doubled(const T& half) {
    using std::cos, std::sin;
    using R = Constant<T>;
    const T s = sin(half), c = cos(half);
    return {s, T(R(2)) * s * c, (c - s) * (c + s)};
}

/// x - sin(x), for x from 0 to 1.5 by its series, in which nothing cancels. sine = sin(x).
template <class T>
T less_its_sine(const T& x, const T& sine) {
    using R = Constant<T>;
    if (x > T(R(1.5))) return x - sine;
    // x^3/6 (1 - x^2/(4 5) (1 - x^2/(6 7) (...))): term number n is less than 1.5^(2 n + 3) / (2 n + 3)!.
    constexpr int terms = std::numeric_limits<R>::digits <= 53 ? 10 : 23;
    const T square = x * x;
    T sum = T(R(1));
    for (int n = terms; n > 0; --n)
        sum = T(R(1)) - square * T(R(1) / R((2 * n + 2) * (2 * n + 3))) * sum;
    return x * square * T(R(1) / R(6)) * sum;
}

/// amplitude * (1 - cos(w u)) and derivatives.
template <class T, class R>
Lift<T> versine(const R& amplitude, const R& w, const T& u) {
    const auto [half, sine, cosine] = doubled(T(T(w / R(2)) * u));
    return {T(R(2) * amplitude) * half * half, T(amplitude * w) * sine, T(amplitude * w * w) * cosine,
            T(-(amplitude * w * w * w)) * sine};
}

/// u - sin(w u) / w and derivatives.
template <class T, class R>
Lift<T> cycloid(const R& w, const T& u) {
    const auto [half, sine, cosine] = doubled(T(T(w / R(2)) * u));
    return {less_its_sine(T(T(w) * u), sine) * T(R(1) / w), T(R(2)) * half * half, T(w) * sine, T(w * w) * cosine};
}

template <class T>
Lift<T> difference(const Lift<T>& f, const Lift<T>& g) {
    return {f.s - g.s, f.v - g.v, f.a - g.a, f.j - g.j};
}

}  // namespace detail

/// How many pieces a law is made of.
inline std::size_t pieces(Law law) {
    const auto arcs = detail::arcs_of(law);
    return arcs.empty() ? 1 : arcs.size();
}

/// Where piece number `piece` begins; for the number of pieces 1, where the last one ends.
inline double break_before(Law law, std::size_t piece) {
    if (piece == 0) return 0;
    return piece == pieces(law) ? 1 : detail::arcs_of(law)[piece - 1].to / 16.0;
}

/// Whether a law is half of another one, from or to rest.
inline bool is_half(Law law) {
    return law == Law::half_parabolic || law == Law::half_harmonic || law == Law::half_cycloidal;
}

/// The law at u in [0, 1], by the formula of the given piece (precondition: piece < pieces(law)). Half laws start from
/// rest.
template <class T>
Lift<T> lift_at(Law law, std::size_t piece, const T& u) {
    using R = Constant<T>;
    const R p = pi<R>();
    switch (law) {
        case Law::constant_velocity: return {u, T(R(1)), T(R(0)), T(R(0))};
        case Law::harmonic: return detail::versine<T, R>(R(1) / R(2), p, u);
        case Law::double_harmonic:
            return detail::difference(detail::versine<T, R>(R(1) / R(2), p, u),
                                      detail::versine<T, R>(R(1) / R(8), R(2) * p, u));
        case Law::cycloidal: return detail::cycloid<T, R>(R(2) * p, u);
        case Law::polynomial_345: {
            constexpr std::array<int, 6> either_end{0, 0, 0, 10, -15, 6};
            return detail::on_polynomial<T>(either_end, either_end, 1, u);
        }
        case Law::polynomial_4567: {
            constexpr std::array<int, 8> either_end{0, 0, 0, 0, 35, -84, 70, -20};
            return detail::on_polynomial<T>(either_end, either_end, 1, u);
        }
        case Law::kloomok_muffley:
            return detail::on_polynomial<T>(std::array{0, 0, 0, 609755, 0, -2078040, 2673155, -1360965, 256095},
                                            std::array{0, 0, 263415, 0, 0, -278055, -317060, 687795, -256095}, 100000,
                                            u);
        case Law::half_parabolic: return detail::on_polynomial<T, 3>({R(0), R(0), R(1)}, u);
        case Law::half_harmonic: return detail::versine<T, R>(R(1), p / R(2), u);
        case Law::half_cycloidal: return detail::cycloid<T, R>(p, u);
        default: return detail::on_arcs(law, piece, u);
    }
}

}  // namespace mechwright::cam
