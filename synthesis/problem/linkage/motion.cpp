#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"

namespace mechwright::reading {

namespace {

double input(const LinkageReading& reading, double value) {
    const auto& drives = reading.made.structure.drives;
    const bool angle = drives.empty() || !drives.front().of_slide;
    return angle && reading.made.units.degrees ? value * std::numbers::pi / 180 : value;
}

}  // namespace

void read_linkage_motion(LinkageReading& reading) {
    std::optional<Section> section = read_section(reading.file, "motion", reading.messages);
    if (!section) return;
    if (const auto at = read_number(*section, "at", reading.messages))
        reading.made.at = reading.made.motion_at = input(reading, *at);
    if (const auto range = read_numbers(*section, "crank_range", reading.messages)) {
        if (range->size() != 2 || !((*range)[0] < (*range)[1]))
            add_error(
                reading.messages, place_of(*section, "crank_range"),
                "crank_range must be two inputs that rise, like [0, 120]: crank angles, or displacements of a driven "
                "slide");
        else
            reading.made.crank_range = {input(reading, (*range)[0]), input(reading, (*range)[1])};
        if (reading.made.crank_range && !reading.made.at) reading.made.at = reading.made.crank_range->x;
    }
    accept_range_of_use(*section);
    report_unknown_keys(*section, reading.messages);
}

void read_sketch(LinkageReading& reading) {
    std::optional<Section> section = read_section(reading.file, "sketch", reading.messages);
    if (!section) return;
    if (!has(*section, "crank"))
        add_error(reading.messages, section->place, "'crank' in [sketch] is missing: the input at which it is drawn");
    LinkageSketch sketch;
    if (const auto crank = read_number(*section, "crank", reading.messages)) {
        sketch.input = input(reading, *crank);
        if (!reading.made.at) reading.made.at = sketch.input;
    }
    std::optional<Section> points = read_section(*section, "points", reading.messages);
    report_unknown_keys(*section, reading.messages);
    if (!points) return;
    for (const auto& [name, node] : in_order(*points->table)) {
        const auto pin = find_pin(reading, name, key_place(*points, name), "[sketch]");
        const toml::array* place = node->as_array();
        if (place == nullptr || place->size() != 2 || !place->get(0)->is_number() || !place->get(1)->is_number())
            add_error(reading.messages, place_of(*node),
                      fmt::format("'{}' in [sketch] must be two numbers [x, y] in the frame's axes", name));
        else if (pin)
            sketch.points.emplace_back(
                *pin, Vector<double>{*place->get(0)->value<double>(), *place->get(1)->value<double>()});
    }
    reading.made.sketch = std::move(sketch);
}

void read_placement(LinkageReading& reading) {
    auto& placement = reading.made.placement;
    for (std::size_t i = 0; i < placement.size(); ++i)
        placement[i].range.name = keys::placement[i].name;
    placement[3].range.min = placement[3].range.max = 1;
    std::optional<Section> section = read_section(reading.file, "placement", reading.messages);
    if (!section) return;
    reading.made.scaled = has(*section, "scale");
    for (std::size_t i = 0; i < placement.size(); ++i) {
        const Key& key = keys::placement[i];
        LinkageAnchor& anchor = placement[i];
        const toml::node* node = find(*section, key.name);
        if (node == nullptr) continue;
        const Measure measure = key.name == "tilt"    ? Measure::angle
                                : key.name == "scale" ? Measure::ratio
                                                      : Measure::length;
        const auto value_at = [&](const toml::node& at) {
            const auto number = to_linkage_number(reading, at, name_of(*section, key.name), measure);
            if (number && key.name == "scale" && number->value.terms.empty() && !(number->value.constant > 0))
                add_error(reading.messages, place_of(at), "'scale' in [placement] must be greater than 0");
            if (number && number->value.terms.empty())
                anchor.range.min = anchor.range.max = number->value.constant;
            else if (number)
                anchor.sum = number->value;
        };
        const toml::table* range = node->as_table();
        if (range == nullptr) {
            value_at(*node);
            continue;
        }
        if (read_linkage_range(reading, *range, anchor.range) && key.name == "scale" && !(anchor.range.min > 0))
            add_error(reading.messages, place_of(*node), "'scale' in [placement] must be greater than 0");
    }
    report_unknown_keys(*section, reading.messages);
}

}  // namespace mechwright::reading
