#include "synthesis/verify/proofs/proof_checks.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "synthesis/document/claim_json.h"
#include "synthesis/document/claimed_problem.h"
#include "synthesis/exact/known_solutions.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/possible_values.h"
#include "synthesis/verify/proofs/bounds_again.h"
#include "synthesis/verify/proofs/cam_certificates.h"
#include "synthesis/verify/proofs/limits_again.h"
#include "synthesis/verify/proofs/ranges_again.h"

namespace mechwright {

namespace {

using claims::Json;
using claims::member;
using claims::Reader;

bool all_given(const Problem& problem) {
    return std::all_of(problem.dimensions.begin(), problem.dimensions.end(),
                       [](const DimensionRange& range) { return range.fixed() || range.tied(); });
}

Finding check_given(const ProofContext& c) {
    const bool timed = !c.problem.path || c.problem.path->prescribed_timing;
    if (timed && all_given(c.problem)) return holds("every dimension is given");
    if (!c.infeasible && !c.problem.objective) return holds("nothing is to be made greatest or least");
    return fails("dimensions or crank angles are free, and there may be a better design");
}

Finding check_zero(const ProofContext& c) {
    constexpr double zero_within = 1e-12;
    const Quantity* quantity = single_objective(c, false);
    if (c.infeasible || !quantity) return fails("one quantity is to be least for this");
    if (possible_values(quantity->name).least != 0) return fails(fmt::format("{} can be negative", quantity->name));
    Measurements measurements(c.design);
    const auto& again = measurements.of(c.problem.objective->terms.front().quantity);
    if (!again) return fails("it has no value for this design");
    Digits50 size = 1;
    if (quantity->unit == Unit::length || quantity->unit == Unit::area) {
        size = std::max(c.design.longest, c.design.path ? c.design.path->size : Digits50(0));
        if (quantity->unit == Unit::area) size *= size;
    } else if (quantity->unit == Unit::curvature) {
        size = 1 / c.design.longest;
    }
    if (!(again->value <= zero_within * size)) return fails("it is " + size_text(again->value) + ", not zero");
    return holds(fmt::format("{} cannot be negative, and is {}", quantity->name, size_text(again->value)));
}

Finding check_count(const ProofContext& c) {
    const Json* counts = member(c.search, "solutions");
    if (!counts || !counts->is_object()) return fails("there are no counts of solutions");
    Reader in;
    const auto number = [&](const char* name) { return in.number(member(*counts, name), name); };
    const double tracked = number("tracked"), distinct = number("distinct"), at_infinity = number("at_infinity");
    const double singular = number("singular"), real = number("real"), certified = number("certified");
    const double defect_free = number("defect_free");
    if (!in.understood()) return fails(in.defect);
    const double known = distinct + at_infinity + singular;
    if (tracked != known) return fails(fmt::format("of {} solutions {} are known", tracked, known));
    const auto all = known_solutions(c.problem);
    if (all && tracked != static_cast<double>(*all))
        return fails(fmt::format("{} solutions are counted, and such a problem has {}", tracked, *all));
    if (singular != 0) return fails("singular solutions are counted, and not examined");
    if (certified > real) return fails("more solutions are certified than are real");
    if (c.infeasible != (defect_free == 0)) return fails("the number of designs without a defect does not go with it");
    return holds(fmt::format("{} solutions are {} distinct ones and {} at infinity", tracked, distinct, at_infinity));
}

struct Kind {
    std::string_view name;
    Finding (*check)(const ProofContext&);
};

constexpr std::array<Kind, 8> kinds{{{"half-planes", check_half_planes},
                                     {"curvature", check_curvature},
                                     {"limit", check_limit_again},
                                     {"bound", check_bound_again},
                                     {"count", check_count},
                                     {"zero", check_zero},
                                     {"given", check_given},
                                     {"ranges", check_ranges_again}}};

}  // namespace

bool says_infeasible(const Json& document) {
    const Json* status = member(document, "status");
    return status && status->is_string() && status->get<std::string>() == "infeasible";
}

Json with_some_design(Json document) {
    if (!document.is_object() || !says_infeasible(document) || member(document, "design")) return document;
    Json design = Json::object();
    const Json* given = member(document, "dimensions");
    if (given && given->is_object())
        for (const auto& [name, value] : given->items())
            design[name] = value.is_object() ? value.value("min", Json(1)) : value;
    if (const Json* cam = member(document, "cam"); cam && cam->is_object()) {
        design["rotation"] = cam_rotation_names[0];
        design["laws"] = Json::array();
        const Json* segments = member(*cam, "segments");
        for (std::size_t i = 0; segments && segments->is_array() && i < segments->size(); ++i) {
            const Json* laws = (*segments)[i].is_object() ? member((*segments)[i], "laws") : nullptr;
            design["laws"].push_back(laws && laws->is_array() && !laws->empty() ? (*laws)[0] : Json(""));
        }
    }
    document["design"] = std::move(design);
    return document;
}

namespace {

/// What the document says, as checks of proofs have it; a document without a design has some.
Check checked(const Json& document, const Json& search, const Json& certificate, Check check, std::string_view kind,
              Finding (*find)(const ProofContext&)) {
    const auto [claim, defect] = read_claim(with_some_design(document));
    check.detail = defect;
    if (!defect.empty()) return check;
    const Rebuilt design = rebuilt(claim);
    const ClaimedDesign claimed = claimed_design(claim);
    const Finding finding = find({document, search, certificate, design, claimed.problem, says_infeasible(document)});
    check.passed = finding.defect.empty();
    check.detail = check.passed ? finding.shown : finding.defect;
    if (!kind.empty()) check.detail = fmt::format("{}: {}", kind, check.detail);
    return check;
}

/// A bound that no certificate is about.
std::vector<Check> check_bound(const Json& document, const Json& search) {
    if (!member(search, "bound")) return {};
    Json some = document;
    if (!member(document, "design")) some["status"] = "infeasible";  // then one is taken from its ranges
    return {checked(some, search, Json(), {"no design is better than the bound", false, ""}, "", check_bound_below)};
}

}  // namespace

std::vector<Check> check_proof(const Json& document) {
    const Json* search = member(document, "search");
    if (!search || !search->is_object()) return {};
    const Json* complete = member(*search, "complete");
    const Json* certificate = member(*search, "certificate");
    const bool said = complete && complete->is_boolean() && complete->get<bool>();
    if (!said && !certificate) return check_bound(document, *search);
    Check check{says_infeasible(document) ? "that no design meets the requirements is shown"
                                          : "that no design is better is shown",
                false, "there is no certificate"};
    if (!said) check.detail = "it has a certificate, and is not said to be complete";
    if (!said || !certificate || !certificate->is_object()) return {check};
    const Json* name = member(*certificate, "kind");
    const auto* kind = std::find_if(kinds.begin(), kinds.end(), [&](const Kind& k) {
        return name && name->is_string() && name->get<std::string>() == k.name;
    });
    check.detail = "there is no such certificate";
    if (kind == kinds.end()) return {check};
    std::vector<Check> checks{checked(document, *search, *certificate, check, kind->name, kind->check)};
    if (kind->check != check_bound_again)
        for (Check& more : check_bound(document, *search))
            checks.push_back(std::move(more));
    return checks;
}

}  // namespace mechwright
