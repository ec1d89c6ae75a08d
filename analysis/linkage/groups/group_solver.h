#pragma once
/// \file
/// A larger group placed in a pose: Newton's method on its equations in doubles, from places that are near, then in the
/// number type that is asked for by steps with the same inverse matrix, each of which makes one more order of
/// derivatives right (chord method in a ring with nilpotent elements; Griewank and Walther, Evaluating Derivatives,
/// section 15.1). One factorisation for each pose, and no allocation.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "analysis/linkage/groups/factors.h"
#include "analysis/linkage/groups/loop_equations.h"
#include "analysis/linkage/groups/way.h"

namespace mechwright::linkage {

namespace detail {

/// How many chord steps make all derivatives of a number type right; of one with more digits all digits.
template <class T>
constexpr std::size_t chord_steps() {
    if constexpr (std::is_same_v<T, double>)
        return 0;
    else if constexpr (requires(const T& x) { x.c; })
        return std::tuple_size_v<decltype(T::c)> - 1 + chord_steps<typename T::Value>();
    else if constexpr (requires(const T& x) { x.mixed(0, 0); })
        return 2 + chord_steps<typename T::Value>();
    else if constexpr (requires(const T& x) { x.partial; })
        return 1 + chord_steps<typename T::Value>();
    else
        return 6;
}

/// sum + k x.
template <class T>
void add_times(T& sum, double k, const T& x) {
    if constexpr (requires { x.c; }) {
        for (std::size_t i = 0; i < x.c.size(); ++i)
            add_times(sum.c[i], k, x.c[i]);
    } else if constexpr (requires { x.mixed(0, 0); }) {
        add_times(sum.value, k, x.value);
        for (std::size_t i = 0; i < x.first.size(); ++i)
            add_times(sum.first[i], k, x.first[i]);
        for (std::size_t i = 0; i < x.second.size(); ++i)
            add_times(sum.second[i], k, x.second[i]);
    } else if constexpr (requires { x.partial; }) {
        add_times(sum.value, k, x.value);
        for (std::size_t i = 0; i < x.partial.size(); ++i)
            add_times(sum.partial[i], k, x.partial[i]);
    } else {
        sum += T(k) * x;
    }
}

template <class T>
double plain(const T& x) {
    return number_as<double>(value_of(x));
}

template <class T>
Vector<double> plain(const Vector<T>& x) {
    return {plain(x.x), plain(x.y)};
}

}  // namespace detail

template <class T>
class GroupSolver {
public:
    GroupSolver(const Structure& s, LargerGroup group, std::span<const T> numbers)
        : group_(std::move(group)),
          factors_(group_.unknowns.size()),
          places(group_.unknowns.size(), 0.0),
          missed_(group_.unknowns.size(), T(0)),
          unknowns_(group_.unknowns.size(), T(0)),
          inverse_(std::is_same_v<T, double> ? 0 : group_.unknowns.size() * group_.unknowns.size()),
          step_(group_.unknowns.size()),
          plain_drives_(s.drives.size()) {
        plain_.links.resize(s.links);
        plain_.turns.resize(s.links, 0.0);
        first_column_.assign(3 * s.links, none);
        for (std::size_t i = 0; i < group_.unknowns.size(); ++i)
            first_column_[3 * group_.unknowns[i].link + static_cast<std::size_t>(group_.unknowns[i].part)] = i;
        for (const LoopEquation& e : group_.equations) {
            parts_.push_back(equation_part(s, e, numbers));
            Part<double> part;
            const Part<T>& from = parts_.back();
            part.own = detail::plain(from.own);
            part.moved = detail::plain(from.moved);
            part.through = detail::plain(from.through);
            part.direction = detail::plain(from.direction);
            part.length = detail::plain(from.length);
            for (const Vector<double>& at : {part.own, part.moved, part.through})
                size_ = std::max({size_, std::abs(at.x), std::abs(at.y)});
            plain_parts_.push_back(part);
        }
        if (!(size_ > 0)) size_ = 1;
    }

