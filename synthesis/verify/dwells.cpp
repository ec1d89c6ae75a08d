#include "synthesis/verify/dwells.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "synthesis/document/claimed_problem.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/mechanism/linkage/dwell.h"
#include "synthesis/program/alternation/dwell_alternation.h"
#include "synthesis/verify/rebuilt.h"
#include "synthesis/verify/slopes_again.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t most_extremes_of_dwell = 40;  // in a document
constexpr double dwell_independent_beyond = 1e-7, dwell_doubtful = 30;

/// A dwell of the claimed design in fifty digits.
struct Dwell {
    const Claim& claim;
    const Quantity& quantity;
    Rebuilt design;
    Motion motion;
    std::vector<DwellExtremeAgain> extremes;
    Digits50 middle = 0, farthest = 0;

    Dwell(const Claim& c, const Quantity& q)
        : claim(c),
          quantity(q),
          design(rebuilt(c)),
          motion(motion_of(design, q)),
          extremes(dwell_extremes_again(q, motion, design.dimensions)) {
        if (extremes.empty()) return;
        const auto [least, greatest] = std::minmax_element(
            extremes.begin(), extremes.end(), [](const auto& a, const auto& b) { return a.value < b.value; });
        middle = (least->value + greatest->value) / 2;
        farthest = (greatest->value - least->value) / 2;
    }

    Unit of_input() const { return input_unit(*claim.mechanism); }
    double place(const DwellExtremeAgain& e) const {
        return in_document(e.input, of_input(), claim.units).convert_to<double>();
    }
    /// What a stated value is off by rounding of the dimensions and of itself.
    Digits50 rounding() const {
        const Digits50 size = quantity.unit == Unit::angle ? Digits50(1) : design.longest;
        return 8 * std::numeric_limits<double>::epsilon() * (size + abs(middle));
    }
};

bool is_number(const Json& one, const char* name) {
    return one.is_object() && one.contains(name) && one[name].is_number();
}

/// Why a list of extremes is not that of the design; empty if it is. Ripples that are nothing but rounding may be
/// listed or not.
std::string extremes_defect(const Json& stated, const Dwell& dwell) {
    constexpr double place_within = 1e-5, off_within = 1e-7;
    const Units& units = dwell.claim.units;
    const double first = dwell.place(dwell.extremes.front()), last = dwell.place(dwell.extremes.back());
    const Digits50 room = off_within * dwell.farthest + dwell.rounding();
    if (!stated.is_array()) return "they are no list";
    std::vector<bool> listed(dwell.extremes.size(), false);
    double before = -std::numeric_limits<double>::infinity();
    for (const Json& one : stated) {
        if (!is_number(one, "input") || !is_number(one, "value") || !is_number(one, "off"))
            return one.dump() + " is no extreme";
        const double input = one["input"].get<double>();
        const Digits50 value = from_document(one["value"].get<double>(), dwell.quantity.unit, units),
                       off = from_document(one["off"].get<double>(), dwell.quantity.unit, units);
        bool known = false;
        for (std::size_t i = 0; i < dwell.extremes.size(); ++i) {
            const DwellExtremeAgain& e = dwell.extremes[i];
            const bool here = std::abs(dwell.place(e) - input) <= place_within * (last - first) &&
                              abs(e.value - value) <= room && abs(e.value - dwell.middle - off) <= room;
            if (here) known = listed[i] = true;
        }
        if (!known) return fmt::format("there is none at {} of {}", input, one["value"].dump());
        if (!(input > before)) return "they are not in order";
        before = input;
    }
    for (std::size_t i = 0; i < listed.size() && stated.size() < most_extremes_of_dwell; ++i) {
        const bool ripple =
            i > 0 && i + 1 < listed.size() && abs(dwell.extremes[i].value - dwell.extremes[i - 1].value) <= room;
        if (!listed[i] && !ripple) return fmt::format("that at {} is not stated", dwell.place(dwell.extremes[i]));
    }
    return {};
}

/// Those as far from the middle as the farthest, the first of each run on one side.
std::vector<DwellExtremeAgain> alternating(const Dwell& dwell) {
    std::vector<DwellExtremeAgain> kept;
    for (const DwellExtremeAgain& e : dwell.extremes) {
        const Digits50 off = e.value - dwell.middle;
        if (abs(off) < (1 - as_far_within) * dwell.farthest - dwell.rounding()) continue;
        if (kept.empty() || (kept.back().value - dwell.middle) * off < 0) kept.push_back(e);
    }
    return kept;
}

