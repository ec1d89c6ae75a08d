// [[room]] and [[region]]: the boxes that parts of a linkage need, and where they keep in or out.

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "analysis/geometry/convex_pieces.h"
#include "analysis/geometry/polygon.h"
#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

using Shape = LinkageRegion::Shape;
using Place = Vector<double>;
using Parts = std::vector<std::vector<std::size_t>>;

constexpr std::string_view of_all = "mechanism", of_frame = "pivots";

/// Whether something stands for a circular slot, and is no link to be seen.
bool is_circular(const linkage::Structure& s, std::size_t link) {
    return std::any_of(s.circular.begin(), s.circular.end(),
                       [link](const linkage::CircularSlot& slot) { return slot.link == link; });
}

/// Whether a pin is a joint of links that can be seen.
bool joins(const linkage::Structure& s, std::size_t pin) {
    const auto& points = s.pins[pin].points;
    const auto seen = std::count_if(points.begin(), points.end(),
                                    [&](const linkage::Point& point) { return !is_circular(s, point.link); });
    return seen > 1 || (points.size() == 1 && linkage::is_joint(s, pin));
}

std::vector<std::size_t> pins_on(const linkage::Structure& s, std::size_t link) {
    std::vector<std::size_t> pins;
    for (std::size_t pin = 0; pin < s.pins.size(); ++pin)
        if (linkage::is_on(s.pins[pin], link)) pins.push_back(pin);
    return pins;
}

/// The joints on the frame, each by itself: nothing fills what is between them.
void add_pivots(const linkage::Structure& s, Parts& parts) {
    for (const std::size_t pin : pins_on(s, 0))
        if (joins(s, pin)) parts.push_back({pin});
}

void add_link(const linkage::Structure& s, std::size_t link, Parts& parts) {
    if (link == 0) return add_pivots(s, parts);
    if (std::vector<std::size_t> pins = pins_on(s, link); !pins.empty()) parts.push_back(std::move(pins));
}

/// A link or a point by its name.
void add_named(LinkageReading& reading, const toml::node& node, const std::string& what, Parts& parts) {
    const Linkage& made = reading.made;
    const auto name = node.value_exact<std::string>();
    if (!name) return report_kind(node, what, "the name of a link or a point", reading.messages);
    std::vector<std::string_view> known;
    std::optional<std::size_t> link, pin;
    for (std::size_t i = 0; i < made.links.size(); ++i) {
        if (is_circular(made.structure, i)) continue;
        known.push_back(made.links[i]);
        if (made.links[i] == *name) link = i;
    }
    for (std::size_t i = 0; i < made.pins.size(); ++i) {
        if (made.pins[i].find(' ') != std::string::npos) continue;  // the centre of a circular slot
        known.push_back(made.pins[i]);
        if (made.pins[i] == *name) pin = i;
    }
    if (link && pin)
        return add_error(reading.messages, place_of(node),
                         fmt::format("{}: '{}' names a link and a point: give one of them another name", what, *name));
    const std::size_t before = parts.size();
    if (pin) return parts.push_back({*pin});
    if (link) add_link(made.structure, *link, parts);
    if (parts.size() > before) return;
    add_error(reading.messages, place_of(node),
              link ? fmt::format("{}: the link '{}' has no points: give it some where it reaches to", what, *name)
                   : fmt::format("{}: there is no link and no point {}; {}", what, reading::quoted(*name),
                                 remedy(*name, known)));
}

/// What `of` says: all links and pivots where it is not there.
Parts read_parts(LinkageReading& reading, Section& section) {
    Parts parts;
    const linkage::Structure& s = reading.made.structure;
    const toml::node* node = find(section, "of");
    const auto word = node == nullptr ? std::optional(std::string(of_all)) : node->value_exact<std::string>();
    const std::string what = name_of(section, "of");
    if (word == of_all) {
        for (std::size_t link = 0; link < s.links; ++link)
            if (!is_circular(s, link)) add_link(s, link, parts);
    } else if (word == of_frame) {
        add_pivots(s, parts);
        if (parts.empty())
            add_error(reading.messages, place_of(*node),
                      fmt::format("{}: nothing is pinned to the frame: name points or links, like [\"P\"]", what));
    } else if (const toml::array* list = node->as_array()) {
        if (list->empty())
            add_error(reading.messages, place_of(*node),
                      fmt::format("{} is empty: name links and points, or write of = \"mechanism\"", what));
        for (const toml::node& one : *list)
            add_named(reading, one, what, parts);
    } else if (word) {
        add_named(reading, *node, what, parts);
    } else {
        report_kind(*node, what, "\"mechanism\", \"pivots\" or a list of names of links and points", reading.messages);
    }
    return parts;
}