    /// The way that it follows.
    std::shared_ptr<const Way> way{};
    /// Where its unknowns are taken to be near, instead of on the way; empty: on the way.
    std::vector<double> near{};
    /// Where its unknowns are held, so that nothing is solved; empty: they are not.
    std::vector<T> held{};

    const LargerGroup& group() const { return group_; }
    std::size_t unknowns() const { return group_.unknowns.size(); }
    double size() const { return size_; }
    /// Its determinant in the last pose, scale-free, with its sign.
    double determinant() const { return determinant_; }
    /// The unknowns of the last pose that was solved.
    std::span<const double> solution() const { return places; }

    /// Places the links of the group at an input of the master, for which all that it hangs on is placed. Its margin is
    /// the determinant of its equations as unit vectors, > 0; negative where it does not close or leaves its branch.
    bool place(double master, std::span<const T> drives, Pose<T>& pose, Margin<T>& margin) {
        margin = {T(-1), T(-1)};
        if (!held.empty()) {
            write(std::span<const T>(held), pose);
            margin = {T(0), T(0)};
            return true;
        }
        if (group_.equations.size() != group_.unknowns.size()) return false;
        Way::Near on_way{true};
        if (!near.empty())
            std::copy(near.begin(), near.end(), places.begin());
        else
            on_way = way ? way->near(master, places) : Way::Near{};
        if (!on_way.found) return false;
        hang_on(drives, pose);
        constexpr double at_limit = 4e-15, beside_limit = 1e-11;
        const bool there = on_way.to_limit <= at_limit * (1 + std::abs(master));
        solved_ = !there && solve();
        if (solved_ && near.empty() && way->sign * determinant_ < 0) solved_ = false;
        if (!solved_) {
            if (!(on_way.to_limit <= beside_limit * (1 + std::abs(master)))) return false;
            way->near(master, places);
            determinant_ = 0;
        }
        lift(drives, pose);
        margin = {T(std::abs(determinant_)), T(std::abs(determinant_))};
        return true;
    }

    /// Takes over, in doubles, where everything is that the group hangs on.
    void hang_on(std::span<const T> drives, const Pose<T>& pose) {
        std::transform(drives.begin(), drives.end(), plain_drives_.begin(),
                       [](const T& drive) { return detail::plain(drive); });
        for (const LoopEquation& e : group_.equations)
            for (const std::size_t link : e.links)
                if (link != none) copy_link(pose, link);
    }

    /// Newton's method in doubles from `places`, hung on what is placed, by steps that are no longer than `longest`.
    bool solve(int most_steps = 16, double longest = 1e3) {
        constexpr double rounding = 4e-15, settled = 1e-9;
        first_step = second_step = 0;
        double last = 0;
        for (int i = 0; i < most_steps; ++i) {
            write(std::span<const double>(places), plain_);
            for (std::size_t k = 0; k < unknowns(); ++k)
                step_[k] = missed(group_.equations[k], plain_parts_[k], plain_, std::span<const double>(plain_drives_));
            determinant_ = factor(plain_);
            if (!(std::abs(determinant_) > 0)) return false;
            factors_.solve(step_);
            double moved = 0;
            for (const double step : step_)
                moved = std::max(moved, std::abs(step));
            if (!(moved < 1e9)) return false;
            const double share = moved > longest ? longest / moved : 1;
            for (std::size_t k = 0; k < unknowns(); ++k)
                places[k] -= share * step_[k] * unit(k);
            if (i == 0) first_step = moved;
            if (i == 1) second_step = moved;
            if (moved <= rounding || (i > 0 && moved < settled && moved >= 0.5 * last)) return true;
            last = moved;
        }
        return false;
    }
    double first_step = 0, second_step = 0;  ///< of the last solution: how far they went, over the size, or radians

