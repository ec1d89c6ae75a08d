#include "synthesis/mechanism/linkage/rooms/room_quantities.h"

#include <fmt/format.h>

#include <numbers>
#include <string>
#include <utility>

#include "synthesis/mechanism/linkage/mechanism.h"
#include "synthesis/mechanism/linkage/quantities.h"

namespace mechwright {

namespace {

using Kind = LinkageMeasure::Kind;

std::string meaning_of_side(std::string_view side, const LinkageRoom& room, double direction) {
    return fmt::format("{} of the box that '{}' needs over the motion, at {:.6g} deg to the drawing's x axis", side,
                       room.name, direction);
}

std::string meaning_of_least(std::string_view size, const LinkageRoom& room) {
    return fmt::format("least {} of all boxes, turned in any direction, that '{}' needs over the motion", size,
                       room.name);
}

std::string meaning_of_self_distance(const LinkageRoom& room) {
    return fmt::format(
        "least length of a chord that stands square to the path of '{}' at both of its ends; 0 where the "
        "path crosses itself",
        room.name);
}

std::string meaning_of_swept_area(const LinkageRoom& room, bool uncovered) {
    return fmt::format("area {} the straight line between the two points of '{}' over the motion",
                       uncovered ? "of the screen that is not swept by" : "that is swept by", room.name);
}

std::string meaning_of_margin(const LinkageRegion& region) {
    return fmt::format("least distance over the motion by which parts keep {} '{}'; negative where they do not",
                       region.inside ? "in" : "out of", region.name);
}

}  // namespace

std::vector<Quantity> quantities_of_rooms(const LinkageModel& model, std::size_t dimensions) {
    std::vector<Quantity> all;
    const auto add = [&](std::string name, Unit unit, std::string meaning, Kind kind, std::size_t of_room) {
        LinkageMeasure measure{.kind = kind};
        measure.of_room = of_room;
        all.push_back(linkage_quantity(std::move(name), unit, std::move(meaning), std::move(measure), dimensions));
        all.back().measure_again = measure_linkage_again;
    };
    constexpr double degree = std::numbers::pi / 180;
    for (std::size_t i = 0; i < model.rooms.size(); ++i) {
        const LinkageRoom& room = model.rooms[i];
        if (room.turn == LinkageRoom::Turn::least_width)
            add(room.name + ".width", Unit::length, meaning_of_least("width", room), Kind::turned_width, i);
        if (room.turn == LinkageRoom::Turn::least_area)
            add(room.name + ".area", Unit::area, meaning_of_least("area", room), Kind::turned_area, i);
        if (room.turn != LinkageRoom::Turn::given) continue;
        if (has_path(model.structure, room))
            add(room.name + ".self-distance", Unit::length, meaning_of_self_distance(room), Kind::self_distance, i);
        if (has_blade(model.structure, room))
            add(room.name + ".swept-area", Unit::area, meaning_of_swept_area(room, false), Kind::swept_area, i);
        if (!room.screen.empty())
            add(room.name + ".uncovered", Unit::area, meaning_of_swept_area(room, true), Kind::uncovered, i);
        const double width = room.direction / degree, height = width + 90;
        add(room.name + ".width", Unit::length, meaning_of_side("width", room, width), Kind::room_width, i);
        add(room.name + ".height", Unit::length, meaning_of_side("height", room, height), Kind::room_height, i);
        add(room.name + ".area", Unit::area, "area of this box", Kind::room_area, i);
    }
    for (std::size_t i = 0; i < model.regions.size(); ++i)
        add(model.regions[i].name + ".margin", Unit::length, meaning_of_margin(model.regions[i]), Kind::region_margin,
            i);
    return all;
}

}  // namespace mechwright