std::optional<std::string> read_own_name(LinkageReading& reading, Section& section, std::string_view example) {
    const auto name = read_string(section, "name", reading.messages);
    const FilePlace place = place_of(section, "name");
    if (!name) {
        if (!has(section, "name"))
            add_error(reading.messages, section.place,
                      fmt::format("{} is missing: its quantities are called by it, like {}", name_of(section, "name"),
                                  example));
        return {};
    }
    if (!is_name(reading, *name, place, "name")) return {};
    if (is_reserved_name(*name)) {
        add_error(reading.messages, place,
                  fmt::format("'{}' cannot be the name of a room or a region: it is a quantity already", *name));
        return {};
    }
    if (is_name_of_room(reading.made, *name)) {
        add_error(reading.messages, place,
                  fmt::format("'{}' is the name of another room or region: give this one another", *name));
        return {};
    }
    // Of a linkage that a file describes these are read later, and are refused then.
    const auto& signals = reading.made.signals;
    if (std::any_of(signals.begin(), signals.end(), [&](const LinkageSignal& one) { return one.name == *name; })) {
        add_error(reading.messages, place,
                  fmt::format("'{}' is a signal of the linkage that this mechanism is, as 'mechwright expand' writes "
                              "it: give the room or region another name",
                              *name));
        return {};
    }
    return name;
}

std::optional<Place> to_pair(LinkageReading& reading, const toml::node& node, const std::string& what) {
    const toml::array* pair = node.as_array();
    if (pair == nullptr || pair->size() != 2)
        return report_kind(node, what, "two numbers, [x, y] in the drawing's axes", reading.messages), std::nullopt;
    const auto x = to_number(*pair->get(0), what, reading.messages),
               y = to_number(*pair->get(1), what, reading.messages);
    return x && y ? std::optional(Place{*x, *y}) : std::nullopt;
}

std::optional<Place> read_pair(LinkageReading& reading, Section& section, std::string_view key) {
    if (const toml::node* node = find(section, key)) return to_pair(reading, *node, name_of(section, key));
    add_error(reading.messages, section.place, fmt::format("{} is missing", name_of(section, key)));
    return {};
}

/// Why corners are those of no polygon; empty if they are. They then are against the clock.
std::string why_no_polygon(std::vector<Place>& corners) {
    const std::size_t n = corners.size();
    if (n < 3) return "needs three corners or more";
    double size = 0;
    for (std::size_t i = 0; i < n; ++i) {
        const Place side = corners[(i + 1) % n] - corners[i];
        if (side.x == 0 && side.y == 0)
            return fmt::format("has the corner [{}, {}] twice in a row: leave one out", corners[i].x, corners[i].y);
        size = std::max(size, std::hypot(side.x, side.y));
    }
    if (const auto at = crossing_of_sides(corners))
        return fmt::format(
            "crosses itself at [{:.6g}, {:.6g}]: give its corners in their order around it, each once, so that "
            "sides meet nowhere else",
            at->x, at->y);
    constexpr double rounding = 1e-12;
    const double area = area_of(corners);
    if (!(std::abs(area) > rounding * size * size)) return "has no area: give it corners that are not in one line";
    if (area < 0) std::reverse(corners.begin(), corners.end());
    return {};
}

/// Corners against the clock; none where they are those of no polygon, which is reported.
std::vector<Place> read_corners(LinkageReading& reading, Section& section, std::string_view key) {
    const toml::node* node = find(section, key);
    const std::string what = name_of(section, key);
    const toml::array* list = node->as_array();
    if (list == nullptr)
        return report_kind(*node, what, "a list of corners, [[x, y], ...]", reading.messages), std::vector<Place>{};
    if (list->size() > LinkageReading::most_corners) {
        add_error(reading.messages, place_of(*node),
                  fmt::format("{} has more than {} corners", what, LinkageReading::most_corners));
        return {};
    }
    std::vector<Place> corners;
    for (const toml::node& one : *list)
        if (const auto corner = to_pair(reading, one, "a corner of " + what)) corners.push_back(*corner);
    if (corners.size() < list->size()) return {};
    const std::string why = why_no_polygon(corners);
    if (why.empty()) return corners;
    add_error(reading.messages, place_of(*node), fmt::format("{} {}", what, why));
    return {};
}

