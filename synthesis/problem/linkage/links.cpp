#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// The pin of a name, made where there is none yet.
std::size_t pin_of(LinkageReading& reading, std::string_view name, FilePlace place) {
    std::vector<std::string>& pins = reading.made.pins;
    const auto at = std::find(pins.begin(), pins.end(), name);
    if (at != pins.end()) return static_cast<std::size_t>(at - pins.begin());
    pins.emplace_back(name);
    reading.pin_places.push_back(place);
    reading.made.structure.pins.emplace_back();
    return pins.size() - 1;
}

/// What points a link has, for messages.
std::string pins_of(const LinkageReading& reading, std::size_t link) {
    std::vector<std::string_view> names;
    for (std::size_t i = 0; i < reading.made.pins.size(); ++i)
        if (linkage::is_on(reading.made.structure.pins[i], link)) names.push_back(reading.made.pins[i]);
    return names.empty() ? "it has no points" : "its points are " + listed(names);
}

/// A place on a link: a point of it by name, or coordinates.
std::optional<linkage::Coordinates> to_place(LinkageReading& reading, const toml::node& node, std::size_t link,
                                             std::string_view what) {
    const auto name = node.value_exact<std::string>();
    if (!name) return to_coordinates(reading, node, what);
    const auto pin = find_pin(reading, *name, place_of(node), what);
    if (!pin) return {};
    if (linkage::is_on(reading.made.structure.pins[*pin], link))
        return linkage::coordinates_on(reading.made.structure.pins[*pin], link);
    add_error(reading.messages, place_of(node),
              fmt::format("{}: '{}' is no point of the link '{}': {}", what, *name, reading.made.links[link],
                          pins_of(reading, link)));
    return {};
}

std::optional<linkage::Line> line_along(LinkageReading& reading, Section& section, std::size_t link) {
    const toml::node& node = *find(section, "along");
    const toml::array* list = node.as_array();
    const std::string what = name_of(section, "along");
    if (list == nullptr || list->size() != 2 || !list->get(0)->is_string() || !list->get(1)->is_string()) {
        add_error(
            reading.messages, place_of(node),
            fmt::format("{} must be two points of the link '{}', like [\"A\", \"D\"]", what, reading.made.links[link]));
        return {};
    }
    const auto from = to_place(reading, *list->get(0), link, what), to = to_place(reading, *list->get(1), link, what);
    if (!from || !to) return {};
    if (*list->get(0)->value<std::string>() == *list->get(1)->value<std::string>()) {
        add_error(reading.messages, place_of(node), fmt::format("{}: a line needs two points that differ", what));
        return {};
    }
    linkage::Line line;
    line.on = link;
    line.through = *from;
    line.towards = *to;
    return line;
}

/// `along`, or `point` and `direction`.
std::optional<linkage::Line> read_line(LinkageReading& reading, Section& section, std::size_t link) {
    const toml::node* point = find(section, "point");
    const toml::node* direction = find(section, "direction");
    if (find(section, "along") != nullptr) {
        if (point == nullptr && direction == nullptr) return line_along(reading, section, link);
        add_error(reading.messages, section.place,
                  fmt::format("{} has its line twice: leave out 'along', or 'point' and 'direction'", section.title));
        return {};
    }
    if (point == nullptr || direction == nullptr) {
        add_error(
            reading.messages, section.place,
            fmt::format("{} has no line: write along = [\"A\", \"B\"], or 'point' and 'direction'", section.title));
        return {};
    }
    const auto through = to_place(reading, *point, link, name_of(section, "point"));
    const auto angle = to_linkage_number(reading, *direction, name_of(section, "direction"), Measure::angle);
    if (!through || !angle) return {};
    linkage::Line line;
    line.on = link;
    line.through = *through;
    line.angle = add_number(reading, *angle);
    line.by_angle = true;
    return line;
}

void read_points(LinkageReading& reading, const toml::table& table, std::size_t link) {
    for (const auto& [name, node] : in_order(table)) {
        const Section section{&table, "", {}};
        const FilePlace place = key_place(section, name);
        if (!is_name(reading, name, place, "point")) continue;
        const auto at =
            to_coordinates(reading, *node, fmt::format("'{}' of the link '{}'", name, reading.made.links[link]));
        if (!at) continue;
        reading.made.structure.pins[pin_of(reading, name, place)].points.push_back({link, *at});
    }
}

/// A sum less another, if it is a number.
std::optional<double> difference_of(const Affine& a, const Affine& b) {
    std::map<std::size_t, double> terms;
    for (const auto& [dimension, factor] : a.terms)
        terms[dimension] += factor;
    for (const auto& [dimension, factor] : b.terms)
        terms[dimension] -= factor;
    if (std::any_of(terms.begin(), terms.end(), [](const auto& term) { return term.second != 0; })) return {};
    return a.constant - b.constant;
}

