#pragma once
/// \file
/// Where along a motion convex outlines come closest to each other: links, by the outlines of their pins, and outlines
/// that stand still in the drawing.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "analysis/geometry/separation.h"
#include "analysis/linkage/measuring/course.h"
#include "analysis/numbers/golden_section.h"

namespace mechwright::linkage {

/// Corners against the clock: pins, or else places in the drawing.
struct ConvexOutline {
    std::vector<std::size_t> pins{};
    std::vector<Vector<double>> places{};
    bool is_half_plane = false;  ///< all to the left of the line through two places
};

/// Where two outlines come closest: at a stationary place or an end by one pair of features; where outlines that
/// overlap are least deep in each other by two, which say the same there.
struct ClosestPlace {
    Extreme place{};
    Separation by{};
    std::optional<Separation> and_by{};
};

/// The places of all pins along a motion, in the drawing; those that were asked for are kept.
class PlacedPins {
public:
    PlacedPins(const Driven<double>& driven, const Placing<double>& placing, const Course& course)
        : course_(course), driven_(driven), placing_(placing), tilt_(unit_at(placing.tilt)) {
        driven_.shortfall = 1e-13 * size_of(driven);
    }

    /// At an input, until the next is asked for; none where the linkage does not close, of which `closes` tells from
    /// then on.
    std::span<const Vector<double>> at(double input) {
        const std::size_t count = driven_.pose.pins.size();
        const auto [entry, is_new] = kept_.try_emplace(input, places_.size());
        if (is_new) {
            const bool placed = driven_.place(input, course_.turns.near(input));
            closes = closes && placed;
            for (const Vector<double>& pin : driven_.pose.pins) {
                places_.push_back(placing_.origin + placing_.scale * turned(pin, tilt_));
                if (!placed) continue;
                farthest_ = std::max({farthest_, std::abs(places_.back().x), std::abs(places_.back().y)});
            }
        }
        return closes ? std::span(places_).subspan(entry->second, count) : std::span<const Vector<double>>();
    }
    /// By which pieces of motions drives follow (Driven::within), until it is said anew.
    void follow_within(double within) {
        if (within == driven_.within || (std::isnan(within) && std::isnan(driven_.within))) return;
        driven_.within = within;
        kept_.clear();
        places_.clear();
    }
    const Course& course() const { return course_; }
    std::span<const DriveLaw> laws() const { return driven_.laws; }
    /// What is less than this is rounding.
    double floor() const { return detail::one_rounding * farthest_; }

    bool closes = true;

private:
    const Course& course_;
    Driven<double> driven_;
    Placing<double> placing_;
    Vector<double> tilt_;
    std::unordered_map<double, std::size_t> kept_{};
    std::vector<Vector<double>> places_{};
    double farthest_ = 0;
};

namespace detail {

struct SeparationSample {
    double share;
    Separation by;
};

/// Samples over a stretch, closer where it may come nearer than at any of them: between two it falls no steeper than
/// twice as steep as between them or their neighbours.
template <class Function>
std::vector<SeparationSample> separation_samples(const Function& at_share, const Stretch& stretch,
                                                 const PlacedPins& pins) {
    constexpr double of_radian = 40;
    constexpr std::size_t fewest = 64, levels = 4, most = 1 << 15;
    const auto count =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(of_radian * stretch.length())), fewest, most);
    std::vector<SeparationSample> samples, finer;
    samples.reserve(count + 64);
    double best = std::numeric_limits<double>::infinity();
    const auto sample = [&](double share) {
        const SeparationSample one{share, at_share(share)};
        best = std::min(best, one.by.distance);
        return one;
    };
    for (std::size_t i = 0; i <= count; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(count);
        samples.push_back(sample(stretch.first() + (stretch.last() - stretch.first()) * part));
    }
    for (std::size_t level = 0; level < levels && samples.size() < most; ++level) {
        const auto slope = [&](std::size_t i) {
            return std::abs(samples[i + 1].by.distance - samples[i].by.distance) /
                   (samples[i + 1].share - samples[i].share);
        };
        finer.clear();
        for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
            finer.push_back(samples[i]);
            double steepest = slope(i);
            if (i > 0) steepest = std::max(steepest, slope(i - 1));
            if (i + 2 < samples.size()) steepest = std::max(steepest, slope(i + 1));
            const double from = samples[i].share, to = samples[i + 1].share;
            const double lowest = 0.5 * (samples[i].by.distance + samples[i + 1].by.distance) - steepest * (to - from);
            if (lowest < best - pins.floor()) finer.push_back(sample(0.5 * (from + to)));
        }
        finer.push_back(samples.back());
        samples.swap(finer);
    }
    return samples;
}

/// Adds a sample between an end and the sample next to it where it is less than at both of them.
template <class Function>
void look_beside(const Function& at_share, std::vector<SeparationSample>& samples, bool last) {
    constexpr int halvings = 20;
    const SeparationSample &end = last ? samples.back() : samples.front(),
                           &next = last ? samples[samples.size() - 2] : samples[1];
    if (!(end.by.distance <= next.by.distance)) return;
    const auto beside = [&](double part) {
        const double share = end.share + part * (next.share - end.share);
        return SeparationSample{share, at_share(share)};
    };
    const auto is_less = [&](const SeparationSample& one) { return one.by.distance < end.by.distance; };
    if (!is_less(beside(std::ldexp(1.0, -halvings)))) return;
    for (int i = 1; i <= halvings; ++i) {
        const SeparationSample one = beside(std::ldexp(1.0, -i));
        if (!is_less(one)) continue;
        samples.insert(last ? samples.end() - 1 : samples.begin() + 1, one);
        return;
    }
}

