#pragma once
/// \file
/// Elliptic Fourier descriptors of closed curves (F. P. Kuhl and C. R. Giardina, "Elliptic Fourier features of a closed
/// contour", Computer Graphics and Image Processing 18, 1982), by which others compare coupler curves.

#include <complex>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"

namespace mechwright::bench {

/// The curve z(s) = sum over k of forward[k] e^(iks) + backward[k] e^(-iks) by its length s, k from 1, with the middle
/// (k = 0), the size and the direction of its first ellipse taken out: the pair of the first is forward + backward = 1,
/// real. The contour's start is at an end of the long axis of that ellipse; there are two, and they differ in the sign
/// of the pairs with even k.
struct Descriptors {
    std::vector<std::complex<double>> forward;   ///< [k - 1]
    std::vector<std::complex<double>> backward;  ///< [k - 1]
    std::complex<double> middle;
    std::complex<double> factor;  ///< z = middle + factor (what is described)
};

/// Of a closed polygon, whose last point is not the first again. Empty where it is a point.
Descriptors descriptors_of(std::span<const Vector<double>> points, int harmonics);

/// How many harmonics hold all but such a part of a polygon's power.
int harmonics_of(std::span<const Vector<double>> points, int most, double part);

/// How two curves differ, and the similarity that lays the second over the first where they differ least: from either
/// end of the long axis.
struct Difference {
    double distance;  ///< root of the sum of squared differences
    std::complex<double> shift;
    std::complex<double> factor;
};
Difference difference(const Descriptors& of, const Descriptors& other);

}  // namespace mechwright::bench
