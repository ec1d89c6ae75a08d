#pragma once
/// \file
/// Where a vector that moves with the time vanishes, as a velocity does at a rest, its size has a corner: it goes like
/// the distance from there. Beside the corner the size is that distance times the size of what the vector is over it,
/// which is smooth.

#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/geometry/vector.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

/// On which side of a rest sizes are asked for, where they are at one.
struct BesideRest {
    int time = 0;     ///< 1: after it, -1: before it, 0: neither
    double near = 0;  ///< so much time from it is at it
};

/// Whether a vector vanishes within so short a time.
template <class T, std::size_t K>
bool is_at_rest(const Vector<Series<T, K>>& v, double near) {
    if constexpr (K < 2) return false;
    const double size = std::hypot(number_as<double>(value_of(v.x.c[0])), number_as<double>(value_of(v.y.c[0])));
    const double rate = std::hypot(number_as<double>(value_of(v.x.c[1])), number_as<double>(value_of(v.y.c[1])));
    return size <= near * rate && rate > 0;
}

/// The size of a vector that is at rest, at the rest itself, as it is after it or before it. Where dimensions move the
/// rest, by their derivatives in T, the size is that at the rest which moves. The last of the powers is not known, and
/// 0.
template <class T, std::size_t K>
Series<T, K> size_beside_rest(const Vector<Series<T, K>>& v, bool after) {
    if constexpr (K < 2) return hypot(v.x, v.y);
    // v0 + v1 t + v2 t t = 0 along v1: twice, which second derivatives by the dimensions need.
    const auto along = [&](std::size_t k) { return T(v.x.c[1] * v.x.c[k] + v.y.c[1] * v.y.c[k]); };
    const T square = along(1);
    T rest = -along(0) / square;
    rest = -T(along(0) + rest * rest * along(2)) / square;
    const auto from_rest = [&](const Series<T, K>& a) {
        std::array<T, K + 1> c = a.c;
        for (std::size_t k = 0; k < K; ++k)
            for (std::size_t j = K; j-- > k;)
                c[j] += rest * c[j + 1];
        return Series<T, K>::by_powers([&](std::size_t k) { return k < K ? c[k + 1] : T(0); });
    };
    const Vector<Series<T, K>> over_time{from_rest(v.x), from_rest(v.y)};
    const Series<T, K> size = hypot(over_time.x, over_time.y);
    return Series<T, K>::by_powers([&](std::size_t k) {
        return k == 0 || k == K ? T(0) : after ? size.c[k - 1] : T(-size.c[k - 1]);
    });
}

}  // namespace mechwright::linkage
