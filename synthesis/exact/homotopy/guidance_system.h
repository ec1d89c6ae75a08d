#pragma once
/// \file
/// Four-bars, or slider-cranks, that guide a body through given poses and a point of it through given points, as eight
/// equations.
///
/// In complex numbers, with the body's point in the first pose as the origin: fixed pivots a and b, their moving pivots
/// at x and y in that pose. At a displacement by d the body has turned by theta, T = e^(i theta), and the moving pivot
/// is at d + x T, as far from a as before: (d + x T - a)(d' + x'/T - a') = (x - a)(x' - a'), primes for conjugates.
/// Multiplied out, each dyad is linear in T and 1/T:
///     A T + A'/T + C = 0,  A = x (d' - a'),  A' = x' (d - a),  C = d d' - d a' - d' a + x a' + x' a,
/// likewise B T + B'/T + D = 0 for the dyad y, b. In a further pose T is known: two equations, multiplied by T. At a
/// point it is not, and both hold for some T if
///     (A' D - B' C)(B C - A D) = (A B' - A' B)^2.
/// Conjugates are unknowns of their own, so that the equations are polynomials in eight unknowns. One pose and eight
/// points, two and six, three and four, four and two make eight equations. (The first of these is the nine-point
/// problem: Wampler, Morgan and Sommese, "Complete solution of the nine-point path synthesis problem for four-bar
/// linkages", 1992; eliminated here by determinants.)
///
/// A ram slides on a line: its fixed pivot is infinitely far away. Divided by its distance, the dyad's equation keeps
/// the terms with the pivot, which stands for its direction (b, b'), square to the line:
///     B = -y b',  B' = -y' b,  D = -d b' - d' b + y b' + y' b.
/// One place less says all of it: one pose and seven points, two and five, three and three, four and one. The eighth
/// equation is b b' = 1.

#include <array>
#include <cstddef>
#include <cstdint>

#include "synthesis/exact/homotopy/linear_system.h"

namespace mechwright::homotopy {

/// What the second dyad is.
enum class SecondDyad : std::uint8_t { rocker, ram };

struct GuidanceSystem {
    static constexpr std::size_t size = 8;
    /// Displacements, their conjugates, and the turns of further poses.
    static constexpr std::size_t first_conjugate = 8;
    static constexpr std::size_t first_turn = 16;
    static constexpr std::size_t most_poses = 4;
    static constexpr std::size_t parameters = first_turn + most_poses - 1;

    std::size_t poses = 1;  ///< 1 to 4; further ones come first among the displacements

    SecondDyad second = SecondDyad::rocker;

    friend bool operator==(const GuidanceSystem&, const GuidanceSystem&) = default;

    constexpr bool has_ram() const { return second == SecondDyad::ram; }
    std::size_t displacements() const { return (has_ram() ? 8 : 9) - poses; }

    /// For a ram b is the direction of its fixed pivot.
    enum Unknown : std::size_t { x, x_conjugate, a, a_conjugate, y, y_conjugate, b, b_conjugate };

    /// Those that there are no places for stay 0.
    template <class T>
    using Parameters = std::array<Complex<T>, parameters>;
    template <class T>
    using Point = std::array<Complex<T>, size>;

    /// The equations' matrix of derivatives, and as right-hand side their negative values (`along` null) or the
    /// negative of their change as the parameters move in the direction `along`.
    template <class T>
    void linearise(const Point<T>& u, const Parameters<T>& p, const Parameters<T>* along,
                   Augmented<T, size>& out) const {
        const std::size_t turned = poses - 1;
        for (std::size_t k = 0; k < turned; ++k) {
            pose_row(x, SecondDyad::rocker, u, p, along, k, out[2 * k]);
            pose_row(y, second, u, p, along, k, out[2 * k + 1]);
        }
        for (std::size_t j = turned; j < displacements(); ++j)
            point_row(u, p, along, j, out[turned + j]);
        if (has_ram()) direction_row(u, along, out[size - 1]);
    }

    /// Conjugates in the place of the numbers and the other way round.
    template <class T>
    static Point<T> mirrored(const Point<T>& u) {
        Point<T> other;
        for (std::size_t i = 0; i < size; ++i)
            other[i] = {u[i ^ 1].re, -u[i ^ 1].im};
        return other;
    }

private:
    template <class T>
    using Row = std::array<Complex<T>, size + 1>;

