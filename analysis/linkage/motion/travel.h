#pragma once
/// \file
/// Where a linkage moves: the intervals of its master's input over which all its dyads close, with their ends to
/// rounding; and how many turns of the master make its motion whole.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/linkage/motion/driven.h"
#include "analysis/linkage/motion/motion_breaks.h"
#include "analysis/linkage/motion/turns.h"
#include "analysis/linkage/structure/inputs.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage {

/// What ends a motion: a margin that vanishes, or nothing but the interval that was asked for.
struct Limit {
    std::size_t margin = none;
    bool inner = false;     ///< Margin::inner, else Margin::outer; of a larger group Way::last, else Way::first
    bool parallel = false;  ///< of two lines that become parallel: places beyond all bounds, no pose
    bool stop = false;      ///< of a joint or a drive: nothing is singular there

    bool exists() const { return margin != none; }
    /// Whether places beside it go like the root of the distance from it.
    bool is_singular() const { return exists() && !stop; }
    friend bool operator==(const Limit&, const Limit&) = default;
};

/// An interval of the master's input in which the linkage moves.
struct Travel {
    double from = 0;
    double to = 0;
    bool whole = false;  ///< it goes on without end, from `to` as from `from`
    Limit first{}, last{};

    friend bool operator==(const Travel&, const Travel&) = default;
};

namespace detail {

/// One margin of a linkage as a function of the master's input. All margins before it must be >= 0 there.
class MarginAlong {
public:
    MarginAlong(const Driven<double>& driven, std::size_t margin)
        : head_(driven.order), margin_(margin), driven_(driven, head_) {
        const auto step = std::find_if(head_.steps.begin(), head_.steps.end(),
                                       [&](const Step& each) { return each.margin == margin; });
        head_.steps.erase(step + 1, head_.steps.end());
        driven_.shortfall = std::numeric_limits<double>::infinity();
        lines_ = head_.steps.back().is_of_lines();
        stop_ = driven.order.is_stop(margin);
        angle_ = head_.steps.back().is_of_angle();
        for (const Step& each : head_.steps)
            unwinds_ = unwinds_ || each.kind == Step::Kind::unwound;
    }
    MarginAlong(const MarginAlong&) = delete;

