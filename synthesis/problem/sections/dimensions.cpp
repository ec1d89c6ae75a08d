#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

constexpr std::string_view assembly_key = "assembly";
constexpr std::string_view any_assembly = "either";

void check_length(const toml::table& table, std::string_view name, const DimensionRange& read, Messages& messages) {
    const auto fault = [&](const char* key, std::string_view why) {
        const toml::node* node = table.get(read.choices.empty() && table.contains(key) ? key : "choices");
        add_error(messages, node == nullptr ? place_of(table) : place_of(*node),
                  fmt::format("{} in the range of '{}' must be {}",
                              node == table.get(key) ? quoted(key) : "each choice", name, why));
    };
    if (read.discrete() && read.min <= 0)
        fault("min", fmt::format("greater than 0, not {}", read.min));
    else if (read.min < 0)
        fault("min", fmt::format("0 or greater, not {}", read.min));
    if (read.max <= 0) fault("max", fmt::format("greater than 0, not {}", read.max));
    if (read.start && *read.start <= 0) fault("start", "greater than 0");
}

std::optional<DimensionRange> read_range(const toml::table& table, const Dimension& dimension, Messages& messages) {
    const auto read = to_range(table, dimension.name, messages);
    if (read && dimension.kind == DimensionKind::length) check_length(table, dimension.name, *read, messages);
    return read;
}

std::optional<DimensionRange> read_fixed(const toml::node& node, const Dimension& dimension, Messages& messages) {
    if (!node.is_number()) {
        report_kind(node, fmt::format("'{}'", dimension.name), "a number or a range { min = ..., max = ... }",
                    messages);
        return {};
    }
    const auto number = to_number(node, fmt::format("'{}'", dimension.name), messages);
    if (!number) return {};
    if (dimension.kind == DimensionKind::length && *number <= 0)
        add_error(messages, place_of(node),
                  fmt::format("'{}' is a length and must be greater than 0, not {}", dimension.name, *number));
    return DimensionRange{*number, *number, {}, true};
}

DimensionRange in_radians(const Units& units, const DimensionRange& range) {
    DimensionRange converted = range;
    converted.min = to_radians(units, range.min);
    converted.max = to_radians(units, range.max);
    if (range.start) converted.start = to_radians(units, *range.start);
    for (double& choice : converted.choices)
        choice = to_radians(units, choice);
    converted.step = to_radians(units, range.step);
    return converted;
}

DimensionRange read_dimension(Section& section, std::size_t index, const Mechanism& mechanism, const Units& units,
                              Messages& messages) {
    const Dimension& dimension = mechanism.dimensions[index];
    const toml::node* node = find(section, dimension.name);
    if (node == nullptr) {
        if (dimension.required)
            add_error(messages, section.place,
                      fmt::format("dimension '{}' ({}) is missing: give a number, or {{ min = ..., max = ... }}",
                                  dimension.name, dimension.meaning));
        return {};
    }
    return to_dimension_or_tie(*node, index, mechanism, units, messages).value_or(DimensionRange{});
}

std::vector<std::size_t> read_assemblies(Section& section, const Mechanism& mechanism, Messages& messages) {
    if (mechanism.assemblies.size() < 2) return {0};
    std::vector<std::string_view> names(mechanism.assemblies.begin(), mechanism.assemblies.end());
    names.push_back(any_assembly);
    const auto chosen = read_choice(section, assembly_key, "assembly", names, messages);
    if (chosen != mechanism.assemblies.size()) return {chosen.value_or(0)};
    std::vector<std::size_t> all(mechanism.assemblies.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        all[i] = i;
    return all;
}

/// Ranges in which no design of the mechanism lies.
void report_objection(const Section& file, const Problem& problem, Messages& messages) {
    if (problem.mechanism->objection == nullptr) return;
    std::vector<double> least, greatest;
    for (const DimensionRange& range : problem.dimensions) {
        least.push_back(range.min);
        greatest.push_back(range.max);
    }
    if (const auto objection = problem.mechanism->objection(least, greatest))
        add_error(messages, place_of_dimension(file, problem.mechanism->dimensions[objection->dimension].name),
                  objection->why);
}

/// "'a', 'b'" of the dimensions that a file must give.
std::string required_names(const Mechanism& mechanism) {
    std::vector<std::string_view> names;
    for (const Dimension& dimension : mechanism.dimensions)
        if (dimension.required) names.push_back(dimension.name);
    return listed(names);
}

}  // namespace

std::optional<DimensionRange> to_dimension(const toml::node& node, const Dimension& dimension, const Units& units,
                                           Messages& messages) {
    const auto range =
        node.is_table() ? read_range(*node.as_table(), dimension, messages) : read_fixed(node, dimension, messages);
    return range && dimension.kind == DimensionKind::angle ? in_radians(units, *range) : range;
}

void read_dimensions(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, "dimensions", messages);
    if (problem.mechanism == nullptr) return;
    const Mechanism& mechanism = *problem.mechanism;
    problem.dimensions.resize(mechanism.dimensions.size());
    problem.assemblies = {0};
    if (!section) {
        if (!has(file, "dimensions"))
            add_error(messages, file.place,
                      fmt::format("the section [dimensions] is missing: a {} needs {}", mechanism.name,
                                  required_names(mechanism)));
        return;
    }
    const std::size_t messages_before = messages.entries.size();
    for (const Dimension& dimension : whole_of(mechanism).dimensions)  // messages know all that could stand here
        if (stands_in_dimensions(dimension)) find(*section, dimension.name);
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i)
        if (stands_in_dimensions(mechanism.dimensions[i]))
            problem.dimensions[i] = read_dimension(*section, i, mechanism, problem.units, messages);
    if (messages.entries.size() == messages_before && !has_ties(problem)) report_objection(file, problem, messages);
    problem.assemblies = read_assemblies(*section, mechanism, messages);
    report_unknown_keys(*section, messages);
}

void conclude_dimensions(const Section& file, Problem& problem, Messages& messages) {
    if (problem.mechanism == nullptr || !has_ties(problem)) return;
    resolve_ties(file, problem, messages);
    if (!messages.failed) report_objection(file, problem, messages);
}

}  // namespace mechwright::reading
