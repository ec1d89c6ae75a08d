#pragma once
/// \file
/// Where two branches of a larger group meet: the equations hold and are singular. Newton's method on both, with the
/// null vector as unknowns, too (Moore and Spence, The calculation of turning points of nonlinear equations, SIAM J.
/// Numer. Anal. 17 (1980), 567-576), in doubles, then by chord steps in the number type.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "analysis/linkage/groups/factors.h"
#include "analysis/linkage/motion/driven.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

template <class T>
struct TurningPoint {
    bool found = false;
    T at{};                       ///< input of the master
    std::vector<T> places{};      ///< of the group's unknowns
    std::vector<double> along{};  ///< how they move there while the input stands
};

/// The margin that a larger group has.
inline std::size_t margin_of_larger(const Order& order, std::size_t larger) {
    for (const Step& step : order.steps)
        if (step.kind == Step::Kind::together && step.joint == larger) return step.margin;
    return none;
}

namespace detail {

/// Places, input and null vector as unknowns of one system.
template <class T, std::size_t K>
class TurningEquations {
public:
    using Value = Series<T, K>;
    static_assert(K > 0, "the derivatives come from the series");

    TurningEquations(Driven<Value>& driven, std::size_t group, std::span<const double> direction)
        : driven_(driven),
          group_(driven.groups[group]),
          margin_(margin_of_larger(driven.order, group)),
          n_(group_.unknowns()),
          norm_(direction.begin(), direction.end()),
          matrix_(2 * n_ + 1) {}

    std::size_t size() const { return 2 * n_ + 1; }
    /// A step of 1 of an unknown.
    double unit(std::size_t i) const { return i == n_ ? 1 : group_.unit(i < n_ ? i : i - n_ - 1); }

    bool missed(const std::vector<Value>& x, std::vector<Value>& out) {
        group_.held.assign(x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n_));
        const bool placed = driven_.place(x[n_], {}, margin_);
        if (placed) {
            const std::span<Value> all(out);
            group_.residual(driven_.pose, driven_.inputs(), all.first(n_));
            group_.along(driven_.pose, driven_.inputs(), std::span<const Value>(x).last(n_), all.subspan(n_, n_));
            Value sum(T(-1));
            for (std::size_t i = 0; i < n_; ++i)
                add_times(sum, norm_[i], x[n_ + 1 + i]);
            out[2 * n_] = sum;
        }
        group_.held.clear();
        return placed;
    }
    /// Factors the derivatives at x.
    bool factor(const std::vector<Value>& x) {
        std::vector<Value> there;
        for (const Value& one : x)
            there.push_back(Value(T(plain(one))));
        std::vector<Value> column(size());
        matrix_.clear();
        for (std::size_t j = 0; j < size(); ++j) {
            const Value kept = there[j];
            there[j] = Value::variable(kept.c[0], T(unit(j)));
            if (!missed(there, column)) return false;
            for (std::size_t i = 0; i < size(); ++i)
                matrix_.at(i, j) = plain(column[i].c[1]);
            there[j] = kept;
        }
        return std::abs(matrix_.factor()) > 0;
    }
    void inverse(std::vector<double>& into) {
        std::vector<double> column(size());
        into.resize(size() * size());
        matrix_.invert(into, column);
    }

private:
    Driven<Value>& driven_;
    GroupSolver<Value>& group_;
    std::size_t margin_, n_;
    std::vector<double> norm_;
    Factors matrix_;
};

}  // namespace detail

/// The turning point next to an input and places, where they move along `direction`. Not found where Newton's method
/// finds none.
template <class T, std::size_t K>
TurningPoint<Series<T, K>> turning_point(Driven<Series<T, K>>& driven, std::size_t group, double at,
                                         std::span<const double> places, std::span<const double> direction) {
    using Value = Series<T, K>;
    constexpr int most_steps = 24;
    constexpr double settled = 1e-9, rounding = 1e-14;
    const std::size_t n = places.size();
    const GroupSolver<Value>& solver = driven.groups[group];
    double square = 0;
    for (std::size_t i = 0; i < n; ++i)
        square += std::pow(direction[i] / solver.unit(i), 2);
    std::vector<double> norm(n);
    std::vector<Value> x;
    for (const double place : places)
        x.push_back(Value(T(place)));
    x.push_back(Value(T(at)));
    for (std::size_t i = 0; i < n; ++i) {
        norm[i] = direction[i] / std::sqrt(square) / std::pow(solver.unit(i), 2);
        x.push_back(Value(T(direction[i] / std::sqrt(square))));
    }
    detail::TurningEquations<T, K> equations(driven, group, norm);
    std::vector<Value> missed(equations.size());
    std::vector<double> inverse;
    double last = 1;
    std::size_t more = detail::chord_steps<T>();
    bool settling = true;
    for (int step = 0; step < most_steps; ++step) {
        if (settling) {
            if (!equations.factor(x)) return {};
            equations.inverse(inverse);
        }
        if (!equations.missed(x, missed)) return {};
        double moved = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const Value before = x[i];
            for (std::size_t k = 0; k < x.size(); ++k)
                detail::add_times(x[i], -equations.unit(i) * inverse[i * x.size() + k], missed[k]);
            moved = std::max(moved, std::abs(detail::plain(T(x[i].c[0] - before.c[0]))) / equations.unit(i));
        }
        if (!(moved < 10)) return {};
        if (!settling && more-- <= 1) break;
        if (settling && (moved <= rounding || (moved < settled && moved >= 0.5 * last))) {
            settling = false;
            if (more == 0) break;
        }
        last = moved;
        if (step + 1 == most_steps) return {};
    }
    TurningPoint<Value> found{true, x[n], {x.begin(), x.begin() + static_cast<std::ptrdiff_t>(n)}, {}};
    for (std::size_t i = 0; i < n; ++i)
        found.along.push_back(detail::plain(x[n + 1 + i]));
    return found;
}

}  // namespace mechwright::linkage
