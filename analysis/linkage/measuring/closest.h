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
#include <vector>

#include "analysis/geometry/separation.h"
#include "analysis/linkage/measuring/course.h"
#include "analysis/numbers/golden_section.h"

namespace mechwright::linkage {

/// Corners against the clock: pins, or else places in the drawing.
struct ConvexOutline {
    std::vector<std::size_t> pins{};
    std::vector<Vector<double>> places{};
};

/// Where two outlines come closest: at a stationary place or an end by one pair of features; where outlines that
/// overlap are least deep in each other by two, which say the same there.
struct ClosestPlace {
    Extreme place{};
    Separation by{};
    std::optional<Separation> and_by{};
};

namespace detail {

/// The outlines of a pose in the drawing.
class Outlines {
public:
    Outlines(Driven<double>& driven, const Placing<double>& placing, const Course& course)
        : driven_(driven), placing_(placing), tilt_(unit_at(placing.tilt)), course_(course) {}

    /// Of two outlines at an input; infinite where the linkage does not close, once for all in `closes`.
    Separation at(double input, const ConvexOutline& a, const ConvexOutline& b) {
        if (!driven_.place(input, course_.turns.near(input))) {
            closes = false;
            return {};
        }
        corners_of(a, first_);
        corners_of(b, second_);
        return separation(first_, second_);
    }
    /// What is less than this is rounding.
    double floor() const { return one_rounding * farthest_; }
    void follow_within(double within) { driven_.within = within; }

    bool closes = true;

private:
    void corners_of(const ConvexOutline& outline, std::vector<Vector<double>>& corners) {
        corners.clear();
        for (const std::size_t pin : outline.pins)
            corners.push_back(placing_.origin + placing_.scale * turned(driven_.pose.pins[pin], tilt_));
        if (outline.pins.empty()) corners = outline.places;
        for (const Vector<double>& corner : corners)
            farthest_ = std::max({farthest_, std::abs(corner.x), std::abs(corner.y)});
    }

    Driven<double>& driven_;
    Placing<double> placing_;
    Vector<double> tilt_;
    const Course& course_;
    std::vector<Vector<double>> first_{}, second_{};
    double farthest_ = 0;
};

struct SeparationSample {
    double share;
    Separation by;
};

/// Samples of a separation over a stretch, closer where it may come nearer than at any of them: between two it falls no
/// steeper than twice as steep as between their neighbours.
template <class Function>
std::vector<SeparationSample> separation_samples(const Function& at_share, const Stretch& stretch,
                                                 const Outlines& outlines) {
    constexpr double of_radian = 40;
    constexpr std::size_t fewest = 64, levels = 8, most = 1 << 15;
    const auto count =
        std::clamp<std::size_t>(static_cast<std::size_t>(std::ceil(of_radian * stretch.length())), fewest, most);
    std::vector<SeparationSample> samples, finer;
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
            if (lowest < best - outlines.floor()) finer.push_back(sample(0.5 * (from + to)));
        }
        finer.push_back(samples.back());
        samples.swap(finer);
    }
    return samples;
}

/// Adds the places in a part of a motion at which a separation is less than beside them, inside of it.
template <class Function>
void add_closest(const Function& at_share, const Stretch& stretch, double within, const Outlines& outlines,
                 std::vector<ClosestPlace>& found) {
    constexpr int steps = 44;
    constexpr double beside = 1e-7;
    const std::vector<SeparationSample> samples = separation_samples(at_share, stretch, outlines);
    const auto [least, greatest] =
        std::minmax_element(samples.begin(), samples.end(),
                            [](const auto& one, const auto& other) { return one.by.distance < other.by.distance; });
    if (greatest->by.distance - least->by.distance <= 4 * outlines.floor()) return;  // it never changes
    for (std::size_t i = 1; i + 1 < samples.size(); ++i) {
        const double here = samples[i].by.distance;
        if (!(here <= samples[i - 1].by.distance && here < samples[i + 1].by.distance)) continue;
        const double share = greatest_between([&](double s) { return -at_share(s).distance; }, samples[i - 1].share,
                                              samples[i + 1].share, steps);
        const Separation before = at_share(std::max(share - beside, 0.0)),
                         after = at_share(std::min(share + beside, 1.0));
        ClosestPlace one{{stretch.at(share), at_share(share).distance, true, {}, within}, before, {}};
        if (!before.is_of_same(after)) one.and_by = after;
        found.push_back(one);
    }
}

}  // namespace detail

/// All places at which two outlines may be closest over a course, the ends of one that is no cycle among them. Empty
/// where the linkage does not close over all of it.
inline std::vector<ClosestPlace> closest_places(const Driven<double>& driven, const Placing<double>& placing,
                                                const Course& course, const ConvexOutline& a, const ConvexOutline& b) {
    constexpr double same_within = 1e-6, rounding = 1e-12;
    Driven<double> moving = driven;
    moving.shortfall = 1e-13 * size_of(driven);
    detail::Outlines outlines(moving, placing, course);
    const Travel& travel = course.travel;
    const double period = course.period();
    const double start = travel.whole ? travel.from + detail::seam_of_cycle : travel.from,
                 end = travel.whole ? start + period + detail::overlap_of_cycle : travel.to;
    const Stretch all = travel.whole ? Stretch{start, end} : detail::stretch_of(course, start, end);
    std::vector<ClosestPlace> found;
    const auto parts = parts_of(std::span<const DriveLaw>(driven.laws), all);
    for (const MotionPart& part : parts) {
        outlines.follow_within(part.within);
        const auto at_share = [&](double share) { return outlines.at(part.stretch.at(share), a, b); };
        detail::add_closest(at_share, part.stretch, part.within, outlines, found);
        // Its ends, where they are ends of the motion or breaks of it.
        for (const bool last : {false, true}) {
            const double at = last ? part.stretch.to : part.stretch.from;
            if (travel.whole && (at == start || at == end)) continue;
            const Limit limit = at == travel.from ? travel.first : at == travel.to ? travel.last : Limit{};
            const Separation by = at_share(last ? part.stretch.last() : part.stretch.first());
            found.push_back({{at, by.distance, false, limit, part.within}, by, {}});
        }
    }
    if (!outlines.closes) return {};
    if (!travel.whole) return found;
    for (ClosestPlace& one : found)
        if (one.place.at >= travel.to) one.place.at -= period;
    std::vector<ClosestPlace> once;
    for (const ClosestPlace& one : found)
        if (std::none_of(once.begin(), once.end(), [&](const ClosestPlace& other) {
                const double apart = std::abs(one.place.at - other.place.at);
                return (apart < same_within || std::abs(apart - period) < same_within) &&
                       std::abs(one.place.value - other.place.value) <= rounding * size_of(driven) &&
                       one.place.stationary == other.place.stationary && one.by.is_of_same(other.by);
            }))
            once.push_back(one);
    if (once.empty()) {
        // What never changes is closest anywhere.
        const double at = travel.from + 0.5 * period;
        const Separation by = outlines.at(at, a, b);
        once.push_back({{at, by.distance, false}, by, {}});
    }
    return once;
}

}  // namespace mechwright::linkage
