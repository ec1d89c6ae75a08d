#include "synthesis/document/document.h"

#include <algorithm>
#include <cmath>

#include "synthesis/document/cam_document.h"
#include "synthesis/document/followed_document.h"
#include "synthesis/document/function_document.h"
#include "synthesis/document/proof_document.h"
#include "synthesis/document/versions.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/singular.h"
#include "synthesis/program/standing.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

bool finite(double number) { return std::isfinite(number); }

/// Numbers that are not finite are never written.
void put(Json& object, std::string_view name, double number) {
    if (finite(number)) object[std::string(name)] = number;
}

Json pairs(const std::vector<Vector<double>>& points) {
    Json list = Json::array();
    for (const Vector<double>& p : points)
        list.push_back({p.x, p.y});
    return list;
}

Json angles(const std::vector<double>& radians, const Units& units) {
    Json list = Json::array();
    for (const double angle : radians)
        list.push_back(finite(angle) ? Json(in_file_unit(angle, Unit::angle, units)) : Json());
    return list;
}

Json given_dimensions(const Problem& problem) {
    Json given = Json::object();
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        if (!range.named) continue;
        const Dimension& dimension = problem.mechanism->dimensions[i];
        const auto outside = [&](double x) { return in_file_unit(x, unit_of(dimension.kind), problem.units); };
        if (range.tied())
            given[std::string(dimension.name)] = {{"of", problem.mechanism->dimensions[range.tie.of].name},
                                                  {"times", range.tie.times}};
        else if (range.fixed())
            given[std::string(dimension.name)] = outside(range.min);
        else
            given[std::string(dimension.name)] = {{"min", outside(range.min)}, {"max", outside(range.max)}};
    }
    return given;
}

Json design_of(const Problem& problem, const Design& design) {
    const Mechanism& mechanism = *problem.mechanism;
    Json json = Json::object();
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i) {
        const Dimension& dimension = mechanism.dimensions[i];
        const double value = design.dimensions[i];
        if (!dimension.required && !problem.dimensions[i].named && value == 0) continue;
        put(json, dimension.name, in_file_unit(value, unit_of(dimension.kind), problem.units));
    }
    if (!mechanism.assemblies.empty()) json["assembly"] = mechanism.assemblies[design.assembly];
    if (problem.program) put_cam_choice(json, problem, design.assembly);
    json["kind"] = mechanism.describe(design.dimensions);
    return json;
}

void put_value_of(Json& json, std::string_view name, const Problem& problem, std::size_t quantity,
                  const Design& design) {
    if (const std::optional<double> value = quantity_value(problem, quantity, design))
        put(json, name, in_file_unit(*value, problem.mechanism->quantities[quantity].unit, problem.units));
}

/// Values only where there is a solution.
Json objective_of(const Problem& problem, const Solution* solution) {
    const Objective& objective = *problem.objective;
    const auto quantity_and_sense = [&](const ObjectiveTerm& term) {
        return Json{{"quantity", problem.mechanism->quantities[term.quantity].name},
                    {"sense", term.maximize ? "maximize" : "minimize"}};
    };
    Json json;
    if (objective.terms.size() == 1) {
        json = quantity_and_sense(objective.terms.front());
    } else {
        Json terms = Json::array();
        for (const ObjectiveTerm& term : objective.terms) {
            Json one = quantity_and_sense(term);
            put(one, "weight", term.weight);
            if (solution) put_value_of(one, "value", problem, term.quantity, solution->design);
            terms.push_back(std::move(one));
        }
        json = {{"terms", std::move(terms)}, {"reduce", objective.worst ? "max" : "sum"}};
    }
    if (solution) put(json, "value", solution->objective);
    return json;
}

Json requirements_of(const Problem& problem, const Design* design) {
    Json list = Json::array();
    for (const Requirement& requirement : problem.requirements) {
        const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
        const Standing standing = design ? standing_of(problem, requirement, *design) : Standing{};
        const auto outside = [&](double x) { return in_file_unit(x, quantity.unit, problem.units); };
        Json one{{"quantity", quantity.name}};
        if (standing.value) put(one, "value", outside(*standing.value));
        if (requirement.equal) put(one, "equal", outside(*requirement.equal));
        if (requirement.min) put(one, "min", outside(*requirement.min));
        if (requirement.max) put(one, "max", outside(*requirement.max));
        if (standing.violation) put(one, "violation", *standing.violation);
        if (design) one["active"] = standing.active;
        list.push_back(std::move(one));
    }
    return list;
}

