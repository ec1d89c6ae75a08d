#include "synthesis/report/text/sections.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/document/document.h"
#include "synthesis/document/kinds_in_documents.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/standing.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

constexpr std::size_t longest_title = 400;
constexpr int digits_of_what_is_given = 6;

/// What there is to say of a dimension beside its value. `size` is what is great in its unit.
std::string remark_on(const DimensionRange& range, double value, double size, Unit unit, const Units& units) {
    if (range.tied()) return "tied";
    if (range.fixed()) return range.named ? "given" : "";
    if (!range.choices.empty()) return fmt::format("one of {} choices", range.choices.size());
    if (range.step > 0) return fmt::format("in steps of {}", number_text(in_file_unit(range.step, unit, units)));
    constexpr double at_limit_within = 1e-6;
    // A limit that is far away is no measure: a range may go on to where nobody looks.
    const double scale = std::min(size, range.max - range.min);
    const auto is_at = [&](double limit) {
        return std::abs(value - limit) <= at_limit_within * std::max(std::abs(limit), scale);
    };
    if (is_at(range.min)) return "at its lower limit " + number_text(in_file_unit(range.min, unit, units));
    if (is_at(range.max)) return "at its upper limit " + number_text(in_file_unit(range.max, unit, units));
    return {};
}

/// A line of the requirement table. `shortfall` is positive where the limit is missed.
std::vector<std::string> requirement_row(const Problem& problem, const Quantity& quantity, const Design& design,
                                         const Standing& standing, std::string_view relation, double limit,
                                         double shortfall, int digits) {
    const auto outside = [&](double x) { return in_file_unit(x, quantity.unit, problem.units); };
    std::string judgement;
    if (!standing.value)
        judgement = "not defined";
    else if (shortfall > standing.allowed)
        judgement = "missed by " + rounded_text(outside(shortfall), usual_digits);
    else if (relation == "=")
        judgement = "met";
    else if (is_active(shortfall, standing))
        judgement = "met, at its limit";
    else
        judgement = "met, " + rounded_text(outside(-shortfall), usual_digits) + " to spare";
    return {std::string(quantity.name),
            std::string(relation),
            rounded_text(outside(limit), std::max(digits, digits_of_what_is_given)),
            standing.value ? quantity_text(*standing.value, quantity.unit, problem, design, digits) : "",
            unit_label(quantity.unit, problem.units),
            judgement};
}

}  // namespace

std::string heading(std::string_view text, const TextStyle& style) {
    return fmt::format("\n{}\n", emphasised(text, Emphasis::strong, style.colour));
}

std::string given_with_unit(double value, Unit unit, const Units& units) {
    const std::string label = unit_label(unit, units);
    const std::string number = number_text(in_file_unit(value, unit, units), digits_of_what_is_given);
    return label.empty() ? number : number + " " + label;
}

std::string title_section(const Problem& problem, const TextStyle& style) {
    const std::string file = reading::printable(problem.file, longest_title);
    const std::string from = fmt::format("{} from {}\n", problem.mechanism->name, file);
    if (problem.title.empty()) return emphasised(from, Emphasis::strong, style.colour);
    const std::string title = folded("", reading::printable(problem.title, longest_title));
    return emphasised(std::string_view(title).substr(0, title.size() - 1), Emphasis::strong, style.colour) + "\n" +
           from;
}

std::string design_section(const Problem& problem, const Design& design, const TextStyle& style) {
    const Mechanism& mechanism = *problem.mechanism;
    Table table{{Align::left, Align::point, Align::left, Align::left}, {}};
    const std::vector<std::string> values = dimension_texts(problem, design, style.digits);
    double longest = 0;
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i)
        if (unit_of(mechanism.dimensions[i].kind) == Unit::length)
            longest = std::max(longest, std::abs(design.dimensions[i]));
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i) {
        const Dimension& dimension = mechanism.dimensions[i];
        const double value = design.dimensions[i];
        if (!dimension.required && !problem.dimensions[i].named && value == 0) continue;
        const Unit unit = unit_of(dimension.kind);
        table.rows.push_back(
            {std::string(dimension.name), values[i], unit_label(unit, problem.units),
             remark_on(problem.dimensions[i], value, unit == Unit::length ? longest : 1, unit, problem.units)});
    }
    std::string kind = mechanism.describe(mechanism.form(0), design.dimensions);
    if (!mechanism.assemblies.empty()) kind += fmt::format(", {} assembly", mechanism.assemblies[design.assembly]);
    std::string text = heading("Design: " + kind, style) + to_text(table, 2);
    if (const KindInDocuments* own = kind_in_documents(mechanism))
        text += folded("  ", own->choices_text(problem, design.assembly));
    return text;
}

