#include "synthesis/document/document.h"

#include <algorithm>
#include <cmath>

#include "synthesis/document/dwell_document.h"
#include "synthesis/document/fields.h"
#include "synthesis/document/given_document.h"
#include "synthesis/document/kinds_in_documents.h"
#include "synthesis/document/lists.h"
#include "synthesis/document/search_document.h"
#include "synthesis/document/versions.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/singular.h"
#include "synthesis/program/standing/standing.h"
#include "synthesis/target/over_input/document.h"
#include "synthesis/target/path/document.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

using namespace names;

Json design_of(const Problem& problem, const Design& design) {
    const Mechanism& mechanism = *problem.mechanism;
    Json json = Json::object();
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i) {
        const Dimension& dimension = mechanism.dimensions[i];
        const double value = design.dimensions[i];
        if (!dimension.required && !problem.dimensions[i].named && value == 0) continue;
        put_number(json, dimension.name, in_file_unit(value, unit_of(dimension.kind), problem.units));
    }
    if (!mechanism.assembly_documents.empty())
        json[of_design("assembly")] = Json::parse(mechanism.assembly_documents[design.assembly]);
    else if (!mechanism.assemblies.empty())
        json[of_design("assembly")] = mechanism.assemblies[design.assembly];
    if (const KindInDocuments* own = kind_in_documents(mechanism)) own->put_choices(json, problem, design.assembly);
    json[of_design("kind")] = mechanism.describe(mechanism.form(0), design.dimensions);
    return json;
}

void put_value(Json& json, std::string_view name, const Problem& problem, std::size_t quantity,
               const std::optional<double>& value) {
    if (value)
        put_number(json, name, in_file_unit(*value, problem.mechanism->quantities[quantity].unit, problem.units));
}

void put_value_of(Json& json, std::string_view name, const Problem& problem, std::size_t quantity,
                  const Design& design) {
    put_value(json, name, problem, quantity, quantity_value(problem, quantity, design));
}

/// Values only where there is a solution.
Json objective_of(const Problem& problem, const Solution* solution) {
    const Objective& objective = *problem.objective;
    const auto quantity_and_sense = [&](const ObjectiveTerm& term) {
        return Json{{of_term("quantity"), problem.mechanism->quantities[term.quantity].name},
                    {of_term("sense"), term.maximize ? "maximize" : "minimize"}};
    };
    Json json;
    if (objective.terms.size() == 1) {
        json = quantity_and_sense(objective.terms.front());
    } else {
        Json terms = Json::array();
        for (const ObjectiveTerm& term : objective.terms) {
            Json one = quantity_and_sense(term);
            put_number(one, of_term("weight"), term.weight);
            if (solution) put_value_of(one, of_term("value"), problem, term.quantity, solution->design);
            terms.push_back(std::move(one));
        }
        json = {{of_objective("terms"), std::move(terms)}, {of_objective("reduce"), objective.worst ? "max" : "sum"}};
    }
    if (solution) put_number(json, of_objective("value"), solution->objective);
    return json;
}

Json wishes_of(const Problem& problem, const Solution* solution) {
    Json list = Json::array();
    for (std::size_t i = 0; i < problem.wishes.size(); ++i) {
        const Wish& wish = problem.wishes[i];
        const Quantity& quantity = problem.mechanism->quantities[wish.term.quantity];
        const auto outside = [&](double value) { return in_file_unit(value, quantity.unit, problem.units); };
        Json one{{of_wish("quantity"), quantity.name},
                 {of_wish("sense"), wish.term.maximize ? "maximize" : "minimize"},
                 {of_wish("within"), outside(wish.within)}};
        if (solution && i < solution->wished.size()) {
            put_number(one, of_wish("best"), outside(solution->wished[i].best));
            put_number(one, of_wish("limit"), outside(solution->wished[i].limit));
        }
        if (solution) put_value_of(one, of_wish("value"), problem, wish.term.quantity, solution->design);
        list.push_back(std::move(one));
    }
    return list;
}

Json requirements_of(const Problem& problem, const Design* design) {
    Json list = Json::array();
    for (const Requirement& requirement : problem.requirements) {
        const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
        const Standing standing = design ? standing_of(problem, requirement, *design) : Standing{};
        const auto outside = [&](double x) { return in_file_unit(x, quantity.unit, problem.units); };
        Json one{{of_requirement("quantity"), quantity.name}};
        if (standing.value) put_number(one, of_requirement("value"), outside(*standing.value));
        if (requirement.equal) put_number(one, of_requirement("equal"), outside(*requirement.equal));
        if (requirement.min) put_number(one, of_requirement("min"), outside(*requirement.min));
        if (requirement.max) put_number(one, of_requirement("max"), outside(*requirement.max));
        if (standing.violation) put_number(one, of_requirement("violation"), *standing.violation);
        if (design) one[of_requirement("active")] = standing.active;
        list.push_back(std::move(one));
    }
    return list;
}

