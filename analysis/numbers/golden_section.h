#pragma once
/// \file
/// Maxima without derivatives, for measuring again by another way.

#include <cmath>

namespace mechwright {

/// Where a function that has one maximum between two places is greatest, to half of its digits.
template <class T, class Function>
T greatest_between(const Function& f, T left, T right, int steps = 60) {
    using std::sqrt;
    const T golden = (sqrt(T(5)) - 1) / 2;
    T a = right - golden * (right - left), b = left + golden * (right - left);
    auto at_a = f(a), at_b = f(b);
    for (int i = 0; i < steps; ++i) {
        if (at_a > at_b) {
            right = b;
            b = a;
            at_b = at_a;
            a = right - golden * (right - left);
            at_a = f(a);
        } else {
            left = a;
            a = b;
            at_a = at_b;
            b = left + golden * (right - left);
            at_b = f(b);
        }
    }
    return (left + right) / 2;
}

}  // namespace mechwright
