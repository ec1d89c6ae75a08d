#include "synthesis/exact/geared/geared_rows.h"

#include <algorithm>
#include <numbers>

#include "synthesis/exact/chains/link_frames.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;

constexpr std::size_t of_frame = 0;
constexpr double turn = 2 * std::numbers::pi;

/// The frame of a link that joins two pins; rows of where they are on it.
std::optional<LinkFrame> read_link(const LinkReader& reader, const std::vector<KnownPin>& pins,
                                   std::vector<ChainRow>& rows) {
    const auto frames = reader.frames_of(pins);
    if (frames.empty()) return {};
    for (const KnownPin& pin : pins)
        reader.numbers.add_place(rows, pin.at, frames.front().on_link(pin.drawn));
    return frames.front();
}

/// Between which values a coordinate of the frame may be in the drawing, from its origin.
struct CoordinateRange {
    double min, max;
};

CoordinateRange range_of(const LinkNumbers& numbers, const Affine& affine) {
    CoordinateRange range{affine.constant, affine.constant};
    for (const auto& [dimension, factor] : affine.terms) {
        const DimensionRange& of = numbers.dimensions[dimension];
        range.min += factor * (factor > 0 ? of.min : of.max);
        range.max += factor * (factor > 0 ? of.max : of.min);
    }
    return range;
}

}  // namespace

std::optional<GearedReading> reading_of(const Problem& problem, const GearedFiveBar& bars,
                                        std::span<const Point, 5> pins) {
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    const LinkReader reader{model, {problem.dimensions, model}, model.scale.constant};
    const auto& [driving, driven] = std::pair(bars.driving, bars.driven);
    const auto known = [&](std::size_t pin, std::size_t link, const Point& drawn) {
        return KnownPin{reader.at(pin, link), drawn};
    };
    GearedReading reading;
    auto& rows = reading.rows;
    const std::vector<KnownPin> on_frame{known(driving.pivot, of_frame, pins[0]),
                                         known(driven.pivot, of_frame, pins[3])};
    const auto frames = reader.frames_of_frame(on_frame);
    if (frames.empty()) return {};
    const LinkFrame& frame = frames.front();
    rows = {{model.placement[0], frame.origin.real(), false},
            {model.placement[1], frame.origin.imag(), false},
            {model.placement[2], std::arg(frame.direction), true}};
    for (const KnownPin& pin : on_frame)
        reader.numbers.add_place(rows, pin.at, frame.on_link(pin.drawn));
    const auto first = read_link(
        reader, {known(driving.pivot, driving.link, pins[0]), known(driving.pin, driving.link, pins[1])}, rows);
    const auto second =
        read_link(reader, {known(driven.pivot, driven.link, pins[3]), known(driven.pin, driven.link, pins[2])}, rows);
    const bool rods =
        read_link(reader, {known(driving.pin, driving.rod, pins[1]), known(bars.point, driving.rod, pins[4])}, rows) &&
        read_link(reader, {known(driven.pin, driven.rod, pins[2]), known(bars.point, driven.rod, pins[4])}, rows);
    if (!first || !second || !rods) return {};
    rows.push_back({reader.numbers.number(model.structure.gears[bars.gear].phase), 0, true});
    reading.driving = std::arg(first->direction / frame.direction);
    reading.driven = std::arg(second->direction / frame.direction);
    return reading;
}

std::vector<double> phases_at(const Problem& problem, const GearedFiveBar& bars, double driving, double driven) {
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    const double speed = *speed_of_driven(problem, bars);
    if (bars.drives_first) return {driven - speed * driving};
    const int cycle = std::max(model.turns, 1);
    std::vector<double> phases;
    for (int k = -cycle; k <= cycle; ++k)
        phases.push_back(driving - (driven + turn * k) / speed);
    return phases;
}

PivotRanges pivot_ranges(const Problem& problem, const GearedCrank& crank, const DrawingPlace& place) {
    const LinkageModel& model = *problem.mechanism->model.as<LinkageModel>();
    const LinkNumbers numbers{problem.dimensions, model};
    const PivotRanges any{0, false, -anywhere, anywhere, -anywhere, anywhere};
    const auto x = numbers.constant(model.placement[0]), y = numbers.constant(model.placement[1]);
    const auto tilt = numbers.constant(model.placement[2]);
    if (!x || !y || !tilt) return any;
    const linkage::Coordinates& at = coordinates_on(model.structure.pins[crank.pivot], of_frame);
    const double scale = model.scale.constant, size = place.size;
    const Point origin = (Point(*x, *y) - place.origin) / size;
    if (const auto given = numbers.constant_place(at)) {
        const Point pivot = scale / size * std::polar(1.0, *tilt) * *given;
        return {origin, false, pivot.real(), pivot.real(), pivot.imag(), pivot.imag()};
    }
    if (at.polar || *tilt != 0) return any;
    const CoordinateRange first = range_of(numbers, numbers.number(at.first));
    const CoordinateRange second = range_of(numbers, numbers.number(at.second));
    return {origin,
            false,
            scale / size * first.min,
            scale / size * first.max,
            scale / size * second.min,
            scale / size * second.max};
}

}  // namespace mechwright