    /// By how much the equations are missed in a pose.
    void residual(const Pose<T>& pose, std::span<const T> drives, std::span<T> out) const {
        for (std::size_t k = 0; k < unknowns(); ++k)
            out[k] = missed(group_.equations[k], parts_[k], pose, drives);
    }
    /// The derivatives of the equations in a pose along a direction of the unknowns.
    void along(const Pose<T>& pose, std::span<const T> drives, std::span<const T> direction, std::span<T> out) const {
        for (std::size_t k = 0; k < unknowns(); ++k) {
            out[k] = T(0);
            slopes(group_.equations[k], parts_[k], pose, drives, [&](std::size_t link, int part, const T& slope) {
                const std::size_t column = column_of(link, part);
                if (column != none) out[k] = out[k] + slope * direction[column];
            });
        }
    }
    /// Puts the links of the group where unknowns say.
    template <class Number>
    void write(std::span<const Number> unknowns, Pose<Number>& pose) const {
        for (std::size_t i = 0; i < unknowns.size(); ++i) {
            const auto& [link, part] = group_.unknowns[i];
            if (part == 0) pose.links[link].origin.x = unknowns[i];
            if (part == 1) pose.links[link].origin.y = unknowns[i];
            if (part != 2) continue;
            pose.turns[link] = unknowns[i];
            pose.links[link].along = unit_at(unknowns[i]);
        }
    }
    /// What a step of 1 is for an unknown: a radian, or the size.
    double unit(std::size_t unknown) const { return group_.unknowns[unknown].part == 2 ? 1 : size_; }
    /// The pose in doubles, with the links that the equations speak of.
    const Pose<double>& plain_pose() const { return plain_; }
    bool faces_right() const {
        return linkage::faces_right(group_, plain_parts_, plain_, std::span<const double>(plain_drives_));
    }

private:
    std::size_t column_of(std::size_t link, int part) const {
        return first_column_[3 * link + static_cast<std::size_t>(part)];
    }
    void copy_link(const Pose<T>& pose, std::size_t link) {
        plain_.links[link] = {detail::plain(pose.links[link].origin), detail::plain(pose.links[link].along)};
        plain_.turns[link] = detail::plain(pose.turns[link]);
    }
    double factor(const Pose<double>& pose) {
        factors_.clear();
        for (std::size_t k = 0; k < unknowns(); ++k)
            slopes(group_.equations[k], plain_parts_[k], pose, std::span<const double>(plain_drives_),
                   [&](std::size_t link, int part, double slope) {
                       const std::size_t column = column_of(link, part);
                       if (column != none) factors_.at(k, column) += slope * unit(column);
                   });
        return factors_.factor();
    }
    /// From the solution in doubles to that in T.
    void lift(std::span<const T> drives, Pose<T>& pose) {
        for (std::size_t i = 0; i < unknowns(); ++i)
            missed_[i] = T(places[i]);
        write(std::span<const T>(missed_), pose);
        if constexpr (detail::chord_steps<T>() > 0) {
            if (!solved_) return;
            std::copy(missed_.begin(), missed_.end(), unknowns_.begin());
            factors_.invert(inverse_, step_);
            for (std::size_t step = 0; step < detail::chord_steps<T>(); ++step) {
                residual(pose, drives, missed_);
                for (std::size_t i = 0; i < unknowns(); ++i)
                    for (std::size_t k = 0; k < unknowns(); ++k)
                        detail::add_times(unknowns_[i], -unit(i) * inverse_[i * unknowns() + k], missed_[k]);
                write(std::span<const T>(unknowns_), pose);
            }
        }
    }

    LargerGroup group_;
    std::vector<Part<T>> parts_;
    std::vector<Part<double>> plain_parts_;
    double size_ = 0;
    Factors factors_;
    Pose<double> plain_;

public:
    std::vector<double> places;  ///< of the unknowns

private:
    std::vector<T> missed_, unknowns_;
    std::vector<double> inverse_, step_;
    std::vector<double> plain_drives_;
    std::vector<std::size_t> first_column_;
    double determinant_ = 0;
    bool solved_ = false;
};

}  // namespace mechwright::linkage