Json quantities_of(const Problem& problem, const Design& design) {
    Json json = Json::object();
    const auto is_wanted = [&](std::size_t i) {
        return !problem.wanted || std::find(problem.wanted->begin(), problem.wanted->end(), i) != problem.wanted->end();
    };
    for (std::size_t i = 0; i < problem.mechanism->quantities.size(); ++i)
        if (is_wanted(i)) put_value_of(json, problem.mechanism->quantities[i].name, problem, i, design);
    return json;
}

Json path_of(const Problem& problem, const Solution* best) {
    const PathTarget& target = *problem.path;
    Json json{{"points", pairs(target.points)},
              {"timing", target.prescribed_timing ? "prescribed"
                         : target.any_order       ? "none"
                                                  : "free"},
              {"closed", target.closed}};
    if (target.guides_body()) {
        json["directions"] = angles(target.directions, problem.units);
        json["body_length"] = target.body_length;
    }
    if (std::any_of(target.weights.begin(), target.weights.end(), [](double w) { return w != 1; }))
        json["weights"] = target.weights;
    if (target.prescribed_timing) json["prescribed_angles"] = angles(target.crank_angles, problem.units);
    if (!best) return json;
    if (const std::optional<PathValues> values = path_values(problem, best->design)) {
        json["reached"] = pairs(values->reached);
        if (target.guides_body()) json["reached_directions"] = angles(values->directions, problem.units);
        json["crank_angles"] = angles(best->design.path_angles, problem.units);
        json["distances"] = values->distances;
    }
    return json;
}

Json alternative_of(const Problem& problem, const Solution& solution) {
    Json one{{"design", design_of(problem, solution.design)}};
    put(one, "objective", solution.objective);
    const std::vector<double>& path_angles = solution.design.path_angles;
    if (!path_angles.empty() && std::all_of(path_angles.begin(), path_angles.end(), finite))
        one["path_angles"] = angles(solution.design.path_angles, problem.units);
    if (const std::optional<PathValues> values = path_values(problem, solution.design))
        one["distances"] = values->distances;
    return one;
}

Json alternatives_of(const Problem& problem, const Result& result) {
    Json list = Json::array();
    for (const VerifiedDesign& other : result.alternatives) {
        list.push_back(alternative_of(problem, other.solution));
        if (other.cognate_of) list.back()["cognate_of"] = *other.cognate_of;
        if (!other.verification.empty()) list.back()["verification"] = verification_document(other.verification);
    }
    for (const ExcludedDesign& excluded : result.excluded) {
        list.push_back(alternative_of(problem, excluded.solution));
        list.back()["defect"] = excluded.defect;
    }
    return list;
}

Json solutions_of(const SolutionCounts& counts) {
    return {{"tracked", counts.tracked},        {"distinct", counts.distinct}, {"at_infinity", counts.at_infinity},
            {"singular", counts.singular},      {"real", counts.real},         {"certified", counts.certified},
            {"defect_free", counts.defect_free}};
}

/// Targets, and how a design meets them.
void put_targets(Json& json, const Problem& problem, const Solution* best) {
    const Design* design = best ? &best->design : nullptr;
    if (problem.path) json[problem.path->guides_body() ? "poses" : "path"] = path_of(problem, best);
    if (problem.function) json["function"] = function_document(problem, design);
    if (problem.followed)
        json[std::string(followed_shape_of(*problem.mechanism, *problem.followed).name)] =
            followed_document(problem, design);
}

/// Where the design stands close to a singular position.
void put_warnings(Json& json, const Problem& problem, const Design& design) {
    for (const SingularMargin& m : singular_margins(problem, design)) {
        Json one{{"name", m.name}};
        put(one, "margin", m.margin);
        put(one, "relative", m.relative);
        one["warned_below"] = singular_below;
        json["warnings"].push_back(std::move(one));
    }
}

/// The members that are about one design.
void put_findings(Json& json, const Problem& problem, const Solution& solution) {
    json["design"] = design_of(problem, solution.design);
    if (problem.objective) json["objective"] = objective_of(problem, &solution);
    if (!problem.requirements.empty()) json["requirements"] = requirements_of(problem, &solution.design);
    json["quantities"] = quantities_of(problem, solution.design);
    put_targets(json, problem, &solution);
    put_warnings(json, problem, solution.design);
}

