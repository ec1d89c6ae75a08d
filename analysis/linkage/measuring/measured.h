#pragma once
/// \file
/// A linkage along its motion with its signals as series of the time.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <unordered_map>
#include <utility>
#include <vector>

#include "analysis/linkage/measuring/signals.h"
#include "analysis/linkage/motion/travel.h"
#include "analysis/linkage/motion/turning_point.h"
#include "analysis/numbers/series.h"

namespace mechwright::linkage {

/// The motion over which signals are measured: a travel, or a part of one, with the turns of links along it (over a
/// second cycle too, where it is whole, for stretches that go through its end).
struct Course {
    Travel travel{};
    Turns turns{};

    double period() const { return travel.to - travel.from; }
};

namespace detail {

/// Extremes of a cycle are sought from here on, where they seldom are, and as much beyond its end.
inline constexpr double seam_of_cycle = 0.7, overlap_of_cycle = 0.125, beyond_cycle = 1;

}  // namespace detail

/// Follows the links along a travel: from turns in (-pi, pi] at its start. Of a whole one that no stretch goes beyond
/// one cycle is enough.
inline Course course_along(const Driven<double>& driven, const Travel& travel, bool twice = true) {
    Driven<double> moving = driven;
    moving.shortfall = 1e-13 * size_of(driven);
    const double beyond = !travel.whole ? 0 : twice ? travel.to - travel.from : detail::beyond_cycle;
    return {travel, Turns(moving, travel.from, travel.to + beyond)};
}

/// A linkage with its signals as series of the time, in which the master's input grows by `rate`: numbers of the type T
/// that is given, and all derivatives up to the K-th.
template <class T, std::size_t K>
class Measured {
public:
    using Value = Series<T, K>;

    Measured(const Structure& s, const Order& order, std::span<const T> numbers, std::span<const std::int8_t> sides,
             std::span<const DriveLaw> laws, std::span<const Signal> signals, const Placing<T>& placing,
             double rate = 1, std::span<const std::shared_ptr<const Way>> ways = {})
        : driven_(s, order, series(numbers), sides, laws),
          values_(s, signals, std::span<const Value>(series(numbers)),
                  {{placing.origin.x, placing.origin.y}, placing.tilt, placing.scale}),
          rate_(rate),
          unit_of_input_(s.drives.front().of_slide ? size_of(driven_) : 1) {
        driven_.shortfall = 1e-13 * size_of(driven_);
        driven_.set_ways(ways);
    }

    /// A signal at an input of the master. At a limit its dyad or larger group is placed exactly there. Not a number
    /// where the linkage does not close.
    Value value(std::size_t signal, double master, std::span<const double> near, const Limit& limit = {}) {
        if (!place(master, near, limit)) return Value(T(std::numeric_limits<double>::quiet_NaN()));
        look_beside(master);
        return values_.value(signal, driven_, near);
    }
    /// The vector whose size a signal is (is_size).
    Vector<Value> vector(std::size_t signal, double master, std::span<const double> near) {
        if (!place(master, near, {})) return {T(std::numeric_limits<double>::quiet_NaN()), T(0)};
        return values_.vector(signal, driven_.pose);
    }
    /// A margin there; another one can be held at its limit. Of a larger group that is not held it is how far the
    /// master is beyond the limit, times its rate.
    Value margin(const Limit& limit, double master, std::span<const double> near, const Limit& held = {}) {
        if (!held.exists() && step_together(driven_.order, limit.margin) != nullptr) return beyond_limit(limit, master);
        const Margin<Value>& both = margins(limit.margin, master, near, held);
        return limit.inner ? both.inner : both.outer;
    }
    const Margin<Value>& margins(std::size_t margin, double master, std::span<const double> near,
                                 const Limit& held = {}) {
        place(master, near, held, margin);
        return driven_.pose.margins[margin];
    }
    /// How far a dyad is from its outer limit; not a number where those before it do not close, or it does not itself.
    Value closed_margin(std::size_t margin, double master, std::span<const double> near) {
        if (!place(master, near, {}, margin)) return Value(T(std::numeric_limits<double>::quiet_NaN()));
        return driven_.pose.margins[margin].outer;
    }
    /// The same of the limit of a larger group.
    Value beyond_limit(const Limit& limit, double master) {
        return Value::variable(T(master), T(rate_)) - turning(limit, master).at;
    }

