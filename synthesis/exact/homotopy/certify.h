#pragma once
/// \file
/// Proof that a system of equations has a solution near an approximation, that it is the only one there, and that it is
/// real: Krawczyk's operator over the complex numbers. (R. Krawczyk, "Newton-Algorithmen zur Bestimmung von Nullstellen
/// mit Fehlerschranken", 1969.)
///
/// With F' the derivatives over a box X of half-width r about m, and Y an approximate inverse of F'(m): if
/// m - Y F(m) + (I - Y F'(X)) (X - m) lies inside X, then exactly one solution does. Evaluated with balls (ball.h), so
/// that rounding is part of the proof.

#include <Eigen/LU>
#include <complex>
#include <optional>

#include "synthesis/exact/homotopy/ball.h"
#include "synthesis/exact/homotopy/linear_system.h"

namespace mechwright::homotopy {

template <class System>
struct Certificate {
    typename System::template Point<Digits50> solution;  ///< to about fifty digits less its condition
    double radius = 0;                                   ///< in which it is the only one, in each part
    bool real = false;                                   ///< it is its own mirror image
};

namespace detail {

inline Complex<double> rounded(const Complex<Digits50>& z) {
    return {z.re.convert_to<double>(), z.im.convert_to<double>()};
}

template <class System>
typename System::template Parameters<Ball> in_balls(const typename System::template Parameters<Digits50>& p) {
    typename System::template Parameters<Ball> balls;
    for (std::size_t i = 0; i < p.size(); ++i)
        balls[i] = {Ball(p[i].re, 0), Ball(p[i].im, 0)};
    return balls;
}

template <class System>
Augmented<Ball, System::size> at_box(const System& system, const typename System::template Point<Digits50>& middle,
                                     double half_width, const typename System::template Parameters<Ball>& p) {
    typename System::template Point<Ball> box;
    for (std::size_t i = 0; i < middle.size(); ++i)
        box[i] = {Ball(middle[i].re, half_width), Ball(middle[i].im, half_width)};
    Augmented<Ball, System::size> out;
    system.linearise(box, p, static_cast<const typename System::template Parameters<Ball>*>(nullptr), out);
    return out;
}

/// Newton's corrections in fifty digits; false where they do not converge.
template <class System>
bool refined(const System& system, typename System::template Point<Digits50>& u,
             const typename System::template Parameters<Digits50>& p) {
    constexpr int most = 10;
    constexpr double done = 1e-30;  // relative: far inside the box, also where half of the digits cancel
    Augmented<Digits50, System::size> matrix;
    for (int k = 0; k < most; ++k) {
        system.linearise(u, p, static_cast<const typename System::template Parameters<Digits50>*>(nullptr), matrix);
        solve(matrix);
        double change = 0, size = 0;
        for (std::size_t i = 0; i < u.size(); ++i) {
            u[i] = u[i] + matrix[i][System::size];
            change = std::max(change, norm(rounded(matrix[i][System::size])));
            size = std::max(size, norm(rounded(u[i])));
        }
        if (!std::isfinite(change)) return false;
        if (change <= done * done * size) return true;
    }
    return false;
}

inline double magnitude(const Complex<Ball>& z) { return std::hypot(z.re.magnitude(), z.im.magnitude()) * (1 + 1e-14); }

template <std::size_t n>
using Square = std::array<std::array<Complex<Digits50>, n>, n>;

/// About the inverse of the derivatives, in double.
template <std::size_t n>
Square<n> rough_inverse(const Augmented<Ball, n>& slopes) {
    Eigen::Matrix<std::complex<double>, n, n> plain;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            plain(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = {
                slopes[i][j].re.middle().template convert_to<double>(),
                slopes[i][j].im.middle().template convert_to<double>()};
    const Eigen::Matrix<std::complex<double>, n, n> inverse = plain.partialPivLu().inverse();
    Square<n> out;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const auto& z = inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
            out[i][j] = {Digits50(z.real()), Digits50(z.imag())};
        }
    return out;
}

/// The same in fifty digits.
template <std::size_t n>
Square<n> fine_inverse(const Augmented<Ball, n>& slopes) {
    Square<n> out;
    for (std::size_t column = 0; column < n; ++column) {
        Augmented<Digits50, n> equations;
        for (std::size_t i = 0; i < n; ++i) {
            for (std::size_t j = 0; j < n; ++j)
                equations[i][j] = {slopes[i][j].re.middle(), slopes[i][j].im.middle()};
            equations[i][n] = {Digits50(i == column ? 1 : 0), Digits50(0)};
        }
        solve(equations);
        for (std::size_t i = 0; i < n; ++i)
            out[i][column] = equations[i][n];
    }
    return out;
}

/// How far from m, in any part, a solution in the box can be at most; nothing where the operator does not lie inside
/// the box.
template <std::size_t n>
std::optional<double> contraction(const Augmented<Ball, n>& at_middle, const Augmented<Ball, n>& over_box,
                                  const Square<n>& inverse, double half_width) {
    constexpr double corner = 1.4142135623731;  // a number of the box is at most so many half-widths long
    double farthest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        Complex<Ball> step{Ball(0.0), Ball(0.0)};
        double spread = 0;
        for (std::size_t j = 0; j < n; ++j) {
            Complex<Ball> entry{Ball(i == j ? 1.0 : 0.0), Ball(0.0)};
            for (std::size_t k = 0; k < n; ++k) {
                const Complex<Ball> factor{Ball(inverse[i][k].re, 0), Ball(inverse[i][k].im, 0)};
                entry = entry - factor * over_box[k][j];
                if (j == 0) step = step + factor * at_middle[k][n];
            }
            spread += magnitude(entry);
        }
        const double here = magnitude(step) + corner * spread * half_width * (1 + 1e-12);
        if (!(here < half_width)) return {};
        farthest = std::max(farthest, here);
    }
    return farthest;
}

}  // namespace detail

