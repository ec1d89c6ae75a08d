#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <set>

#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/judged_motion.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/target/names.h"

namespace mechwright::reading {

namespace {

/// What all requirements on a quantity so far leave for it.
struct Bounds {
    double min = -std::numeric_limits<double>::infinity();
    double max = std::numeric_limits<double>::infinity();
    FilePlace last{0, 0};  ///< of the last requirement on it; 0:0: there is none
    bool equal = false;
};

/// A requirement in the file's units, and whether its values are all right.
struct Values {
    std::optional<double> equal;
    std::optional<double> min;
    std::optional<double> max;
    bool right = false;
};

bool check_values(const Section& section, const Values& values, Messages& messages) {
    const bool equal = has(section, "equal");
    const bool range = has(section, "min") || has(section, "max");
    if (equal && range)
        add_error(messages, place_of(section, "equal"),
                  "a requirement takes either 'equal', or 'min' and 'max', not both");
    else if (!equal && !range)
        add_error(messages, section.place, "a requirement needs a value: 'equal', or 'min' and/or 'max'");
    else if (values.min && values.max && *values.min > *values.max)
        add_error(messages, place_of(section, "min"),
                  fmt::format("no value can meet this: 'min' {} is greater than 'max' {}", *values.min, *values.max));
    else
        return equal == values.equal.has_value() && has(section, "min") == values.min.has_value() &&
               has(section, "max") == values.max.has_value();
    return false;
}

Values read_values(Section& section, Messages& messages) {
    Values values{.equal = read_number(section, "equal", messages),
                  .min = read_number(section, "min", messages),
                  .max = read_number(section, "max", messages)};
    values.right = check_values(section, values, messages);
    return values;
}

/// Narrows the bounds of a quantity; reports a requirement that contradicts earlier ones.
void narrow(Bounds& bounds, const Values& values, const Section& section, std::string_view quantity,
            Messages& messages) {
    const double min = values.equal.value_or(values.min.value_or(bounds.min));
    const double max = values.equal.value_or(values.max.value_or(bounds.max));
    const FilePlace earlier = bounds.last;
    bounds.min = std::max(bounds.min, min);
    bounds.max = std::min(bounds.max, max);
    bounds.equal |= min == max;
    bounds.last = section.place;
    if (bounds.min <= bounds.max) return;
    add_error(messages, section.place,
              fmt::format("no value of '{}' can meet both this and the requirement {}", quantity,
                          place_text(messages, earlier)));
    bounds = {};
}

std::optional<double> converted(const Units& units, Unit unit, const std::optional<double>& value) {
    return value && unit == Unit::angle ? to_radians(units, *value) : value;
}

std::optional<std::size_t> read_quantity(Section& section, const Section& file, const Problem& problem,
                                         Messages& messages) {
    const toml::node* node = find(section, "quantity");
    if (node != nullptr) return to_quantity(*node, name_of(section, "quantity"), file, problem, messages);
    add_error(messages, section.place, "a requirement needs a 'quantity'");
    return {};
}

void read_requirement(const toml::node& node, const Section& file, Problem& problem, std::vector<Bounds>& bounds,
                      Messages& messages) {
    if (!node.is_table()) return report_kind(node, "an entry of 'require'", "a section, headed [[require]]", messages);
    Section section{node.as_table(), "[[require]]", place_of(node), keys::requirement};
    const auto index = read_quantity(section, file, problem, messages);
    const Values values = read_values(section, messages);
    report_unknown_keys(section, messages);
    if (!index || !values.right) return;
    const Quantity& quantity = problem.mechanism->quantities[*index];
    narrow(bounds[*index], values, section, quantity.name, messages);
    problem.requirements.push_back({*index, converted(problem.units, quantity.unit, values.equal),
                                    converted(problem.units, quantity.unit, values.min),
                                    converted(problem.units, quantity.unit, values.max)});
}

/// In general position n equalities take n variables, of those that the quantities depend on. Path quantities are left
/// out: a path has variables of its own.
void compare_with_variables(const Problem& problem, const std::vector<Bounds>& bounds, FilePlace place,
                            Messages& messages) {
    std::size_t equalities = 0;
    std::set<std::size_t> variables;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        const Quantity& quantity = problem.mechanism->quantities[i];
        if (!bounds[i].equal || quantity.path != PathMeasure::none) continue;
        ++equalities;
        for (const std::size_t d : quantity.reads) {
            const DimensionRange& range = problem.dimensions[d];
            for (const auto& [other, times] : range.tie.terms)
                variables.insert(other);
            if (!range.fixed() && !range.tied()) variables.insert(d);
        }
    }
    if (equalities > variables.size() && !messages.failed)
        add_warning(messages, place,
                    fmt::format("{} quantities are required to equal a value, but only {} of the dimensions they "
                                "depend on are free: in general no design meets them all; give more dimensions a "
                                "range, or drop requirements",
                                equalities, variables.size()));
}

/// Whether a quantity is of the whole motion alone, and has no value over a part of it.
bool is_of_whole_alone(const Mechanism& mechanism, const Quantity& quantity) {
    if (!quantity.of_motion || quantity.whole) return false;
    const auto& moving = mechanism.input->quantities;
    const auto same =
        std::find_if(moving.begin(), moving.end(), [&](const Quantity& one) { return one.name == quantity.name; });
    Motion over;
    over.is_range_of_use = true;
    return same == moving.end() || !is_defined(*same, over);
}

/// Why there is no NAME.whole beside a quantity that there is.
std::string why_not_whole(const Problem& problem, std::size_t quantity) {
    const Quantity& q = problem.mechanism->quantities[quantity];
    if (!q.of_motion)
        return fmt::format("'{0}' is the same over any part of the motion: write '{0}' without '{1}'", q.name,
                           whole_suffix);
    return fmt::format(
        "'{0}{1}' has no value here, where no part of a greater motion is judged: write '{0}', or give "
        "the motion a range of use, from = \"first-target\" and to = \"last-target\" in [motion]",
        q.name, whole_suffix);
}

}  // namespace

