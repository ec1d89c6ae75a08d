#include "synthesis/bench/extremes/given_design.h"

#include <algorithm>
#include <cassert>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/problem/reader.h"

namespace mechwright::bench {

GivenDesign::GivenDesign(std::shared_ptr<const Problem> kind, std::vector<double> given)
    : problem(std::move(kind)), motion(motion_of(*problem, Design{given, 0, {}})), dimensions(std::move(given)) {}

double GivenDesign::quantity(std::size_t index) const {
    const Quantity& q = problem->mechanism->quantities[index];
    std::array<double, Quantity::most_components> components;
    measure(q, motion, dimensions, {components, {}, {}});
    const auto found = std::span(components).first(q.components(motion));
    return q.reduce == Reduce::least ? std::ranges::min(found) : std::ranges::max(found);
}

Digits50 GivenDesign::quantity_again(std::size_t index) const {
    const std::vector<Digits50> exact(dimensions.begin(), dimensions.end());
    return measure_again(problem->mechanism->quantities[index], motion, exact);
}

std::shared_ptr<const Problem> problem_of(std::string_view text) {
    ReadProblem read = parse_problem(text, "given.toml");
    assert(read.ok());
    return std::make_shared<const Problem>(std::move(read.problem));
}

std::vector<double> dimensions_of(const Problem& problem) {
    std::vector<double> dimensions;
    for (const DimensionRange& range : problem.dimensions)
        dimensions.push_back(range.min);
    return dimensions;
}

double random_number(std::size_t k, std::size_t i) {
    return std::ldexp(static_cast<double>(mixed(mixed(k) ^ i) >> 11) + 0.5, -53);
}

}  // namespace mechwright::bench
