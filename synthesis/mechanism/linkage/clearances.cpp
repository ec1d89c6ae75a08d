#include "synthesis/mechanism/linkage/clearances.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace mechwright {

namespace {

using linkage::Coordinates;

/// Whether a line runs through a place, so that it would move with it.
bool carries_line(const linkage::Structure& structure, const Coordinates& place) {
    const auto is_it = [&](const Coordinates& other) {
        return other.first == place.first && other.second == place.second;
    };
    const auto runs = [&](const linkage::Line& line) {
        return is_it(line.through) || (!line.by_angle && is_it(line.towards));
    };
    return std::any_of(structure.slides.begin(), structure.slides.end(),
                       [&](const linkage::Slide& slide) { return runs(slide.line); }) ||
           std::any_of(structure.slots.begin(), structure.slots.end(),
                       [&](const linkage::Slot& slot) { return runs(slot.line); });
}

/// Whether a link is there to be joined: neither redundant nor what stands for a circular slot.
bool is_joined(const LinkageModel& model, std::size_t link) {
    const auto& circular = model.structure.circular;
    return std::find(model.redundant.begin(), model.redundant.end(), link) == model.redundant.end() &&
           std::none_of(circular.begin(), circular.end(),
                        [link](const linkage::CircularSlot& slot) { return slot.link == link; });
}

/// Those of one pin: of all its links but one, which is the frame where that is among them.
void add_holes(const LinkageModel& model, std::size_t pin, std::vector<PinOnLink>& holes) {
    const std::vector<linkage::Point>& points = model.structure.pins[pin].points;
    std::vector<std::size_t> movable;
    std::size_t joined = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_joined(model, points[i].link)) continue;
        ++joined;
        if (!carries_line(model.structure, points[i].at)) movable.push_back(i);
    }
    if (joined < 2) return;
    // Links stand in their order, the frame first: where all can move, the first stays.
    if (movable.size() == joined) movable.erase(movable.begin());
    for (const std::size_t point : movable)
        holes.push_back({pin, point});
}

}  // namespace

std::vector<PinOnLink> holes_of(const LinkageModel& model) {
    std::vector<PinOnLink> holes;
    for (std::size_t pin = 0; pin < model.structure.pins.size(); ++pin)
        add_holes(model, pin, holes);
    return holes;
}

std::vector<std::string> names_of_joints(const LinkageModel& model) {
    std::vector<std::string> names;
    for (const auto& [pin, point] : holes_of(model)) {
        const std::vector<linkage::Point>& points = model.structure.pins[pin].points;
        const std::string& name = model.pins[pin];
        names.push_back(points.size() == 2 ? name : fmt::format("{} on {}", name, model.links[points[point].link]));
    }
    return names;
}

Model with_moved_holes(const Model& model, std::span<const double> dimensions, std::span<const Vector<double>> by) {
    LinkageModel moved = *model.as<LinkageModel>();
    moved.identity = std::make_shared<const char>();
    if (moved.as_drawn.empty()) moved.as_drawn = moved.numbers;
    const std::vector<double> numbers = numbers_of(moved, dimensions);
    const double scale = placement_of(moved, dimensions).scale;
    const std::vector<PinOnLink> holes = holes_of(moved);
    for (std::size_t j = 0; j < holes.size(); ++j) {
        const Coordinates& at = moved.structure.pins[holes[j].pin].points[holes[j].point].at;
        const Vector<double> place = linkage::place_of(at, std::span(numbers)) + (1 / scale) * by[j];
        const double first = at.polar ? std::hypot(place.x, place.y) : place.x;
        const double second = at.polar ? std::atan2(place.y, place.x) : place.y;
        const double turned = second - numbers[at.second];
        moved.numbers[at.first].constant += first - numbers[at.first];
        moved.numbers[at.second].constant += at.polar ? std::remainder(turned, 2 * std::numbers::pi) : turned;
    }
    return Model(std::move(moved));
}

}  // namespace mechwright
