#pragma once
/// \file
/// The measures whose derivatives are tested, each as a template of its variables, and how exact derivatives by second
/// dual numbers compare with central differences in fifty digits.
///
/// Lengths are measured in units of the linkage: derivatives are taken after dividing each length by `size`, the
/// longest link, so that all entries of a gradient or Hessian have the same dimension. Errors are relative to its
/// largest entry.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "analysis/four_bar.h"
#include "analysis/numbers/second_dual.h"
#include "tests/analysis/precise.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {

template <class T, std::size_t N>
FourBar<T> linkage_of(const std::array<T, N>& x) {
    return {x[0], x[1], x[2], x[3]};
}

struct SwingMeasure {
    static constexpr std::size_t variables = 4;
    template <class T>
    T operator()(const std::array<T, 4>& x) const {
        return swing(linkage_of(x));
    }
};

struct TimeRatioMeasure {
    static constexpr std::size_t variables = 4;
    template <class T>
    T operator()(const std::array<T, 4>& x) const {
        const T excess = stroke_excess(linkage_of(x));
        const T half = pi<decltype(value_of(excess) + 0)>();
        return (half + excess) / (half - excess);
    }
};

struct StrokeExcessMeasure {
    static constexpr std::size_t variables = 4;
    template <class T>
    T operator()(const std::array<T, 4>& x) const {
        return stroke_excess(linkage_of(x));
    }
};

struct TransmissionMeasure {
    static constexpr std::size_t variables = 4;
    bool at_pi;
    template <class T>
    T operator()(const std::array<T, 4>& x) const {
        return transmission_angle(linkage_of(x), at_pi ? HalfTurn<T>{T(0), T(1)} : HalfTurn<T>{T(1), T(0)});
    }
};

/// Variables: the links and the crank angle.
struct VelocityRatioMeasure {
    static constexpr std::size_t variables = 5;
    Assembly assembly;
    template <class T>
    T operator()(const std::array<T, 5>& x) const {
        return velocity_ratio(linkage_of(x), x[4], assembly);
    }
};

/// Variables: the links, the crank angle, the coupler point. One coordinate of its position.
struct PositionMeasure {
    static constexpr std::size_t variables = 7;
    Assembly assembly;
    bool second_coordinate;
    template <class T>
    T operator()(const std::array<T, 7>& x) const {
        const auto m = linkage_of(x);
        const auto at = position(m, CouplerPoint<T>{x[5], x[6]}, pose(m, x[4], assembly));
        return second_coordinate ? at.y : at.x;
    }
};

/// A linkage with all variables that any measure reads.
struct Sample {
    std::array<double, 7> x;
    double size;
    Assembly assembly;

    FourBar<double> links() const { return linkage_of(x); }
    template <std::size_t N>
    std::array<double, N> first() const {
        std::array<double, N> part;
        std::copy_n(x.begin(), N, part.begin());
        return part;
    }
    /// What one unit of variable i is: the size of the linkage, or a radian.
    double unit(std::size_t i) const { return i == 4 ? 1 : size; }
};

inline double longest_of(const FourBar<double>& m) { return std::max({m.ground, m.crank, m.coupler, m.rocker}); }

template <class Measure>
SecondDual<double, Measure::variables> evaluated(const Measure& measure, const Sample& sample) {
    constexpr std::size_t n = Measure::variables;
    std::array<SecondDual<double, n>, n> x;
    for (std::size_t i = 0; i < n; ++i) {
        x[i] = SecondDual<double, n>::variable(sample.x[i], i);
        x[i].first[i] = sample.unit(i);
    }
    return measure(x);
}

template <class Dual>
struct Largest {
    double gradient = 0, hessian = 0;

    explicit Largest(const Dual& f) {
        for (const double g : f.first)
            gradient = std::max(gradient, std::abs(g));
        for (const double h : f.second)
            hessian = std::max(hessian, std::abs(h));
    }
};

/// The largest errors seen, relative as said above.
struct Errors {
    double gradient = 0, hessian = 0;

    void add(double in_gradient, double in_hessian) {
        gradient = std::max(gradient, in_gradient);
        hessian = std::max(hessian, in_hessian);
    }
};

/// The measure in fifty digits, as a function of the steps taken in each variable in its unit.
template <class Measure>
auto in_steps(const Measure& measure, const Sample& sample) {
    return [&](const Point<Measure::variables>& steps) {
        Point<Measure::variables> x;
        for (std::size_t i = 0; i < Measure::variables; ++i)
            x[i] = Precise(sample.x[i]) + sample.unit(i) * steps[i];
        return measure(x);
    };
}

/// Compares every entry.
template <class Measure>
void compare_entries(const Measure& measure, const Sample& sample, Errors& errors) {
    constexpr std::size_t n = Measure::variables;
    const auto f = evaluated(measure, sample);
    const Largest largest(f);
    const auto exact = central_differences<n>(in_steps(measure, sample), Point<n>{}, Precise(1));
    for (std::size_t i = 0; i < n; ++i) {
        errors.add(std::abs(static_cast<double>(exact.gradient[i] - f.first[i])) / largest.gradient, 0);
        for (std::size_t j = 0; j <= i; ++j)
            errors.add(0, std::abs(static_cast<double>(exact.hessian[i][j] - f.mixed(i, j))) / largest.hessian);
    }
}

/// A random direction of taxicab length one: a sum over it is at most the largest entry.
template <std::size_t N>
std::array<double, N> random_direction(Random& random) {
    std::array<double, N> u;
    double sum = 0;
    for (double& v : u) {
        v = random.between(-1, 1);
        sum += std::abs(v);
    }
    for (double& v : u)
        v /= sum;
    return u;
}

struct Along {
    Precise first, second;
};

/// First and second derivative along `u` in fifty digits, by steps of h.
template <std::size_t N, class Function>
Along differences_along(const Function& f, const Point<N>& at, const std::array<double, N>& u, double h) {
    Point<N> up = at, down = at;
    for (std::size_t i = 0; i < N; ++i) {
        up[i] += u[i] * h;
        down[i] -= u[i] * h;
    }
    const Precise above = f(up), here = f(at), below = f(down);
    return {(above - below) / (2 * h), (above - 2 * here + below) / (h * h)};
}

template <std::size_t N>
struct AlongDual {
    double first = 0, second = 0;

    AlongDual(const SecondDual<double, N>& f, const std::array<double, N>& u) {
        for (std::size_t i = 0; i < N; ++i) {
            first += f.first[i] * u[i];
            for (std::size_t j = 0; j < N; ++j)
                second += f.mixed(i, j) * u[i] * u[j];
        }
    }
};

/// Compares the derivatives along a random direction, in which all entries take part.
template <class Measure>
void compare_along(const Measure& measure, const Sample& sample, Random& random, Errors& errors) {
    constexpr std::size_t n = Measure::variables;
    const auto f = evaluated(measure, sample);
    const Largest largest(f);
    const auto u = random_direction<n>(random);
    const AlongDual<n> along(f, u);
    const Along exact = differences_along<n>(in_steps(measure, sample), Point<n>{}, u, 1e-13);
    errors.add(std::abs(static_cast<double>(exact.first - along.first)) / largest.gradient,
               std::abs(static_cast<double>(exact.second - along.second)) / largest.hessian);
}

}  // namespace mechwright::test
