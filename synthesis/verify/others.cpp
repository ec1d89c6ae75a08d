#include "synthesis/verify/others.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/document/claim_json.h"
#include "synthesis/program/result.h"
#include "synthesis/target/path/document.h"
#include "synthesis/verify/derived.h"
#include "synthesis/verify/rebuilt.h"
#include "synthesis/verify/verify.h"

namespace mechwright {

namespace {

using claims::Json;
using claims::member;

constexpr double same_within = 1e-9;  // of objectives, relative

/// All checks of one of the other designs as one.
Check as_one(std::string name, const std::vector<Check>& checks) {
    Check check{std::move(name), all_passed(checks), {}};
    for (const Check& one : checks)
        if (!one.passed) check.detail += (check.detail.empty() ? "" : "; ") + one.name + ": " + one.detail;
    if (check.passed) check.detail = fmt::format("all {} checks passed", checks.size());
    return check;
}

std::optional<double> number_in(const Json& json, const char* name) {
    const Json* at = json.is_object() ? member(json, name) : nullptr;
    return at && at->is_number() ? std::optional(at->get<double>()) : std::nullopt;
}

Json without_others(const Json& document) {
    Json alone = document;
    for (const char* name : {"front", "alternatives", "warnings"})
        alone.erase(name);
    return alone;
}

/// A design of a front stands in the document with all that is stated of it in place of the best one.
Check check_front_design(const Json& document, const Json& entry, std::size_t number) {
    const std::string name = fmt::format("front design {}", number);
    if (!entry.is_object()) return {name, false, "it is not an object"};
    Json alone = without_others(document);
    for (const auto& [key, value] : entry.items())
        if (key != "front") alone[key] = value;
    std::vector<Check> checks = verify_design(alone, Stated::everything);
    for (Check& check : check_derived(alone))
        checks.push_back(std::move(check));
    for (Check& check : check_verdict({{"verification", entry.value("verification", Json())}}, checks))
        checks.push_back(std::move(check));
    return as_one(name, checks);
}

/// What the terms of a front's objective come to, the sign turned so that less is better.
std::vector<double> costs_of(const Json& entry) {
    std::vector<double> costs;
    const auto objective = entry.is_object() ? entry.find("objective") : entry.end();
    if (objective == entry.end() || !objective->is_object() || !objective->contains("terms")) return costs;
    for (const Json& term : (*objective)["terms"])
        if (const auto value = number_in(term, "value"))
            costs.push_back(term.value("sense", Json()) == "maximize" ? -*value : *value);
    return costs;
}

/// That no member of a front is as good as another in both objectives within the tolerance, and better in one.
Check check_front_order(const Json& front, double tolerance) {
    Check check{"no design of the front is dominated", true, fmt::format("{} designs compared", front.size())};
    for (std::size_t i = 0; i < front.size(); ++i)
        for (std::size_t k = 0; k < front.size() && check.passed; ++k) {
            const std::vector<double> one = costs_of(front[i]), other = costs_of(front[k]);
            if (i == k || one.empty() || one.size() != other.size()) continue;
            bool as_good = true, better = false;
            for (std::size_t t = 0; t < one.size(); ++t) {
                const double same = tolerance * std::max(std::abs(one[t]), std::abs(other[t]));
                as_good = as_good && one[t] <= other[t] + same;
                better = better || one[t] < other[t] - same;
            }
            if (!as_good || !better) continue;
            check = {check.name, false, fmt::format("design {} is by design {}", k + 1, i + 1)};
        }
    return check;
}

void add_front(const Json& document, std::vector<Check>& checks) {
    const Json* front = member(document, "front");
    if (!front) return;
    if (!front->is_array()) return checks.push_back({"the front is a list of designs", false, ""});
    for (std::size_t i = 0; i < front->size(); ++i)
        checks.push_back(check_front_design(document, (*front)[i], i + 1));
    checks.push_back(check_front_order(*front, number_in(document, "tolerance").value_or(same_within)));
}

/// The document with another design in place of its own, and nothing stated of it but its objective.
Json with_alternative(const Json& document, const Json& entry) {
    Json alone = without_others(document);
    for (const char* own : {"quantities", "verification", "circuit", "branch", "used_crank_angles"})
        alone.erase(own);
    alone["design"] = entry.value("design", Json());
    if (alone.contains("objective") && alone["objective"].is_object())
        alone["objective"]["value"] = entry.value("objective", Json());
    const Json crank_angles = entry.value("path_angles", Json()), distances = entry.value("distances", Json());
    put_reached(alone, &crank_angles, &distances);
    return alone;
}

/// Why an alternative is better than the result's own design; empty if it is not.
std::string better_than_best(const Json& document, const Json& entry) {
    // Of designs at zero, which is proven, none is better: another reason chooses among them.
    const Json* search = member(document, "search");
    const Json* certificate = search && search->is_object() ? member(*search, "certificate") : nullptr;
    if (certificate && certificate->is_object() && certificate->value("kind", Json()) == "zero") return {};
    const Json objective = document.value("objective", Json());
    const auto best = number_in(objective, "value"), other = number_in(entry, "objective");
    if (!best || !other) return {};
    const bool single = objective.value("sense", Json()) == "maximize";
    const Json terms = objective.value("terms", Json());
    const bool worst = objective.value("reduce", Json()) == "max" && terms.is_array() && !terms.empty() &&
                       terms[0].is_object() && terms[0].value("sense", Json()) == "maximize";
    const double gain = single || worst ? *other - *best : *best - *other;
    if (gain <= same_within * std::max(std::abs(*best), std::abs(*other))) return {};
    return fmt::format("its objective {} is better than that of the design, {}", *other, *best);
}

/// Why an alternative is no cognate of what it is stated to be one of.
std::string cognate_defect(const Json& document, const Json& entry) {
    if (!entry.contains("cognate_of")) return {};
    const auto number = number_in(entry, "cognate_of");
    const Json& alternatives = document["alternatives"];
    if (!number || *number != std::floor(*number) || *number < 0 || *number > static_cast<double>(alternatives.size()))
        return "cognate_of is no number of a design";
    const auto of = static_cast<std::size_t>(*number);
    const Json other = of == 0 ? document : with_alternative(document, alternatives[of - 1]);
    const ReadClaim one = read_claim(with_alternative(document, entry)), two = read_claim(other);
    if (!one.defect.empty() || !two.defect.empty()) return "one of the cognates is not understood";
    const auto& point = one.claim.mechanism->point;
    if (point && point->draws_same_curve &&
        point->draws_same_curve(rebuilt(one.claim).rounded, rebuilt(two.claim).rounded))
        return {};
    return "it is stated as a cognate, and is none";
}

void add_alternatives(const Json& document, std::vector<Check>& checks) {
    const Json* list = member(document, "alternatives");
    if (!list) return;
    if (!list->is_array()) return checks.push_back({"the alternatives are a list of designs", false, ""});
    for (std::size_t i = 0; i < list->size(); ++i) {
        const Json& entry = (*list)[i];
        const std::string name = fmt::format("alternative {}", i + 1);
        if (!entry.is_object()) {
            checks.push_back({name, false, "it is not an object"});
            continue;
        }
        if (entry.contains("defect")) continue;  // it is stated to be no use
        std::vector<Check> all = verify_design(with_alternative(document, entry), Stated::design_alone);
        for (const std::string& defect : {better_than_best(document, entry), cognate_defect(document, entry)})
            if (!defect.empty()) all.push_back({"stands where it should", false, defect});
        for (Check& check : check_verdict({{"verification", entry.value("verification", Json())}}, all))
            all.push_back(std::move(check));
        checks.push_back(as_one(name, all));
    }
}

}  // namespace

std::vector<Check> check_others(const Json& document) {
    std::vector<Check> checks;
    add_front(document, checks);
    add_alternatives(document, checks);
    return checks;
}

std::vector<Check> check_verdict(const Json& document, const std::vector<Check>& checks) {
    std::vector<Check> verdict;
    if (!all_passed(checks)) return verdict;  // then the document is not verified, whatever it says of itself
    const auto verification = document.find("verification");
    if (verification != document.end() && !verification->is_null()) {
        bool as_stated = verification->is_object() && verification->value("passed", Json()) == true;
        if (as_stated && verification->contains("checks"))
            for (const Json& one : (*verification)["checks"])
                as_stated = as_stated && one.is_object() && one.contains("passed") && one["passed"] == true;
        verdict.push_back({"passed verification as stated", as_stated, "it passes"});
    }
    const auto status = document.find("status");
    if (status == document.end()) return verdict;
    const bool fits = *status == "solved" || *status == "infeasible" || *status == "limit" || *status == "interrupted";
    verdict.push_back({"has the status that the checks come to", fits,
                       fmt::format("stated is {}, and the checks pass", status->dump())});
    return verdict;
}

}  // namespace mechwright