/// Every design of the front with all that the document says of one.
Json front_of(const Problem& problem, const Result& result) {
    Json list = Json::array();
    for (const VerifiedDesign& point : result.front) {
        Json one = Json::object();
        put_findings(one, problem, point.solution);
        one["verification"] = verification_document(point.verification);
        list.push_back(std::move(one));
    }
    return list;
}

Json search_of(const Problem& problem, const SearchReport& search) {
    Json json{{"method", search.method}, {"complete", search.complete()}};
    if (search.proof) {
        json["argument"] = search.proof->argument;
        json["certificate"] = certificate_document(problem, search.proof->certificate);
    }
    json["starts"] = search.starts;
    json["local_optima"] = search.local_optima;
    json["hits"] = search.hits;
    put(json, "missed_chance", search.missed_chance);
    if (search.bound) {
        put(json, "bound", *search.bound);
        json["boxes"] = search.boxes;
    }
    if (search.solutions) json["solutions"] = solutions_of(*search.solutions);
    json["evaluations"] = search.evaluations;
    json["seed"] = problem.solver.seed;
    put(json, "seconds", search.seconds);
    return json;
}

Json problem_of(const Problem& problem) {
    Json json{{"file", problem.file}, {"sha256", problem.sha256}};
    if (!problem.text.empty()) json["text"] = problem.text;
    json["title"] = problem.title;
    json["mechanism"] = problem.mechanism->name;
    return json;
}

Json head(const Problem& problem) {
    return {{"schema", 1},
            {"problem", problem_of(problem)},
            {"program",
             {{"version", program_version()},
              {"libraries", {{"ipopt", ipopt_version()}, {"nlopt", nlopt_version()}, {"eigen", eigen_version()}}}}},
            {"units", {{"angle", problem.units.degrees ? "deg" : "rad"}, {"length", problem.units.length}}}};
}

/// The members from tolerance to path.
void put_body(Json& json, const Problem& problem, const Solution* best) {
    put(json, "tolerance", problem.solver.tolerance);
    json["dimensions"] = given_dimensions(problem);
    if (problem.program) json["cam"] = cam_document(problem);
    if (problem.crank_range)
        json["crank_range"] = angles({problem.crank_range->x, problem.crank_range->y}, problem.units);
    for (std::size_t i = 0; i < problem.mechanism->settings.size(); ++i)
        json["settings"][std::string(problem.mechanism->settings[i].name)] = problem.settings[i];
    if (problem.has_instant) json["instant"] = true;
    if (best) return put_findings(json, problem, *best);
    put_targets(json, problem, nullptr);
}

}  // namespace

std::string_view name_of(Status status) {
    switch (status) {
        case Status::solved: return "solved";
        case Status::infeasible: return "infeasible";
        case Status::limit: return "limit";
        case Status::unverified: return "unverified";
        case Status::interrupted: return "interrupted";
    }
    return "";
}

nlohmann::ordered_json verification_document(const std::vector<Check>& done) {
    Json checks = Json::array();
    for (const Check& check : done)
        checks.push_back({{"name", check.name}, {"passed", check.passed}, {"detail", check.detail}});
    return {{"passed", all_passed(done)}, {"checks", std::move(checks)}};
}

/// What is asked for, where there is no design that it is measured of.
void put_asked(Json& json, const Problem& problem) {
    if (problem.objective) json["objective"] = objective_of(problem, nullptr);
    if (!problem.requirements.empty()) json["requirements"] = requirements_of(problem, nullptr);
}

nlohmann::ordered_json document(const Problem& problem, const Result& result) {
    Json json = head(problem);
    json["status"] = name_of(result.status);
    if (!result.note.empty()) json["note"] = result.note;
    put_body(json, problem, result.best ? &*result.best : nullptr);
    if (!result.best) put_asked(json, problem);
    if (!result.verification.empty()) json["verification"] = verification_document(result.verification);
    if (problem.solver.pareto > 0) json["front"] = front_of(problem, result);
    json["alternatives"] = alternatives_of(problem, result);
    json["search"] = search_of(problem, result.search);
    return json;
}

nlohmann::ordered_json asked_document(const Problem& problem) {
    Json json{{"problem", {{"title", problem.title}, {"mechanism", problem.mechanism->name}}}};
    json["units"] = head(problem)["units"];
    put_body(json, problem, nullptr);
    put_asked(json, problem);
    return json;
}

nlohmann::ordered_json analysis_document(const Problem& problem, const Solution& solution) {
    Json json = head(problem);
    put_body(json, problem, &solution);
    return json;
}

}  // namespace mechwright
