#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "synthesis/problem/problem.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/problem/study/study_sections.h"
#include "synthesis/problem/text.h"

namespace mechwright {

std::string name_of_deviation(const Deviation& deviation, const Mechanism& mechanism) {
    return deviation.joint ? "clearance " + mechanism.pin_joints->names[*deviation.joint]
                           : mechanism.dimensions[deviation.dimension].name;
}

}  // namespace mechwright

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

bool samples_pieces(const toml::table& study) { return study.contains("tolerance") || study.contains("clearance"); }

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

constexpr std::string_view usual_clearance = "clearance = 0.05, or clearance = { C = 0.05 } for some pins";

/// A diameter, > 0, as half of it.
std::optional<double> read_half_clearance(const toml::node& node, const std::string& what, Messages& messages) {
    const auto number = node.value<double>();
    if (!number || !node.is_number()) {
        report_kind(node, what, "a number", messages);
        return {};
    }
    if (!(*number > 0) || !std::isfinite(*number)) {
        add_error(messages, place_of(node), fmt::format("{} must be greater than 0, not {}", what, *number));
        return {};
    }
    return *number / 2;
}

/// Whether a joint is of this pin.
bool is_of_pin(std::string_view joint, std::string_view pin) {
    return joint == pin || (joint.starts_with(pin) && joint.substr(pin.size()).starts_with(" on "));
}

void add_clearance(std::size_t joint, double half, Study& study) {
    Deviation deviation;
    deviation.size = half;
    deviation.joint = joint;
    study.deviations.push_back(deviation);
}

/// What each pin is called, once.
std::vector<std::string> pins_of(const PinJoints& joints) {
    std::vector<std::string> pins;
    for (const std::string& joint : joints.names) {
        const std::string pin = joint.substr(0, joint.find(" on "));
        if (std::find(pins.begin(), pins.end(), pin) == pins.end()) pins.push_back(pin);
    }
    return pins;
}

void read_clearances_of_pins(const toml::node& node, const PinJoints& joints, Study& study, Messages& messages) {
    const std::vector<std::string> pins = pins_of(joints);
    Section section{node.as_table(), "'clearance' in [study]", place_of(node)};
    for (const std::string& pin : pins) {
        const toml::node* one = find(section, pin);
        if (one == nullptr) continue;
        const auto half = read_half_clearance(*one, name_of(section, pin), messages);
        for (std::size_t j = 0; half && j < joints.names.size(); ++j)
            if (is_of_pin(joints.names[j], pin)) add_clearance(j, *half, study);
    }
    report_unknown_keys(section, messages);
}

}  // namespace

void read_clearance(Section& study_section, Study& study, const Problem& problem, Messages& messages) {
    const toml::node* node = find(study_section, "clearance");
    if (node == nullptr || problem.mechanism == nullptr || problem.dimensions.empty()) return;
    const std::optional<PinJoints>& joints = problem.mechanism->pin_joints;
    study.as_linkage = problem.mechanism->as_linkage.has_value();
    if (study.as_linkage) return;  // the linkage's own reader says what is wrong with it
    if (!joints)
        return add_error(
            messages, place_of(*node),
            fmt::format("'clearance' is for the pins of linkages, and this {} has none", problem.mechanism->name));
    if (node->is_table()) return read_clearances_of_pins(*node, *joints, study, messages);
    if (!node->is_number())
        return report_kind(*node, "'clearance' in [study]",
                           fmt::format("a number or a table, as in {}", usual_clearance), messages);
    const auto half = read_half_clearance(*node, "'clearance' in [study]", messages);
    for (std::size_t j = 0; half && j < joints->names.size(); ++j)
        add_clearance(j, *half, study);
}

namespace {

/// What the tolerances of dimensions cost in comparison with each other; 1 where nothing is said.
std::vector<double> read_weights(Section& allocation, const Study& study, const Problem& problem, Messages& messages) {
    std::vector<double> weights(study.deviations.size(), 1.0);
    if (study.as_linkage) return weights;  // the linkage has others
    std::vector<std::string> names;
    for (const Deviation& deviation : study.deviations)
        names.push_back(name_of_deviation(deviation, *problem.mechanism));
    std::optional<Section> section = read_section(allocation, "weights", messages);
    if (!section) return weights;
    section->title = "[study.allocation.weights]";
    for (std::size_t i = 0; i < study.deviations.size(); ++i) {
        const std::string& name = names[i];
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
    if (!study.tolerances())
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
