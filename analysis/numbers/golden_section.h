#pragma once
/// \file
/// Maxima without derivatives, for measuring again by another way.

namespace mechwright {

/// Where a function that has one maximum between two places is greatest, to half of its digits.
template <class Function>
double greatest_between(const Function& f, double left, double right) {
    constexpr double golden = 0.6180339887498949;
    double a = right - golden * (right - left), b = left + golden * (right - left);
    double at_a = f(a), at_b = f(b);
    for (int i = 0; i < 60; ++i) {
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
    return 0.5 * (left + right);
}

}  // namespace mechwright