/// How the signal at some inputs, less its middle, changes: [input][open dimension, then the middle].
std::vector<RowAgain> slopes(const Dwell& dwell, const std::vector<double>& inputs) {
    std::vector<RowAgain> rows = slopes_again(dwell.design, [&](const std::vector<Digits50>& dimensions) {
        return dwell_again(dwell.quantity, dwell.motion, dimensions, inputs);
    });
    rows.resize(inputs.size());
    for (RowAgain& row : rows)
        row.push_back(-1);
    return rows;
}

/// All along the stretch.
std::vector<RowAgain> sampled_slopes(const Dwell& dwell) {
    constexpr int places = 24;
    const Vector<double> stretch = dwell_stretch(dwell.quantity, dwell.motion);
    std::vector<double> inputs;
    for (int i = 0; i < places; ++i)
        inputs.push_back(stretch.x + (stretch.y - stretch.x) * i / (places - 1));
    return slopes(dwell, inputs);
}

/// The limits that hold the design: how many, and as rows that must not grow, where each has one.
struct Held {
    std::size_t count = 0;
    std::vector<RowAgain> rows{};
    std::vector<bool> equality{};
    std::string unknown{};  ///< why some have no row
};

void add_requirement(const Dwell& dwell, const ClaimedRequirement& requirement, Held& held) {
    constexpr double smooth_within = 1e-9;
    const Quantity& quantity = dwell.claim.mechanism->quantities[requirement.quantity];
    if (quantity.measure_again == nullptr) {
        held.unknown = quantity.name + " has no slope by itself";
        return;
    }
    const Motion motion = motion_of(dwell.design, quantity);
    Digits50 sides = 0;
    std::vector<RowAgain> rows = slopes_again(
        dwell.design,
        [&](const std::vector<Digits50>& dimensions) {
            return std::vector<Digits50>{measure_again(quantity, motion, dimensions)};
        },
        &sides);
    if (rows.size() != 1 || !(sides <= smooth_within)) {
        held.unknown = quantity.name + " has a corner";
        return;
    }
    // Of two limits it stands at the nearer one.
    const double value = requirement.value.value_or(0);
    const bool at_least = requirement.min &&
                          (!requirement.max || std::abs(value - *requirement.min) < std::abs(value - *requirement.max));
    for (Digits50& slope : rows[0])
        if (at_least && !requirement.equal) slope = -slope;
    rows[0].push_back(0);
    held.rows.push_back(rows[0]);
    held.equality.push_back(requirement.equal.has_value());
}

Held held_by(const Dwell& dwell, const ClaimedDesign& claimed, bool with_rows) {
    Held held;
    for (const ClaimedRequirement& requirement : dwell.claim.requirements) {
        if (!requirement.active.value_or(requirement.equal.has_value())) continue;
        ++held.count;
        if (with_rows) add_requirement(dwell, requirement, held);
    }
    const std::vector<std::size_t> open = open_dimensions(dwell.claim);
    for (std::size_t i = 0; i < open.size(); ++i) {
        const int end = end_of_range(claimed.problem, claimed.design, open[i]);
        if (end == 0) continue;
        ++held.count;
        held.rows.emplace_back(open.size() + 1, Digits50(0));
        held.rows.back()[i] = end;
        held.equality.push_back(false);
    }
    return held;
}

/// Why the extremes do not balance with the limits; empty if they do, and `detail` then says which.
std::string balance_defect(const Dwell& dwell, const std::vector<DwellExtremeAgain>& equal, const Held& held,
                           std::vector<RowAgain> all, std::string& detail) {
    if (!held.unknown.empty()) return held.unknown;
    all.insert(all.end(), held.rows.begin(), held.rows.end());
    scale_columns(all);
    const std::vector<std::size_t> columns = independent_columns(all, dwell_independent_beyond);
    const std::size_t limits = held.rows.size();
    if (columns.size() + 1 <= limits) return "there are more limits than free numbers";
    const std::size_t needed = columns.size() + 1 - limits;
    std::vector<double> inputs;
    for (const DwellExtremeAgain& e : equal)
        inputs.push_back(e.input.convert_to<double>());
    std::vector<RowAgain> extremes = slopes(dwell, inputs);
    for (std::size_t i = 0; i < extremes.size(); ++i)
        for (Digits50& slope : extremes[i])
            if (equal[i].value < dwell.middle) slope = -slope;
    for (std::size_t first = 0; first + needed <= extremes.size(); ++first) {
        std::vector<RowAgain> rows(extremes.begin() + static_cast<std::ptrdiff_t>(first),
                                   extremes.begin() + static_cast<std::ptrdiff_t>(first + needed));
        rows.insert(rows.end(), held.rows.begin(), held.rows.end());
        rows = in_columns(rows, columns);
        scale_columns(rows);
        std::vector<bool> equality(needed, false);
        equality.insert(equality.end(), held.equality.begin(), held.equality.end());
        if (!balances(rows, equality)) continue;
        detail = fmt::format("{} extremes and {} limits balance in {} free numbers, with weights above 0", needed,
                             limits, columns.size());
        return {};
    }
    return "the extremes do not balance";
}

