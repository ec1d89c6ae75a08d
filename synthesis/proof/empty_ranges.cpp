#include "synthesis/proof/empty_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

/// Whether sum of coefficient times dimension >= 0 is out of reach of the ranges, by more than their tolerance.
bool out_of_reach(const Problem& problem, std::span<const double> coefficients) {
    std::vector<double> whole(problem.dimensions.size(), 0.0);
    double greatest = 0, size = 0;
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        const Affine& tie = problem.dimensions[i].tie;
        for (const auto& [other, times] : tie.terms)
            whole[other] += coefficients[i] * times;
        if (tie.terms.empty()) whole[i] += coefficients[i];
        greatest += coefficients[i] * tie.constant;
        size += std::abs(coefficients[i] * tie.constant);
    }
    for (std::size_t i = 0; i < whole.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        greatest += std::max(whole[i] * range.min, whole[i] * range.max);
        size += std::abs(whole[i]) * std::max(std::abs(range.min), std::abs(range.max));
    }
    return greatest < -2 * problem.solver.tolerance * size;
}

/// The condition of a family that no dimensions meet; empty if there is none.
std::string condition_out_of_reach(const Problem& problem, const Family& family) {
    for (const LinearCondition& condition : family.conditions)
        if (out_of_reach(problem, condition.coefficients)) return std::string(condition.name);
    if (!is_four_bar(*problem.mechanism)) return {};
    constexpr std::array<std::array<double, 4>, 4> loops{{{-1, 1, 1, 1}, {1, -1, 1, 1}, {1, 1, -1, 1}, {1, 1, 1, -1}}};
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (out_of_reach(problem, loops[i]))
            return fmt::format("the {} is no longer than the other three links together",
                               problem.mechanism->dimensions[i].name);
    return {};
}

/// Whether a design may have a motion of this family that ends by itself. Searches leave such out where no range is
/// given; a design is judged over it all the same, unless the crank has to turn fully or a quantity is asked for that
/// only full turns have.
bool may_end_by_itself(const Problem& problem, std::size_t family) {
    if (problem.mechanism->families[family].full_turn) return false;
    if ((problem.path && problem.path->closed) || must_turn_fully(problem)) return false;
    Motion motion = motion_of(problem, family, 0);
    if (!(motion.from <= motion.to)) motion.to = motion.from;
    return all_defined(problem, motion);
}

}  // namespace

std::shared_ptr<const Proof> proof_by_ranges(const Problem& problem) {
    std::set<std::size_t> families;
    for (const Variant& variant : variants(problem))
        families.insert(variant.family);
    for (std::size_t f = 0; f < problem.mechanism->families.size(); ++f)
        if (may_end_by_itself(problem, f)) families.insert(f);
    if (families.empty()) return nullptr;
    std::string why;
    for (const std::size_t f : families) {
        const Family& family = problem.mechanism->families[f];
        const std::string condition = condition_out_of_reach(problem, family);
        if (condition.empty()) return nullptr;
        why += fmt::format("{}{} asks that {}", why.empty() ? "" : "; ", family.name, condition);
    }
    return proof_by("the ranges of the dimensions exclude every kind of motion: " + why, RangesCertificate{});
}

}  // namespace mechwright