/// Where a parabola through three samples is least.
inline double lowest_of_parabola(const SeparationSample& a, const SeparationSample& b, const SeparationSample& c) {
    const double before = (b.by.distance - a.by.distance) / (b.share - a.share),
                 after = (c.by.distance - b.by.distance) / (c.share - b.share);
    const double bend = (after - before) / (c.share - a.share);
    const double share = 0.5 * (a.share + b.share) - 0.5 * before / bend;
    return share > a.share && share < c.share ? share : b.share;
}

/// Adds the places in a part of a motion at which it is less than beside them, inside of it: of what is smooth nearly,
/// else to half of the digits.
template <class Function>
void add_lowest(const Function& at_share, const MotionPart& part, bool smooth, const PlacedPins& pins,
                std::vector<ClosestPlace>& found) {
    constexpr int steps = 36;
    constexpr double beside = 1e-7;
    const Stretch& stretch = part.stretch;
    std::vector<SeparationSample> samples = separation_samples(at_share, stretch, pins);
    look_beside(at_share, samples, false);
    look_beside(at_share, samples, true);
    const auto [least, greatest] =
        std::minmax_element(samples.begin(), samples.end(),
                            [](const auto& one, const auto& other) { return one.by.distance < other.by.distance; });
    if (greatest->by.distance - least->by.distance <= 4 * pins.floor()) return;  // it never changes
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        const SeparationSample &before = samples[i - 1], &here = samples[i], &after = samples[i + 1];
        if (!(here.by.distance <= before.by.distance && here.by.distance < after.by.distance)) continue;
        if (smooth) {
            const double share = lowest_of_parabola(before, here, after);
            found.push_back({{stretch.at(share), here.by.distance, true, {}, part.within}, here.by, {}});
            continue;
        }
        const double share =
            greatest_between([&](double s) { return -at_share(s).distance; }, before.share, after.share, steps);
        const Separation last = at_share(std::max(share - beside, 0.0)), next = at_share(std::min(share + beside, 1.0));
        ClosestPlace one{{stretch.at(share), at_share(share).distance, true, {}, part.within}, last, {}};
        if (!last.is_of_same(next)) one.and_by = next;
        found.push_back(one);
    }
}

}  // namespace detail

/// All places of a course at which of(pins), a Separation, may be least, the ends of one that is no cycle among them;
/// of what is `smooth` nearly those. Empty where the linkage does not close over all of it.
template <class Of>
std::vector<ClosestPlace> lowest_places(PlacedPins& pins, const Of& of, bool smooth) {
    constexpr double same_within = 1e-3;
    const Course& course = pins.course();
    const Travel& travel = course.travel;
    const double period = course.period();
    const double start = travel.whole ? travel.from + detail::seam_of_cycle : travel.from,
                 end = travel.whole ? start + period + detail::overlap_of_cycle : travel.to;
    const Stretch all = travel.whole ? Stretch{start, end} : detail::stretch_of(course, start, end);
    std::vector<ClosestPlace> found;
    const auto at = [&](double input) {
        const auto places = pins.at(input);
        return places.empty() ? Separation{} : of(places);
    };
    const auto parts = parts_of(pins.laws(), all);
    for (const MotionPart& part : parts) {
        pins.follow_within(part.within);
        const auto at_share = [&](double share) { return at(part.stretch.at(share)); };
        detail::add_lowest(at_share, part, smooth, pins, found);
        // Its ends, where they are ends of the motion or breaks of it.
        for (const bool last : {false, true}) {
            const double input = last ? part.stretch.to : part.stretch.from;
            if (travel.whole && (input == start || input == end)) continue;
            const Limit limit = input == travel.from ? travel.first : input == travel.to ? travel.last : Limit{};
            const Separation by = at_share(last ? part.stretch.last() : part.stretch.first());
            found.push_back({{input, by.distance, false, limit, part.within}, by, {}});
        }
    }
    if (!pins.closes) return {};
    if (!travel.whole) return found;
    // What is beyond one cycle was seen at its beginning.
    std::vector<ClosestPlace> once;
    for (const ClosestPlace& one : found) {
        const double back = one.place.at - period;
        const bool again =
            one.place.at >= start + period - same_within &&
            std::any_of(once.begin(), once.end(), [&](const ClosestPlace& other) {
                return std::abs(other.place.at - back) < same_within && other.place.stationary == one.place.stationary;
            });
        if (again) continue;
        once.push_back(one);
    }
    for (ClosestPlace& one : once) {
        if (one.place.at < travel.to) continue;
        one.place.at -= period;
        one.place.within -= period;
    }
    if (once.empty()) {
        // What never changes is least anywhere.
        const Separation by = at(travel.from);
        once.push_back({{travel.from, by.distance, false}, by, {}});
    }
    return once;
}

/// The same of the separation of two outlines, whose nearest features change along the motion.
inline std::vector<ClosestPlace> closest_places(PlacedPins& pins, const ConvexOutline& a, const ConvexOutline& b) {
    std::vector<Vector<double>> first, second;
    const auto corners_of = [](const ConvexOutline& outline, std::span<const Vector<double>> places,
                               std::vector<Vector<double>>& corners) {
        corners.clear();
        for (const std::size_t pin : outline.pins)
            corners.push_back(places[pin]);
        corners.insert(corners.end(), outline.places.begin(), outline.places.end());
    };
    return lowest_places(
        pins,
        [&](std::span<const Vector<double>> places) {
            corners_of(a, places, first);
            corners_of(b, places, second);
            return b.is_half_plane ? separation_from_half_plane(first, second.front(), second.back())
                                   : separation(first, second);
        },
        false);
}

}  // namespace mechwright::linkage
