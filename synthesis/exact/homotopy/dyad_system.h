#pragma once
/// \file
/// A dyad that meets four conditions (synthesis/exact/dyads.h) as four equations in the coordinates of its pivots, each
/// linear in 1, a.x, a.y, x.x, x.y, Re(x conj(a)), Im(x conj(a)).

#include <array>
#include <cstddef>

#include "synthesis/exact/homotopy/linear_system.h"

namespace mechwright::homotopy {

struct DyadSystem {
    static constexpr std::size_t size = 4;
    static constexpr std::size_t terms = 7;
    static constexpr std::size_t parameters = size * terms;

    template <class T>
    using Parameters = std::array<Complex<T>, parameters>;
    /// a.x, a.y, x.x, x.y
    template <class T>
    using Point = std::array<Complex<T>, size>;

    /// As GuidanceSystem::linearise, without a direction.
    template <class T>
    void linearise(const Point<T>& unknowns, const Parameters<T>& conditions, const Parameters<T>*,
                   Augmented<T, size>& out) const {
        const auto& [u, v, p, q] = unknowns;
        for (std::size_t i = 0; i < size; ++i) {
            const Complex<T>* c = conditions.data() + terms * i;
            out[i][0] = c[1] + p * c[5] + q * c[6];
            out[i][1] = c[2] + q * c[5] - p * c[6];
            out[i][2] = c[3] + u * c[5] - v * c[6];
            out[i][3] = c[4] + v * c[5] + u * c[6];
            out[i][size] =
                -(c[0] + u * c[1] + v * c[2] + p * c[3] + q * c[4] + (p * u + q * v) * c[5] + (q * u - p * v) * c[6]);
        }
    }

    template <class T>
    static Point<T> mirrored(const Point<T>& u) {
        Point<T> other;
        for (std::size_t i = 0; i < size; ++i)
            other[i] = {u[i].re, -u[i].im};
        return other;
    }
};

}  // namespace mechwright::homotopy