/// Where a circular slot ends, 'min' and 'max' being directions of its pin from the centre, as CircularSlot::ends.
/// Absent where they are none, which is reported.
std::optional<linkage::Slot> read_ends(LinkageReading& reading, Section& section, std::size_t pin,
                                       const linkage::Line& from_centre, const Affine& radius) {
    const linkage::Stops stops = read_stops(reading, section, Measure::angle);
    const auto fail = [&](const char* key, const char* why) -> std::optional<linkage::Slot> {
        add_error(reading.messages, place_of(section, key), fmt::format("{} {}", section.title, why));
        return {};
    };
    if (!has(section, "min") || !has(section, "max"))
        return fail(has(section, "min") ? "min" : "max",
                    "is circular and needs both ends, or none: give 'min' and 'max', directions from its centre");
    if (!stops.min || !stops.max) return {};
    const Affine least = reading.made.numbers[*stops.min].value;
    const auto arc = difference_of(reading.made.numbers[*stops.max].value, least);
    if (!arc)
        return fail("max",
                    "is circular, and its arc has to be a number: write 'max' as 'min' and so much, like min = "
                    "\"start\" and max = \"start + 40\"");
    const bool degrees = reading.made.units.degrees;
    if (!(*arc > 0 && *arc < (degrees ? 360 : 2 * std::numbers::pi)))
        return fail("max", "is circular: its arc from 'min' to 'max' is more than 0 and less than a full turn");
    const double half = *arc / 2, cosine = std::cos(degrees ? half * std::numbers::pi / 180 : half);
    LinkageNumber middle{least, Measure::angle}, reach{radius, Measure::length};
    middle.value.constant += half;
    reach.value.constant *= cosine;
    for (auto& [dimension, factor] : reach.value.terms)
        factor *= cosine;
    linkage::Slot ends{pin, from_centre, false, {}};
    ends.line.by_angle = true;
    ends.line.angle = add_number(reading, std::move(middle));
    ends.stops.min = add_number(reading, std::move(reach));
    return ends;
}

/// A circular slot is a link from its centre to the pin.
void read_circle(LinkageReading& reading, Section& section, std::size_t pin, std::size_t in) {
    Linkage& made = reading.made;
    const toml::node* centre = find(section, "centre");
    const toml::node* radius = find(section, "radius");
    for (const char* key : {"along", "point", "direction"})
        if (find(section, key) != nullptr)
            add_error(reading.messages, place_of(section, key),
                      fmt::format("{} is circular: leave '{}' out", section.title, key));
    if (centre == nullptr || radius == nullptr)
        return add_error(reading.messages, section.place,
                         fmt::format("{} is circular: it needs 'centre' and 'radius'", section.title));
    const auto at = to_place(reading, *centre, in, name_of(section, "centre"));
    const auto length = to_linkage_number(reading, *radius, name_of(section, "radius"), Measure::length);
    if (!at || !length) return;
    const std::string name = fmt::format("slot of {}", made.pins[pin]);
    const std::size_t link = made.structure.links++;
    made.links.push_back(name);
    reading.link_places.push_back(section.place);
    const linkage::Number zero = add_constant(reading, 0, Measure::length);
    const Affine radius_of_it = length->value;
    const linkage::Number reach = add_number(reading, *length);
    std::size_t middle = 0;
    if (const auto named = centre->value_exact<std::string>()) {
        middle = *find_pin(reading, *named, place_of(*centre), "");
    } else {
        middle = pin_of(reading, fmt::format("centre of the {}", name), section.place);
        made.structure.pins[middle].points.push_back({in, *at});
    }
    made.structure.pins[middle].points.push_back({link, {zero, zero}});
    made.structure.pins[pin].points.push_back({link, {reach, zero}});
    made.structure.circular.push_back({link, in, middle, pin, {}});
    if (has(section, "min") || has(section, "max"))
        made.structure.circular.back().ends = read_ends(reading, section, pin, {in, *at, {}, 0, false}, radius_of_it);
}

std::optional<std::size_t> read_pin(LinkageReading& reading, Section& section, std::string_view key) {
    const auto name = read_string(section, key, reading.messages);
    if (!name) {
        if (!has(section, key))
            add_error(reading.messages, section.place,
                      fmt::format("{} is missing: it names a point", name_of(section, key)));
        return {};
    }
    return find_pin(reading, *name, place_of(section, key), name_of(section, key));
}

}  // namespace

linkage::Stops read_stops(LinkageReading& reading, Section& section, Measure measure) {
    linkage::Stops stops;
    for (const auto& [key, stop] : {std::pair("min", &stops.min), std::pair("max", &stops.max)})
        if (const toml::node* node = find(section, key))
            if (auto number = to_linkage_number(reading, *node, name_of(section, key), measure))
                *stop = add_number(reading, std::move(*number));
    if (!stops.min || !stops.max) return stops;
    const Affine &least = reading.made.numbers[*stops.min].value, &greatest = reading.made.numbers[*stops.max].value;
    if (least.terms.empty() && greatest.terms.empty() && !(least.constant < greatest.constant))
        add_error(reading.messages, place_of(section, "min"),
                  fmt::format("'min' has to be less than 'max' in {}", section.title));
    return stops;
}