/// Of a signal that stands still but for rounding neither places nor their number mean anything.
bool is_rounding(const Dwell& dwell) {
    constexpr double zero_within = 1e-11;
    return dwell.farthest < zero_within * (dwell.quantity.unit == Unit::angle ? Digits50(1) : dwell.design.longest);
}
bool is_stated_as_rounding(const Json& extremes) {
    return extremes.is_array() && std::all_of(extremes.begin(), extremes.end(), [](const Json& e) {
               return is_number(e, "off") && std::abs(e["off"].get<double>()) <= 1e-8;
           });
}

std::vector<Check> check_dwell(const Json& stated, const Claim& claim, const Quantity& quantity) {
    Check check{fmt::format("extremes of {} are as stated", quantity.name), false, {}};
    const Dwell dwell(claim, quantity);
    if (!all_passed(dwell.design.of_motion)) return {};
    if (dwell.extremes.empty()) return check.detail = "the signal has none", std::vector{check};
    if (is_rounding(dwell)) {
        check.passed = is_stated_as_rounding(stated.value("extremes", Json()));
        check.detail =
            check.passed ? "the signal moves by rounding alone" : "it moves by rounding, and is not stated so";
        return {check};
    }
    const ClaimedDesign claimed = claimed_design(claim);
    const bool balanced = stated.value("balanced", Json()) == true;
    check.detail = extremes_defect(stated.value("extremes", Json()), dwell);
    const auto expect = [&](const char* name, std::size_t least, std::size_t most) {
        const Json number = stated.value(name, Json());
        if (check.detail.empty() && !(number.is_number() && number >= least && number <= most))
            check.detail = fmt::format("{} is stated as {}, it is {}", name, number.dump(), most);
    };
    const auto equal = alternating(dwell);
    const Held held = held_by(dwell, claimed, balanced);
    std::vector<RowAgain> samples = sampled_slopes(dwell), scaled = samples;
    scale_columns(scaled);
    expect("alternating", equal.size(), equal.size());
    expect("free", independent_columns(scaled, dwell_independent_beyond * dwell_doubtful).size(),
           independent_columns(scaled, dwell_independent_beyond / dwell_doubtful).size());
    expect("held", held.count, held.count);
    const Json middle = stated.value("middle", Json());
    if (check.detail.empty() &&
        !(middle.is_number() && abs(from_document(middle.get<double>(), quantity.unit, claim.units) - dwell.middle) <=
                                    1e-7 * dwell.farthest + dwell.rounding()))
        check.detail = fmt::format("the middle is stated as {}, it is {}", middle.dump(),
                                   value_text(dwell.middle, quantity.unit, claim.units));
    check.passed = check.detail.empty();
    if (!check.passed) return {check};
    check.detail = fmt::format("{} extremes derived again in fifty digits, {} of them alternate", dwell.extremes.size(),
                               equal.size());
    if (!balanced) return {check};
    Check balance{"alternation shows that no design near is as still, to first order", false, {}};
    const std::string defect = balance_defect(dwell, equal, held, std::move(samples), balance.detail);
    balance.passed = defect.empty();
    if (!balance.passed) balance.detail = defect;
    return {check, balance};
}

}  // namespace

std::vector<Check> check_dwells(const Json& stated, const Claim& claim) {
    const auto fault = [](std::string why) {
        return std::vector{Check{"dwells are those that are to be still", false, std::move(why)}};
    };
    if (!stated.is_array() || !claim.objective) return fault("nothing is to be still");
    std::vector<Check> checks;
    for (const Json& one : stated) {
        const auto is_it = [&](const ClaimedTerm& term) {
            const Quantity& quantity = claim.mechanism->quantities[term.quantity];
            return one.is_object() && !term.maximize && is_of_dwell(quantity) &&
                   one.value("quantity", Json()) == quantity.name;
        };
        const auto& terms = claim.objective->terms;
        const auto term = std::find_if(terms.begin(), terms.end(), is_it);
        if (term == terms.end()) return fault(one.dump() + " is not of the objective");
        for (Check& check : check_dwell(one, claim, claim.mechanism->quantities[term->quantity]))
            checks.push_back(std::move(check));
    }
    return checks;
}

}  // namespace mechwright
