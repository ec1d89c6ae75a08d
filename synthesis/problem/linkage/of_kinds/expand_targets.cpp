// Targets of a built-in kind, as those of the linkage that it is.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>

#include "synthesis/problem/linkage/of_kinds/expanding.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/problem/units.h"
#include "synthesis/target/names.h"

namespace mechwright::reading {

namespace {

/// The key of a target's number in its section: "line-angle" is 'angle', "input-start" of a stretch is 'start'.
std::string_view key_of_number(std::string_view section, std::string_view name) {
    if (name == "arc-x") return "centre-x";
    if (name == "arc-y") return "centre-y";
    for (const std::string_view before : {section, std::string_view("input")})
        if (name.starts_with(before) && name.substr(before.size()).starts_with('-'))
            return name.substr(before.size() + 1);
    return name;
}

/// Whether a number of targets is one of this one: a mechanism's that has several has the numbers of those asked for.
bool is_of(std::string_view section, std::string_view name) {
    if (section == "path") return name == "crank-start";
    if (section == "poses") return name == "crank-start" || name == "body-angle";
    return name.starts_with(section) || name.starts_with("input-");
}

/// A number of a target: as the file says it, with the design's number put in; empty where it says nothing.
std::string number_of_target_text(const Expanding& e, const toml::node* node, std::size_t dimension) {
    const std::string& name = e.problem.mechanism->dimensions[dimension].name;
    const DimensionRange& range = e.problem.dimensions[dimension];
    const auto design = e.number_of_design(name);
    if (!design || range.fixed()) return node == nullptr ? "" : value_text(*node);
    if (!e.put_in.as_starts) return fmt::format("{}", *design);
    const Unit unit = unit_of(e.problem.mechanism->dimensions[dimension].kind);
    const auto in_file = [&](double value) { return in_file_unit(value, unit, e.problem.units); };
    std::string values = fmt::format("min = {}, max = {}", in_file(range.min), in_file(range.max));
    if (range.step > 0) values += fmt::format(", step = {}", in_file(range.step));
    if (!range.choices.empty()) {
        std::vector<double> choices;
        for (const double choice : range.choices)
            choices.push_back(in_file(choice));
        values = fmt::format("choices = [{}]", fmt::join(choices, ", "));
    }
    return fmt::format("{{ {}, start = {} }}", values, *design);
}

/// Start and range of a function's input or output, as [function] or [dimensions] says them.
std::string scale_text(const Expanding& e, const toml::table& section, std::string_view scale) {
    const toml::table& dimensions = *e.table["dimensions"].as_table();
    const auto& all = e.problem.mechanism->dimensions;
    std::string text;
    for (const std::string_view key : {"start", "range"}) {
        const std::string name = fmt::format("{}-{}", scale, key);
        const auto at = std::find_if(all.begin(), all.end(), [&](const Dimension& d) { return d.name == name; });
        const toml::node* said = section[scale][key].node();
        const std::string number = number_of_target_text(e, said != nullptr ? said : dimensions.get(name),
                                                         static_cast<std::size_t>(at - all.begin()));
        if (!number.empty()) text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", key, number);
    }
    return text.empty() ? "" : fmt::format("{} = {{ {} }}\n", scale, text);
}

void write_function(Expanding& e, const AsLinkage::Target& target) {
    const toml::table& section = *e.table[target.section].as_table();
    e.text += fmt::format("\n[{}]\n{}", target.section, target.names);
    for (const auto& [key, node] : in_order(section))
        if (key != "input" && key != "output") e.text += fmt::format("{} = {}\n", key, value_text(*node));
    for (const std::string_view scale : {"input", "output"})
        e.text += scale_text(e, section, scale);
}

void write_target(Expanding& e, const AsLinkage::Target& target) {
    if (target.section == "function") return write_function(e, target);
    const toml::table& section = *only_table(e.table, target.section);
    const toml::table& dimensions = *e.table["dimensions"].as_table();
    const auto& all = e.problem.mechanism->dimensions;
    e.text += fmt::format("\n[{}]\n{}", target.section, target.names);
    const auto number_of = [&](std::string_view key) {
        for (std::size_t i = 0; i < all.size(); ++i)
            if (e.is_of_target(i) && is_of(target.section, all[i].name) &&
                key_of_number(target.section, all[i].name) == key)
                return std::optional(i);
        return std::optional<std::size_t>();
    };
    for (const auto& [key, node] : in_order(section)) {
        const auto number = number_of(key);
        e.text += fmt::format("{} = {}\n", key, number ? number_of_target_text(e, node, *number) : value_text(*node));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        const std::string_view key = key_of_number(target.section, all[i].name);
        if (!e.is_of_target(i) || !is_of(target.section, all[i].name) || section.contains(key)) continue;
        const std::string number = number_of_target_text(e, dimensions.get(all[i].name), i);
        if (!number.empty()) e.text += fmt::format("{} = {}\n", key, number);
    }
}

const AsLinkage::Target* find_carried_target(const Expanding& e, std::string_view section) {
    const auto at = std::find_if(e.as.targets.begin(), e.as.targets.end(),
                                 [&](const AsLinkage::Target& target) { return target.section == section; });
    return at == e.as.targets.end() ? nullptr : &*at;
}

}  // namespace

void refuse_targets(Expanding& e) {
    for (const std::string_view kind : repeated_sections)
        if (const toml::node* node = e.table.get(kind); node != nullptr && find_carried_target(e, kind) == nullptr)
            add_error(e.messages, place_of(*node),
                      fmt::format("[{0}] is not carried over: write [{0}] with the signal that it is of, like signal = "
                                  "\"rocker-angle\", by hand",
                                  kind));
}

void write_targets(Expanding& e) {
    for (const std::string_view kind : repeated_sections)
        if (const AsLinkage::Target* target = find_carried_target(e, kind); target != nullptr && e.table.contains(kind))
            write_target(e, *target);
}

}  // namespace mechwright::reading