    /// Two lines have one margin, the sine of the angle between them, here with its sign; it parts travels.
    bool lines() const { return lines_; }
    bool stop() const { return stop_; }
    std::size_t functions() const { return lines_ || stop_ ? 1 : 2; }
    /// What it is measured against, for a linkage of a size.
    double unit(double size) const { return lines_ || angle_ ? 1 : size; }
    std::span<const DriveLaw> laws() const { return driven_.laws; }
    /// As of Driven.
    void follow_within(double input) { driven_.within = input; }
    void follow(double from, double to) {
        if (unwinds_) turns_ = Turns(driven_, from, to);
    }
    Margin<double> operator()(double master) {
        driven_.place(master, turns_.near(master));
        if (!lines_) return driven_.pose.margins[margin_];
        const Step& step = head_.steps.back();
        const Sized<double>& size = driven_.sizes[head_.steps.size() - 1];
        const double sine = cross(locus_line(step.first, size.first, driven_.pose).direction,
                                  locus_line(step.second, size.second, driven_.pose).direction);
        return {sine, sine};
    }
    /// What decides whether it closes.
    double least(double master) {
        const auto [outer, inner] = (*this)(master);
        if (lines_) return std::abs(outer);
        return outer <= inner || std::isnan(outer) ? outer : inner;
    }

private:
    Order head_;
    std::size_t margin_;
    Driven<double> driven_;
    bool lines_ = false, stop_ = false, angle_ = false;
    bool unwinds_ = false;
    Turns turns_{};
};

/// Where a margin vanishes.
struct Vanishing {
    double at;
    Limit limit;
};

/// Adds those in a stretch, or a `part` of one between breaks. Returns whether the margin is a number all over it.
inline bool add_vanishing(MarginAlong& margin, std::size_t index, const Stretch& stretch, bool part, double size,
                          std::vector<Vanishing>& found) {
    constexpr double rounding = 2e-15;
    const auto per_turn = static_cast<std::size_t>(std::ceil(stretch.length() / std::numbers::pi * 3));
    const double floor = rounding * margin.unit(size);
    // The second function is mostly asked for where the first one was, in the same order.
    std::vector<std::pair<double, Margin<double>>> sampled;
    for (std::size_t function = 0; function < margin.functions(); ++function) {
        std::size_t next = 0;
        const auto g = [&](double s) {
            if (function == 0) return sampled.emplace_back(s, margin(stretch.at(s))).second.outer;
            if (next < sampled.size() && sampled[next].first == s) return sampled[next++].second.inner;
            return margin(stretch.at(s)).inner;
        };
        const Panels panels(
            g, stretch.first(), stretch.last(),
            {.first = std::clamp<std::size_t>(per_turn, part ? 1 : 2, 384), .floor = floor, .everywhere = true});
        if (!panels.finite()) return false;
        if (panels.greatest() > 4 * floor)
            panels.zeros(g, [&](double s) {
                found.push_back({stretch.at(s), {index, function == 1, margin.lines(), margin.stop()}});
            });
    }
    return true;
}

/// All in a stretch, in order; absent where the margin is not a number somewhere, as of dyads whose outer pins
/// coincide.
inline std::optional<std::vector<Vanishing>> vanishing(MarginAlong& margin, std::size_t index, const Stretch& stretch,
                                                       double size) {
    std::vector<Vanishing> found;
    const auto parts = parts_of(margin.laws(), stretch);
    for (const MotionPart& part : parts) {
        margin.follow_within(part.within);
        if (!add_vanishing(margin, index, part.stretch, parts.size() > 1, size, found)) return {};
    }
    margin.follow_within(by_itself);
    std::sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
    return found;
}

/// The input next to the end of a travel, on the side of `inside`, at which its margin is not negative by rounding.
inline double closing_end(const Driven<double>& driven, const Travel& travel, const Limit& limit, double end) {
    if (!limit.exists() || limit.parallel || step_together(driven.order, limit.margin) != nullptr) return end;
    constexpr int most = 40;
    MarginAlong margin(driven, limit.margin);
    margin.follow(travel.from, travel.to);
    const double inside = travel.from + 0.5 * (travel.to - travel.from);
    const double toward = inside > end ? 1 : -1;
    double x = end, step = std::numeric_limits<double>::epsilon() * (1 + std::abs(end)) / 2;
    for (int i = 0; i < most && !(margin.least(x) >= 0) && step < std::abs(inside - end); ++i, step *= 2)
        x = end + toward * step;
    return x;
}

/// The part of a travel that the way of a larger group goes along, if it does anywhere.
inline void split_by_way(const Way& way, std::size_t margin, const Travel& travel, std::vector<Travel>& parts) {
    constexpr double beside = 1e-6;  // within which a way comes to the end of what it hangs on
    if (way.whole) return parts.push_back(travel);
    Travel part = travel;
    part.whole = false;
    // Of a whole travel the way is where it is; else it is counted in the turn in which it meets the travel.
    const double middle = 0.5 * (way.from() + way.to()), centre = 0.5 * (travel.from + travel.to);
    const double shift = travel.whole || way.period == 0 ? 0 : way.period * std::round((centre - middle) / way.period);
    const double from = way.from() + shift, to = way.to() + shift;
    if (travel.whole || (way.first.limit && from > travel.from) || from > travel.from + beside) {
        part.from = from;
        part.first = way.first.limit ? Limit{margin, false} : Limit{};
    }
    if (travel.whole || (way.last.limit && to < travel.to) || to < travel.to - beside) {
        part.to = to;
        part.last = way.last.limit ? Limit{margin, true} : Limit{};
    }
    if (part.from < part.to) parts.push_back(part);
}

/// The parts of a travel in which one more margin is not negative. A margin that vanishes without becoming negative but
/// for rounding ends nothing.
inline void split(const Driven<double>& driven, std::size_t index, double size, const Travel& travel,
                  std::vector<Travel>& parts) {
    constexpr double rounding = 8e-15, overlap = 0.125;
    if (const Step* step = step_together(driven.order, index)) {
        if (const auto& way = driven.groups[step->joint].way) split_by_way(*way, index, travel, parts);
        return;
    }
    MarginAlong margin(driven, index);
    const double period = travel.to - travel.from;
    const double to = travel.to + (travel.whole ? overlap : 0);
    margin.follow(travel.from, to);
    const Stretch stretch{travel.from, to, travel.first.is_singular(), travel.last.is_singular()};
    const auto found = vanishing(margin, index, stretch, size);
    if (!found) return;
    std::vector<Vanishing> ends = *found;
    if (travel.whole) {
        // What lies in the overlap is seen a second time, but for pairs next to the seam.
        constexpr double same_within = 1e-6;
        std::vector<Vanishing> first;
        for (const Vanishing& end : ends) {
            const double back = end.at - period;
            const bool again = end.at >= travel.to && std::any_of(first.begin(), first.end(), [&](const auto& f) {
                                   return std::abs(f.at - back) < same_within;
                               });
            if (!again) first.push_back(end.at >= travel.to ? Vanishing{back, end.limit} : end);
        }
        std::sort(first.begin(), first.end(), [](const auto& a, const auto& b) { return a.at < b.at; });
        ends = std::move(first);
    }
    const auto closes = [&](double from, double until) {
        const double least = margin.least(from + 0.5 * (until - from));
        return margin.lines() ? least > rounding : least > -rounding * margin.unit(size);
    };
    if (ends.empty()) {
        if (closes(travel.from, travel.to)) parts.push_back(travel);
        return;
    }
    std::vector<Travel> arcs;
    if (travel.whole) {
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const bool last = i + 1 == ends.size();
            arcs.push_back({ends[i].at, last ? ends[0].at + period : ends[i + 1].at, false, ends[i].limit,
                            ends[last ? 0 : i + 1].limit});
        }
    } else {
        arcs.push_back({travel.from, ends[0].at, false, travel.first, ends[0].limit});
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const bool last = i + 1 == ends.size();
            arcs.push_back({ends[i].at, last ? travel.to : ends[i + 1].at, false, ends[i].limit,
                            last ? travel.last : ends[i + 1].limit});
        }
    }
    // Neighbours that both close are one, unless lines become parallel between them.
    std::vector<bool> closed;
    for (const Travel& arc : arcs)
        closed.push_back(closes(arc.from, arc.to));
    const std::size_t n = arcs.size();
    const auto goes_on = [&](std::size_t i) { return closed[i] && closed[(i + 1) % n] && !margin.lines(); };
    if (travel.whole && std::all_of(closed.begin(), closed.end(), [](bool c) { return c; }) && !margin.lines())
        return parts.push_back(travel);
    std::size_t start = 0;
    if (travel.whole)
        while (start < n && goes_on((start + n - 1) % n))
            ++start;
    for (std::size_t k = 0; k < n; ++k) {
        const std::size_t i = (start + k) % n;
        if (!closed[i]) continue;
        Travel part = arcs[i];
        std::size_t j = i;
        while (k + 1 < n && goes_on(j) && (travel.whole || j + 1 < n)) {
            const Travel& next = arcs[j = (j + 1) % n];
            part.last = next.last;
            ++k;
        }
        if (j != i) part.to = arcs[j].to + (arcs[j].to < part.from ? period : 0);
        if (part.from < part.to) parts.push_back(part);
    }
}

