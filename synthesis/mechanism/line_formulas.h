#pragma once
/// \file
/// A guided point that is to follow a straight line over an input range of the crank: a function generator
/// (function_formulas.h) whose output, the distance from the line, ought to stay 0. The line has a direction in the
/// drawing and an offset, its distance from the drawing's origin, positive to the left of its direction; both may be
/// design variables, and then the greatest distance is half the width of the narrowest band that holds the stretch.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "synthesis/mechanism/function_formulas.h"
#include "synthesis/mechanism/guided_point.h"

namespace mechwright {

/// The place of the guided point of `Path` (guided_point.h) at a crank angle.
template <class Path, class T, std::size_t N>
Vector<T> guided_point(std::size_t assembly, const std::array<T, N>& x, const T& crank_angle) {
    std::array<T, Path::reads + 1> at;
    std::copy_n(x.begin(), Path::reads, at.begin());
    at[Path::reads] = crank_angle;
    return -Path::miss(assembly, at, Vector<double>{0, 0}).miss;
}

/// `input` is the first of the two dimensions of the input range, `line` that of the line's direction and offset.
template <class Path, std::size_t input, std::size_t line>
struct LineDistance {
    static constexpr std::size_t reads = line + 2;
    template <class T>
    static T error(const std::array<T, reads>& x, std::size_t assembly, const T& share, const T&) {
        using std::cos, std::sin;
        const Vector<T> p = guided_point<Path>(assembly, x, T(x[input] + x[input + 1] * share));
        return cross(Vector<T>{cos(x[line]), sin(x[line])}, p) - x[line + 1];
    }
};

/// The way along the line between the two ends of the stretch.
template <class Path, std::size_t input, std::size_t line>
struct LineLength {
    static constexpr std::size_t reads = line + 2;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        using std::abs, std::cos, std::sin;
        const Vector<T> first = guided_point<Path>(motion.assembly, x, x[input]);
        const Vector<T> last = guided_point<Path>(motion.assembly, x, T(x[input] + x[input + 1]));
        out[0] = abs(dot(Vector<T>{cos(x[line]), sin(x[line])}, last - first));
        return most;
    }
};

/// Both again, in fifty digits, by the mechanism's path_point.
template <auto path_point, std::size_t input, std::size_t line>
struct LineAgain {
    static constexpr std::size_t scales = input;
    std::size_t assembly;
    std::span<const Digits50> dimensions;

    LineAgain(std::size_t a, std::span<const Digits50> d) : assembly(a), dimensions(d) {}

    template <class T>
    T error(const T& crank_angle, const T&) const {
        const Vector<Digits50> p = path_point(assembly, dimensions, Digits50(crank_angle));
        return T(cos(dimensions[line]) * p.y - sin(dimensions[line]) * p.x - dimensions[line + 1]);
    }

    static Digits50 length(const Motion& motion, std::span<const Digits50> d) {
        const Vector<Digits50> way = path_point(motion.assembly, d, Digits50(d[input] + d[input + 1])) -
                                     path_point(motion.assembly, d, d[input]);
        return abs(cos(d[line]) * way.x + sin(d[line]) * way.y);
    }
};

inline bool follows_line(const Motion& motion) { return motion.line; }

/// line-deviation and line-length.
template <class Path, auto path_point, std::size_t input, std::size_t line>
std::array<Quantity, 2> line_quantities() {
    using Distance = LineDistance<Path, input, line>;
    using Again = LineAgain<path_point, input, line>;
    return {{{.name = "line-deviation",
              .unit = Unit::length,
              .meaning = "greatest distance of a stretch of the guided point's path from its line",
              .reduce = Reduce::greatest,
              .reads = Distance::reads,
              .defined = follows_line,
              .components = always<FunctionMax<Distance>::most>,
              .measure = measure_by<FunctionMax<Distance>>,
              .measure_again = function_max_again<Again>,
              .section = "line"},
             {.name = "line-length",
              .unit = Unit::length,
              .meaning = "way along the line between the two ends of the stretch",
              .reduce = Reduce::only,
              .reads = Distance::reads,
              .defined = follows_line,
              .components = always<1>,
              .measure = measure_by<LineLength<Path, input, line>>,
              .measure_again = Again::length,
              .section = "line"}}};
}

/// The registry's line_extremes.
template <class Path, std::size_t input, std::size_t line>
std::vector<ErrorExtreme> line_extremes_by(std::size_t assembly, std::span<const double> dimensions) {
    std::array<double, line + 2> x;
    std::copy_n(dimensions.begin(), x.size(), x.begin());
    return error_extremes<LineDistance<Path, input, line>>(nullptr, x, assembly);
}

/// The registry's line_fit: the principal axis of points of the stretch, in the middle of its band.
template <class Path, std::size_t input, std::size_t line>
void line_fit_by(std::size_t assembly, std::span<double> dimensions, bool free_angle) {
    std::array<double, line> x;
    std::copy_n(dimensions.begin(), x.size(), x.begin());
    std::array<Vector<double>, 33> points;
    Vector<double> mean{0, 0};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const double share = static_cast<double>(i) / (points.size() - 1);
        points[i] = guided_point<Path>(assembly, x, x[input] + x[input + 1] * share);
        mean = mean + (1.0 / points.size()) * points[i];
    }
    if (free_angle) {
        double xx = 0, xy = 0, yy = 0;
        for (const Vector<double>& p : points) {
            const Vector<double> d = p - mean;
            xx += d.x * d.x;
            xy += d.x * d.y;
            yy += d.y * d.y;
        }
        dimensions[line] = 0.5 * std::atan2(2 * xy, xx - yy);
    }
    const Vector<double> direction{std::cos(dimensions[line]), std::sin(dimensions[line])};
    double least = cross(direction, mean), greatest = least;
    for (const Vector<double>& p : points) {
        least = std::min(least, cross(direction, p));
        greatest = std::max(greatest, cross(direction, p));
    }
    dimensions[line + 1] = 0.5 * (least + greatest);
}

}  // namespace mechwright
