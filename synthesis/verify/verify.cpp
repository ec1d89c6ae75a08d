#include "synthesis/verify/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>

#include "synthesis/problem/units.h"
#include "synthesis/program/result.h"
#include "synthesis/target/followed/verify.h"
#include "synthesis/target/function/function_target.h"
#include "synthesis/target/function/verify.h"
#include "synthesis/target/path/verify.h"
#include "synthesis/verify/asked.h"
#include "synthesis/verify/derived.h"
#include "synthesis/verify/design_checks.h"
#include "synthesis/verify/others.h"
#include "synthesis/verify/proofs/proof_checks.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

namespace {

const Quantity& quantity_of(const Claim& claim, std::size_t index) { return claim.mechanism->quantities[index]; }

std::string joined(const std::vector<std::string>& parts, std::string_view between) {
    return fmt::format("{}", fmt::join(parts, between));
}

bool has_its_lengths(const Claim& claim) {
    for (std::size_t i = 0; i < claim.design.size(); ++i)
        if (claim.mechanism->dimensions[i].kind == DimensionKind::length && !(claim.design[i] > 0)) return false;
    return true;
}

/// The longest link to the power in which lengths are in a unit; 1 of a unit that is none of lengths.
Digits50 length_of_unit(const Rebuilt& design, Unit unit) {
    switch (unit) {
        case Unit::length: return design.longest;
        case Unit::area: return design.longest * design.longest;
        case Unit::curvature: return 1 / design.longest;
        default: return 1;
    }
}

/// What a violation is relative to: the greatest limit, but at least 1 for plain numbers and angles in radians; for
/// lengths (areas) whose limits are all 0 the longest link (its square).
Digits50 violation_scale(const Rebuilt& design, Unit unit, const std::vector<Digits50>& limits) {
    Digits50 scale = 0;
    for (const Digits50& limit : limits)
        scale = std::max<Digits50>(scale, abs(limit));
    if (unit == Unit::none || unit == Unit::rate || unit == Unit::angle) return std::max(scale, Digits50(1));
    if (scale > 0) return scale;
    if (unit == Unit::force || unit == Unit::torque) return 1;
    return length_of_unit(design, unit);
}

/// "is at least 40 deg", for each limit of a requirement.
std::string requirement_name(const Claim& claim, const ClaimedRequirement& r) {
    const Quantity& quantity = quantity_of(claim, r.quantity);
    std::vector<std::string> parts;
    const auto add = [&](std::string_view relation, const std::optional<double>& limit) {
        const std::string label = unit_label(quantity.unit, claim.units);
        if (limit) parts.push_back(fmt::format("{} {}{}{}", relation, *limit, label.empty() ? "" : " ", label));
    };
    add("equals", r.equal);
    add("is at least", r.min);
    add("is at most", r.max);
    return fmt::format("{} {}", quantity.name, joined(parts, " and "));
}

Check check_requirement(const ClaimedRequirement& r, Measurements& measurements) {
    const Rebuilt& design = *measurements.design;
    const Claim& claim = *design.claim;
    const Unit unit = quantity_of(claim, r.quantity).unit;
    Check check{requirement_name(claim, r), false, "it has no value for this design"};
    const auto& again = measurements.of(r.quantity);
    if (!again) return check;
    const auto inside = [&](double number) { return from_document(number, unit, claim.units); };
    std::vector<Digits50> limits;
    Digits50 beyond = 0;
    if (r.equal) beyond = std::max<Digits50>(beyond, abs(again->value - limits.emplace_back(inside(*r.equal))));
    if (r.min) beyond = std::max<Digits50>(beyond, limits.emplace_back(inside(*r.min)) - again->value);
    if (r.max) beyond = std::max<Digits50>(beyond, again->value - limits.emplace_back(inside(*r.max)));
    const Digits50 violation = beyond / violation_scale(design, unit, limits);
    check.passed = violation <= claim.tolerance;
    check.detail = fmt::format("measured again {}, stated {}, relative violation {}, allowed {:.2g}",
                               value_text(again->value, unit, claim.units),
                               r.value ? value_text(inside(*r.value), unit, claim.units) : "nothing",
                               size_text(violation), claim.tolerance);
    return check;
}

/// That a wish is met within its limit, and that the limit is no worse than the wish says, but for the room that
/// searches are given: a millionth of the best and of the longest length.
Check check_wish(const ClaimedWish& wish, Measurements& measurements) {
    const Rebuilt& design = *measurements.design;
    const Claim& claim = *design.claim;
    const Quantity& quantity = quantity_of(claim, wish.quantity);
    Check check{fmt::format("{} is as {} as was wished", quantity.name, wish.maximize ? "great" : "small"), false,
                "it has no value for this design"};
    const auto& again = measurements.of(wish.quantity);
    if (!again) return check;
    check.detail = "the best value and the limit are not stated";
    if (!wish.best || !wish.limit) return check;
    const auto inside = [&](double number) { return from_document(number, quantity.unit, claim.units); };
    const Digits50 sign = wish.maximize ? -1 : 1;
    const Digits50 best = inside(*wish.best), limit = inside(*wish.limit);
    const Digits50 room = sign * (limit - best), beyond = sign * (again->value - limit);
    const Digits50 most = inside(wish.within) + 1e-6 * (abs(best) + violation_scale(design, quantity.unit, {0}));
    check.passed =
        room >= 0 && room <= most && beyond <= claim.tolerance * violation_scale(design, quantity.unit, {limit});
    check.detail =
        fmt::format("measured again {}, the best that was found is {}, allowed is {}",
                    value_text(again->value, quantity.unit, claim.units), value_text(best, quantity.unit, claim.units),
                    value_text(limit, quantity.unit, claim.units));
    return check;
}

/// Whether a stated value is the one measured again; if not, why.
std::string stated_defect(std::size_t quantity, const std::optional<double>& stated, Measurements& measurements) {
    const Claim& claim = *measurements.design->claim;
    const std::string_view name = quantity_of(claim, quantity).name;
    const Unit unit = quantity_of(claim, quantity).unit;
    const auto& again = measurements.of(quantity);
    // What is infinite or no number is not stated.
    if (!again) return stated ? fmt::format("{} is stated as {}, and has no value for this design", name, *stated) : "";
    const std::string measured = value_text(again->value, unit, claim.units);
    if (!stated) return fmt::format("{} is not stated, measured again {}", name, measured);
    const Digits50 value = from_document(*stated, unit, claim.units);
    const Digits50 difference = abs(value - again->value);
    if (difference <= again->slack || difference <= again->slack + measurements.end_rounding(quantity)) return {};
    return fmt::format("{} is stated as {}, measured again {}", name, value_text(value, unit, claim.units), measured);
}

/// How far a requirement is missed, over its greatest limit (1, the longest length or its square where all are 0), and
/// whether it is active: within a millionth of its limit.
std::string standing_defect(const ClaimedRequirement& r, Measurements& measurements) {
    const Rebuilt& design = *measurements.design;
    const Unit unit = quantity_of(*design.claim, r.quantity).unit;
    const auto& again = measurements.of(r.quantity);
    if (!again) return r.violation ? "a violation is stated of what has no value" : "";
    constexpr double active_within = 1e-6, stated_within = 1e-9;
    std::vector<Digits50> limits, shortfalls;
    const auto add = [&](const std::optional<double>& limit, bool below, bool above) {
        if (!limit) return;
        limits.push_back(from_document(*limit, unit, design.claim->units));
        if (below) shortfalls.push_back(limits.back() - again->value);
        if (above) shortfalls.push_back(again->value - limits.back());
    };
    add(r.equal, true, true);
    add(r.min, true, false);
    add(r.max, false, true);
    Digits50 scale = 0, most = shortfalls.front();
    for (const Digits50& limit : limits)
        scale = std::max<Digits50>(scale, abs(limit));
    if (scale == 0) scale = length_of_unit(design, unit);
    for (const Digits50& shortfall : shortfalls)
        most = std::max(most, shortfall);
    const Digits50 violation = std::max<Digits50>(most, 0) / scale;
    if (r.violation && abs(violation - *r.violation) > stated_within + again->slack / scale)
        return fmt::format("its violation is stated as {}, measured again {}", *r.violation, size_text(violation));
    const Digits50 beyond = most / scale + active_within;
    const bool unsure = abs(beyond) <= stated_within + again->slack / scale;
    if (r.active && !unsure && *r.active != (r.equal || beyond >= 0))
        return *r.active ? "it is stated as active, and is not" : "it is active, and not stated so";
    return {};
}

Check stated_check(std::string name, std::vector<std::string> defects) {
    defects.erase(std::remove(defects.begin(), defects.end(), std::string()), defects.end());
    return {std::move(name), defects.empty(),
            defects.empty() ? "measured again to 1e-9 relative, angles to 1e-9 rad" : joined(defects, "; ")};
}

/// The objective in the user's units: the one term; the worst term; or the weighted sum, which is minimised, so that
/// terms to be maximised count negatively.
std::optional<Measured> objective_again(const ClaimedObjective& objective, Measurements& measurements) {
    const Claim& claim = *measurements.design->claim;
    const bool single = objective.terms.size() == 1;
    Measured total{0, 0};
    for (std::size_t i = 0; i < objective.terms.size(); ++i) {
        const ClaimedTerm& term = objective.terms[i];
        const auto& again = measurements.of(term.quantity);
        if (!again) return std::nullopt;
        const Unit unit = quantity_of(claim, term.quantity).unit;
        const Digits50 value = term.weight * in_document(again->value, unit, claim.units);
        const Digits50 slack = std::abs(term.weight) * in_document(again->slack, unit, claim.units);
        if (!single && !objective.worst) {
            total.value += term.maximize ? Digits50(-value) : value;
            total.slack += slack;
        } else if (i == 0 || (term.maximize ? value < total.value : value > total.value)) {
            total = {value, slack};
        }
    }
    return total;
}

Check check_objective(const ClaimedObjective& objective, Measurements& measurements, Stated parts) {
    std::vector<std::string> defects;
    if (objective.terms.size() > 1 && parts == Stated::everything)
        for (const ClaimedTerm& term : objective.terms)
            defects.push_back(stated_defect(term.quantity, term.value, measurements));
    const auto again = objective_again(objective, measurements);
    if (!again || !objective.value) {
        if (again) defects.emplace_back("it is not stated");
        if (objective.value) defects.emplace_back("it is stated, and has no value for this design");
    } else if (!(abs(*objective.value - again->value) <= again->slack)) {
        defects.push_back(fmt::format("it is stated as {:.15g}, measured again {:.15g}", *objective.value,
                                      again->value.convert_to<double>()));
    }
    return stated_check("the objective is as stated", std::move(defects));
}

constexpr std::string_view as_stated = "as stated";

/// What is wrong with a design that is shown for a problem without one that meets its requirements: it has to miss
/// something, and what is stated of it is checked as it is of any other.
std::vector<Check> checks_of_miss(const std::vector<Check>& checks) {
    std::vector<Check> kept{{"the design that is shown misses what is asked for", false, "it meets all of it"}};
    for (const Check& check : checks) {
        if (check.name.ends_with(as_stated))
            kept.push_back(check);
        else if (!check.passed && !kept.front().passed)
            kept.front() = {kept.front().name, true, check.name + ": " + check.detail};
    }
    return kept;
}

/// `parts`: whether everything is stated, or of another design of a result the design and its objective alone.
std::vector<Check> checks_of(const Claim& claim, bool infeasible, Stated parts) {
    std::vector<Check> checks{check_ranges(claim)};
    const Rebuilt design = rebuilt(claim);
    if (claim.kind) checks.push_back(check_kind(design));
    if (claim.circuit) checks.push_back(check_circuit(design));
    checks.insert(checks.end(), design.of_motion.begin(), design.of_motion.end());
    if (!has_its_lengths(claim)) return checks;
    if (ends_by_itself(design) && all_passed(design.of_motion)) checks.push_back(check_whole_motion(design));

    Measurements measurements(design);
    for (const ClaimedRequirement& r : claim.requirements) {
        checks.push_back(check_requirement(r, measurements));
        if (parts == Stated::everything && (!infeasible || r.value))
            checks.push_back(
                stated_check(fmt::format("{} is as stated", quantity_of(claim, r.quantity).name),
                             {stated_defect(r.quantity, r.value, measurements), standing_defect(r, measurements)}));
    }
    if (claim.objective && (!infeasible || claim.objective->value))
        checks.push_back(check_objective(*claim.objective, measurements, parts));
    else if (claim.objective && !objective_again(*claim.objective, measurements))
        checks.push_back({"the objective has a value", false, "it has none for this design"});
    for (const ClaimedWish& wish : claim.wishes) {
        if (infeasible && !wish.best) continue;
        checks.push_back(check_wish(wish, measurements));
        if (parts == Stated::everything)
            checks.push_back(stated_check(fmt::format("{} is as stated", quantity_of(claim, wish.quantity).name),
                                          {stated_defect(wish.quantity, wish.value, measurements)}));
    }
    if (!claim.quantities.empty()) {
        std::vector<std::string> defects;
        for (const auto& [quantity, value] : claim.quantities)
            defects.push_back(stated_defect(quantity, value, measurements));
        checks.push_back(stated_check("all listed quantities are as stated", std::move(defects)));
    }
    if (claim.function && !claim.function->accuracy_points.empty()) checks.push_back(check_accuracy_points(design));
    if (must_turn_fully(claim)) checks.push_back(check_full_turn(design));
    if (claim.use) checks.push_back(check_range_of_use(design, parts));
    if (claim.path)
        for (Check& check : check_path(design, parts))
            checks.push_back(std::move(check));
    return checks;
}

}  // namespace