/// How many sides a margin follows from: of the dyads that are placed before its own.
inline std::size_t sides_before(const Order& order, std::size_t margin) {
    std::size_t count = 0;
    for (const Step& step : order.steps) {
        if (step.margin == margin) break;
        if (step.choice != none) ++count;
    }
    return count;
}

}  // namespace detail

/// The parts of travels in which margins are not negative, as they were found for one linkage: assemblies that share
/// the sides of their first dyads share them.
class KnownParts {
public:
    const std::vector<Travel>& of(const Driven<double>& driven, std::size_t margin, double size, const Travel& travel) {
        const auto first = driven.sides.begin();
        const std::vector<std::int8_t> sides(
            first, first + static_cast<std::ptrdiff_t>(detail::sides_before(driven.order, margin)));
        for (const Known& known : all_)
            if (known.margin == margin && known.sides == sides && known.travel == travel) return known.parts;
        std::vector<Travel> parts;
        detail::split(driven, margin, size, travel, parts);
        return all_.emplace_back(Known{margin, sides, travel, std::move(parts)}).parts;
    }

private:
    struct Known {
        std::size_t margin;
        std::vector<std::int8_t> sides;
        Travel travel;
        std::vector<Travel> parts;
    };
    std::vector<Known> all_;
};

/// Every travel of one assembly over the inputs, in order; those that go through the end of cyclic inputs end beyond
/// it. `whole` is one that covers all of cyclic inputs. `known`: of other assemblies of the same linkage.
inline std::vector<Travel> travels(const Driven<double>& driven, const Inputs& inputs, KnownParts& known) {
    // The seam of a cycle lies where linkages seldom have a limit.
    constexpr double seam = -1;
    const double size = size_of(driven), period = inputs.to - inputs.from;
    std::vector<Travel> now{inputs.cyclic ? Travel{inputs.from + seam, inputs.to + seam, true}
                                          : Travel{inputs.from, inputs.to}};
    for (std::size_t margin = 0; margin < driven.order.margins; ++margin) {
        std::vector<Travel> next;
        for (const Travel& travel : now) {
            const std::vector<Travel>& parts = known.of(driven, margin, size, travel);
            next.insert(next.end(), parts.begin(), parts.end());
        }
        now = std::move(next);
    }
    if (inputs.cyclic) {
        if (now.size() == 1 && now[0].whole) return {{inputs.from, inputs.to, true}};
        for (Travel& travel : now) {
            const double shift = period * std::floor((travel.from - inputs.from) / period);
            travel.from -= shift;
            travel.to -= shift;
        }
    }
    for (Travel& travel : now) {
        const double from = detail::closing_end(driven, travel, travel.first, travel.from);
        travel.to = detail::closing_end(driven, travel, travel.last, travel.to);
        travel.from = from;
    }
    if (inputs.cyclic)
        std::sort(now.begin(), now.end(), [](const Travel& a, const Travel& b) { return a.from < b.from; });
    return now;
}

