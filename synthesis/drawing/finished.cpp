#include "synthesis/drawing/finished.h"

#include <cmath>

#include "synthesis/program/quantity_value.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

namespace {

double plain(const Digits50& value) { return value.convert_to<double>(); }

std::vector<TargetPlace> targets_of(const Claim& claim, const Rebuilt& design) {
    std::vector<TargetPlace> targets;
    if (!claim.path) return targets;
    for (std::size_t i = 0; i < claim.path->points.size(); ++i) {
        TargetPlace target{.at = claim.path->points[i], .direction = {}, .reached = {}};
        if (i < claim.path->directions.size() && claim.path->directions[i])
            target.direction = plain(from_document(*claim.path->directions[i], Unit::angle, claim.units));
        if (design.path) {
            const Vector<double> reached{plain(design.path->reached[i].x), plain(design.path->reached[i].y)};
            if (std::isfinite(reached.x) && std::isfinite(reached.y)) target.reached = reached;
        }
        targets.push_back(target);
    }
    return targets;
}

std::vector<TargetPlace> targets_of(const Problem& problem, const Design& design) {
    std::vector<TargetPlace> targets;
    if (!problem.path) return targets;
    const std::optional<PathValues> values = path_values(problem, design);
    for (std::size_t i = 0; i < problem.path->points.size(); ++i) {
        TargetPlace target{.at = problem.path->points[i], .direction = {}, .reached = {}};
        if (problem.path->faces(i)) target.direction = problem.path->directions[i];
        if (values) target.reached = values->reached[i];
        targets.push_back(target);
    }
    return targets;
}

/// Puts the values of all quantities into a document, and those of its requirements, as they are measured again.
void state_values(nlohmann::ordered_json& document) {
    const ReadClaim read = read_claim(document);
    if (!read.defect.empty()) return;
    const Mechanism& mechanism = *read.claim.mechanism;
    const Rebuilt design = rebuilt(read.claim);
    Measurements measurements(design);
    const auto value_of = [&](std::size_t quantity) -> std::optional<double> {
        const auto& measured = measurements.of(quantity);
        if (!measured) return std::nullopt;
        return plain(in_document(measured->value, mechanism.quantities[quantity].unit, read.claim.units));
    };
    for (std::size_t i = 0; i < mechanism.quantities.size(); ++i)
        if (const auto value = value_of(i)) document["quantities"][std::string(mechanism.quantities[i].name)] = *value;
    for (std::size_t i = 0; i < read.claim.requirements.size(); ++i) {
        nlohmann::ordered_json& requirement = document["requirements"][i];
        requirement.erase("value");
        if (const auto value = value_of(read.claim.requirements[i].quantity)) requirement["value"] = *value;
    }
}

}  // namespace

double FinishedDesign::operator[](std::string_view dimension) const {
    const int index = find_dimension(*mechanism, dimension);
    return index < 0 ? 0 : dimensions[static_cast<std::size_t>(index)];
}

FinishedOrNot finished_design(const nlohmann::ordered_json& document) {
    FinishedOrNot result;
    const ReadClaim read = read_claim(document);
    if (!read.defect.empty()) {
        result.defect = read.defect;
        return result;
    }
    const Claim& claim = read.claim;
    const Rebuilt design = rebuilt(claim);
    result.design = {.mechanism = claim.mechanism,
                     .units = claim.units,
                     .motion = design.motion,
                     .dimensions = design.rounded,
                     .program = claim.program,
                     .function = claim.function,
                     .targets = targets_of(claim, design),
                     .guides_body = claim.path && !claim.path->directions.empty()};
    return result;
}

FinishedDesign finished_design(const Problem& problem, const Design& design) {
    return {.mechanism = problem.mechanism,
            .units = problem.units,
            .motion = motion_of(problem, design),
            .dimensions = design.dimensions,
            .program = problem.program,
            .function = problem.function,
            .targets = targets_of(problem, design),
            .guides_body = problem.path && problem.path->guides_body()};
}

nlohmann::ordered_json with_other_design(const nlohmann::ordered_json& document, const nlohmann::ordered_json& other) {
    nlohmann::ordered_json shown = document;
    for (const char* own : {"objective", "quantities", "verification", "front", "alternatives", "note"})
        shown.erase(own);
    for (const auto& [member, value] : other.items())
        shown[member] = value;
    if (document.contains("objective") && document["objective"].is_object() && other.contains("objective") &&
        other["objective"].is_number()) {
        shown["objective"] = document["objective"];
        shown["objective"]["value"] = other["objective"];
    }
    for (const char* kind : {"path", "poses"}) {
        if (other.contains(kind) || !shown.contains(kind) || !shown[kind].is_object()) continue;
        for (const char* reached : {"reached", "reached_directions", "crank_angles", "distances"})
            shown[kind].erase(reached);
        if (other.contains("path_angles")) shown[kind]["crank_angles"] = other["path_angles"];
    }
    if (!other.contains("quantities")) state_values(shown);
    return shown;
}

}  // namespace mechwright
