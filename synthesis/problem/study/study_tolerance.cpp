#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "synthesis/problem/problem.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/study/study_sections.h"
#include "synthesis/problem/text.h"

namespace mechwright::reading {

namespace {

/// Every length that is not named by itself.
constexpr std::string_view all_lengths = "lengths";

/// "IT7": the grade 7 of ISO 286; "ISO 2768-m": the class m of ISO 2768.
bool read_standard(const toml::node& node, std::string_view what, const Problem& problem, Deviation& deviation,
                   Messages& messages) {
    const auto word = node.value_exact<std::string_view>();
    if (!word) {
        report_kind(node, what, "a grade of ISO 286 or a class of ISO 2768 in quotes, as in \"IT7\" or \"ISO 2768-m\"",
                    messages);
        return false;
    }
    int grade = 0;
    const bool it = word->starts_with("IT");
    const auto [end, error] = std::from_chars(word->data() + (it ? 2 : 0), word->data() + word->size(), grade);
    const bool is_grade = it && error == std::errc{} && end == word->data() + word->size() &&
                          grade >= keys::least_grade && grade <= keys::greatest_grade;
    const auto general = std::find(keys::general_tolerances.begin(), keys::general_tolerances.end(), *word);
    if (!is_grade && general == keys::general_tolerances.end()) {
        add_error(messages, place_of(node),
                  fmt::format("{} must be a grade of ISO 286 from \"IT{}\" to \"IT{}\", or a class of ISO 2768 ({}), "
                              "not {}",
                              what, keys::least_grade, keys::greatest_grade, listed(keys::general_tolerances),
                              reading::quoted(*word)));
        return false;
    }
    if (problem.units.length != "mm") {
        add_error(messages, place_of(node),
                  fmt::format("tolerances of standards are for millimetres; the lengths of this file are in {}: write "
                              "{{ normal = ... }} or {{ uniform = ... }}",
                              reading::quoted(problem.units.length)));
        return false;
    }
    if (is_grade)
        deviation.grade = grade;
    else
        deviation.general = static_cast<int>(general - keys::general_tolerances.begin()) + 1;
    return true;
}

std::optional<Deviation> read_table(const toml::node& node, const std::string& what, const Problem& problem,
                                    Messages& messages) {
    Section section{node.as_table(), what, place_of(node), keys::deviation};
    Deviation deviation;
    int given = 0;
    for (const std::string_view key : keys::distributions) {
        const auto size = read_number(section, key, messages);
        given += has(section, key);
        if (!size) continue;
        deviation.uniform = key == "uniform";
        deviation.size = *size;
        if (!(*size > 0))
            add_error(messages, place_of(section, key),
                      fmt::format("{} must be greater than 0, not {}", name_of(section, key), *size));
    }
    if (const toml::node* grade = find(section, "grade")) {
        ++given;
        read_standard(*grade, name_of(section, "grade"), problem, deviation, messages);
        deviation.uniform = read_choice(section, "distribution", "distribution", messages) == 1u;
    }
    if (given != 1) {
        add_error(
            messages, section.place,
            fmt::format("{} needs one of 'normal' (standard deviation), 'uniform' (half the width) and 'grade'", what));
        return {};
    }
    report_unknown_keys(section, messages);
    return deviation;
}

std::optional<Deviation> to_deviation(const toml::node& node, const std::string& what, const Problem& problem,
                                      Messages& messages) {
    if (node.is_table()) return read_table(node, what, problem, messages);
    Deviation deviation;
    read_standard(node, what, problem, deviation, messages);
    return deviation;
}

}  // namespace

void read_tolerance(Section& study_section, Study& study, const Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(study_section, "tolerance", messages);
    if (!section || problem.mechanism == nullptr || problem.dimensions.empty()) return;
    section->title = "[study.tolerance]";
    const auto& dimensions = problem.mechanism->dimensions;
    const toml::node* lengths = find(*section, all_lengths);
    std::optional<Deviation> of_lengths;
    if (lengths != nullptr) of_lengths = to_deviation(*lengths, name_of(*section, all_lengths), problem, messages);
    for (const Dimension& dimension : whole_of(*problem.mechanism).dimensions)
        if (!dimension.of_segment && !dimension.of_target) find(*section, dimension.name);
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const Dimension& dimension = dimensions[i];
        if (dimension.of_segment || dimension.of_target) continue;
        const bool angle = dimension.kind == DimensionKind::angle;
        std::optional<Deviation> deviation;
        if (const toml::node* node = find(*section, dimension.name)) {
            deviation = to_deviation(*node, name_of(*section, dimension.name), problem, messages);
            if (deviation && (deviation->grade > 0 || deviation->general > 0) &&
                dimension.kind != DimensionKind::length)
                add_error(messages, place_of(*node),
                          "tolerances of standards are for lengths: write { normal = ... } or { uniform = ... }");
            if (deviation && angle) deviation->size = to_radians(problem.units, deviation->size);
        } else if (dimension.kind == DimensionKind::length) {
            deviation = of_lengths;
        }
        if (!deviation) continue;
        deviation->dimension = i;
        study.deviations.push_back(*deviation);
    }
    report_unknown_keys(*section, messages);
    if (section->table->empty())
        add_error(messages, section->place,
                  "[study.tolerance] is empty: name dimensions, or write lengths = \"IT7\" for all of them");
}

namespace {

/// What the tolerances of dimensions cost in comparison with each other; 1 where nothing is said.
std::vector<double> read_weights(Section& allocation, const Study& study, const Problem& problem, Messages& messages) {
    std::vector<double> weights(study.deviations.size(), 1.0);
    std::optional<Section> section = read_section(allocation, "weights", messages);
    if (!section) return weights;
    section->title = "[study.allocation.weights]";
    for (std::size_t i = 0; i < study.deviations.size(); ++i) {
        const std::string& name = problem.mechanism->dimensions[study.deviations[i].dimension].name;
        const auto weight = read_number(*section, name, messages);
        if (weight && !(*weight > 0))
            add_error(messages, place_of(*section, name),
                      fmt::format("{} must be greater than 0, not {}", name_of(*section, name), *weight));
        weights[i] = weight.value_or(1);
    }
    report_unknown_keys(*section, messages);
    return weights;
}

}  // namespace

void read_allocation(Section& study_section, Study& study, const Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(study_section, "allocation", messages);
    if (!section || problem.mechanism == nullptr) return;
    section->title = "[study.allocation]";
    Allocation allocation;
    const auto read = [&](std::string_view key, double above, double below, double& value) {
        const auto number = read_number(*section, key, messages);
        if (!number) return;
        value = *number;
        if (value > above && value < below) return;
        add_error(messages, place_of(*section, key),
                  fmt::format("{} must be above {} and below {}, not {}", name_of(*section, key), above, below, value));
    };
    double percent = 100 * allocation.share;
    read("share", 50, 100, percent);
    allocation.share = percent / 100;
    read("exponent", 0, 10, allocation.exponent);
    allocation.weights = read_weights(*section, study, problem, messages);
    report_unknown_keys(*section, messages);
    if (study.deviations.empty())
        add_error(messages, section->place,
                  "[study.allocation] widens the tolerances of [study.tolerance] or makes them closer: write the usual "
                  "ones there, like lengths = \"IT9\"");
    if (std::none_of(problem.requirements.begin(), problem.requirements.end(),
                     [](const Requirement& requirement) { return requirement.min || requirement.max; }))
        add_error(messages, section->place,
                  "[study.allocation] needs a limit that pieces are to meet: a [[require]] with 'min' or 'max'");
    study.allocation = std::move(allocation);
}

}  // namespace mechwright::reading
