#include <fmt/format.h>

#include <algorithm>

#include "synthesis/problem/affine.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/text.h"
#include "synthesis/target/names.h"

namespace mechwright::reading {

namespace {

/// Dimensions and numbers of targets that one can be tied to.
std::vector<std::string_view> partners_of(const Mechanism& mechanism, const Dimension& dimension) {
    std::vector<std::string_view> names;
    for (const Dimension& d : whole_of(mechanism).dimensions)
        if (d.name != dimension.name && !d.of_segment && scales(d.kind) == scales(dimension.kind) &&
            (!d.of_target || find_dimension(mechanism, d.name) >= 0))
            names.push_back(d.name);
    return names;
}

std::string open_tie(std::string_view tied, std::string_view to, std::string_view why) {
    return fmt::format("'{}' is tied to '{}', which {}: tie it to a dimension that has a number or a range", tied, to,
                       why);
}

/// The index of what a tie names; or what is wrong with the name, which is called `what`.
std::optional<std::size_t> partner(const Mechanism& mechanism, const Dimension& dimension, std::string_view name,
                                   const std::string& what, std::string& fault) {
    const auto names = partners_of(mechanism, dimension);
    const int of = find_dimension(mechanism, name);
    if (std::find(names.begin(), names.end(), name) == names.end())
        fault = fmt::format("{} must be another dimension of the same kind: {}", what, listed(names));
    else if (of < 0)
        fault = open_tie(dimension.name, name, "is not given");
    return fault.empty() ? std::optional(static_cast<std::size_t>(of)) : std::nullopt;
}

/// { of = "coupler", times = 2, plus = 3 }; the other dimension need not have been read yet.
std::optional<Affine> read_multiple(const toml::node& node, const Dimension& dimension, const Mechanism& mechanism,
                                    Messages& messages) {
    Section section{node.as_table(), fmt::format("the tie of '{}'", dimension.name), place_of(node), keys::tie};
    const auto other = read_string(section, "of", messages);
    const double times = read_number(section, "times", messages).value_or(1);
    const double plus = read_number(section, "plus", messages).value_or(0);
    report_unknown_keys(section, messages);
    if (!other) return {};
    std::string fault;
    const auto of = partner(mechanism, dimension, *other, fmt::format("'of' in {}", section.title), fault);
    if (!of) {
        add_error(messages, place_of(section, "of"), fault);
        return {};
    }
    if (times == 0 || (dimension.kind == DimensionKind::length && times < 0 && plus <= 0)) {
        add_error(messages, place_of(section, "times"),
                  fmt::format("'times' in {} must be {}, not {}", section.title,
                              times == 0 ? "other than 0" : "greater than 0: it is a length", times));
        return {};
    }
    return Affine{plus, {{*of, times}}};
}

/// "2 coupler - crank + 3".
std::optional<Affine> read_sum(const toml::node& node, const Dimension& dimension, const Mechanism& mechanism,
                               Messages& messages) {
    ParsedAffine read = parse_affine(*node.value<std::string>(), [&](std::string_view name, std::string& fault) {
        return partner(mechanism, dimension, name, quoted(name), fault);
    });
    std::erase_if(read.value.terms, [](const auto& term) { return term.second == 0; });
    if (!read.fault.empty())
        add_error(messages, place_of(node), fmt::format("in '{}': {}", dimension.name, read.fault));
    else if (read.value.terms.empty())
        add_error(messages, place_of(node),
                  fmt::format("'{}' is a string that names no other dimension: write a number", dimension.name));
    else
        return std::move(read.value);
    return {};
}

/// Whether all that a tie names have numbers or ranges of their own.
bool is_closed(const std::vector<bool>& tied, std::size_t dimension, const Section& file, const Problem& problem,
               Messages& messages) {
    const auto& dimensions = problem.mechanism->dimensions;
    for (const auto& [other, times] : problem.dimensions[dimension].tie.terms) {
        if (!tied[other] && problem.dimensions[other].named) continue;
        add_error(messages, place_of_dimension(file, dimensions[dimension].name),
                  open_tie(dimensions[dimension].name, dimensions[other].name,
                           tied[other] ? "is tied itself" : "is not given"));
        return false;
    }
    return true;
}

/// The range of a tied dimension; what it is tied to and has a number counts as that.
void settle(DimensionRange& range, const std::vector<DimensionRange>& all) {
    Affine free{range.tie.constant, {}};
    for (const auto& [other, times] : range.tie.terms)
        if (all[other].fixed())
            free.constant += times * all[other].min;
        else
            free.terms.emplace_back(other, times);
    range.tie = free;
    range.min = range.max = free.constant;
    for (const auto& [other, times] : free.terms) {
        const auto [least, greatest] = std::minmax({times * all[other].min, times * all[other].max});
        range.min += least;
        range.max += greatest;
    }
}

}  // namespace

bool stands_in_dimensions(const Dimension& dimension) { return !dimension.of_segment && !dimension.of_target; }

FilePlace place_of_dimension(const Section& file, std::string_view name) {
    std::vector<std::string> paths{fmt::format("dimensions.{}", name)};
    if (const auto dash = name.rfind('-'); dash != std::string_view::npos) {
        const std::string_view scale = name.substr(0, dash), part = name.substr(dash + 1);
        paths.push_back(fmt::format("function.{}.{}", scale, part));
        for (const std::string_view followed : sections_of_shapes)
            paths.push_back(fmt::format("{}.{}", followed, part));
    }
    for (const std::string& path : paths)
        if (const toml::node* node = file.table->at_path(path).node()) return place_of(*node);
    return file.place;
}

std::optional<DimensionRange> to_dimension_or_tie(const toml::node& node, std::size_t index, const Mechanism& mechanism,
                                                  const Units& units, Messages& messages) {
    const Dimension& dimension = mechanism.dimensions[index];
    const bool multiple = node.is_table() && node.as_table()->contains("of");
    if (!multiple && !node.is_string()) return to_dimension(node, dimension, units, messages);
    const auto tie =
        multiple ? read_multiple(node, dimension, mechanism, messages) : read_sum(node, dimension, mechanism, messages);
    if (!tie) return {};
    DimensionRange tied;
    tied.named = true;
    tied.tie = *tie;
    if (dimension.kind == DimensionKind::angle) tied.tie.constant = to_radians(units, tie->constant);
    return tied;
}

void resolve_ties(const Section& file, Problem& problem, Messages& messages) {
    std::vector<bool> tied;
    for (const DimensionRange& range : problem.dimensions)
        tied.push_back(range.tied());
    for (std::size_t i = 0; i < tied.size(); ++i) {
        DimensionRange& range = problem.dimensions[i];
        if (!tied[i] || !is_closed(tied, i, file, problem, messages)) continue;
        settle(range, problem.dimensions);
        const Dimension& dimension = problem.mechanism->dimensions[i];
        const auto never = [&](std::string_view what) {
            add_error(messages, place_of_dimension(file, dimension.name),
                      fmt::format("'{}' is {} for all values of what it is tied to: change the tie or their ranges",
                                  dimension.name, what));
        };
        if (dimension.kind == DimensionKind::length && range.max <= 0) never("a length and not greater than 0");
        if (dimension.name.ends_with("-range") && dimension.of_target && range.min == 0 && range.max == 0) never("0");
    }
    // The search for paths eliminates dimensions one by one.
    if (const toml::node* path = file.table->get("path"); path != nullptr && problem.path && has_ties(problem))
        add_error(messages, place_of(*path),
                  "[path] does not go with dimensions that are tied to others: give them ranges of their own");
    if (!problem.path || !problem.mechanism->point) return;
    const std::size_t start = problem.mechanism->roles_of(0).start;
    if (start < problem.dimensions.size() && problem.dimensions[start].tied())
        add_error(
            messages, place_of_dimension(file, problem.mechanism->dimensions[start].name),
            "the crank angle from which targets are counted cannot be tied to others: give it a range of its own");
}

}  // namespace mechwright::reading
