#include "synthesis/report/drawing/finished.h"

#include "synthesis/document/claimed_problem.h"
#include "synthesis/document/document.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/target/names.h"
#include "synthesis/target/path/document.h"

namespace mechwright {

namespace {

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

/// Puts what there is to say of the document's design in place of what it says.
void evaluate_again(nlohmann::ordered_json& document) {
    const ReadClaim read = read_claim(document);
    if (!read.defect.empty() || !why_not_evaluable(read.claim).empty()) return;
    auto [problem, design] = claimed_design(read.claim);
    const nlohmann::ordered_json found = analysis_document(problem, assess(problem, std::move(design)));
    const auto put = [&](std::string_view name) {
        if (const std::string member(name); found.contains(member)) document[member] = found[member];
    };
    for (const char* member : {"objective", "requirements", "quantities", "warnings"})
        put(member);
    std::for_each(repeated_sections.begin(), repeated_sections.end(), put);
}

}  // namespace

FinishedOrNot finished_design(const nlohmann::ordered_json& document) {
    const ReadClaim read = read_claim(document);
    if (!read.defect.empty()) return {{}, read.defect};
    if (const std::string why = why_not_evaluable(read.claim); !why.empty()) return {{}, why};
    const auto [problem, design] = claimed_design(read.claim);
    return {finished_design(problem, design), {}};
}

FinishedDesign finished_design(const Problem& problem, const Design& design) {
    FinishedDesign finished;
    finished.mechanism = problem.mechanism;
    finished.motion = motion_of(problem, design);
    finished.dimensions = design.dimensions;
    const std::vector<InputTask> tasks = input_tasks(problem);
    const bool follows_something =
        std::any_of(tasks.begin(), tasks.end(), [](const InputTask& task) { return !task.is_function(); });
    finished.guides_point = problem.path || follows_something;
    finished.guides_body = problem.path && problem.path->guides_body();
    finished.units = problem.units;
    finished.function = problem.function;
    finished.followed = problem.followed;
    finished.over_input = problem.over_input;
    finished.targets = targets_of(problem, design);
    return finished;
}

nlohmann::ordered_json with_other_design(const nlohmann::ordered_json& document, const nlohmann::ordered_json& other) {
    nlohmann::ordered_json shown = document;
    for (const char* own : {"objective", "quantities", "verification", "front", "alternatives", "note", "warnings",
                            "circuit", "branch", "used_crank_angles"})
        shown.erase(own);
    for (const auto& [member, value] : other.items())
        shown[member] = value;
    // An alternative has the value of the objective alone; what it is of stands in the result.
    if (shown.contains("objective") && !shown["objective"].is_object() && document.contains("objective"))
        shown["objective"] = document["objective"];
    if (!other.contains("path") && !other.contains("poses"))
        put_reached(shown, other.contains("path_angles") ? &other["path_angles"] : nullptr, nullptr);
    if (!other.contains("quantities")) evaluate_again(shown);
    return shown;
}

Unit input_unit(const FinishedDesign& design) { return input_unit(*design.mechanism); }

std::vector<double> even_angles(const FinishedDesign& design, int steps) {
    const Motion& motion = design.motion;
    if (!design.assembles()) return {};
    const Unit unit = input_unit(design);
    const double from = in_file_unit(motion.from, unit, design.units), to = in_file_unit(motion.to, unit, design.units);
    std::vector<double> angles{motion.from};
    for (int i = 1; i < steps; ++i)
        angles.push_back(from_file_unit(from + (to - from) * i / steps, unit, design.units));
    angles.push_back(motion.to);
    return angles;
}

double in_file_unit(const FinishedDesign& design, const MotionRow& row, std::size_t column) {
    return in_file_unit(row.values()[column], design.mechanism->table.units[column], design.units);
}

}  // namespace mechwright
