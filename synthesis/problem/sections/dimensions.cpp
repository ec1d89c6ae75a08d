#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

constexpr std::string_view assembly_key = "assembly";
constexpr std::string_view any_assembly = "either";

/// A value that ought to be there; reported if it is not.
std::optional<double> required_number(Section& section, std::string_view key, Messages& messages) {
    if (!has(section, key))
        add_error(messages, section.place,
                  fmt::format("{} is missing: write {{ min = ..., max = ... }}", name_of(section, key)));
    return read_number(section, key, messages);
}

void check_range(const Section& range, const Dimension& dimension, const DimensionRange& read, Messages& messages) {
    const bool length = dimension.kind == DimensionKind::length;
    const FilePlace min = place_of(range, "min");
    if (read.min > read.max)
        return add_error(messages, min,
                         fmt::format("'min' {} is greater than 'max' {} in {}", read.min, read.max, range.title));
    if (length && read.min < 0)
        add_error(messages, min, fmt::format("'min' in {} must be 0 or greater, not {}", range.title, read.min));
    if (length && read.max <= 0)
        add_error(messages, place_of(range, "max"),
                  fmt::format("'max' in {} must be greater than 0, not {}", range.title, read.max));
    if (!read.start) return;
    if (*read.start < read.min || *read.start > read.max)
        add_error(messages, place_of(range, "start"),
                  fmt::format("'start' {} in {} must lie between 'min' {} and 'max' {}", *read.start, range.title,
                              read.min, read.max));
    else if (length && *read.start <= 0)
        add_error(messages, place_of(range, "start"), fmt::format("'start' in {} must be greater than 0", range.title));
}

std::optional<DimensionRange> read_range(const toml::node& node, const Dimension& dimension, Messages& messages) {
    Section range{node.as_table(), fmt::format("the range of '{}'", dimension.name), place_of(node),
                  keys::dimension_range};
    const auto min = required_number(range, "min", messages);
    const auto max = required_number(range, "max", messages);
    const auto start = read_number(range, "start", messages);
    report_unknown_keys(range, messages);
    if (!min || !max) return {};
    const DimensionRange read{*min, *max, start, true};
    check_range(range, dimension, read, messages);
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
    const auto range = node.is_table() ? read_range(node, dimension, messages) : read_fixed(node, dimension, messages);
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
