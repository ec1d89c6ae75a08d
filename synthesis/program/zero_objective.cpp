#include "synthesis/program/zero_objective.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/possible_values.h"
#include "synthesis/problem/units.h"

namespace mechwright {

namespace {

/// Zero to this part of the size of what a value is computed from.
constexpr double exact_within = 1e-13;
/// What is drawn by hand or measured is hardly met as well as this by chance; and what has less left than that is met
/// as well as points that were written with eight digits can be.
constexpr double nearly_within = 1e-4;
constexpr double rounded_within = 1e-8;

/// The greatest distance of a target from the first, or the length of a guided body that stays in one place; without
/// targets the longest length.
double size_of(const Problem& problem, const Design& design) {
    double size = 0;
    if (problem.path) {
        size = problem.path->body_length;
        for (const Vector<double>& p : problem.path->points)
            size =
                std::max(size, std::hypot(p.x - problem.path->points.front().x, p.y - problem.path->points.front().y));
        return size;
    }
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::length) size = std::max(size, design.dimensions[i]);
    return size;
}

/// Whether what is to be least is zero to a part of what it is computed from.
bool is_zero_within(double part, const Problem& problem, const Solution& solution) {
    if (!solution.feasible || !problem.objective || problem.objective->terms.size() != 1) return false;
    const ObjectiveTerm& term = problem.objective->terms.front();
    const Quantity& quantity = problem.mechanism->quantities[term.quantity];
    if (term.maximize || possible_values(quantity.name).least != 0) return false;
    const double value = from_file_unit(solution.objective, quantity.unit, problem.units);
    const double size = size_of(problem, solution.design);
    switch (quantity.unit) {
        case Unit::length: return value <= part * size;
        case Unit::area: return value <= part * part * size * size;
        case Unit::curvature: return value * size <= part;
        case Unit::none:
        case Unit::angle: return value <= part;
        case Unit::force:
        case Unit::torque:
        case Unit::rate: return value == 0;
    }
    return false;
}

}  // namespace

bool is_at_zero(const Problem& problem, const Solution& solution) {
    return is_zero_within(exact_within, problem, solution);
}

bool is_nearly_at_zero(const Problem& problem, const Solution& solution) {
    return is_zero_within(nearly_within, problem, solution) && !is_zero_within(rounded_within, problem, solution);
}

std::shared_ptr<const Proof> proof_by_zero(const Problem& problem) {
    const std::string_view name = problem.mechanism->quantities[problem.objective->terms.front().quantity].name;
    return proof_by(problem.path ? std::string("the points are met exactly, and no distance is less than zero")
                                 : fmt::format("{} is zero, and cannot be less", name),
                    ZeroCertificate{});
}

}  // namespace mechwright
