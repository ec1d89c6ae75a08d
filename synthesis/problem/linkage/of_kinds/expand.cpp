#include "synthesis/problem/linkage/of_kinds/expand.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <numbers>

#include "synthesis/problem/linkage/of_kinds/expanding.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/study/study_sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/made_table.h"
#include "synthesis/problem/toml/toml_text.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace reading {

bool Expanding::is_of_target(std::size_t dimension) const {
    return problem.mechanism->plain && dimension >= problem.mechanism->plain->dimensions.size();
}

std::optional<double> Expanding::number_of_design(std::string_view name) const {
    if (put_in.design == nullptr || !put_in.design->is_object()) return {};
    const auto at = put_in.design->find(std::string(name));
    if (at == put_in.design->end() || !at->is_number()) return {};
    return at->get<double>();
}

std::optional<std::size_t> Expanding::assembly_of_design() const {
    if (put_in.design == nullptr || !put_in.design->is_object()) return {};
    const auto at = put_in.design->find("assembly");
    const auto& assemblies = problem.mechanism->assemblies;
    if (at == put_in.design->end() || !at->is_string()) return {};
    const auto found = std::find(assemblies.begin(), assemblies.end(), at->get<std::string>());
    if (found == assemblies.end()) return {};
    return static_cast<std::size_t>(found - assemblies.begin());
}

