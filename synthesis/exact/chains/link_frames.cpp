#include "synthesis/exact/chains/link_frames.h"

#include <algorithm>

namespace mechwright {

namespace {

using Point = std::complex<double>;

}  // namespace

std::vector<LinkFrame> LinkReader::frames_of(const std::vector<KnownPin>& pins, const std::optional<KnownLine>& line,
                                             const std::optional<Point>& given) const {
    const auto anchor = std::find_if(pins.begin(), pins.end(),
                                     [&](const KnownPin& pin) { return numbers.constant_place(pin.at).has_value(); });
    if (anchor == pins.end()) return {};
    const Point from = *numbers.constant_place(anchor->at);
    std::vector<Point> directions;
    if (given) directions.push_back(*given);
    for (auto pin = pins.begin(); pin != pins.end() && directions.empty(); ++pin) {
        if (pin == anchor || std::abs(pin->drawn - anchor->drawn) == 0) continue;
        const auto to = numbers.direction_to(pin->at, from);
        const Point drawn = pin->drawn - anchor->drawn;
        if (to) directions.push_back(drawn / std::abs(drawn) / *to);
    }
    if (directions.empty() && line)
        if (const auto angle = numbers.constant(line->angle))
            for (const double sense : {1.0, -1.0})
                directions.push_back(sense * line->along / std::polar(1.0, *angle));
    std::vector<LinkFrame> frames;
    for (const Point& direction : directions)
        frames.push_back({anchor->drawn - size * direction * from, direction, size});
    return frames;
}

std::vector<LinkFrame> LinkReader::frames_of_frame(const std::vector<KnownPin>& pins,
                                                   const std::optional<KnownLine>& line) const {
    const auto x = numbers.constant(model.placement[0]), y = numbers.constant(model.placement[1]);
    const auto tilt = numbers.constant(model.placement[2]);
    const auto direction = tilt ? std::optional(std::polar(1.0, *tilt)) : std::nullopt;
    if (x && y && direction) return {{Point(*x, *y), *direction, size}};
    return frames_of(pins, line, direction);
}

}  // namespace mechwright
