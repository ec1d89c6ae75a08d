#include "synthesis/program/choices.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>

#include "analysis/numbers/low_discrepancy.h"
namespace mechwright {

namespace {

using Choice = std::vector<std::size_t>;

constexpr std::size_t most_ways = 64;
/// Designs that are drawn, and the span of their lengths as a part of the greatest.
constexpr std::uint64_t drawn = 2000;
constexpr double least_part = 1e-2;

/// The ways to choose, as far as they can be counted.
std::size_t ways(const std::vector<Disjunction>& all) {
    constexpr std::size_t uncounted = std::size_t{1} << 40;
    std::size_t count = 1;
    for (const Disjunction& d : all)
        count = std::min(uncounted, count * d.components);
    return count;
}

/// One of them by its number; the last disjunction changes first.
Choice numbered(const std::vector<Disjunction>& all, std::size_t number) {
    Choice choice(all.size());
    for (std::size_t i = all.size(); i-- > 0; number /= all[i].components)
        choice[i] = number % all[i].components;
    return choice;
}

double drawn_value(const Variable& variable, double part) {
    if (!std::isfinite(variable.lower) || !std::isfinite(variable.upper)) return 0;
    if (variable.lower < 0) return std::lerp(variable.lower, variable.upper, part);
    const double low = std::max(variable.lower, least_part * variable.upper);
    return low * std::pow(variable.upper / low, part);
}

bool meets_conditions(const Program& program, const Eigen::VectorXd& x) {
    return std::all_of(program.rows.begin(), program.rows.end(), [&](const Row& row) {
        if (!row.form.outputs.empty() || row.requirement) return true;
        double value = row.form.constant;
        for (const LinearTerm& t : row.form.variables)
            value += t.factor * x[static_cast<Eigen::Index>(t.index)];
        return value >= row.lower && value <= row.upper;
    });
}

/// The component of each disjunction that is the extreme one of a design.
Choice extreme_components(const Program& program, const std::vector<Disjunction>& all, const Eigen::VectorXd& outputs) {
    Choice choice;
    for (const Disjunction& d : all) {
        const Quantity& quantity = programmed_quantity(*program.problem, d.quantity);
        const auto block = std::find_if(program.blocks.begin(), program.blocks.end(),
                                        [&](const QuantityBlock& b) { return b.quantity == &quantity; });
        if (block == program.blocks.end()) return {};
        const double* const first = outputs.data() + block->first;
        const double* const last = first + std::min(d.components, block->count);
        const double* const at =
            quantity.reduce == Reduce::least ? std::min_element(first, last) : std::max_element(first, last);
        choice.push_back(static_cast<std::size_t>(at - first));
    }
    return choice;
}

/// How often drawn designs have their extremes in each way.
std::map<Choice, int> counted_choices(const Problem& problem, const std::vector<Disjunction>& all, std::size_t family,
                                      std::size_t assembly) {
    const Program program = build_program(problem, {family, assembly, 1, Choice(all.size(), 0)});
    const LowDiscrepancy sequence(program.size(), 1, 0);
    Eigen::VectorXd x(static_cast<Eigen::Index>(program.size()));
    RowsBesidePath values;
    std::map<Choice, int> counts;
    for (std::uint64_t k = 0; k < drawn; ++k) {
        for (std::size_t i = 0; i < program.size(); ++i)
            x[static_cast<Eigen::Index>(i)] = drawn_value(program.variables[i], sequence(k, i));
        if (!meets_conditions(program, x)) continue;
        evaluate_beside_path(program, {}, x, false, values);
        if (!values.outputs.assembled) continue;
        if (Choice choice = extreme_components(program, all, values.outputs.value); !choice.empty())
            ++counts[std::move(choice)];
    }
    return counts;
}

}  // namespace

std::vector<std::vector<std::size_t>> choices_of_components(const Problem& problem, std::size_t family,
                                                            std::size_t assembly) {
    const std::vector<Disjunction> all = disjunctions(problem, motion_of(problem, family, assembly));
    const std::size_t count = ways(all);
    std::vector<Choice> chosen;
    if (count > most_ways) {
        const std::map<Choice, int> counts = counted_choices(problem, all, family, assembly);
        std::vector<std::pair<Choice, int>> by_count(counts.begin(), counts.end());
        std::stable_sort(by_count.begin(), by_count.end(),
                         [](const auto& a, const auto& b) { return a.second > b.second; });
        for (std::size_t i = 0; i < std::min(most_ways, by_count.size()); ++i)
            chosen.push_back(by_count[i].first);
    }
    const std::size_t room = std::min(count, most_ways) - chosen.size();
    for (std::size_t i = 0; i < room; ++i) {
        Choice choice = numbered(all, i * count / room);
        if (std::find(chosen.begin(), chosen.end(), choice) == chosen.end()) chosen.push_back(std::move(choice));
    }
    return chosen;
}

std::optional<Variant> without_choices(const Problem& problem, const Variant& variant) {
    const std::vector<Disjunction> all = disjunctions(problem, motion_of(problem, variant.family, variant.assembly));
    if (std::none_of(all.begin(), all.end(), [](const Disjunction& d) { return d.required; })) return std::nullopt;
    Variant open = variant;
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].required) open.choices[i] = no_component;
    return open;
}

Variant with_choices_at(const Program& program, const Eigen::VectorXd& x) {
    const Problem& problem = *program.problem;
    Variant variant = program.variant;
    const std::vector<Disjunction> all = disjunctions(problem, motion_of(problem, variant.family, variant.assembly));
    RowsBesidePath values;
    evaluate_beside_path(program, {}, x, false, values);
    const Choice at = values.outputs.assembled ? extreme_components(program, all, values.outputs.value) : Choice{};
    for (std::size_t i = 0; i < at.size(); ++i)
        if (all[i].required) variant.choices[i] = at[i];
    return variant;
}

}  // namespace mechwright