void read_links(LinkageReading& reading) {
    Linkage& made = reading.made;
    made.links = {"frame"};
    reading.link_places = {reading.file.place};
    std::optional<Section> section = read_section(reading.file, "links", reading.messages);
    if (!section) {
        if (!has(reading.file, "links"))
            add_error(reading.messages, reading.file.place,
                      "the section [links] is missing: a linkage is made of links with points, like crank = { A = [0, "
                      "0], B = [40, 0] }");
        return;
    }
    if (!section->table->contains("frame"))
        add_error(reading.messages, section->place,
                  "[links] has no 'frame': that is the link that does not move, like frame = { A = [0, 0] }");
    const auto links = in_order(*section->table);
    for (const auto& [name, node] : links) {
        const FilePlace place = key_place(*section, name);
        const toml::table* table = node->as_table();
        if (table == nullptr)
            report_kind(*node, fmt::format("the link '{}'", name), "a table of points, like { A = [0, 0] }",
                        reading.messages);
        if (name == "frame") {
            reading.link_places[0] = place;
        } else {
            if (!is_name(reading, name, place, "link")) continue;
            if (made.links.size() == LinkageReading::most_links)
                return add_error(reading.messages, place,
                                 fmt::format("more than {} links", LinkageReading::most_links));
            made.links.emplace_back(name);
            reading.link_places.push_back(place);
        }
    }
    made.structure.links = made.links.size();
    std::size_t points = 0;
    for (const auto& [name, node] : links) {
        const auto at = std::find(made.links.begin(), made.links.end(), name);
        const toml::table* table = node->as_table();
        if (table == nullptr || at == made.links.end()) continue;
        points += table->size();
        if (points > LinkageReading::most_points)
            return add_error(reading.messages, key_place(*section, name),
                             fmt::format("more than {} points", LinkageReading::most_points));
        read_points(reading, *table, static_cast<std::size_t>(at - made.links.begin()));
    }
    report_case_twins(reading, made.links, reading.link_places, "link");
    report_case_twins(reading, made.pins, reading.pin_places, "point");
}

void read_slides(LinkageReading& reading) {
    Linkage& made = reading.made;
    std::vector<FilePlace> places;
    for (Section& section : sections_in(reading, "slide", keys::slide)) {
        const auto link = read_link(reading, section, "link", true), on = read_link(reading, section, "on", true);
        const auto line = on ? read_line(reading, section, *on) : std::nullopt;
        if (!on)
            for (const char* key : {"along", "point", "direction"})
                find(section, key);
        linkage::Slide slide;
        slide.angle = read_structure_number(reading, section, "angle", Measure::angle);
        slide.offset = read_structure_number(reading, section, "offset", Measure::length);
        const std::string name = read_string(section, "name", reading.messages).value_or("");
        if (!name.empty() && is_name(reading, name, place_of(section, "name"), "slide") &&
            std::find(made.slides.begin(), made.slides.end(), name) != made.slides.end())
            add_error(reading.messages, place_of(section, "name"),
                      fmt::format("there is a slide '{}' already: give this one another name", name));
        slide.stops = read_stops(reading, section, Measure::length);
        report_unknown_keys(section, reading.messages);
        if (link && on && *link == *on)
            add_error(reading.messages, place_of(section, "on"),
                      fmt::format("'{}' cannot slide on itself: name another link", made.links[*link]));
        made.slides.push_back(name);
        slide.link = link.value_or(0);
        if (line) slide.line = *line;
        made.structure.slides.push_back(slide);
    }
}

void read_slots(LinkageReading& reading) {
    Linkage& made = reading.made;
    for (Section& section : sections_in(reading, "slot", keys::slot)) {
        const auto pin = read_pin(reading, section, "pin");
        const auto in = read_link(reading, section, "in", true);
        const bool circular = has(section, "centre") || has(section, "radius");
        for (const Key& key : keys::slot)
            find(section, key.name);
        report_unknown_keys(section, reading.messages);
        if (!pin || !in) continue;
        if (linkage::is_on(made.structure.pins[*pin], *in)) {
            add_error(reading.messages, place_of(section, "in"),
                      fmt::format("'{}' is a point of '{}' itself: a slot is in another link than its pin",
                                  made.pins[*pin], made.links[*in]));
            continue;
        }
        if (circular) {
            read_circle(reading, section, *pin, *in);
            continue;
        }
        const auto line = read_line(reading, section, *in);
        const linkage::Stops stops = read_stops(reading, section, Measure::length);
        if (!line) continue;
        made.structure.slots.push_back({*pin, *line, false, stops});
    }
}

}  // namespace mechwright::reading