void read_polygon(LinkageReading& reading, Section& section, LinkageRegion& region) {
    const toml::node* node = find(section, "polygon");
    const std::string what = name_of(section, "polygon");
    region.shape = Shape::polygon;
    region.places = read_corners(reading, section, "polygon");
    if (region.places.empty() || is_convex(region.places)) return;
    const auto pieces = region.inside ? convex_pieces_outside(region.places) : convex_pieces(region.places);
    if (!pieces)
        return add_error(reading.messages, place_of(*node),
                         fmt::format("{} has too many inward corners: write it as several polygons with fewer, each in "
                                     "a [[region]] of its own",
                                     what));
    region.pieces = *pieces;
}

void read_circular(LinkageReading& reading, Section& section, LinkageRegion& region) {
    region.shape = Shape::circle;
    std::optional<Section> circle = read_section(section, "circle", reading.messages);
    if (!circle) return;
    if (const auto centre = read_pair(reading, *circle, "centre")) region.places.push_back(*centre);
    if (const auto radius = read_number(*circle, "radius", reading.messages)) {
        region.radius = *radius;
        if (!(*radius > 0))
            add_error(reading.messages, place_of(*circle, "radius"),
                      fmt::format("{} must be greater than 0", name_of(*circle, "radius")));
    } else if (!has(*circle, "radius")) {
        add_error(reading.messages, circle->place, fmt::format("{} is missing", name_of(*circle, "radius")));
    }
    report_unknown_keys(*circle, reading.messages);
}

void read_half_plane(LinkageReading& reading, Section& section, LinkageRegion& region) {
    region.shape = Shape::half_plane;
    std::optional<Section> plane = read_section(section, "half-plane", reading.messages);
    if (!plane) return;
    if (const auto through = read_pair(reading, *plane, "through")) region.places.push_back(*through);
    if (const auto direction = read_number(*plane, "direction", reading.messages))
        region.direction = to_radians(reading.made.units, *direction);
    else if (!has(*plane, "direction"))
        add_error(reading.messages, plane->place,
                  fmt::format("{} is missing: the half-plane lies to the left of it", name_of(*plane, "direction")));
    report_unknown_keys(*plane, reading.messages);
}

/// Another link, with whose points no part has one in common: they always would touch there.
void read_moving(LinkageReading& reading, Section& section, LinkageRegion& region) {
    region.shape = Shape::link;
    if (region.inside)
        add_error(
            reading.messages, place_of(section, "keep"),
            fmt::format("{} has a 'link', which parts can keep out of only: write keep = \"out\"", section.title));
    std::optional<Section> moving = read_section(section, "link", reading.messages);
    if (!moving) return;
    const double width = read_number(*moving, "width", reading.messages).value_or(0);
    region.radius = 0.5 * width;
    if (width < 0)
        add_error(reading.messages, place_of(*moving, "width"),
                  fmt::format("{} must be 0 or more", name_of(*moving, "width")));
    const linkage::Structure& s = reading.made.structure;
    const auto link = read_link(reading, *moving, "name", true);
    report_unknown_keys(*moving, reading.messages);
    if (!link) return;
    const FilePlace place = place_of(*moving, "name");
    const std::string &name = reading.made.links[*link], what = name_of(*moving, "name");
    if (*link == 0 || is_circular(s, *link))
        return add_error(
            reading.messages, place,
            fmt::format("{}: '{}' has no outline: say its edge as a polygon, a circle or a half-plane", what, name));
    region.pins = pins_on(s, *link);
    if (region.pins.empty())
        return add_error(reading.messages, place,
                         fmt::format("{}: the link '{}' has no points: give it some where it reaches to", what, name));
    for (const auto& part : region.parts)
        for (const std::size_t pin : part)
            if (linkage::is_on(s.pins[pin], *link))
                return add_error(
                    reading.messages, place,
                    fmt::format("{}: '{}' has the point '{}' in common with what is to keep out of it: name others in "
                                "'of'",
                                what, name, reading.made.pins[pin]));
}

