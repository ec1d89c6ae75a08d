#include "synthesis/mechanism/linkage/drawing/drawn_rooms.h"

#include <cmath>

#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/linkage/rooms/box.h"

namespace mechwright {

namespace {

Outline polygon_of(const std::vector<Vector<double>>& corners) {
    Outline outline{Layer::room, {}, true};
    for (const Vector<double>& corner : corners)
        outline.vertices.push_back({corner, 0});
    return outline;
}

Vector<double> way(double direction) { return {std::cos(direction), std::sin(direction)}; }

/// The border of a half-plane beside what keeps to it.
std::optional<Outline> border_of(const MovingDesign& design, const LinkageRegion& region) {
    constexpr double beyond = 0.1;
    LinkageRoom beside{{}, {}, region.direction};
    for (const auto& part : region.parts)
        beside.pins.insert(beside.pins.end(), part.begin(), part.end());
    const auto box = box_of(design.motion, design.dimensions, beside);
    if (!box) return {};
    const double longer = beyond * (box->along.y - box->along.x + box->across.y - box->across.x);
    const Vector<double> along = way(region.direction), through = region.places.front();
    const auto at = [&](double far) { return through + (far - dot(along, through)) * along; };
    return outlines::segment(at(box->along.x - longer), at(box->along.y + longer), Layer::room);
}

std::optional<Outline> outline_of(const MovingDesign& design, const LinkageRegion& region) {
    switch (region.shape) {
        case LinkageRegion::Shape::half_plane: return border_of(design, region);
        case LinkageRegion::Shape::circle: return outlines::circle(region.places.front(), region.radius, Layer::room);
        case LinkageRegion::Shape::polygon: return polygon_of(region.places);
        case LinkageRegion::Shape::link: break;  // is drawn as the link that it is
    }
    return {};
}

std::optional<Outline> outline_of(const MovingDesign& design, const LinkageRoom& room) {
    const auto box = box_of(design.motion, design.dimensions, room);
    if (!box) return {};
    const Vector<double> along = way(box->direction), across = left_of(along);
    const auto at = [&](double width, double height) { return width * along + height * across; };
    return polygon_of({at(box->along.x, box->across.x), at(box->along.y, box->across.x),
                       at(box->along.y, box->across.y), at(box->along.x, box->across.y)});
}

}  // namespace

void draw_rooms(const MovingDesign& design, Body& ground) {
    const LinkageModel& model = linkage_of(design.motion.model);
    const auto add = [&](const auto& all) {
        for (const auto& one : all)
            if (auto outline = outline_of(design, one)) {
                ground.labels.push_back({one.name, outline->vertices.front().at});
                ground.outlines.push_back(*std::move(outline));
            }
    };
    add(model.regions);
    add(model.rooms);
    for (const LinkageRoom& room : model.rooms)
        if (!room.screen.empty()) ground.outlines.push_back(polygon_of(room.screen));
}

}  // namespace mechwright
