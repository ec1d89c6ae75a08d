#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "synthesis/problem/linkage/reading.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

constexpr std::array<std::string_view, 10> reserved{
    "assembly",     "kind",       "scale",           "tilt", "origin-x", "origin-y", "transmission-angle-worst",
    "total-length", "link-ratio", "full-turn-margin"};

/// { of = "coupler", times = 2 }, as other mechanisms have it.
std::optional<Affine> read_tie(LinkageReading& reading, const toml::table& table, const std::string& name) {
    Section tie{&table, fmt::format("the tie of '{}'", name), place_of(table), keys::tie};
    const auto of = read_string(tie, "of", reading.messages);
    const double times = read_number(tie, "times", reading.messages).value_or(1);
    report_unknown_keys(tie, reading.messages);
    if (!of) return {};
    const auto whole = to_linkage_number(reading, *table.get("of"), name_of(tie, "of"), Measure::unknown);
    if (!whole) return {};
    Affine value;
    add(value, whole->value, times);
    return value;
}

void read_value(LinkageReading& reading, const toml::node& node, std::size_t index) {
    LinkageDimension& dimension = reading.made.dimensions[index];
    const std::string what = fmt::format("dimension '{}'", dimension.name);
    std::optional<Affine> tie;
    if (const toml::table* table = node.as_table()) {
        if (!table->contains("of")) {
            read_linkage_range(reading, *table, dimension);
            return;
        }
        tie = read_tie(reading, *table, dimension.name);
    } else if (node.is_number()) {
        if (const auto number = to_number(node, what, reading.messages)) dimension.min = dimension.max = *number;
        return;
    } else if (node.is_string()) {
        if (const auto number = to_linkage_number(reading, node, what, Measure::unknown)) tie = number->value;
    } else {
        report_kind(node, what, "a number, a range { min = ..., max = ... } or a sum of other dimensions",
                    reading.messages);
    }
    if (!tie) return;
    reading.ties[index] = *tie;
    dimension.tied = *tie;
}

/// Ties of ties as sums of what is not tied, and circles among them.
struct Expansion {
    LinkageReading& reading;
    std::vector<Affine> done;
    std::vector<int> state;  ///< 0: not yet, 1: being expanded, 2: expanded

    const Affine& of(std::size_t index) {
        LinkageDimension& dimension = reading.made.dimensions[index];
        if (state[index] == 2) return done[index];
        if (state[index] == 1) {
            if (dimension.tied)
                add_error(
                    reading.messages, reading.dimension_places[index],
                    fmt::format("'{}' is tied to itself in a circle: give one dimension of it a number or a range",
                                dimension.name));
            dimension.tied.reset();
            return done[index];
        }
        state[index] = 1;
        Affine whole;
        if (dimension.tied) {
            whole.constant = reading.ties[index].constant;
            for (const auto& [other, factor] : reading.ties[index].terms)
                add(whole, of(other), factor);
        } else {
            whole.terms.push_back({index, 1});
        }
        state[index] = 2;
        return done[index] = std::move(whole);
    }
};

}  // namespace

bool read_linkage_range(LinkageReading& reading, const toml::table& table, LinkageDimension& dimension) {
    const auto range = to_range(table, dimension.name, reading.messages);
    if (!range) return false;
    dimension.min = range->min;
    dimension.max = range->max;
    dimension.start = range->start;
    dimension.choices = range->choices;
    dimension.step = range->step;
    return true;
}

void read_linkage_dimensions(LinkageReading& reading) {
    std::optional<Section> section = read_section(reading.file, "dimensions", reading.messages);
    if (!section) return;
    std::vector<const toml::node*> nodes;
    for (const auto& [key, node] : in_order(*section->table)) {
        const FilePlace place = key_place(*section, key);
        if (std::find(reserved.begin(), reserved.end(), key) != reserved.end()) {
            add_error(reading.messages, place,
                      fmt::format("'{}' cannot be the name of a dimension: it means something else; for sides write "
                                  "[assembly], for scale, tilt and origin [placement]",
                                  key));
            continue;
        }
        if (!is_name(reading, key, place, "dimension")) continue;
        reading.made.dimensions.emplace_back().name = key;
        reading.dimension_places.push_back(place);
        nodes.push_back(node);
    }
    const std::size_t count = nodes.size();
    reading.uses.resize(count);
    reading.ties.resize(count);
    for (std::size_t i = 0; i < count; ++i)
        read_value(reading, *nodes[i], i);
    Expansion expansion{reading, std::vector<Affine>(count), std::vector<int>(count, 0)};
    for (std::size_t i = 0; i < count; ++i)
        expansion.of(i);
    reading.expanded = std::move(expansion.done);
    for (std::size_t i = 0; i < count; ++i)
        if (reading.made.dimensions[i].tied) reading.made.dimensions[i].tied = reading.expanded[i];
    std::vector<std::string> names;
    for (const LinkageDimension& dimension : reading.made.dimensions)
        names.push_back(dimension.name);
    report_case_twins(reading, names, reading.dimension_places, "dimension");
}

void conclude_dimensions(LinkageReading& reading, bool all_named) {
    std::vector<LinkageDimension>& dimensions = reading.made.dimensions;
    std::vector<bool> passed_on(dimensions.size(), false);
    for (std::size_t round = 0; round < dimensions.size(); ++round)
        for (std::size_t i = 0; i < dimensions.size(); ++i) {
            if (dimensions[i].measure == Measure::unknown || passed_on[i]) continue;
            passed_on[i] = true;
            for (const auto& [other, factor] : reading.ties[i].terms)
                use(reading, other, dimensions[i].measure, reading.dimension_places[i]);
        }
    if (!all_named) return;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (dimensions[i].measure == Measure::unknown)
            add_error(reading.messages, reading.dimension_places[i],
                      fmt::format("nothing uses the dimension '{}': name it where it stands for a number, or leave it "
                                  "out",
                                  dimensions[i].name));
}

}  // namespace mechwright::reading
