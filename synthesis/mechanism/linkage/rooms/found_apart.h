#pragma once
/// \file
/// Where parts of a linkage come closest to a region out of which they keep, found for one design, with the signals
/// that say by how much.

#include <cmath>
#include <cstddef>
#include <span>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/rooms/found_room.h"

namespace mechwright::measuring {

using linkage::ConvexOutline;

/// A part as the outline of its pins: their convex hull on the first link that has them all.
inline ConvexOutline outline_of_part(const Over& over, std::span<const double> dimensions,
                                     const std::vector<std::size_t>& part) {
    const auto& pins = over.model.structure.pins;
    for (const linkage::Point& point : pins[part.front()].points) {
        const auto is_on_it = [&](std::size_t pin) { return linkage::is_on(pins[pin], point.link); };
        if (!std::all_of(part.begin(), part.end(), is_on_it)) continue;
        const std::vector<double> numbers = numbers_of(over.model, dimensions);
        std::vector<Vector<double>> places;
        for (const std::size_t pin : part)
            places.push_back(
                linkage::place_of(linkage::coordinates_on(pins[pin], point.link), std::span<const double>(numbers)));
        ConvexOutline outline;
        for (const std::size_t corner : convex_hull(places))
            outline.pins.push_back(part[corner]);
        return outline;
    }
    return {part, {}};
}

/// What of a region has to be free, as outlines about which there is `radius`.
inline std::vector<ConvexOutline> outlines_of_region(const Over& over, std::span<const double> dimensions,
                                                     const LinkageRegion& region) {
    if (!region.pins.empty()) return {outline_of_part(over, dimensions, region.pins)};
    std::vector<ConvexOutline> outlines;
    const auto add = [&](const std::vector<Vector<double>>& places) {
        ConvexOutline& outline = outlines.emplace_back();
        for (const Vector<double>& place : places)
            outline.places.push_back((1 / over.model.unit) * place);
    };
    if (region.pieces.empty()) add(region.places);
    for (const auto& piece : region.pieces) {
        add(piece);
        outlines.back().is_half_plane = piece.size() == 2;
    }
    return outlines;
}

/// A separation of a part and a region as a signal, times a factor, plus a constant.
struct SignalOfSeparation {
    Signal signal{};
    double factor = 1;
    double constant = 0;
};

inline SignalOfSeparation signal_of(const Separation& by, const ConvexOutline& part, const ConvexOutline& region) {
    using Of = Separation::Of;
    const auto& corners = region.places;
    const bool moves = corners.empty();
    const auto next = [](const auto& all, std::size_t i) { return all[(i + 1) % all.size()]; };
    Signal signal;
    if (by.of == Of::corners) {
        signal = {.kind = moves ? Signal::Kind::distance : Signal::Kind::from_place, .of = part.pins[by.first]};
        if (moves)
            signal.to = region.pins[by.second];
        else
            signal.place = corners[by.second];
        return {signal};
    }
    if (by.of == Of::side_of_first) {
        signal = {.kind = moves ? Signal::Kind::from_line : Signal::Kind::place_from_line,
                  .to = part.pins[by.first],
                  .end = next(part.pins, by.first)};
        if (moves)
            signal.of = region.pins[by.second];
        else
            signal.place = corners[by.second];
        return {signal, -1};
    }
    if (moves)
        return {{.kind = Signal::Kind::from_line,
                 .of = part.pins[by.first],
                 .to = region.pins[by.second],
                 .end = next(region.pins, by.second)},
                -1};
    const Vector<double> side = next(corners, by.second) - corners[by.second];
    const Vector<double> outward = (-1 / std::hypot(side.x, side.y)) * left_of(side);
    // Corners of pieces may be far away: the nearer end of the side costs the fewer digits.
    const Vector<double>&from = corners[by.second], to = next(corners, by.second);
    const Vector<double>& through = dot(from, from) <= dot(to, to) ? from : to;
    return {{.kind = Signal::Kind::along, .of = part.pins[by.first], .number = std::atan2(outward.y, outward.x)},
            1,
            -dot(outward, through)};
}

/// The places, and their signals.
struct FoundApart {
    std::vector<Signal> signals{};
    Found found{};
};

/// Adds where a part comes closest to an outline about which there is `radius`.
inline void add_closest(linkage::PlacedPins& placed, const ConvexOutline& part, const ConvexOutline& outline,
                        double radius, FoundApart& made) {
    const auto add_signal = [&](const SignalOfSeparation& of) {
        made.signals.push_back(of.signal);
        return made.signals.size() - 1;
    };
    const auto places = linkage::closest_places(placed, part, outline);
    made.found.possible = made.found.possible && !places.empty();
    for (const ClosestPlace& one : places) {
        const SignalOfSeparation by = signal_of(one.by, part, outline);
        Term term{{add_signal(by), 0}, one.place, by.factor, by.constant - radius};
        term.place.value = (one.place.value - radius - term.constant) / term.factor;
        if (one.and_by) {
            const SignalOfSeparation other = signal_of(*one.and_by, part, outline);
            term.also = linkage::Scaled{add_signal(other), other.factor, other.constant - radius};
        }
        made.found.plus.push_back(std::move(term));
    }
}

/// Where the parts of a region come closest to what of it has to be free.
inline FoundApart closest_to_region(const Over& over, std::span<const double> dimensions, const Course& course) {
    const LinkageRegion& region = over.model.regions[over.measure.of_room];
    const double unit = over.model.unit;
    const std::vector<ConvexOutline> outlines = outlines_of_region(over, dimensions, region);
    linkage::PlacedPins placed(over.driven(dimensions), placing_of<double>(over, dimensions, {}), course);
    FoundApart made;
    for (const std::vector<std::size_t>& pins : region.parts) {
        const ConvexOutline part = outline_of_part(over, dimensions, pins);
        for (const ConvexOutline& outline : outlines)
            add_closest(placed, part, outline, region.radius / unit, made);
    }
    made.found.possible = made.found.possible && !made.found.plus.empty();
    keep_least(made.found.plus, most_extremes + 2);
    return made;
}

}  // namespace mechwright::measuring
