#pragma once
/// \file
/// A guided point that is to follow a straight line or a circular arc over an input range of the crank: a function
/// generator (target/function/formulas.h) whose output, the distance from the curve, ought to stay 0. The curve's own
/// dimensions may be design variables; then the greatest distance is half the width of the narrowest band that holds
/// the stretch. What is pinned to the point by a link of the arc's radius dwells at the arc's centre.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>

#include "analysis/numbers/scalar.h"
#include "synthesis/mechanism/guided_point.h"
#include "synthesis/target/function/formulas.h"

namespace mechwright {

using StretchPoints = std::array<Vector<double>, 33>;

/// The names and texts of a shape's two quantities.
struct ShapeTexts {
    std::string deviation;
    std::string extent;
    std::string meaning_of_extent;
    Unit unit_of_extent;
};

/// The place of the guided point of `Path` (guided_point.h) at a crank angle.
template <class Path, class T, std::size_t N>
Vector<T> guided_point(std::size_t assembly, const std::array<T, N>& x, const T& crank_angle) {
    std::array<T, Path::reads + 1> at;
    std::copy_n(x.begin(), Path::reads, at.begin());
    at[Path::reads] = crank_angle;
    return -Path::miss(assembly, at, Vector<double>{0, 0}).miss;
}

/// How the arguments of a shape's quantities stand: those of the guided point, start and range of the input, the shape.
template <class Path, class Shape>
struct ShapeArguments {
    static constexpr std::size_t input = Path::reads, shape = input + 2, reads = shape + Shape::parameters;

    template <class Arguments>
    static auto shape_of(const Arguments& x) {
        std::array<std::remove_cvref_t<decltype(x[0])>, Shape::parameters> own;
        std::copy_n(x.begin() + shape, own.size(), own.begin());
        return own;
    }
};

/// The generator: the distance from the shape.
template <class Path, class Shape>
struct ShapeDistance : ShapeArguments<Path, Shape> {
    using At = ShapeArguments<Path, Shape>;
    template <class T>
    static T error(const std::array<T, At::reads>& x, std::size_t assembly, const T& share, const T&) {
        return Shape::distance(At::shape_of(x),
                               guided_point<Path>(assembly, x, T(x[At::input] + x[At::input + 1] * share)));
    }
};

/// How far the shape is followed, from the first point of the stretch to the last.
template <class Path, class Shape>
struct ShapeExtent : ShapeArguments<Path, Shape> {
    using At = ShapeArguments<Path, Shape>;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, At::reads>& x, Components<T> out) {
        out[0] = Shape::extent(At::shape_of(x), guided_point<Path>(motion.assembly, x, x[At::input]),
                               guided_point<Path>(motion.assembly, x, T(x[At::input] + x[At::input + 1])));
        return most;
    }
};

/// Both again, in fifty digits, by the mechanism's path_point.
template <class Path, auto path_point, class Shape>
struct ShapeAgain {
    using At = ShapeArguments<Path, Shape>;
    static constexpr std::size_t scales = At::input;
    std::size_t assembly;
    std::span<const Digits50> arguments;

    ShapeAgain(const Motion& motion, std::span<const Digits50> x) : assembly(motion.assembly), arguments(x) {}

    template <class T>
    T error(const T& crank_angle, const T&) const {
        return T(Shape::distance(At::shape_of(arguments),
                                 path_point(Form{nullptr, assembly}, arguments, Digits50(crank_angle))));
    }

    static Digits50 extent(const Motion& motion, std::span<const Digits50> x) {
        return Shape::extent(At::shape_of(x), path_point(motion.form(), x, x[At::input]),
                             path_point(motion.form(), x, Digits50(x[At::input] + x[At::input + 1])));
    }
};

/// How far the guided point is off at most, and how far it follows.
template <class Path, auto path_point, class Shape>
std::vector<Quantity> shape_quantities() {
    using Distance = ShapeDistance<Path, Shape>;
    using Again = ShapeAgain<Path, path_point, Shape>;
    const ShapeTexts texts = Shape::texts();
    constexpr std::size_t reads = Path::reads;
    return {{.name = texts.deviation,
             .unit = Unit::length,
             .meaning = "greatest distance of a stretch of the guided point's path from what it follows",
             .reduce = Reduce::greatest,
             .reads = reads,
             .defined = Shape::is_followed,
             .components = always<FunctionMax<Distance>::most>,
             .measure = measure_by<FunctionMax<Distance>>,
             .measure_again = function_max_again<Again>,
             .section = std::string(Shape::name)},
            {.name = texts.extent,
             .unit = texts.unit_of_extent,
             .meaning = texts.meaning_of_extent,
             .reduce = Reduce::only,
             .reads = reads,
             .defined = Shape::is_followed,
             .components = always<1>,
             .measure = measure_by<ShapeExtent<Path, Shape>>,
             .measure_again = Again::extent,
             .section = std::string(Shape::name)}};
}

/// The registry's entry of a shape.
template <class Path, auto path_point, class Shape>
FollowedShape followed_shape() {
    using At = ShapeArguments<Path, Shape>;
    FollowedShape entry;
    entry.name = Shape::name;
    entry.numbers = Shape::numbers();
    entry.quantities = shape_quantities<Path, path_point, Shape>();
    entry.extremes = [](Form form, std::span<const double> arguments) {
        return error_extremes<ShapeDistance<Path, Shape>>(nullptr, seeded<double, At::reads>(arguments), form.assembly);
    };
    entry.fit = [](Form form, std::span<const double> arguments, std::span<double> shape,
                   const std::array<bool, 3>& free) {
        const auto x = seeded<double, At::reads>(arguments);
        StretchPoints points;
        for (std::size_t i = 0; i < points.size(); ++i)
            points[i] = guided_point<Path>(
                form.assembly, x,
                x[At::input] + x[At::input + 1] * static_cast<double>(i) / static_cast<double>(points.size() - 1));
        std::array<bool, Shape::parameters> own;
        std::copy_n(free.begin(), own.size(), own.begin());
        auto fitted = At::shape_of(x);
        Shape::fit(points, own, fitted);
        std::copy(fitted.begin(), fitted.end(), shape.begin());
    };
    return entry;
}

}  // namespace mechwright
