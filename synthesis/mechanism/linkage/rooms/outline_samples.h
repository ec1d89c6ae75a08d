#pragma once
/// \file
/// Samples of the places that the pins of a room go through, and the directions in which a box about them is least.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "analysis/geometry/separation.h"
#include "analysis/linkage/measuring/closest.h"
#include "synthesis/mechanism/linkage/measured_over.h"
#include "synthesis/mechanism/linkage/rooms/contacts.h"

namespace mechwright::measuring {

using linkage::Course;

struct OutlineSample {
    Contact contact;
    Vector<double> at;
    bool first, last;  ///< of a part of the motion, or the only one of a pin that stands still

    bool is_fixed() const { return first && last; }
};

/// Those of each pin over each part of a motion, one after the other; none where the linkage does not close over it.
struct OutlineSamples {
    std::vector<OutlineSample> samples{};
    bool seamless = false;  ///< the last of a pin is followed by its first
};

/// Dense enough that the farthest places lie beside one of them. The signals 2 k and 2 k + 1 are the coordinates of the
/// k-th pin.
template <std::size_t K>
OutlineSamples sampled_outline(const Over& over, const LinkageRoom& room, linkage::Measured<double, K>& measured,
                               const Course& course, std::span<const double> dimensions) {
    constexpr double of_radian = 64;
    constexpr std::size_t fewest = 64, most = 1 << 14;
    linkage::PlacedPins placed(over.driven(dimensions), placing_of<double>(over, dimensions, {}), course);
    OutlineSamples outline;
    const linkage::Travel& travel = course.travel;
    const Stretch all = linkage::detail::stretch_of(course, travel.from, travel.to);
    const auto parts = linkage::parts_of(placed.laws(), all);
    for (const linkage::MotionPart& part : parts) {
        placed.follow_within(part.within);
        const Stretch& stretch = part.stretch;
        const auto count = std::clamp<std::size_t>(
            static_cast<std::size_t>(std::ceil(of_radian * stretch.length() / measured.unit_of_input())), fewest, most);
        for (std::size_t k = 0; k < room.pins.size(); ++k) {
            const bool fixed = linkage::is_on(over.model.structure.pins[room.pins[k]], 0);
            if (fixed && &part != &parts.front()) continue;
            for (std::size_t i = fixed ? count / 2 : 0; i <= (fixed ? count / 2 : count); ++i) {
                const double share = static_cast<double>(i) / static_cast<double>(count);
                const double input = stretch.at(stretch.first() + (stretch.last() - stretch.first()) * share);
                const auto places = placed.at(input);
                if (places.empty()) return {};
                const bool first = fixed || i == 0, last = fixed || i == count;
                const bool inside =
                    (first && !fixed && stretch.from > travel.from) || (last && !fixed && stretch.to < travel.to);
                const linkage::Limit limit = fixed || inside ? linkage::Limit{}
                                             : first         ? travel.first
                                             : last          ? travel.last
                                                             : linkage::Limit{};
                Vector<double> at = places[room.pins[k]];
                if (limit.exists())
                    at = {linkage::value_at_limit(measured, {2 * k, 0}, course, !first),
                          linkage::value_at_limit(measured, {2 * k + 1, 0}, course, !first)};
                outline.samples.push_back({{k, {input, 0, !first && !last, limit, part.within}, at}, at, first, last});
            }
        }
    }
    outline.seamless = travel.whole && parts.size() == 1;
    return outline;
}

/// Directions near those in which a box about the samples is least: with a side along one of their hull's, of these
/// such as are close to the least.
inline std::vector<double> directions_of_hull(std::span<const OutlineSample> samples, bool area) {
    constexpr double quarter = std::numbers::pi / 2, close = 2e-3;
    constexpr std::size_t most = 6;
    std::vector<Vector<double>> points;
    for (const OutlineSample& sample : samples)
        points.push_back(sample.at);
    const std::vector<std::size_t> hull = convex_hull(points);
    const double period = area ? quarter : 2 * quarter;
    std::vector<std::pair<double, double>> all;  // a direction, and what is least in it
    for (std::size_t i = 0; i < hull.size() && hull.size() > 1; ++i) {
        const Vector<double> side = points[hull[(i + 1) % hull.size()]] - points[hull[i]];
        double direction = std::atan2(-side.x, side.y);
        direction -= period * std::floor(direction / period);
        const auto width = [&](double d) {
            const Vector<double> way{std::cos(d), std::sin(d)};
            double low = std::numeric_limits<double>::infinity(), high = -low;
            for (const std::size_t corner : hull) {
                const double far = dot(points[corner], way);
                low = std::min(low, far);
                high = std::max(high, far);
            }
            return high - low;
        };
        all.push_back({direction, area ? width(direction) * width(direction + quarter) : width(direction)});
    }
    if (all.empty()) return {0};
    std::sort(all.begin(), all.end());
    const std::size_t n = all.size();
    std::vector<std::pair<double, double>> lowest;
    for (std::size_t i = 0; i < n; ++i)
        if (all[i].second <= all[(i + 1) % n].second && all[i].second <= all[(i + n - 1) % n].second)
            lowest.push_back({all[i].second, all[i].first});
    std::sort(lowest.begin(), lowest.end());
    std::vector<double> found;
    for (const auto& [value, direction] : lowest)
        if (found.size() < most && value <= lowest.front().first * (1 + close)) found.push_back(direction);
    return found;
}

}  // namespace mechwright::measuring