inline std::vector<Travel> travels(const Driven<double>& driven, const Inputs& inputs) {
    KnownParts nothing_yet;
    return travels(driven, inputs, nothing_yet);
}

/// As many turns of the master as its motion can have at most to count as one that closes.
inline constexpr int most_turns = 64;

namespace detail {

/// A whole number but for the rounding of ratios.
inline bool is_whole(double turns) { return std::abs(turns - std::round(turns)) < 1e-9; }

/// How far links turn in one turn of the master, as far as drives and gears say it; links of dyads come back. Absent
/// where something moves away, or drives are no turns.
inline std::optional<std::vector<double>> turns_of_links(const Driven<double>& driven, const Structure& s) {
    std::vector<double> turns(s.links, 0.0);
    for (std::size_t i = 0; i < driven.order.steps.size(); ++i) {
        const Step& step = driven.order.steps[i];
        const Sized<double>& size = driven.sizes[i];
        switch (step.kind) {
            case Step::Kind::driven:
                turns[step.link] = turns[step.other] + (step.reversed ? -1 : 1) * driven.laws[step.input].ratio;
                break;
            case Step::Kind::held: turns[step.link] = turns[step.other]; break;
            case Step::Kind::geared: {
                const double first = turns[step.first.link], second = turns[step.second.link],
                             carrier = turns[step.other], ratio = size.first.length;
                turns[step.link] = step.link == step.second.link  ? carrier + ratio * (first - carrier)
                                   : step.link == step.first.link ? carrier + (second - carrier) / ratio
                                                                  : (ratio * first - second) / (ratio - 1);
                break;
            }
            case Step::Kind::wheeled: turns[step.link] = turns[step.other]; break;
            case Step::Kind::slid:
                if (driven.laws[step.input].ratio != 0) return {};
                break;
            case Step::Kind::racked:
                if (turns[step.first.link] != turns[step.second.link]) return {};
                break;
            default: break;
        }
    }
    return turns;
}

}  // namespace detail

/// The least whole number of turns of the master after which drives, gears and the links that they turn are where they
/// were, `most_turns` at most; absent if there is none, or the master drives a slide. Where gears hang on links that
/// dyads turn, these are followed as far as the linkage closes.
inline std::optional<int> turns_of_cycle(const Structure& s, const Driven<double>& driven) {
    if (s.drives.empty() || s.drives.front().of_slide) return {};
    const auto turns = detail::turns_of_links(driven, s);
    if (!turns) return {};
    const auto comes_back = [&](int n) {
        return std::all_of(turns->begin(), turns->end(), [n](double t) { return detail::is_whole(n * t); });
    };
    int count = 1;
    while (count <= most_turns && !comes_back(count))
        ++count;
    if (count > most_turns) return {};
    const bool unwinds = std::any_of(driven.order.steps.begin(), driven.order.steps.end(),
                                     [](const Step& step) { return step.kind == Step::Kind::unwound; });
    if (!unwinds) return count;
    constexpr double turn = 2 * std::numbers::pi, same_within = 1e-9;
    Driven<double> moving = driven;
    const double size = size_of(driven);
    moving.shortfall = 1e-13 * size;
    if (!moving.place(0)) return count;
    const Pose<double> start = moving.pose;
    std::vector<double> near(s.links);
    Turns::of(start, near, near);
    for (int n = count; n <= most_turns; n += count) {
        const Turns way(moving, turn * (n - count), turn * n, near);
        if (way.empty() || way.to() < turn * n) return count;
        near.assign(way.near(way.to()).begin(), way.near(way.to()).end());
        double apart = 0;
        for (std::size_t i = 0; i < s.links; ++i) {
            const Vector<double> moved = moving.pose.links[i].origin - start.links[i].origin,
                                 turned_by = moving.pose.links[i].along - start.links[i].along;
            apart = std::max({apart, std::hypot(moved.x, moved.y) / size, std::hypot(turned_by.x, turned_by.y)});
        }
        if (apart < same_within) return n;
    }
    return {};
}

}  // namespace mechwright::linkage