    /// Keeps the poses that are placed from now on: for many signals that are looked at for the same inputs.
    void keep_poses() { keeps_poses_ = true; }
    /// What is asked of signals whose errors are measured.
    void ask(const Wanted<T>& wanted) {
        values_.wanted = {Value(wanted.from), Value(wanted.way), Value(wanted.start), Value(wanted.range), wanted.part};
    }
    /// By which pieces of motions drives follow (Driven::within), and on which side of rests sizes are asked for, until
    /// it is said anew.
    void follow_within(double input) {
        const bool same = input == driven_.within || (std::isnan(input) && std::isnan(driven_.within));
        if (!same) {
            kept_.clear();
            shown_.reset();
        }
        driven_.within = input;
    }
    void start_at(const Course& course) { values_.start_at(course.turns.near(course.travel.from)); }
    std::span<const Signal> signals() const { return values_.signals; }
    const Driven<Value>& driven() const { return driven_; }
    double rate() const { return rate_; }
    /// A radian, or the size of the linkage where a slide drives it.
    double unit_of_input() const { return unit_of_input_; }

private:
    /// On the side of the input by whose pieces drives follow.
    void look_beside(double master) {
        constexpr double near = 1e-9;  // of a radian, or of the size
        const bool known = !std::isnan(driven_.within) && driven_.within != master;
        values_.beside_rest = {!known                                     ? 0
                               : (driven_.within > master) == (rate_ > 0) ? 1
                                                                          : -1,
                               near * unit_of_input_ / std::abs(rate_)};
    }
    bool place(double master, std::span<const double> near, const Limit& limit, std::size_t last_margin = none) {
        if (held_ != none) driven_.sides[held_] = held_side_;
        held_ = none;
        put_back();
        if (!keeps_poses_ || limit.exists() || last_margin != none) return place_now(master, near, limit, last_margin);
        const auto [entry, is_new] = kept_.try_emplace(master);
        Kept& kept = entry->second;
        if (is_new) {
            kept.closes = place_now(master, near, limit, last_margin);
            kept.pose = driven_.pose;
        } else {
            driven_.set_inputs(Value::variable(T(master), T(rate_)));
            std::swap(driven_.pose, kept.pose);
            shown_ = master;
        }
        return kept.closes;
    }
    /// A kept pose that is shown goes back to the others.
    void put_back() {
        if (shown_) std::swap(driven_.pose, kept_.at(*shown_).pose);
        shown_.reset();
    }
    bool place_now(double master, std::span<const double> near, const Limit& limit, std::size_t last_margin) {
        for (GroupSolver<Value>& group : driven_.groups)
            group.held.clear();
        if (const Step* step = limit.exists() ? step_together(driven_.order, limit.margin) : nullptr) {
            std::vector<Value> places = turning(limit, master).places;
            driven_.groups[step->joint].held = std::move(places);
        }
        for (const Step& step : driven_.order.steps)
            if (limit.exists() && step.margin == limit.margin) held_ = step.choice;
        if (held_ != none) {
            held_side_ = driven_.sides[held_];
            driven_.sides[held_] = 0;
        }
        return driven_.place(Value::variable(T(master), T(rate_)), near, last_margin);
    }
    /// Where a larger group turns back: its limit next to an input.
    TurningPoint<Value> turning(const Limit& limit, double master) {
        const GroupSolver<Value>& group = driven_.groups[step_together(driven_.order, limit.margin)->joint];
        const WayEnd& end = limit.inner ? group.way->last : group.way->first;
        const double period = group.way->period;
        const double shift = period > 0 ? period * std::round((master - end.at) / period) : 0;
        TurningPoint<Value> found;
        if constexpr (K > 0)
            found = turning_point(driven_, static_cast<std::size_t>(&group - driven_.groups.data()), end.at, end.places,
                                  end.along);
        if (!found.found) {
            found.at = Value(T(end.at));
            found.places.assign(end.places.begin(), end.places.end());
        }
        found.at = found.at + Value(T(shift));
        return found;
    }
    static std::vector<Value> series(std::span<const T> numbers) { return {numbers.begin(), numbers.end()}; }

    struct Kept {
        bool closes = false;
        Pose<Value> pose{};
    };

    Driven<Value> driven_;
    SignalValues<Value> values_;
    double rate_;
    double unit_of_input_;
    bool keeps_poses_ = false;
    std::unordered_map<double, Kept> kept_{};
    std::optional<double> shown_{};  ///< the input whose kept pose `driven_` has
    /// The dyad that is placed at its limit now, and its side elsewhere.
    std::size_t held_ = none;
    std::int8_t held_side_ = 1;
};

/// Keeps drives to the pieces of an input for so long as it stands.
template <class T, std::size_t K>
class WithinPiece {
public:
    WithinPiece(Measured<T, K>& measured, double within) : measured_(measured) { measured.follow_within(within); }
    WithinPiece(const WithinPiece&) = delete;
    ~WithinPiece() { measured_.follow_within(by_itself); }

private:
    Measured<T, K>& measured_;
};

}  // namespace mechwright::linkage
