#pragma once
/// \file
/// Larger groups followed along their branch: predictor and corrector, from one configuration to the ends of the branch
/// or once round. A step counts where Newton's method contracts at once, the velocities go on as they were and the
/// determinant keeps its sign; else it is halved. Where no step counts the branch turns (turning_point.h), or what the
/// group hangs on has come to its end.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "analysis/linkage/groups/way.h"
#include "analysis/linkage/motion/turning_point.h"

namespace mechwright::linkage {

namespace detail {

class BranchFollower {
public:
    using Value = Series<double, 1>;

    /// `unit`: how far the master goes where it goes far: a radian, or the size.
    BranchFollower(Driven<Value>& driven, std::size_t group, double unit)
        : driven_(driven), solver_(driven.groups[group]), group_(group), unit_(unit) {
        margin_ = margin_of_larger(driven.order, group);
    }

    double at = 0;
    std::vector<double> places{}, slopes{};

    /// Stands at an input near some places.
    bool start(double input, std::span<const double> near) {
        solver_.near.assign(near.begin(), near.end());
        const bool placed = driven_.place(Value::variable(input), {}, margin_);
        solver_.near.clear();
        if (!placed) return false;
        at = input;
        read(places, slopes);
        sign = solver_.determinant() > 0 ? 1 : -1;
        return true;
    }
    int sign = 1;

    /// Follows to an input or as far as the branch goes, and calls use() after each step. Returns the end.
    template <class Use>
    WayEnd follow(double end, const Use& use) {
        constexpr double widest = std::numbers::pi / 36, narrowest = 1e-12, near_turning = 1e-3;
        const double way = end > at ? 1 : -1;
        double step = widest / 4 * unit_;
        while (at != end) {
            const double to = std::abs(end - at) <= step ? end : at + way * step;
            if (advance(to)) {
                use();
                step = std::min(widest * unit_, 2 * step);
                continue;
            }
            step = std::min(step, std::abs(end - at)) / 2;
            if (step < near_turning * unit_)
                if (const auto turning = turning_ahead(way, 32 * step)) return *turning;
            if (step < narrowest * (unit_ + std::abs(at))) break;
        }
        return {at};
    }

private:
    bool advance(double to) {
        constexpr double farthest = 0.05, contracts = 0.25, bends = 0.2, exact = 1e-6;
        std::vector<double> predicted = places;
        for (std::size_t i = 0; i < predicted.size(); ++i)
            predicted[i] += (to - at) * slopes[i];
        solver_.near = std::move(predicted);
        const bool placed = driven_.place(Value::variable(to), {}, margin_);
        solver_.near.clear();
        if (!placed || solver_.determinant() * sign <= 0 || solver_.first_step > farthest) return false;
        if (solver_.second_step > contracts * solver_.first_step && solver_.second_step > exact) return false;
        std::vector<double> next, then;
        read(next, then);
        for (std::size_t i = 0; i < then.size(); ++i)
            if (std::abs((then[i] - slopes[i]) * (to - at)) > bends * solver_.unit(i)) return false;
        at = to;
        places = std::move(next);
        slopes = std::move(then);
        return true;
    }
    void read(std::vector<double>& values, std::vector<double>& derivatives) const {
        values.clear();
        derivatives.clear();
        for (const auto& [link, part] : solver_.group().unknowns) {
            const LinkPlace<Value>& place = driven_.pose.links[link];
            const Value& one = part == 0 ? place.origin.x : part == 1 ? place.origin.y : driven_.pose.turns[link];
            values.push_back(one.c[0]);
            derivatives.push_back(one.c[1]);
        }
    }
    /// The turning point that lies not farther ahead.
    std::optional<WayEnd> turning_ahead(double way, double within) {
        constexpr double beside = 0.25;
        const auto turning = turning_point(driven_, group_, at, places, slopes);
        if (!turning.found) return {};
        const double end = turning.at.c[0];
        if (!((end - at) * way > 0) || std::abs(end - at) > within) return {};
        WayEnd made{end, true, {}, turning.along};
        for (std::size_t i = 0; i < places.size(); ++i) {
            made.places.push_back(turning.places[i].c[0]);
            if (std::abs(made.places[i] - places[i]) > beside * solver_.unit(i)) return {};
        }
        return made;
    }