namespace {

/// The lines of comment with which a file begins.
std::string first_comment(std::string_view text) {
    std::size_t end = 0;
    while (text.substr(end).starts_with('#')) {
        const std::size_t line = text.find('\n', end);
        if (line == std::string_view::npos) return {};
        end = line + 1;
    }
    return std::string(text.substr(0, end));
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

/// The numbers that a file can have in [placement] instead.
bool is_of_placement(std::string_view name) {
    return std::any_of(keys::placement.begin(), keys::placement.end(),
                       [&](const Key& key) { return key.name == name; });
}

/// A range, or a number, of a dimension, with the design's number put in.
std::string dimension_text(const Expanding& e, const toml::node& node, std::string_view name) {
    const toml::table* range = node.as_table();
    const auto design = e.number_of_design(name);
    if (!design || range == nullptr || range->contains("of")) return value_text(node);
    if (!e.put_in.as_starts) return fmt::format("{}", *design);
    std::string values;
    for (const char* key : {"min", "max", "step", "round", "choices"})
        if (const toml::node* value = range->get(key)) values += fmt::format("{} = {}, ", key, value_text(*value));
    return fmt::format("{{ {}start = {} }}", values, *design);
}

/// A number of the placement: it can be a sum of dimensions, but not tied to one.
std::string placement_text(const Expanding& e, const toml::node& node, std::string_view name) {
    const toml::table* tie = node.as_table();
    if (tie == nullptr || !tie->contains("of")) return dimension_text(e, node, name);
    return fmt::format("\"{} {}\"", (*tie)["times"].value_or(1.0), (*tie)["of"].value_or(std::string()));
}

void write_head(Expanding& e, std::string_view text) {
    e.text = first_comment(text);
    e.text += fmt::format("# A {} as the linkage that it is.\nschema    = 1\n", e.problem.mechanism->name);
    if (const toml::node* title = e.table.get("title")) e.text += fmt::format("title     = {}\n", value_text(*title));
    e.text += "mechanism = \"linkage\"\n";
}

void write_keys(Expanding& e, const toml::table& section) {
    for (const auto& [key, node] : in_order(section))
        e.text += fmt::format("{} = {}\n", key_text(key), value_text(*node));
}

void write_section(Expanding& e, std::string_view name) {
    const toml::table* section = e.table[name].as_table();
    if (section == nullptr) return;
    e.text += fmt::format("\n[{}]\n", name);
    write_keys(e, *section);
}

/// Rooms or regions: their parts are those of the linkage.
void write_list(Expanding& e, std::string_view name) {
    const toml::array* list = e.table[name].as_array();
    if (list == nullptr) return;
    for (const toml::node& one : *list) {
        e.text += fmt::format("\n[[{}]]\n", name);
        write_keys(e, *one.as_table());
    }
}

void write_dimensions(Expanding& e) {
    const toml::table& section = *e.table["dimensions"].as_table();
    std::size_t longest = 0;
    for (const auto& [key, node] : section)
        longest = std::max(longest, key.str().size());
    std::string placement;
    e.text += "\n[dimensions]\n";
    for (const auto& [key, node] : in_order(section)) {
        const int index = find_dimension(*e.problem.mechanism, key);
        if (index < 0 || e.is_of_target(static_cast<std::size_t>(index))) continue;
        if (is_of_placement(key))
            placement += fmt::format("{} = {}\n", key, placement_text(e, *node, key));
        else
            e.text += fmt::format("{:<{}} = {}\n", key, longest, dimension_text(e, *node, key));
    }
    if (!placement.empty()) e.text += "\n[placement]\n" + placement;
}

/// The word for the side of the one dyad that can be closed on either.
std::string_view assembly_word(const Expanding& e) {
    const auto& words = e.as.assemblies;
    if (words.empty()) return {};
    if (const auto assembly = e.assembly_of_design()) return words[*assembly];
    return e.problem.assemblies.size() > 1 ? "either" : words[e.problem.assemblies.front()];
}

/// The sections of a kind; dimensions that are not given are 0.
template <class IsGiven>
std::string linkage_sections(const Mechanism& kind, std::string_view assembly, bool degrees, const IsGiven& is_given) {
    std::string sections(kind.as_linkage->sections);
    replace_all(sections, "@assembly@", assembly);
    replace_all(sections, "@square@", degrees ? "90" : fmt::format("{}", std::numbers::pi / 2));
    for (const Dimension& dimension : kind.dimensions)
        if (!is_given(dimension)) replace_all(sections, '"' + dimension.name + '"', "0");
    return sections;
}

void write_links(Expanding& e) {
    const toml::table& given = *e.table["dimensions"].as_table();
    e.text += '\n' + linkage_sections(*e.problem.mechanism, assembly_word(e), e.problem.units.degrees,
                                      [&](const Dimension& dimension) { return given.contains(dimension.name); });
    // The sections of a kind end with [signals].
    if (const toml::table* signals = e.table["signals"].as_table()) write_keys(e, *signals);
}

/// What all designs of the kind have in common, and no requirement of a linkage can say, must follow from the ranges.
void check_kind(Expanding& e) {
    const auto& families = e.problem.mechanism->families;
    for (const LinearCondition& condition : families.front().conditions) {
        const bool of_all = std::all_of(families.begin(), families.end(), [&](const Family& family) {
            return std::any_of(family.conditions.begin(), family.conditions.end(),
                               [&](const LinearCondition& c) { return c.name == condition.name; });
        });
        if (!of_all) continue;
        double least = 0;
        std::string names;
        for (std::size_t i = 0; i < condition.coefficients.size(); ++i) {
            const double by = condition.coefficients[i];
            if (by == 0) continue;
            const auto& name = e.problem.mechanism->dimensions[i].name;
            const DimensionRange& range = e.problem.dimensions[i];
            const auto design = e.put_in.as_starts ? std::nullopt : e.number_of_design(name);
            least += by * design.value_or(by > 0 ? range.min : range.max);
            names += (names.empty() ? "'" : " and '") + name + "'";
        }
        if (least < 0)
            add_error(
                e.messages, place_of(*e.table.get("dimensions")),
                fmt::format("{} has only designs of which {}; as a linkage it has others, too: let the ranges of {} "
                            "exclude them",
                            e.problem.mechanism->name, condition.name, names));
    }
}

void refuse_sections(Expanding& e) {
    const auto refuse = [&](std::string_view section, std::string_view why) {
        if (const toml::node* node = e.table.get(section))
            add_error(e.messages, place_of(*node), fmt::format("a linkage cannot carry [{}]: {}", section, why));
    };
    if (const toml::table* study = e.table["study"].as_table(); study == nullptr || !samples_pieces(*study))
        refuse("study", "its values are those of the file as it is: leave it out, and write it for the linkage");
    refuse("instant",
           "it asks for velocities at a crank angle that is designed; require signals at given ones, like "
           "\"rocker-angle.speed.at(60)\"");
    refuse_targets(e);
}

ExpandedProblem refusal(Messages&& messages) { return {{}, sorted(std::move(messages))}; }

/// Why a problem is not of a built-in kind that is a linkage.
std::optional<std::string> why_not_expandable(const Problem& problem) {
    if (is_described(*problem.mechanism)) return "this is a linkage already: its links stand in [links]";
    if (!problem.mechanism->as_linkage)
        return fmt::format("a {} is no linkage of links and joints: only those that are can be said as one",
                           problem.mechanism->name);
    return {};
}

/// What the linkage's own reader says of the text that was made.
void check_made(const std::string& text, const std::string& file, Messages& messages) {
    for (const Message& message : parse_problem(text, file).messages)
        if (!message.warning)
            add_error(messages, fmt::format("as a linkage, which would be no valid problem: {}", message.text));
}

}  // namespace

}  // namespace reading

