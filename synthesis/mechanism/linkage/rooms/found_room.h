#pragma once
/// \file
/// Where boxes and regions are touched along a motion, found for one design.

#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/targets/found_places.h"

namespace mechwright::measuring {

inline constexpr std::size_t most_of_area = 2;  ///< extremes of either sort on each of two ways

/// The extremes of how far a pin is; of one that stands still its place amid the motion.
template <std::size_t K>
std::vector<Extreme> places_of_pin(const Over& over, linkage::Measured<double, K>& plain, const Course& course,
                                   std::size_t signal) {
    const auto at_rest = [&] {
        const double amid = course.travel.from + 0.5 * (course.travel.to - course.travel.from);
        return std::vector<Extreme>{{amid, plain.value(signal, amid, course.turns.near(amid)).c[0], false}};
    };
    if (linkage::is_on(over.model.structure.pins[plain.signals()[signal].of], 0)) return at_rest();
    std::vector<Extreme> places = linkage::extremes(plain, {signal, 0}, course, course.travel.from, course.travel.to);
    return places.empty() ? at_rest() : places;
}

/// The greatest and the least values of some signals.
struct Farthest {
    std::vector<Term> greatest{};
    std::vector<Term> least{};
    bool possible = true;
};

template <std::size_t K>
Farthest farthest_of(const Over& over, linkage::Measured<double, K>& plain, const Course& course, std::size_t first,
                     std::size_t count, std::size_t keep) {
    Found all;
    bool possible = count > 0;
    for (std::size_t signal = first; signal < first + count; ++signal) {
        const std::vector<Extreme> places = places_of_pin(over, plain, course, signal);
        possible = possible && closes(places);
        add_extremes(all, places, {signal, 0}, 1, 0);
    }
    Farthest found{all.plus, std::move(all.plus), possible};
    keep_greatest(found.greatest, keep);
    keep_least(found.least, keep);
    return found;
}

/// What the width, height or area of a room is of. Of an area the height's terms are `plus_across`, `minus_across`.
template <std::size_t K>
Found found_of_room(const Over& over, linkage::Measured<double, K>& plain, const Course& course) {
    const bool area = over.measure.kind == Kind::room_area;
    const std::size_t count = plain.signals().size() / (area ? 2 : 1);
    Farthest along = farthest_of(over, plain, course, 0, count, area ? most_of_area : most_of_range);
    Found found{.plus = std::move(along.greatest), .minus = std::move(along.least), .possible = along.possible};
    if (!area) return found;
    Farthest across = farthest_of(over, plain, course, count, count, most_of_area);
    found.plus_across = std::move(across.greatest);
    found.minus_across = std::move(across.least);
    found.possible = found.possible && across.possible;
    return found;
}

/// What the margin of a region is of where it is that of points.
template <std::size_t K>
Found found_of_points(const Over& over, linkage::Measured<double, K>& plain, const Course& course) {
    const LinkageRegion& region = over.model.regions[over.measure.of_room];
    const double unit = over.model.unit;
    const std::vector<StraightBorder> borders = borders_of(region);
    Found found;
    for (std::size_t signal = 0; signal < plain.signals().size(); ++signal) {
        const std::vector<Extreme> places = places_of_pin(over, plain, course, signal);
        found.possible = found.possible && closes(places);
        if (borders.empty()) {
            add_extremes(found, places, {signal, 0}, -1, region.radius / unit);
        } else {
            const StraightBorder& border = borders[signal % borders.size()];
            add_extremes(found, places, {signal, 0}, 1, -dot(border.inward, border.through) / unit);
        }
    }
    found.possible = found.possible && !found.plus.empty();
    keep_least(found.plus, most_extremes);
    return found;
}

}  // namespace mechwright::measuring