void read_region(LinkageReading& reading, Section& section) {
    LinkageRegion region;
    const auto name = read_own_name(reading, section, "NAME.margin");
    const auto keep = read_choice(section, "keep", "way to keep", reading.messages);
    if (!has(section, "keep"))
        add_error(reading.messages, section.place,
                  fmt::format("{} is missing: write keep = \"in\" or keep = \"out\"", name_of(section, "keep")));
    region.inside = keep.value_or(0) == 0;
    region.parts = read_parts(reading, section);
    region.margin = read_number(section, "margin", reading.messages).value_or(0);
    if (region.margin < 0)
        add_error(reading.messages, place_of(section, "margin"),
                  fmt::format("{} must be 0 or more", name_of(section, "margin")));
    constexpr std::array<std::string_view, 4> shapes{"polygon", "circle", "half-plane", "link"};
    const auto count = std::count_if(shapes.begin(), shapes.end(),
                                     [&](std::string_view key) { return find(section, key) != nullptr; });
    if (count != 1)
        add_error(reading.messages, section.place,
                  fmt::format("{} needs exactly one of {}", section.title, listed(shapes)));
    else if (has(section, "polygon"))
        read_polygon(reading, section, region);
    else if (has(section, "circle"))
        read_circular(reading, section, region);
    else if (has(section, "half-plane"))
        read_half_plane(reading, section, region);
    else
        read_moving(reading, section, region);
    report_unknown_keys(section, reading.messages);
    if (!name) return;
    region.name = *name;
    reading.made.regions.push_back(std::move(region));
}

/// An angle, or a word that says how the box is turned.
void read_direction(LinkageReading& reading, Section& section, LinkageRoom& room) {
    const toml::node* node = find(section, "direction");
    if (node == nullptr) return;
    if (node->is_number()) {
        room.direction = to_radians(reading.made.units,
                                    to_number(*node, name_of(section, "direction"), reading.messages).value_or(0));
        return;
    }
    const auto word = node->value_exact<std::string>();
    if (word == keys::turns_of_rooms[0])
        room.turn = LinkageRoom::Turn::least_width;
    else if (word == keys::turns_of_rooms[1])
        room.turn = LinkageRoom::Turn::least_area;
    else
        report_kind(*node, name_of(section, "direction"), "an angle, \"least-width\" or \"least-area\"",
                    reading.messages);
}

void read_room(LinkageReading& reading, Section& section) {
    LinkageRoom room;
    const auto name = read_own_name(reading, section, "NAME.width");
    for (const std::vector<std::size_t>& part : read_parts(reading, section))
        room.pins.insert(room.pins.end(), part.begin(), part.end());
    std::sort(room.pins.begin(), room.pins.end());
    room.pins.erase(std::unique(room.pins.begin(), room.pins.end()), room.pins.end());
    read_direction(reading, section, room);
    if (find(section, "screen") != nullptr) {
        room.screen = read_corners(reading, section, "screen");
        if (!has_blade(reading.made.structure, room) || room.turn != LinkageRoom::Turn::given)
            add_error(reading.messages, place_of(section, "screen"),
                      fmt::format("{} is swept by the line between two points, of which one moves at least: write of = "
                                  "[\"P\", \"Q\"] with these alone, and no direction in words",
                                  name_of(section, "screen")));
    }
    report_unknown_keys(section, reading.messages);
    if (!name) return;
    room.name = *name;
    reading.made.rooms.push_back(std::move(room));
}

}  // namespace

bool is_name_of_room(const Linkage& linkage, std::string_view name) {
    const auto is_it = [&](const auto& one) { return one.name == name; };
    return std::any_of(linkage.rooms.begin(), linkage.rooms.end(), is_it) ||
           std::any_of(linkage.regions.begin(), linkage.regions.end(), is_it);
}

void read_rooms(LinkageReading& reading) {
    for (Section& section : sections_in(reading, "room", keys::room))
        read_room(reading, section);
    for (Section& section : sections_in(reading, "region", keys::region))
        read_region(reading, section);
}

}  // namespace mechwright::reading