std::string wishes_section(const Problem& problem, const Solution& solution, const TextStyle& style) {
    if (problem.wishes.empty()) return {};
    Table table{{Align::left, Align::left, Align::point, Align::left, Align::point, Align::point},
                {{"", "", "reached", "", "best", "allowed"}}};
    for (std::size_t i = 0; i < problem.wishes.size(); ++i) {
        const ObjectiveTerm& term = problem.wishes[i].term;
        const Quantity& quantity = problem.mechanism->quantities[term.quantity];
        const auto outside = [&](double x) {
            return quantity_text(x, quantity.unit, problem, solution.design, style.digits);
        };
        const std::optional<double> value = quantity_value(problem, term.quantity, solution.design);
        const bool known = i < solution.wished.size();
        table.rows.push_back({term.maximize ? "maximize" : "minimize", std::string(quantity.name),
                              value ? outside(*value) : "not defined", unit_label(quantity.unit, problem.units),
                              known ? outside(solution.wished[i].best) : "",
                              known ? outside(solution.wished[i].limit) : ""});
    }
    return heading("First, in this order", style) + to_text(table, 2);
}

std::string objective_section(const Problem& problem, const Solution& solution, const TextStyle& style) {
    if (!problem.objective) return {};
    const Objective& objective = *problem.objective;
    const auto sense = [](const ObjectiveTerm& term) { return term.maximize ? "maximize" : "minimize"; };
    if (objective.terms.size() == 1) {
        const ObjectiveTerm& term = objective.terms.front();
        const Quantity& quantity = problem.mechanism->quantities[term.quantity];
        const std::string value = objective_with_unit(problem, solution, style.digits);
        return heading(fmt::format("Objective: {} {}", sense(term), quantity.name), style) + "  " + value + "\n";
    }
    Table table{{Align::left, Align::left, Align::point, Align::left, Align::left}, {}};
    for (const ObjectiveTerm& term : objective.terms) {
        const Quantity& quantity = problem.mechanism->quantities[term.quantity];
        const std::optional<double> value = quantity_value(problem, term.quantity, solution.design);
        table.rows.push_back(
            {sense(term), std::string(quantity.name),
             value ? quantity_text(*value, quantity.unit, problem, solution.design, style.digits) : "not defined",
             unit_label(quantity.unit, problem.units),
             term.weight == 1 ? "" : "weight " + number_text(term.weight, digits_of_what_is_given)});
    }
    const std::string value = objective_with_unit(problem, solution, style.digits);
    return heading(objective.worst ? "Objective: the worst of several" : "Objective: a weighted sum", style) +
           to_text(table, 2) + (objective.worst ? "  worst: " : "  sum: ") + value + "\n";
}

std::string requirement_section(const Problem& problem, const Design& design, const TextStyle& style) {
    if (problem.requirements.empty()) return {};
    Table table{{Align::left, Align::left, Align::point, Align::point, Align::left, Align::left}, {}};
    table.rows.push_back({"", "", "required", "reached", "", ""});
    for (const Requirement& requirement : problem.requirements) {
        const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
        const Standing standing = standing_of(problem, requirement, design);
        const double reached = standing.value.value_or(0);
        const auto add = [&](std::string_view relation, double limit, double shortfall) {
            table.rows.push_back(
                requirement_row(problem, quantity, design, standing, relation, limit, shortfall, style.digits));
        };
        if (requirement.equal) add("=", *requirement.equal, std::abs(reached - *requirement.equal));
        if (requirement.min) add(">=", *requirement.min, *requirement.min - reached);
        if (requirement.max) add("<=", *requirement.max, reached - *requirement.max);
    }
    return heading("Requirements", style) + to_text(table, 2);
}

std::string words_of_use(const Problem& problem) {
    const auto beyond = [&](double margin, std::string_view which) {
        return margin > 0 ? fmt::format("{} {} the ",
                                        given_with_unit(margin, input_unit(*problem.mechanism), problem.units), which)
                          : "the ";
    };
    return fmt::format(
        "from {}first target to {}last. Quantities are over it, and NAME{} is NAME over the whole motion.",
        beyond(problem.use->before, "before"), beyond(problem.use->after, "after"), whole_suffix);
}

std::string quantity_section(const Problem& problem, const Design& design, const TextStyle& style) {
    Table table{{Align::left, Align::point, Align::left}, {}};
    QuantityValues values(problem, design);
    for (std::size_t i = 0; i < problem.mechanism->quantities.size(); ++i) {
        const Quantity& quantity = problem.mechanism->quantities[i];
        if (const std::optional<double> value = values[i])
            table.rows.push_back({std::string(quantity.name),
                                  quantity_text(*value, quantity.unit, problem, design, style.digits),
                                  unit_label(quantity.unit, problem.units)});
    }
    if (table.rows.empty()) return {};
    return heading("Quantities", style) + to_text(table, 2);
}

std::string verification_section(const std::vector<Check>& checks, const TextStyle& style) {
    if (checks.empty()) return {};
    const auto failed = std::count_if(checks.begin(), checks.end(), [](const Check& c) { return !c.passed; });
    if (failed == 0)
        return fmt::format(
            "\nVerification: {} by recomputing in fifty digits.\n",
            checks.size() == 1 ? "the one check passed" : fmt::format("all {} checks passed", checks.size()));
    std::string text = heading(fmt::format("Verification: {} of {} checks FAILED", failed, checks.size()), style);
    for (const Check& check : checks)
        if (!check.passed)
            text += folded("  " + emphasised("failed", Emphasis::bad, style.colour) + "  ",
                           check.name + (check.detail.empty() ? "" : ": " + check.detail));
    return text;
}

}  // namespace mechwright