Json quantities_of(const Problem& problem, const Design& design) {
    Json json = Json::object();
    const auto is_wanted = [&](std::size_t i) {
        return !problem.wanted || std::find(problem.wanted->begin(), problem.wanted->end(), i) != problem.wanted->end();
    };
    QuantityValues values(problem, design);
    for (std::size_t i = 0; i < problem.mechanism->quantities.size(); ++i)
        if (is_wanted(i)) put_value(json, problem.mechanism->quantities[i].name, problem, i, values[i]);
    return json;
}

Json alternative_of(const Problem& problem, const Solution& solution) {
    Json one{{of_alternative("design"), design_of(problem, solution.design)}};
    put_number(one, of_alternative("objective"), solution.objective);
    const std::vector<double>& path_angles = solution.design.path_angles;
    if (!path_angles.empty() &&
        std::all_of(path_angles.begin(), path_angles.end(), [](double a) { return std::isfinite(a); }))
        one[of_alternative("path_angles")] =
            in_file_units(solution.design.path_angles, input_unit(*problem.mechanism), problem.units);
    if (const std::optional<PathValues> values = path_values(problem, solution.design))
        one[of_alternative("distances")] = values->distances;
    return one;
}

Json alternatives_of(const Problem& problem, const Result& result) {
    Json list = Json::array();
    for (const VerifiedDesign& other : result.alternatives) {
        list.push_back(alternative_of(problem, other.solution));
        if (other.cognate_of) list.back()[of_alternative("cognate_of")] = *other.cognate_of;
        if (!other.verification.empty())
            list.back()[of_alternative("verification")] = verification_document(other.verification);
    }
    for (const ExcludedDesign& excluded : result.excluded) {
        list.push_back(alternative_of(problem, excluded.solution));
        list.back()[of_alternative("defect")] = excluded.defect;
    }
    return list;
}

/// Targets, and how a design meets them.
void put_targets(Json& json, const Problem& problem, const Solution* best) {
    const Design* design = best ? &best->design : nullptr;
    if (problem.path) put_path(json, problem, best);
    put_over_input(json, problem, design);
}

/// Where the design stands close to a singular position.
void put_warnings(Json& json, const Problem& problem, const Design& design) {
    Json warnings = Json::array();  // a null that becomes an array is left broken where memory runs out
    for (const SingularMargin& m : singular_margins(problem, design)) {
        Json one{{of_warning("name"), m.name}};
        put_number(one, of_warning("margin"), m.margin);
        put_number(one, of_warning("relative"), m.relative);
        if (m.impossible) one[of_warning("impossible")] = true;
        one[of_warning("warned_below")] = singular_below;
        warnings.push_back(std::move(one));
    }
    if (!warnings.empty()) json[of_finding("warnings")] = std::move(warnings);
}

/// Where circuits and branches are numbered, unless single quantities are all that is asked for.
void put_circuit(Json& json, const Problem& problem, const Design& design) {
    if (problem.wanted) return;
    const auto found = circuit_of(problem, motion_of(problem, design), design);
    if (!found) return;
    json[of_finding("circuit")] = found->circuit;
    json[of_finding("branch")] = found->branch;
}

/// Where the range of use of a design lies.
void put_used_angles(Json& json, const Problem& problem, const Design& design) {
    if (!problem.use) return;
    const Motion motion = motion_of(problem, design);
    if (motion.from <= motion.to)
        json[of_finding("used_crank_angles")] =
            in_file_units({motion.from, motion.to}, input_unit(*problem.mechanism), problem.units);
}

/// The members that are about one design.
void put_findings(Json& json, const Problem& problem, const Solution& solution) {
    json[of_finding("design")] = design_of(problem, solution.design);
    put_circuit(json, problem, solution.design);
    put_used_angles(json, problem, solution.design);
    if (problem.objective) json[of_finding("objective")] = objective_of(problem, &solution);
    if (!problem.wishes.empty()) json[of_finding("wishes")] = wishes_of(problem, &solution);
    if (!problem.requirements.empty()) json[of_finding("requirements")] = requirements_of(problem, &solution.design);
    json[of_finding("quantities")] = quantities_of(problem, solution.design);
    put_targets(json, problem, &solution);
    put_dwells(json, problem, solution.design);
    put_warnings(json, problem, solution.design);
}