namespace {

/// A kind whose dimensions are what text_of(index) says, in radians.
template <class TextOf>
std::string linkage_text(const Mechanism& kind, std::size_t assembly, const TextOf& text_of) {
    std::string own, placement;
    const std::size_t count = kind.plain ? kind.plain->dimensions.size() : kind.dimensions.size();
    for (std::size_t i = 0; i < count; ++i) {
        const std::string& name = kind.dimensions[i].name;
        (reading::is_of_placement(name) ? placement : own) += fmt::format("{} = {}\n", name, text_of(i));
    }
    const auto& words = kind.as_linkage->assemblies;
    return fmt::format("schema = 1\nmechanism = \"linkage\"\n[units]\nangle = \"rad\"\n[dimensions]\n{}{}{}{}", own,
                       placement.empty() ? "" : "[placement]\n", placement,
                       reading::linkage_sections(kind, words.empty() ? "" : words[assembly], false,
                                                 [](const Dimension&) { return true; }));
}

}  // namespace

std::string linkage_of_design(const Mechanism& kind, std::span<const double> dimensions, std::size_t assembly) {
    return linkage_text(kind, assembly, [&](std::size_t i) { return fmt::format("{}", dimensions[i]); });
}

std::string linkage_of_kind(const Mechanism& kind, std::size_t assembly) {
    return linkage_text(kind, assembly, [](std::size_t) { return "{ min = 1, max = 2 }"; });
}

ExpandedProblem expand_problem(std::string_view text, const std::string& file, const DesignPutIn& put_in) {
    using namespace reading;
    ReadProblem read = parse_problem(text, file);
    if (!read.ok()) return {{}, std::move(read.messages)};
    Messages messages{.file = file};
    const auto table = parse_toml(text, messages);
    if (!table) return refusal(std::move(messages));
    if (const auto why = why_not_expandable(read.problem)) {
        add_error(messages, place_of(*table->get("mechanism")), *why);
        return refusal(std::move(messages));
    }
    Expanding e{*table, read.problem, *read.problem.mechanism->as_linkage, put_in, messages};
    refuse_sections(e);
    check_kind(e);
    write_head(e, text);
    write_section(e, "units");
    write_dimensions(e);
    write_links(e);
    write_list(e, "room");
    write_list(e, "region");
    write_targets(e);
    write_section(e, "motion");
    write_asked(e);
    write_section(e, "solver");
    write_section(e, "study");
    if (!messages.failed) check_made(e.text, file, messages);
    if (messages.failed) return refusal(std::move(messages));
    return {std::move(e.text), {}};
}

}  // namespace mechwright
