#pragma once
/// \file
/// A dyad that meets four conditions (synthesis/exact/poses/dyads.h) as four equations in the coordinates of its
/// pivots, each linear in 1, a.x, a.y, x.x, x.y, Re(x conj(a)), Im(x conj(a)).

#include <algorithm>
#include <array>
#include <cstddef>

#include "synthesis/exact/homotopy/linear_system.h"
#include "synthesis/exact/poses/dyad_equation.h"

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
            const auto equation = dyad_equation(conditions.data() + terms * i, u, v, p, q);
            std::copy(equation.slopes.begin(), equation.slopes.end(), out[i].begin());
            out[i][size] = -equation.value;
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
