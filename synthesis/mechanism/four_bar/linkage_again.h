#pragma once
/// \file
/// The pose of a four-bar rebuilt by circle intersection, for verification alone (see measure_again.h). Lengths are
/// divided by a power of two close to the longest link, which changes no digit. The sums and differences that would
/// lose digits in double are formed in fifty digits first, so that the samples that look for brackets can be trusted
/// next to change points too.

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <span>
#include <vector>

#include "analysis/geometry/vector.h"
#include "synthesis/mechanism/mechanism.h"
#include "synthesis/mechanism/stationary.h"

namespace mechwright::four_bar::again {

template <class T>
struct Linkage {
    T ground, crank, coupler, rocker;
    T ground_less_crank;
    T stretch_at_zero;  ///< (coupler + rocker)^2 - (ground + crank)^2
    T fold_at_zero;     ///< (ground - crank)^2 - (coupler - rocker)^2
    T square_excess;    ///< coupler^2 - rocker^2
    T side;             ///< +1 open, -1 crossed
};

template <class To, class From>
Linkage<To> rounded(const Linkage<From>& m) {
    return {To(m.ground),          To(m.crank),        To(m.coupler),       To(m.rocker), To(m.ground_less_crank),
            To(m.stretch_at_zero), To(m.fold_at_zero), To(m.square_excess), To(m.side)};
}

inline Digits50 longest_link(std::span<const Digits50> dimensions) {
    return *std::max_element(dimensions.begin(), dimensions.begin() + 4);
}

/// The power of two that lengths are divided by.
inline Digits50 length_unit(std::span<const Digits50> dimensions) {
    int exponent = 0;
    frexp(longest_link(dimensions), &exponent);
    return ldexp(Digits50(1), exponent);
}

inline Linkage<Digits50> linkage(std::size_t assembly, std::span<const Digits50> dimensions) {
    const Digits50 unit = length_unit(dimensions);
    const Digits50 g = dimensions[0] / unit, a = dimensions[1] / unit, b = dimensions[2] / unit,
                   c = dimensions[3] / unit;
    return {g,
            a,
            b,
            c,
            g - a,
            (b + c) * (b + c) - (g + a) * (g + a),
            (g - a) * (g - a) - (b - c) * (b - c),
            (b - c) * (b + c),
            Digits50(assembly == 0 ? 1 : -1)};
}

/// Vectors in the frame of the linkage at one crank angle.
template <class T>
struct Pose {
    Vector<T> crank;     ///< unit vector from crank pivot to crank pin
    Vector<T> coupler;   ///< from crank pin to rocker pin
    Vector<T> rocker;    ///< from rocker pivot to rocker pin
    Vector<T> diagonal;  ///< from crank pin to rocker pivot
    T stretch;           ///< (coupler + rocker)^2 - diagonal^2
    T fold;              ///< diagonal^2 - (coupler - rocker)^2

    bool assembled() const { return stretch >= 0 && fold >= 0; }
};

/// Where the circle of the coupler about the crank pin meets that of the rocker about the rocker pivot; where they do
/// not meet, the foot of their common chord.
template <class T>
Pose<T> pose(const Linkage<T>& m, const T& crank_angle) {
    using std::cos, std::sin, std::sqrt;
    const T half = crank_angle / 2;
    const T cosine = cos(half), sine = sin(half);
    const T product = 4 * m.ground * m.crank;
    Pose<T> p;
    p.crank = {(cosine - sine) * (cosine + sine), 2 * sine * cosine};
    p.diagonal = {m.ground_less_crank + 2 * m.crank * sine * sine, -m.crank * p.crank.y};
    p.stretch = m.stretch_at_zero + product * cosine * cosine;
    p.fold = m.fold_at_zero + product * sine * sine;
    const T square = dot(p.diagonal, p.diagonal);
    const T along = square > 0 ? T((1 + m.square_excess / square) / 2) : T(0.5);
    const T across =
        square > 0 && p.stretch > 0 && p.fold > 0 ? T(m.side * sqrt(p.stretch * p.fold) / (2 * square)) : T(0);
    p.coupler = along * p.diagonal + across * left_of(p.diagonal);
    p.rocker = p.coupler - p.diagonal;
    return p;
}

/// Something that is measured along a motion has a function with the zeros of its slope, as a template for samples in
/// double and for the solution in fifty digits, and a value in fifty digits.
///
/// Slopes come from the loop crank + coupler = ground + rocker, differentiated by the crank angle. With e the direction
/// of the crank, k and r the velocities of coupler and rocker, its component across the coupler is
/// r cross(coupler, rocker) = crank cross(coupler, e), that across the rocker k cross(coupler, rocker) =
/// crank cross(rocker, e).
struct TransmissionAngle {
    /// (r - k) cross(coupler, rocker) / crank
    template <class T>
    static T slope(const Linkage<T>&, const Pose<T>& p) {
        return cross(p.coupler, p.crank) - cross(p.rocker, p.crank);
    }
    static Digits50 value(const Linkage<Digits50>&, const Pose<Digits50>& p) {
        return atan2(abs(cross(p.coupler, p.rocker)), dot(p.coupler, p.rocker));
    }
};

/// The distance from crank pin to rocker pivot, on which alone it depends whether the loop closes.
struct Diagonal {
    /// Half of the slope of its square, over the crank.
    template <class T>
    static T slope(const Linkage<T>&, const Pose<T>& p) {
        return -dot(p.diagonal, left_of(p.crank));
    }
};

/// The crank angles of a sweep at which a measure is stationary.
template <class Measure>
std::vector<Digits50> stationary_crank_angles(const Linkage<Digits50>& m, const Sweep& sweep) {
    const auto plain = rounded<double>(m);
    return stationary_points(
        sweep, [&](double x) { return Measure::slope(plain, pose(plain, x)); },
        [&](const Digits50& x) { return Measure::slope(m, pose(m, x)); });
}

}  // namespace mechwright::four_bar::again