    template <class T>
    static Complex<T> zero() {
        return {T(0.0), T(0.0)};
    }

    /// The direction of a ram's fixed pivot has length 1.
    template <class T>
    static void direction_row(const Point<T>& u, const Parameters<T>* along, Row<T>& row) {
        row.fill(zero<T>());
        row[b] = u[b_conjugate];
        row[b_conjugate] = u[b];
        if (along == nullptr) row[size] = Complex<T>{T(1.0), T(0.0)} - u[b] * u[b_conjugate];
    }

    /// One dyad, whose unknowns begin at `first`, in a pose.
    template <class T>
    static void pose_row(std::size_t first, SecondDyad kind, const Point<T>& u, const Parameters<T>& p,
                         const Parameters<T>* along, std::size_t k, Row<T>& row) {
        const bool ram = kind == SecondDyad::ram;
        const Complex<T>&turn = p[first_turn + k], &d = p[k], &dc = p[first_conjugate + k];
        const Complex<T>&m = u[first], &mc = u[first + 1], &f = u[first + 2], &fc = u[first + 3];
        const Complex<T> square = turn * turn, df = (ram ? zero<T>() : d) - f, dfc = (ram ? zero<T>() : dc) - fc;
        const Complex<T> dd = ram ? zero<T>() : d * dc;
        const Complex<T> A = m * dfc, Ac = mc * df, C = dd - d * fc - dc * f + m * fc + mc * f;
        row.fill(zero<T>());
        row[first] = dfc * square + fc * turn;
        row[first + 1] = df + f * turn;
        row[first + 2] = (mc - dc) * turn - mc;
        row[first + 3] = (m - d) * turn - m * square;
        if (along == nullptr) {
            row[size] = -(A * square + C * turn + Ac);
            return;
        }
        const Complex<T> v = (*along)[k], vc = (*along)[first_conjugate + k], w = (*along)[first_turn + k];
        const Complex<T> by_v = ram ? turn * dfc : mc + turn * dfc;
        const Complex<T> by_vc = ram ? turn * df : m * square + turn * df;
        row[size] = -(v * by_v + vc * by_vc + w * (A * turn + A * turn + C));
    }

    template <class T>
    void point_row(const Point<T>& u, const Parameters<T>& p, const Parameters<T>* along, std::size_t j,
                   Row<T>& row) const {
        const bool ram = has_ram();
        const Complex<T>&d = p[j], &dc = p[first_conjugate + j];
        const Complex<T> da = d - u[a], dca = dc - u[a_conjugate];
        const Complex<T> db = (ram ? zero<T>() : d) - u[b], dcb = (ram ? zero<T>() : dc) - u[b_conjugate];
        const Complex<T> A = u[x] * dca, Ac = u[x_conjugate] * da, B = u[y] * dcb, Bc = u[y_conjugate] * db;
        const Complex<T> dd = d * dc;
        const Complex<T> C = dd - d * u[a_conjugate] - dc * u[a] + u[x] * u[a_conjugate] + u[x_conjugate] * u[a];
        const Complex<T> D =
            (ram ? zero<T>() : dd) - d * u[b_conjugate] - dc * u[b] + u[y] * u[b_conjugate] + u[y_conjugate] * u[b];
        const Complex<T> U = Ac * D - Bc * C, V = B * C - A * D, W = A * Bc - Ac * B;
        const Complex<T> W2 = W + W;
        // The derivatives of U V - W^2.
        const Complex<T> fA = -(U * D) - W2 * Bc, fAc = V * D + W2 * B, fC = U * B - V * Bc;
        const Complex<T> fB = U * C + W2 * Ac, fBc = -(V * C) - W2 * A, fD = V * Ac - U * A;
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
            return;
        }
        const Complex<T>&v = (*along)[j], &vc = (*along)[first_conjugate + j];
        // The terms of the rocker that a ram has not.
        const Complex<T> by_vc = ram ? zero<T>() : fB * u[y], by_v = ram ? zero<T>() : fBc * u[y_conjugate];
        row[size] =
            -(vc * (fA * u[x] + by_vc + fC * da + fD * db) + v * (fAc * u[x_conjugate] + by_v + fC * dca + fD * dcb));
    }
};

}  // namespace mechwright::homotopy
