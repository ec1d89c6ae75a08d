#pragma once
/// \file
/// Turns the formula of a guided point, written once as a template, into the `miss` of a mechanism's guidance.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <span>

#include "synthesis/mechanism/measured.h"

namespace mechwright {

/// What the formula of a guided point gives: target - point, and the least length by which the mechanism closes.
template <class T>
struct MissAndMargin {
    Vector<T> miss;
    double margin;
};

/// A miss with its first derivatives from a guided point in the mechanism's own frame: `reached`, with its derivatives
/// by the first dimensions and, last, by the crank angle, argument number `angle`. After the former stand the origin in
/// the drawing, x and y, and the tilt. Other derivatives are left alone.
template <std::size_t N>
void place_with_gradient(const Vector<double>& reached, const std::array<Vector<double>, N>& gradient,
                         std::span<const double> x, std::size_t angle, const Vector<double>& target, PathMiss& out) {
    constexpr std::size_t origin = N - 1, tilt = origin + 2;
    const Vector<double> axis{std::cos(x[tilt]), std::sin(x[tilt])};
    const Vector<double> from_origin = turned(reached, axis);
    out.miss = (target - Vector<double>{x[origin], x[origin + 1]}) - from_origin;
    const auto set = [&](std::size_t argument, const Vector<double>& of_point) {
        out.gradient_x[argument] = -of_point.x;
        out.gradient_y[argument] = -of_point.y;
    };
    for (std::size_t i = 0; i < origin; ++i)
        set(i, turned(gradient[i], axis));
    set(origin, {1, 0});
    set(origin + 1, {0, 1});
    set(tilt, left_of(from_origin));
    set(angle, turned(gradient[origin], axis));
}

/// What a guided body misses of a direction, with first derivatives: those of the angle in which it faces by the first
/// arguments and by the crank angle, argument number `angle`, and 1 by the angles that are added to it.
template <std::size_t N>
void face_with_gradient(const Vector<double>& faces, const std::array<double, N>& turn, double by_crank_angle,
                        std::initializer_list<std::size_t> added, std::size_t angle, const Vector<double>& facing,
                        PathMiss& out) {
    out.miss = facing - faces;
    std::fill(out.gradient_x.begin(), out.gradient_x.begin() + static_cast<std::ptrdiff_t>(angle), 0.0);
    std::fill(out.gradient_y.begin(), out.gradient_y.begin() + static_cast<std::ptrdiff_t>(angle), 0.0);
    const auto set = [&](std::size_t argument, double by) {
        out.gradient_x[argument] = by * faces.y;
        out.gradient_y[argument] = -by * faces.x;
    };
    for (std::size_t i = 0; i < N; ++i)
        set(i, turn[i]);
    for (const std::size_t i : added)
        set(i, 1);
    set(angle, by_crank_angle);
}

/// What a formula is given of the form: all of it where it has a model, `using Model`, else the assembly alone.
template <class Formula>
auto given_to(Form form) {
    if constexpr (requires { typename Formula::Model; })
        return form;
    else
        return form.assembly;
}

/// The `miss` of PointGuidance by a formula with `static constexpr std::size_t reads` and
/// `template <class T> static MissAndMargin<T> miss(std::size_t assembly, const std::array<T, reads + 1>& x,
/// const Vector<double>& target)`, where x are the dimensions that are read and the crank angle. A formula can have a
/// quicker way to its value, the same bits, and first derivatives: `static bool miss_and_gradient(assembly, x, target,
/// PathMiss& out)`, which returns false where it does not hold.
template <class Formula>
void path_miss_by(Form form, std::span<const double> dimensions, double crank_angle, const Vector<double>& target,
                  PathMiss& out) {
    constexpr std::size_t n = Formula::reads + 1;
    std::array<double, n> at{};
    std::copy_n(dimensions.begin(), Formula::reads, at.begin());
    at[Formula::reads] = crank_angle;
    const auto evaluate = [&]<class T>(const std::array<T, n>& x) {
        const MissAndMargin<T> r = Formula::miss(given_to<Formula>(form), x, target);
        out.miss = {value_of(r.miss.x), value_of(r.miss.y)};
        out.margin = r.margin;
        return r.miss;
    };
    if (!out.hessian_x.empty()) {
        const auto miss = evaluate(seeded<SecondDual<double, n>, n>(at));
        std::copy(miss.x.first.begin(), miss.x.first.end(), out.gradient_x.begin());
        std::copy(miss.y.first.begin(), miss.y.first.end(), out.gradient_y.begin());
        std::copy(miss.x.second.begin(), miss.x.second.end(), out.hessian_x.begin());
        std::copy(miss.y.second.begin(), miss.y.second.end(), out.hessian_y.begin());
    } else if (!out.gradient_x.empty()) {
        if constexpr (requires { Formula::miss_and_gradient(given_to<Formula>(form), at, target, out); })
            if (Formula::miss_and_gradient(given_to<Formula>(form), at, target, out)) return;
        const auto miss = evaluate(seeded<Dual<double, n>, n>(at));
        std::copy(miss.x.partial.begin(), miss.x.partial.end(), out.gradient_x.begin());
        std::copy(miss.y.partial.begin(), miss.y.partial.end(), out.gradient_y.begin());
    } else {
        evaluate(at);
    }
}

/// What the formula of a guided body gives besides: the unit vector asked for less that in which the body faces.
template <class T>
struct PoseMissAndMargin {
    MissAndMargin<T> place;
    Vector<T> turn;
};

/// The `miss` of BodyGuidance by a formula with `reads` and `template <class T> static PoseMissAndMargin<T>
/// miss(assembly, const std::array<T, reads + 1>& x, const Vector<double>& target, const Vector<double>& facing)`; it
/// too can have a miss_and_gradient.
template <class Formula>
void pose_miss_by(Form form, std::span<const double> dimensions, double crank_angle, const Vector<double>& target,
                  const Vector<double>& facing, PoseMiss& out) {
    constexpr std::size_t n = Formula::reads + 1;
    std::array<double, n> at{};
    std::copy_n(dimensions.begin(), Formula::reads, at.begin());
    at[Formula::reads] = crank_angle;
    const auto evaluate = [&]<class T>(const std::array<T, n>& x) {
        const PoseMissAndMargin<T> r = Formula::miss(given_to<Formula>(form), x, target, facing);
        out.place.miss = {value_of(r.place.miss.x), value_of(r.place.miss.y)};
        out.turn.miss = {value_of(r.turn.x), value_of(r.turn.y)};
        out.place.margin = out.turn.margin = r.place.margin;
        return r;
    };
    if (!out.place.hessian_x.empty()) {
        const auto r = evaluate(seeded<SecondDual<double, n>, n>(at));
        const auto copy = [](const auto& v, PathMiss& to) {
            std::copy(v.x.first.begin(), v.x.first.end(), to.gradient_x.begin());
            std::copy(v.y.first.begin(), v.y.first.end(), to.gradient_y.begin());
            std::copy(v.x.second.begin(), v.x.second.end(), to.hessian_x.begin());
            std::copy(v.y.second.begin(), v.y.second.end(), to.hessian_y.begin());
        };
        copy(r.place.miss, out.place);
        copy(r.turn, out.turn);
    } else if (!out.place.gradient_x.empty()) {
        if constexpr (requires { Formula::miss_and_gradient(given_to<Formula>(form), at, target, facing, out); })
            if (Formula::miss_and_gradient(given_to<Formula>(form), at, target, facing, out)) return;
        const auto r = evaluate(seeded<Dual<double, n>, n>(at));
        const auto copy = [](const auto& v, PathMiss& to) {
            std::copy(v.x.partial.begin(), v.x.partial.end(), to.gradient_x.begin());
            std::copy(v.y.partial.begin(), v.y.partial.end(), to.gradient_y.begin());
        };
        copy(r.place.miss, out.place);
        copy(r.turn, out.turn);
    } else {
        evaluate(at);
    }
}

}  // namespace mechwright