std::optional<std::size_t> to_quantity(const toml::node& node, std::string_view what, const Section& file,
                                       const Problem& problem, Messages& messages) {
    // What is no quantity of a signal, room or region has been told with these.
    if (problem.mechanism == nullptr || has_error_at(messages, place_of(node))) return {};
    const auto& quantities = whole_of(*problem.mechanism).quantities;
    std::vector<std::string_view> names;
    for (const Quantity& quantity : quantities)
        names.push_back(quantity.name);
    if (const auto named = node.value<std::string_view>(); named && without_whole(*named) != *named) {
        const int whole = find_quantity(*problem.mechanism, *named);
        if (whole >= 0) return static_cast<std::size_t>(whole);
        const int plain = find_quantity(*problem.mechanism, without_whole(*named));
        if (plain >= 0)
            return add_error(messages, place_of(node), why_not_whole(problem, static_cast<std::size_t>(plain))),
                   std::nullopt;
    }
    const auto index = to_choice(node, what, "quantity", names, messages);
    if (!index) return {};
    const int own = find_quantity(*problem.mechanism, quantities[*index].name);
    if (problem.use && own >= 0 &&
        is_of_whole_alone(*problem.mechanism, problem.mechanism->quantities[static_cast<std::size_t>(own)]))
        return add_error(
                   messages, place_of(node),
                   fmt::format("'{0}' is of the whole motion, and has no value over the range of use in [motion]: "
                               "write '{0}{1}'",
                               names[*index], whole_suffix)),
               std::nullopt;
    const std::string& section = quantities[*index].section;
    if (section.empty() || has(file, section)) return static_cast<std::size_t>(own);
    add_error(messages, place_of(node),
              fmt::format("'{}' has no value here: there is no [{}] section", names[*index], section));
    return {};
}

void read_requirements(Section& file, Problem& problem, Messages& messages) {
    const toml::node* node = find(file, "require");
    if (node == nullptr) return;
    if (!node->is_array())
        return report_kind(*node, "'require'", "a list of sections, each headed [[require]] in double brackets",
                           messages);
    const std::size_t count = problem.mechanism == nullptr ? 0 : problem.mechanism->quantities.size();
    std::vector<Bounds> bounds(count);
    for (const toml::node& entry : *node->as_array())
        read_requirement(entry, file, problem, bounds, messages);
    if (problem.mechanism != nullptr) compare_with_variables(problem, bounds, place_of(*node), messages);
}

namespace {

/// Quantities that a problem requires or optimises.
std::set<std::size_t> asked_quantities(const Problem& problem) {
    std::set<std::size_t> asked;
    for (const Requirement& requirement : problem.requirements)
        asked.insert(requirement.quantity);
    if (problem.objective)
        for (const ObjectiveTerm& term : problem.objective->terms)
            asked.insert(term.quantity);
    return asked;
}

/// Whether a quantity has a value in any kind of motion that designs may have.
bool has_value_anywhere(const Problem& problem, std::size_t index) {
    const Quantity& quantity = problem.mechanism->quantities[index];
    if (quantity.whole || !quantity.section.empty()) return true;
    for (std::size_t family = 0; family < problem.mechanism->families.size(); ++family)
        if (may_have_family(problem, family) && has_value(problem, index, motion_of(problem, family, 0))) return true;
    return false;
}

}  // namespace

void check_quantities_over_range(const Section& file, const Problem& problem, Messages& messages) {
    if (problem.mechanism == nullptr) return;
    const toml::table* motion = (*file.table)["motion"].as_table();
    const toml::node* range = motion == nullptr ? nullptr : motion->get("crank_range");
    std::string over = "crank_range: leave that out, or do not ask for it";
    if (range != nullptr) {
        // A range that falls has been told, and a cam that is wrong has no model to ask.
        const bool risen = problem.crank_range && problem.crank_range->x < problem.crank_range->y;
        if (!risen || std::ranges::all_of(problem.mechanism->families, &Family::full_turn)) return;
    } else {
        // What is wrong with a target leaves nothing to ask.
        if (messages.failed || !moves_over_targets(problem) || problem.use) return;
        const auto there = std::ranges::find_if(sections_over_input, [&](auto name) { return has(file, name); });
        if (there == sections_over_input.end()) return;
        const std::string_view section = *there;
        range = file.table->get(section);
        over = fmt::format("the input range of [{}], which is the motion here: do not ask for it{}", section,
                           section == "function" ? "" : ", or write full_turn = true there");
    }
    for (const std::size_t index : asked_quantities(problem))
        if (!has_value_anywhere(problem, index))
            add_error(messages, place_of(*range),
                      fmt::format("'{}' is of a full turn of the crank, and has no value over {}",
                                  problem.mechanism->quantities[index].name, over));
}

}  // namespace mechwright::reading
