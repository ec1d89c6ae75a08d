#pragma once
/// \file
/// The Roberts-Chebyshev cognates: the two other four-bars whose coupler points draw the same curve. Reference:
/// Roberts' theorem with complex coupler constants; lengths and pivots as derived in the comments below.

#include <array>
#include <cmath>

#include "analysis/four_bar/coupler_point.h"

namespace mechwright {

/// A linkage with its coupler point and placement: everything that draws a coupler curve.
template <class T>
struct PathLinkage {
    FourBar<T> links;
    CouplerPoint<T> point;
    Placement<T> placement;
    Assembly assembly;
};

/// The two cognates. The first keeps the crank pivot: at the angle of the original coupler its crank, which turns as
/// that coupler does, draws the point of the original; where the coupler swings back and forth, so does this crank, and
/// the curve may take both its assemblies. The second keeps the rocker pivot and the crank angles of the original.
/// Precondition: the coupler point lies on neither joint (else a link of a cognate has length zero: its lengths say
/// so).
///
/// With k = (along + i across) / coupler the third pivot is C0 = A0 + k (B0 - A0). Completing the parallelograms
/// A0-A-P and B0-B-P gives on A0, C0 a linkage |k| (ground, coupler, crank, rocker) with the coupler constant 1/k, and
/// on C0, B0 one of |1 - k| (ground, crank, rocker, coupler) with the coupler constant k/(k - 1).
template <class T>
std::array<PathLinkage<T>, 2> cognates(const PathLinkage<T>& original) {
    using std::atan2, std::hypot;
    const FourBar<T>& m = original.links;
    const Vector<T> k{original.point.along / m.coupler, original.point.across / m.coupler};
    const Vector<T> rest{(m.coupler - original.point.along) / m.coupler, -k.y};
    const T size = hypot(k.x, k.y);
    const T rest_size = hypot(rest.x, rest.y);
    const Vector<T> third_pivot = placed(m.ground * k, original.placement);
    const Assembly turned_over = original.assembly == Assembly::open ? Assembly::crossed : Assembly::open;

    const FourBar<T> first{size * m.ground, size * m.coupler, size * m.crank, size * m.rocker};
    const CouplerPoint<T> first_point{m.crank * k.x / size, -(m.crank * k.y / size)};
    const FourBar<T> second{rest_size * m.ground, rest_size * m.crank, rest_size * m.rocker, rest_size * m.coupler};
    // k/(k - 1) = 1 - 1/(1 - k), times the coupler |1 - k| rocker
    const CouplerPoint<T> second_point{second.coupler - m.rocker * rest.x / rest_size, m.rocker * rest.y / rest_size};
    return {
        PathLinkage<T>{
            first, first_point, {original.placement.origin, original.placement.tilt + atan2(k.y, k.x)}, turned_over},
        PathLinkage<T>{
            second, second_point, {third_pivot, original.placement.tilt + atan2(rest.y, rest.x)}, turned_over}};
}

}  // namespace mechwright