/// Nothing where the proof does not succeed. `System` is as for Tracker, with `template <class T> static Point<T>
/// mirrored(const Point<T>&)`, which takes solutions to solutions where the parameters are real, and keeps real ones.
template <class System>
std::optional<Certificate<System>> certify(const System& system,
                                           const typename System::template Point<Digits50>& approximation,
                                           const typename System::template Parameters<Digits50>& parameters) {
    constexpr std::size_t n = System::size;
    // A wide box where double does for the inverse; a narrow one where solutions lie close together.
    constexpr double wide = 1e-22, narrow = 1e-27;
    Certificate<System> certificate{approximation};
    auto& m = certificate.solution;
    double size = 0;
    for (const Complex<Digits50>& z : approximation)
        size = std::max(size, std::sqrt(norm(detail::rounded(z))));
    if (!detail::refined(system, m, parameters)) return {};
    const auto balls = detail::in_balls<System>(parameters);
    const auto at_middle = detail::at_box(system, m, 0, balls);
    const auto within = [&](double half_width, const auto& inverse) {
        certificate.radius = half_width;
        return detail::contraction<n>(at_middle, detail::at_box(system, m, half_width, balls), inverse, half_width);
    };
    auto off = within(wide * size, detail::rough_inverse<n>(at_middle));
    if (!off) off = within(narrow * size, detail::fine_inverse<n>(at_middle));
    if (!off) return {};
    const auto mirrored = System::mirrored(m);
    double apart = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Complex<Digits50> difference = mirrored[i] - m[i];
        apart = std::max(apart, std::sqrt(norm(detail::rounded(difference))));
    }
    certificate.real = apart + *off < certificate.radius;
    return certificate;
}

/// From an approximation in double.
template <class System>
std::optional<Certificate<System>> certify(const System& system,
                                           const typename System::template Point<double>& approximation,
                                           const typename System::template Parameters<Digits50>& parameters) {
    typename System::template Point<Digits50> fine;
    for (std::size_t i = 0; i < fine.size(); ++i)
        fine[i] = {Digits50(approximation[i].re), Digits50(approximation[i].im)};
    return certify(system, fine, parameters);
}

}  // namespace mechwright::homotopy
