#include "synthesis/report/text/numbers.h"

#include <algorithm>
#include <cmath>

#include "synthesis/problem/units.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

constexpr double rounding = 1e-12;  // some thousand times that of a double: what is left of sums that cancel

double longest_length(const Problem& problem, const Design& design) {
    double longest = 0;
    const auto& dimensions = problem.mechanism->dimensions;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (unit_of(dimensions[i].kind) == Unit::length) longest = std::max(longest, std::abs(design.dimensions[i]));
    return longest;
}

/// What values of this unit are small beside; 0 where the design does not say.
double scale_of(Unit unit, const Problem& problem, const Design& design) {
    switch (unit) {
        case Unit::none:
        case Unit::angle: return 1;
        case Unit::length: return longest_length(problem, design);
        case Unit::area: return std::pow(longest_length(problem, design), 2);
        case Unit::curvature: return 1 / longest_length(problem, design);
        case Unit::force:
        case Unit::torque:
        case Unit::rate: return 0;
    }
    return 0;
}

/// Of an objective with one term the unit of its quantity.
Unit objective_unit(const Problem& problem) {
    const auto& terms = problem.objective->terms;
    return terms.size() == 1 ? problem.mechanism->quantities[terms.front().quantity].unit : Unit::none;
}

/// Digits before the point, negative for the zeros after it: 3 for 100, 0 for 0.5, -1 for 0.05.
int digits_before_point(double value) { return 1 + static_cast<int>(std::floor(std::log10(value))); }

std::size_t zeros_at_end(const std::string& text) { return text.size() - 1 - text.find_last_not_of('0'); }

/// Numbers of one column with so many digits after the point, but none that are 0 in all.
std::vector<std::string> column(const std::vector<double>& values, int decimals) {
    std::vector<std::string> texts;
    std::size_t needless = static_cast<std::size_t>(decimals);
    const double smallest_shown = std::pow(10.0, 1 - decimals);
    for (const double value : values) {
        const bool small = value != 0 && std::abs(value) < smallest_shown;
        texts.push_back(small ? number_text(value, 2) : fixed_text(value, decimals));
        if (!small) needless = std::min(needless, zeros_at_end(texts.back()));
    }
    if (decimals == 0) return texts;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (values[i] == 0 || std::abs(values[i]) >= smallest_shown)
            texts[i].resize(texts[i].size() - needless - (needless == static_cast<std::size_t>(decimals) ? 1 : 0));
    return texts;
}

/// How many digits after the point a column of dimensions has; negative where its numbers are too large or too small to
/// be written out.
int decimals_of(Unit unit, const Problem& problem, const Design& design, int digits) {
    if (unit == Unit::angle) return problem.units.degrees ? std::max(digits - 2, 1) : digits;
    const double longest = longest_length(problem, design);
    if (unit != Unit::length || !(longest > 1e-9 && longest < 1e9)) return -1;
    return std::max(0, digits + 1 - digits_before_point(longest));
}

}  // namespace

std::string rounded_text(double value, int digits) {
    constexpr double ten_millions = 1e7;
    const double size = std::abs(value);
    if (size >= 1 && size < ten_millions && digits_before_point(size) > digits) return fixed_text(value, 0);
    return number_text(value, digits);
}

std::string quantity_text(double value, Unit unit, const Problem& problem, const Design& design, int digits) {
    if (std::abs(value) < rounding * scale_of(unit, problem, design)) return "0";
    return rounded_text(in_file_unit(value, unit, problem.units), digits);
}

std::string quantity_with_unit(double value, Unit unit, const Problem& problem, const Design& design, int digits) {
    const std::string label = unit_label(unit, problem.units);
    return quantity_text(value, unit, problem, design, digits) + (label.empty() ? "" : " " + label);
}

std::string objective_text(const Problem& problem, const Solution& solution, int digits) {
    if (!std::isfinite(solution.objective)) return "not defined";
    if (problem.objective->terms.size() > 1) return rounded_text(solution.objective, digits);
    const Unit unit = objective_unit(problem);
    const double least =
        rounding * scale_of(unit, problem, solution.design) * file_units_per_inner(unit, problem.units);
    return std::abs(solution.objective) < least ? "0" : rounded_text(solution.objective, digits);
}

std::string objective_with_unit(const Problem& problem, const Solution& solution, int digits) {
    const std::string label = unit_label(objective_unit(problem), problem.units);
    const std::string text = objective_text(problem, solution, digits);
    return label.empty() || !std::isfinite(solution.objective) ? text : text + " " + label;
}

std::vector<std::string> dimension_texts(const Problem& problem, const Design& design, int digits) {
    const auto& dimensions = problem.mechanism->dimensions;
    std::vector<std::string> texts(dimensions.size());
    for (const Unit unit : {Unit::length, Unit::angle}) {
        const int decimals = decimals_of(unit, problem, design, digits);
        if (decimals < 0) continue;
        std::vector<std::size_t> places;
        std::vector<double> values;
        for (std::size_t i = 0; i < dimensions.size(); ++i) {
            if (unit_of(dimensions[i].kind) != unit) continue;
            const double value = design.dimensions[i];
            const bool nothing = std::abs(value) < rounding * scale_of(unit, problem, design);
            places.push_back(i);
            values.push_back(nothing ? 0 : in_file_unit(value, unit, problem.units));
        }
        const std::vector<std::string> shown = column(values, decimals);
        for (std::size_t i = 0; i < places.size(); ++i)
            texts[places[i]] = shown[i];
    }
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (texts[i].empty())
            texts[i] = rounded_text(in_file_unit(design.dimensions[i], unit_of(dimensions[i].kind), problem.units),
                                    digits + 1);
    return texts;
}

}  // namespace mechwright
