#pragma once
/// \file
/// Sums of multiples of dimensions.

#include <cstddef>
#include <span>
#include <utility>
#include <vector>

namespace mechwright {

/// constant + sum of factor times dimension; dimensions by index, each once, in rising order.
struct Affine {
    double constant = 0;
    std::vector<std::pair<std::size_t, double>> terms{};

    template <class T>
    T at(std::span<const T> dimensions) const {
        T sum(constant);
        for (const auto& [dimension, factor] : terms)
            sum = sum + T(factor) * dimensions[dimension];
        return sum;
    }
};

}  // namespace mechwright
