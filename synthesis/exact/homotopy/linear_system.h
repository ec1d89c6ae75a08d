#pragma once
/// \file
/// Small complex linear systems, the same steps in every lane.

#include <array>
#include <cstddef>

#include "synthesis/exact/homotopy/complex.h"
#include "synthesis/exact/homotopy/doubled.h"

namespace mechwright::homotopy {

/// Rows of a square matrix, each followed by its right-hand side.
template <class T, std::size_t Size>
using Augmented = std::array<std::array<Complex<T>, Size + 1>, Size>;

/// Exchanges two numbers in the lanes where that is wanted.
template <class Mask, class T>
void swap_where(const Mask& wanted, Complex<T>& a, Complex<T>& b) {
    const Complex<T> first = a;
    a = {select(wanted, b.re, a.re), select(wanted, b.im, a.im)};
    b = {select(wanted, first.re, b.re), select(wanted, first.im, b.im)};
}

/// Gaussian elimination: the greatest element of each column rises to its pivot by exchanges of rows, lane by lane. The
/// solution takes the place of the right-hand side; it is not finite where the matrix is singular.
template <class T, std::size_t Size>
void solve(Augmented<T, Size>& a) {
    for (std::size_t k = 0; k < Size; ++k) {
        T greatest = norm(a[k][k]);
        for (std::size_t r = k + 1; r < Size; ++r) {
            const T here = norm(a[r][k]);
            const auto better = greatest < here;
            greatest = select(better, here, greatest);
            for (std::size_t c = k; c <= Size; ++c)
                swap_where(better, a[k][c], a[r][c]);
        }
        const Complex<T> pivot = inverse(a[k][k]);
        for (std::size_t r = k + 1; r < Size; ++r) {
            const Complex<T> factor = a[r][k] * pivot;
            for (std::size_t c = k + 1; c <= Size; ++c)
                a[r][c] = a[r][c] - factor * a[k][c];
        }
        a[k][k] = pivot;
    }
    for (std::size_t k = Size; k-- > 0;) {
        for (std::size_t c = k + 1; c < Size; ++c)
            a[k][Size] = a[k][Size] - a[k][c] * a[c][Size];
        a[k][Size] = a[k][Size] * a[k][k];
    }
}

}  // namespace mechwright::homotopy
