#pragma once
/// \file
/// The nine-point problem as eight equations: four-bars whose coupler point passes through nine given points.
///
/// In complex numbers, with the first point as the origin: fixed pivots a and b, their moving pivots at x and y when
/// the coupler point is at the first point. At a point displaced by d the coupler has turned by theta, T = e^(i theta),
/// and the moving pivot is at d + x T, as far from a as before: (d + x T - a)(d' + x'/T - a') = (x - a)(x' - a'),
/// primes for conjugates. Multiplied out, each dyad is linear in T and 1/T:
///     A T + A'/T + C = 0,  A = x (d' - a'),  A' = x' (d - a),  C = d d' - d a' - d' a + x a' + x' a,
/// likewise B T + B'/T + D = 0 for the dyad y, b. Both hold for some T if
///     (A' D - B' C)(B C - A D) = (A B' - A' B)^2.
/// Conjugates are unknowns of their own, so that the equations are polynomials: eight unknowns, and the eight
/// displacements with their conjugates as parameters. (Wampler, Morgan and Sommese, "Complete solution of the
/// nine-point path synthesis problem for four-bar linkages", 1992; eliminated here by determinants.)

#include <array>
#include <cstddef>

#include "synthesis/exact/homotopy/linear_system.h"

namespace mechwright::homotopy {

struct NinePointSystem {
    static constexpr std::size_t size = 8;
    static constexpr std::size_t parameters = 16;

    enum Unknown : std::size_t { x, x_conjugate, a, a_conjugate, y, y_conjugate, b, b_conjugate };

    /// Eight displacements, then their conjugates.
    template <class T>
    using Parameters = std::array<Complex<T>, parameters>;
    template <class T>
    using Point = std::array<Complex<T>, size>;

    /// The equations' matrix of derivatives, and as right-hand side their negative values (`along` null) or the
    /// negative of their change as the parameters move in the direction `along`.
    template <class T>
    static void linearise(const Point<T>& u, const Parameters<T>& p, const Parameters<T>* along,
                          Augmented<T, size>& out) {
        for (std::size_t j = 0; j < size; ++j) {
            const Complex<T>&d = p[j], &dc = p[size + j];
            const Complex<T> da = d - u[a], dca = dc - u[a_conjugate], db = d - u[b], dcb = dc - u[b_conjugate];
            const Complex<T> A = u[x] * dca, Ac = u[x_conjugate] * da, B = u[y] * dcb, Bc = u[y_conjugate] * db;
            const Complex<T> dd = d * dc;
            const Complex<T> C = dd - d * u[a_conjugate] - dc * u[a] + u[x] * u[a_conjugate] + u[x_conjugate] * u[a];
            const Complex<T> D = dd - d * u[b_conjugate] - dc * u[b] + u[y] * u[b_conjugate] + u[y_conjugate] * u[b];
            const Complex<T> U = Ac * D - Bc * C, V = B * C - A * D, W = A * Bc - Ac * B;
            const Complex<T> W2 = W + W;
            // The derivatives of U V - W^2.
            const Complex<T> fA = -(U * D) - W2 * Bc, fAc = V * D + W2 * B, fC = U * B - V * Bc;
            const Complex<T> fB = U * C + W2 * Ac, fBc = -(V * C) - W2 * A, fD = V * Ac - U * A;
            auto& row = out[j];
            row[x] = fA * dca + fC * u[a_conjugate];
            row[x_conjugate] = fAc * da + fC * u[a];
            row[a] = fC * (u[x_conjugate] - dc) - fAc * u[x_conjugate];
            row[a_conjugate] = fC * (u[x] - d) - fA * u[x];
            row[y] = fB * dcb + fD * u[b_conjugate];
            row[y_conjugate] = fBc * db + fD * u[b];
            row[b] = fD * (u[y_conjugate] - dc) - fBc * u[y_conjugate];
            row[b_conjugate] = fD * (u[y] - d) - fB * u[y];
            if (along == nullptr) {
                row[size] = W * W - U * V;
                continue;
            }
            const Complex<T>&v = (*along)[j], &vc = (*along)[size + j];
            row[size] = -(vc * (fA * u[x] + fB * u[y] + fC * da + fD * db) +
                          v * (fAc * u[x_conjugate] + fBc * u[y_conjugate] + fC * dca + fD * dcb));
        }
    }
};

}  // namespace mechwright::homotopy
