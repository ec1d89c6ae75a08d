#pragma once
/// \file
/// The direction of the coupler over a box of four-bars, in the parameters of timed_path_bound.h: ground over ground
/// and crank together (t), the angles alpha between coupler and diagonal at two crank angles, the bases, and the start
/// of the crank.

#include <array>
#include <cmath>

#include "analysis/numbers/interval.h"
#include "synthesis/proof/branch_and_bound.h"

namespace mechwright::four_bar {

/// (1 - cos) / 2 + u^2 (1 + cos) / 2 = |D|^2 with u = 2 t - 1.
template <class T>
T square_of_diagonal(const T& t, const T& cosine) {
    return (T(1.0) - cosine) * T(0.5) + square(T(T(2.0) * t - T(1.0))) * (T(1.0) + cosine) * T(0.5);
}

/// |D| at a crank angle. Its derivatives have factors that are the same at every target and are kept apart, so that
/// intervals do not forget it: by t (2 t - 1) by_t, by the crank angle t (1 - t) by_angle. T is a number or an
/// interval.
template <class T>
struct Diagonal {
    T cosine, sine;
    T square, length;
    T by_t, by_angle;
};

template <class T>
Diagonal<T> diagonal_at(const T& t, const T& angle) {
    using std::cos, std::sin, std::sqrt;
    Diagonal<T> d;
    d.cosine = cos(angle);
    d.sine = sin(angle);
    d.square = square_of_diagonal(t, d.cosine);
    d.length = sqrt(d.square);
    d.by_t = (T(1.0) + d.cosine) / d.length;
    d.by_angle = d.sine / d.length;
    return d;
}

/// A target by which L is known: the angle alpha there is a parameter.
template <class T>
struct Base {
    Diagonal<T> diagonal;
    T cosine, sine;  ///< of alpha
    T half_cosine, half_sine;
};

template <class T>
Base<T> base_at(const Diagonal<T>& diagonal, const T& alpha) {
    using std::cos, std::sin;
    const T half = alpha * T(0.5);
    return {diagonal, cos(alpha), sin(alpha), cos(half), sin(half)};
}

/// The parameters over a box and in its middle.
struct Ranges {
    double side;
    Interval t, start;
    Base<Interval> least, greatest;
    std::array<double, Box::most> middle, half;
    Base<double> least_here, greatest_here;
    bool obtuse;  ///< the angles alpha are nearer to half a turn than to none
};

/// Which of the two bases a target is.
enum class Role { least, greatest, between };

/// The angle of the coupler from the ground link at one crank angle over a box: that in the middle, its derivatives
/// there (zero where they are not used), and how far it can be from what they say.
struct CouplerTurn {
    double angle = 0;
    std::array<double, Box::most> slope{};
    double astray = 0;
    std::array<double, Box::most> doubt{};  ///< what each parameter may contribute to that
};

/// The turn at a crank angle, counted from the start, of the open (side = +1) or crossed (-1) assembly.
CouplerTurn coupler_turn(const Ranges& over, double crank_angle, Role role);

}  // namespace mechwright::four_bar