    Driven<Value>& driven_;
    GroupSolver<Value>& solver_;
    std::size_t group_, margin_ = 0;
    double unit_;
};

}  // namespace detail

/// Over which inputs ways are followed.
struct Reach {
    double from = 0, to = 0;  ///< of inputs that are no angles
    double period = 0;        ///< after which inputs are the same; 0: never
    double unit = 1;          ///< as of BranchFollower
};

/// The way of a larger group from places near which it is at an input. The ways of groups before it are set. Null where
/// there is no configuration.
inline std::shared_ptr<const Way> follow_way(Driven<Series<double, 1>>& driven, std::size_t group, double input,
                                             std::span<const double> near, const Reach& reach) {
    constexpr double same_within = 1e-9;
    detail::BranchFollower follower(driven, group, reach.unit);
    if (!follower.start(input, near)) return {};
    Way way;
    way.period = reach.period;
    way.sign = follower.sign;
    const std::vector<double> start = follower.places, start_slopes = follower.slopes;
    const auto keep = [&] {
        way.at.push_back(follower.at);
        way.places.insert(way.places.end(), follower.places.begin(), follower.places.end());
        way.slopes.insert(way.slopes.end(), follower.slopes.begin(), follower.slopes.end());
    };
    keep();
    const double ahead = reach.period > 0 ? input + reach.period : reach.to;
    way.last = follower.follow(ahead, keep);
    way.first = {input};
    if (reach.period > 0 && !way.last.limit && way.last.at == ahead) {
        double apart = 0;
        for (std::size_t i = 0; i < start.size(); ++i) {
            const bool turn = driven.groups[group].group().unknowns[i].part == 2;
            const double grown = follower.places[i] - start[i], whole = 2 * std::numbers::pi;
            way.advance.push_back(turn ? whole * std::round(grown / whole) : 0);
            apart = std::max(apart, std::abs(grown - way.advance[i]) / driven.groups[group].unit(i));
        }
        way.whole = apart < same_within;
        return std::make_shared<const Way>(std::move(way));
    }
    Way back;
    std::swap(back.at, way.at);
    std::swap(back.places, way.places);
    std::swap(back.slopes, way.slopes);
    follower.start(input, start);
    way.first = follower.follow(reach.period > 0 ? way.last.at - reach.period : reach.from, keep);
    // The knots behind the start were found from it on: they come in front of the others, the farthest first.
    Way made = way;
    const std::size_t n = start.size(), count = way.at.size();
    made.at.clear();
    made.places.clear();
    made.slopes.clear();
    const auto append = [&](const Way& from, std::size_t k) {
        const auto row = static_cast<std::ptrdiff_t>(k * n), end = static_cast<std::ptrdiff_t>(k * n + n);
        made.at.push_back(from.at[k]);
        made.places.insert(made.places.end(), from.places.begin() + row, from.places.begin() + end);
        made.slopes.insert(made.slopes.end(), from.slopes.begin() + row, from.slopes.begin() + end);
    };
    for (std::size_t k = count; k-- > 0;)
        append(way, k);
    for (std::size_t k = 0; k < back.at.size(); ++k)
        append(back, k);
    return std::make_shared<const Way>(std::move(made));
}

/// A linkage whose larger groups are in one assembly: places of the unknowns of each, at an input.
struct Assembled {
    double input = 0;
    std::vector<std::vector<double>> places{};  ///< for each larger group of the order

    bool exists() const { return !places.empty(); }
};

/// The assembly of other dimensions that the one of these becomes, if they change in proportion from the first to the
/// second at the same input; none where a group comes to a turning point on the way.
inline std::optional<Assembled> assembled_with(const Structure& s, const Order& order, std::span<const double> from,
                                               std::span<const double> to, std::span<const std::int8_t> sides,
                                               std::span<const DriveLaw> laws, const Assembled& start) {
    constexpr double least = 1e-5, farthest = 0.05, contracts = 0.25, exact = 1e-6;
    std::vector<int> signs(start.places.size(), 0);
    const auto at_share = [&](double share, const std::vector<std::vector<double>>& near, Assembled& out) {
        std::vector<double> numbers(from.begin(), from.end());
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] += share * (to[i] - from[i]);
        Driven<double> driven(s, order, std::span<const double>(share == 1 ? to : numbers), sides, laws);
        for (std::size_t g = 0; g < near.size(); ++g)
            driven.groups[g].near = near[g];
        if (!driven.place(start.input, {}, margin_of_larger(order, near.size() - 1))) return false;
        out = {start.input, {}};
        for (std::size_t g = 0; g < near.size(); ++g) {
            const GroupSolver<double>& group = driven.groups[g];
            const int sign = group.determinant() > 0 ? 1 : -1;
            if (signs[g] != 0 && (sign != signs[g] || group.first_step > farthest)) return false;
            if (group.second_step > contracts * group.first_step && group.second_step > exact) return false;
            signs[g] = sign;
            out.places.emplace_back(group.solution().begin(), group.solution().end());
        }
        return true;
    };
    Assembled here, next;
    if (!at_share(0, start.places, here)) return {};
    std::vector<std::vector<double>> before = here.places;
    double share = 0, last = 0, step = 1;
    while (share < 1) {
        const double then = std::min(1.0, share + step);
        std::vector<std::vector<double>> near = here.places;
        for (std::size_t g = 0; g < near.size() && share > last; ++g)
            for (std::size_t i = 0; i < near[g].size(); ++i)
                near[g][i] += (then - share) / (share - last) * (here.places[g][i] - before[g][i]);
        if (at_share(then, near, next)) {
            before = std::exchange(here.places, next.places);
            last = std::exchange(share, then);
            step *= 2;
        } else if ((step /= 2) < least) {
            return {};
        }
    }
    return here;
}

/// The ways of all larger groups from an assembly; null from the first on that has none.
inline std::vector<std::shared_ptr<const Way>> follow_ways(const Structure& s, const Order& order,
                                                           std::span<const double> numbers,
                                                           std::span<const std::int8_t> sides,
                                                           std::span<const DriveLaw> laws, const Assembled& start,
                                                           const Reach& reach) {
    const std::vector<Series<double, 1>> series(numbers.begin(), numbers.end());
    Driven<Series<double, 1>> driven(s, order, std::span<const Series<double, 1>>(series), sides, laws);
    std::vector<std::shared_ptr<const Way>> ways(order.larger.size());
    for (std::size_t g = 0; g < ways.size() && g < start.places.size(); ++g) {
        ways[g] = follow_way(driven, g, start.input, start.places[g], reach);
        driven.groups[g].way = ways[g];
        if (!ways[g]) break;
    }
    return ways;
}

}  // namespace mechwright::linkage
