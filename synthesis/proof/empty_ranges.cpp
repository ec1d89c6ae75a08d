#include "synthesis/proof/empty_ranges.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>

#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

/// Whether sum of coefficient times dimension >= 0 is out of reach of the ranges, by more than their tolerance.
bool out_of_reach(const Problem& problem, std::span<const double> coefficients) {
    std::vector<double> whole(problem.dimensions.size(), 0.0);
    for (std::size_t i = 0; i < coefficients.size(); ++i) {
        const Tie& tie = problem.dimensions[i].tie;
        if (problem.dimensions[i].tied())
            whole[tie.of] += coefficients[i] * tie.times;
        else
            whole[i] += coefficients[i];
    }
    double greatest = 0, size = 0;
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
    if (problem.mechanism != &four_bar_mechanism()) return {};
    constexpr std::array<std::array<double, 4>, 4> loops{{{-1, 1, 1, 1}, {1, -1, 1, 1}, {1, 1, -1, 1}, {1, 1, 1, -1}}};
    for (std::size_t i = 0; i < loops.size(); ++i)
        if (out_of_reach(problem, loops[i]))
            return fmt::format("the {} is no longer than the other three links together",
                               problem.mechanism->dimensions[i].name);
    return {};
}

}  // namespace

std::shared_ptr<const Proof> proof_by_ranges(const Problem& problem) {
    std::set<std::size_t> families;
    for (const Variant& variant : variants(problem))
        families.insert(variant.family);
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