namespace {

/// The checks that a function makes; one that fails where it cannot be carried out.
template <class Checks>
std::vector<Check> guarded(const Checks& checks) {
    try {
        return checks();
    } catch (const std::bad_alloc&) {
        throw;  // says nothing about the document
    } catch (const std::exception&) {
        // The words of a library say nothing of the document.
        return {{"every claim can be computed again", false, "the numbers of the document are beyond what can be"}};
    }
}

}  // namespace

std::vector<Check> verify_design(const nlohmann::ordered_json& document, Stated parts) {
    return guarded([&]() -> std::vector<Check> {
        const bool infeasible = says_infeasible(document);
        const auto [claim, defect] = read_claim(with_some_design(document));
        if (!defect.empty()) return {{"the document can be understood", false, defect}};
        if (!infeasible) return checks_of(claim, false, parts);
        return document.contains("design") ? checks_of_miss(checks_of(claim, true, parts)) : std::vector<Check>{};
    });
}

std::vector<Check> verify(const nlohmann::ordered_json& document) {
    return guarded([&] {
        std::vector<Check> checks = verify_design(document, Stated::everything);
        if (checks.size() == 1 && !checks.front().passed) return checks;  // it is not understood
        for (const auto& more :
             {check_proof(document), check_derived(document), check_asked(document), check_others(document)})
            checks.insert(checks.end(), more.begin(), more.end());
        if (checks.empty()) checks.push_back({"nothing is claimed but that no design was found", true, ""});
        const std::vector<Check> said = check_verdict(document, checks);
        checks.insert(checks.end(), said.begin(), said.end());
        return checks;
    });
}

}  // namespace mechwright