/// Every design of the front with all that the document says of one.
Json front_of(const Problem& problem, const Result& result) {
    Json list = Json::array();
    for (const VerifiedDesign& point : result.front) {
        Json one = Json::object();
        put_findings(one, problem, point.solution);
        one[of_finding("verification")] = verification_document(point.verification);
        list.push_back(std::move(one));
    }
    return list;
}

Json problem_of(const Problem& problem) {
    Json json{{of_problem("file"), problem.file}, {of_problem("sha256"), problem.sha256}};
    if (!problem.text.empty()) json[of_problem("text")] = problem.text;
    json[of_problem("title")] = problem.title;
    json[of_problem("mechanism")] = problem.mechanism->name;
    return json;
}

Json head(const Problem& problem) {
    return {{of_document("schema"), 1},
            {of_document("problem"), problem_of(problem)},
            {of_document("program"),
             {{of_program("version"), program_version()},
              {of_program("libraries"),
               {{of_libraries("ipopt"), ipopt_version()},
                {of_libraries("nlopt"), nlopt_version()},
                {of_libraries("eigen"), eigen_version()}}}}},
            {of_document("units"), units_document(problem.units)}};
}

/// What the mechanism is made from: a linkage's own sections, or rooms and regions of a mechanism of the list.
void put_made_from(Json& json, const Mechanism& mechanism) {
    if (mechanism.made_from.empty()) return;
    Json sections = Json::parse(mechanism.made_from);
    if (is_described(mechanism))
        json[of_document("linkage")] = std::move(sections);
    else
        for (const char* name : {of_document("signals"), of_document("room"), of_document("region")})
            if (const auto at = sections.find(name); at != sections.end()) json[name] = std::move(*at);
}

/// The members from tolerance to path.
void put_body(Json& json, const Problem& problem, const Solution* best) {
    put_number(json, of_document("tolerance"), problem.solver.tolerance);
    json[of_document("dimensions")] = given_dimensions(problem);
    put_made_from(json, *problem.mechanism);
    if (const KindInDocuments* own = kind_in_documents(*problem.mechanism)) json[own->given] = own->given_of(problem);
    if (problem.crank_range) {
        const Unit unit = input_unit(*problem.mechanism);
        json[of_document("crank_range")] = {in_file_unit(problem.crank_range->x, unit, problem.units),
                                            in_file_unit(problem.crank_range->y, unit, problem.units)};
    }
    if (problem.use) json[of_document("range_of_use")] = given_range_of_use(problem);
    Json settings = Json::object();  // made whole: one that null turns into is none where memory runs out
    for (std::size_t i = 0; i < problem.mechanism->settings.size(); ++i)
        settings[problem.mechanism->settings[i].name] =
            problem.settings[i] / inner_per_file_unit(problem.mechanism->settings[i], problem.units);
    if (!settings.empty()) json[of_document("settings")] = std::move(settings);
    if (problem.has_instant) json[of_document("instant")] = true;
    if (best) return put_findings(json, problem, *best);
    put_targets(json, problem, nullptr);
}

}  // namespace

std::string_view name_of(Status status) { return fields::statuses[static_cast<std::size_t>(status)]; }

nlohmann::ordered_json verification_document(const std::vector<Check>& done) {
    Json checks = Json::array();
    for (const Check& check : done)
        checks.push_back(
            {{of_check("name"), check.name}, {of_check("passed"), check.passed}, {of_check("detail"), check.detail}});
    return {{of_verification("passed"), all_passed(done)}, {of_verification("checks"), std::move(checks)}};
}

/// What is asked for, where there is no design that it is measured of.
void put_asked(Json& json, const Problem& problem) {
    if (problem.objective) json[of_document("objective")] = objective_of(problem, nullptr);
    if (!problem.wishes.empty()) json[of_document("wishes")] = wishes_of(problem, nullptr);
    if (!problem.requirements.empty()) json[of_document("requirements")] = requirements_of(problem, nullptr);
}

nlohmann::ordered_json document(const Problem& problem, const Result& result) {
    Json json = head(problem);
    json[of_document("status")] = name_of(result.status);
    if (!result.note.empty()) json[of_document("note")] = result.note;
    put_body(json, problem, result.best ? &*result.best : nullptr);
    if (!result.best) put_asked(json, problem);
    if (!result.verification.empty()) json[of_document("verification")] = verification_document(result.verification);
    if (problem.solver.pareto > 0) json[of_document("front")] = front_of(problem, result);
    json[of_document("alternatives")] = alternatives_of(problem, result);
    json[of_document("search")] = search_document(problem, result.search);
    return json;
}

nlohmann::ordered_json asked_document(const Problem& problem) {
    Json json{{of_document("problem"),
               {{of_problem("title"), problem.title}, {of_problem("mechanism"), problem.mechanism->name}}}};
    json[of_document("units")] = head(problem)[of_document("units")];
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
