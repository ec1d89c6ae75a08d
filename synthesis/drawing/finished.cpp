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

nlohmann::ordered_json with_alternative(const nlohmann::ordered_json& document,
                                        const nlohmann::ordered_json& alternative) {
    nlohmann::ordered_json other = document;
    for (const char* own : {"objective", "requirements", "quantities", "verification", "front", "alternatives", "note"})
        other.erase(own);
    other["design"] = alternative["design"];
    for (const char* member : {"objective", "requirements", "quantities", "verification", "defect"})
        if (alternative.contains(member)) other[member] = alternative[member];
    for (const char* kind : {"path", "poses"}) {
        if (!other.contains(kind) || !other[kind].is_object()) continue;
        for (const char* reached : {"reached", "reached_directions", "crank_angles", "distances"})
            other[kind].erase(reached);
        if (alternative.contains("path_angles")) other[kind]["crank_angles"] = alternative["path_angles"];
    }
    return other;
}

}  // namespace mechwright
