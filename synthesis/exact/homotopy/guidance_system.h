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
/// A line of the coupler that slides through a block on a fixed pivot is such a dyad seen from the coupler: its moving
/// pivot is infinitely far away, and y stands for its direction (y, y'), square to the line:
///     B = y (d' - b'),  B' = y' (d - b),  D = y b' + y' b.
/// With either one place less says all of it: one pose and seven points, two and five, three and three, four and one.
/// The eighth equation is that the direction has length 1, b b' = 1 or y y' = 1.

#include <array>
#include <cstddef>
#include <cstdint>

#include "synthesis/exact/homotopy/linear_system.h"

namespace mechwright::homotopy {

/// What the second dyad is: a link on two pivots, a pivot that slides on a line, a line that slides over a pivot.
enum class SecondDyad : std::uint8_t { rocker, ram, block };

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

    constexpr bool has_rocker() const { return second == SecondDyad::rocker; }
    constexpr std::size_t displacements() const { return (has_rocker() ? 9 : 8) - poses; }

    /// For a ram b is the direction of its fixed pivot, for a block y that of its moving pivot.
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
        if (!has_rocker()) direction_row(second == SecondDyad::ram ? b : y, u, along, out[size - 1]);
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

    /// A displacement as the terms of a dyad have it that lack it where one of its pivots is infinitely far away.
    template <class T>
    struct Seen {
        Complex<T> by_turn, by_turn_conjugate;  ///< in A and A'
        Complex<T> free, free_conjugate;        ///< beside the fixed pivot in C
        Complex<T> square;                      ///< alone in C
    };

    template <class T>
    static Seen<T> seen(SecondDyad kind, const Complex<T>& d, const Complex<T>& dc) {
        const bool ram = kind == SecondDyad::ram, block = kind == SecondDyad::block;
        const Complex<T> zero{T(0.0), T(0.0)};
        return {ram ? zero : d, ram ? zero : dc, block ? zero : d, block ? zero : dc, ram || block ? zero : d * dc};
    }

    /// The direction that begins at `first` has length 1.
    template <class T>
    static void direction_row(std::size_t first, const Point<T>& u, const Parameters<T>* along, Row<T>& row) {
        row.fill({T(0.0), T(0.0)});
        row[first] = u[first + 1];
        row[first + 1] = u[first];
        if (along == nullptr) row[size] = Complex<T>{T(1.0), T(0.0)} - u[first] * u[first + 1];
    }

    /// One dyad, whose unknowns begin at `first`, in a pose.
    template <class T>
    static void pose_row(std::size_t first, SecondDyad kind, const Point<T>& u, const Parameters<T>& p,
                         const Parameters<T>* along, std::size_t k, Row<T>& row) {
        const Complex<T>& turn = p[first_turn + k];
        const Complex<T>&m = u[first], &mc = u[first + 1], &f = u[first + 2], &fc = u[first + 3];
        const Seen<T> d = seen(kind, p[k], p[first_conjugate + k]);
        const Complex<T> square = turn * turn, df = d.by_turn - f, dfc = d.by_turn_conjugate - fc;
        const Complex<T> A = m * dfc, Ac = mc * df;
        const Complex<T> C = d.square - d.free * fc - d.free_conjugate * f + m * fc + mc * f;
        row.fill({T(0.0), T(0.0)});
        row[first] = dfc * square + fc * turn;
        row[first + 1] = df + f * turn;
        row[first + 2] = (mc - d.free_conjugate) * turn - mc;
        row[first + 3] = (m - d.free) * turn - m * square;
        if (along == nullptr) {
            row[size] = -(A * square + C * turn + Ac);
            return;
        }
        const Seen<T> v = seen(kind, (*along)[k], (*along)[first_conjugate + k]);
        const Complex<T>& w = (*along)[first_turn + k];
        // The change of d d' is v d' + v' d, and 0 where d d' is not there.
        const Complex<T> of_square = of_product(kind, (*along)[k], (*along)[first_conjugate + k], d);
        row[size] = -(v.by_turn * mc + v.by_turn_conjugate * m * square +
                      turn * (of_square - v.free * fc - v.free_conjugate * f) + w * (A * turn + A * turn + C));
    }

    template <class T>
    static Complex<T> of_product(SecondDyad kind, const Complex<T>& v, const Complex<T>& vc, const Seen<T>& d) {
        if (kind != SecondDyad::rocker) return {T(0.0), T(0.0)};
        return v * d.free_conjugate + vc * d.free;
    }

    template <class T>
    void point_row(const Point<T>& u, const Parameters<T>& p, const Parameters<T>* along, std::size_t j,
                   Row<T>& row) const {
        const Complex<T>&d = p[j], &dc = p[first_conjugate + j];
        const Seen<T> e = seen(second, d, dc);
        const Complex<T> da = d - u[a], dca = dc - u[a_conjugate];
        const Complex<T> db = e.by_turn - u[b], dcb = e.by_turn_conjugate - u[b_conjugate];
        const Complex<T> A = u[x] * dca, Ac = u[x_conjugate] * da, B = u[y] * dcb, Bc = u[y_conjugate] * db;
        const Complex<T> C = d * dc - d * u[a_conjugate] - dc * u[a] + u[x] * u[a_conjugate] + u[x_conjugate] * u[a];
        const Complex<T> D = e.square - e.free * u[b_conjugate] - e.free_conjugate * u[b] + u[y] * u[b_conjugate] +
                             u[y_conjugate] * u[b];
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
        row[b] = fD * (u[y_conjugate] - e.free_conjugate) - fBc * u[y_conjugate];
        row[b_conjugate] = fD * (u[y] - e.free) - fB * u[y];
        if (along == nullptr) {
            row[size] = W * W - U * V;
            return;
        }
        const Complex<T>&v = (*along)[j], &vc = (*along)[first_conjugate + j];
        const Seen<T> g = seen(second, v, vc);
        const Complex<T> of_second =
            g.by_turn_conjugate * fB * u[y] + g.by_turn * fBc * u[y_conjugate] +
            fD * (of_product(second, v, vc, e) - g.free * u[b_conjugate] - g.free_conjugate * u[b]);
        row[size] = -(vc * (fA * u[x] + fC * da) + v * (fAc * u[x_conjugate] + fC * dca) + of_second);
    }
};

}  // namespace mechwright::homotopy
