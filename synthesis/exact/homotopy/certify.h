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
    constexpr double done = 1e-40;
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

}  // namespace detail

/// Nothing where the proof does not succeed. `System` is as for Tracker, with `template <class T> static Point<T>
/// mirrored(const Point<T>&)`, which takes solutions to solutions where the parameters are real, and keeps real ones.
template <class System>
std::optional<Certificate<System>> certify(const System& system,
                                           const typename System::template Point<double>& approximation,
                                           const typename System::template Parameters<Digits50>& parameters) {
    constexpr std::size_t n = System::size;
    constexpr double relative_half_width = 1e-22;
    Certificate<System> certificate;
    auto& m = certificate.solution;
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        m[i] = {Digits50(approximation[i].re), Digits50(approximation[i].im)};
        size = std::max(size, std::sqrt(norm(approximation[i])));
    }
    if (!detail::refined(system, m, parameters)) return {};
    const double r = certificate.radius = relative_half_width * size;
    const auto balls = detail::in_balls<System>(parameters);
    const auto at_middle = detail::at_box(system, m, 0, balls), over_box = detail::at_box(system, m, r, balls);

    Eigen::Matrix<std::complex<double>, n, n> slopes;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            slopes(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = {
                at_middle[i][j].re.middle().template convert_to<double>(),
                at_middle[i][j].im.middle().template convert_to<double>()};
    const Eigen::Matrix<std::complex<double>, n, n> inverse = slopes.partialPivLu().inverse();
    if (!inverse.allFinite()) return {};
    double off = 0;  // how far the operator's middle is from m, at most
    for (std::size_t i = 0; i < n; ++i) {
        Complex<Ball> step{Ball(0.0), Ball(0.0)};
        double spread = 0;
        for (std::size_t j = 0; j < n; ++j) {
            Complex<Ball> entry{Ball(i == j ? 1.0 : 0.0), Ball(0.0)};
            for (std::size_t k = 0; k < n; ++k) {
                const std::complex<double>& y = inverse(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k));
                const Complex<Ball> factor{Ball(y.real()), Ball(y.imag())};
                entry = entry - factor * over_box[k][j];
                if (j == 0) step = step + factor * at_middle[k][n];
            }
            spread += detail::magnitude(entry);
        }
        // A number of the box has an absolute value of at most sqrt(2) r.
        constexpr double corner = 1.4142135623731;
        const double here = detail::magnitude(step);
        if (!(here + corner * spread * r * (1 + 1e-12) < r)) return {};
        off = std::max(off, here + corner * spread * r);
    }
    const auto mirrored = System::mirrored(m);
    double apart = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Complex<Digits50> difference = mirrored[i] - m[i];
        apart = std::max(apart, std::sqrt(norm(detail::rounded(difference))));
    }
    certificate.real = apart + off < r;
    return certificate;
}

}  // namespace mechwright::homotopy
