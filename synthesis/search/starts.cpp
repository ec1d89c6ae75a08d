#include "synthesis/search/starts.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/search/path_timing.h"
#include "synthesis/target/followed/fit.h"
#include "synthesis/target/function/fit.h"
#include "synthesis/target/path/fit.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;

/// Lengths are sampled evenly in their logarithm over at most this part of their greatest value.
constexpr double least_part_of_limit = 1e-3;

DimensionKind kind_of(const Program& program, std::size_t dimension) {
    return program.problem->mechanism->dimensions[dimension].kind;
}

/// A value of variable v at the fraction u of its range.
double sampled(const Variable& v, DimensionKind kind, double u) {
    if (kind != DimensionKind::length) return v.lower + u * (v.upper - v.lower);
    const double low = std::max(v.lower, least_part_of_limit * v.upper);
    return low * std::pow(v.upper / low, u);
}

void set_path_angles(const Program& program, const PathTiming& timing, VectorXd& x) {
    const std::vector<double> angles = path_angles(program, timing);
    for (std::size_t i = 0; i < angles.size(); ++i)
        x[static_cast<Index>(program.first_path_angle + i)] = angles[i];
}

/// Sum of violations of the rows that are linear in the variables alone: conditions of motion, order.
double linear_violation(const Program& program, const VectorXd& x) {
    double sum = 0;
    for (const Row& row : program.rows) {
        if (!row.form.outputs.empty()) continue;
        double c = row.form.constant;
        for (const LinearTerm& t : row.form.variables)
            c += t.factor * x[static_cast<Index>(t.index)];
        sum += std::max({0.0, row.lower - c, c - row.upper});
    }
    return sum;
}

/// What screening ranks candidates by; both parts are of order one.
double merit(const Program& program, const VectorXd& x, ProgramValues& values) {
    evaluate(program, x, false, values);
    if (!values.assembled) return unlimited;
    const double worst = violation(program, x, values);
    return values.objective + 10 * worst;
}

/// Of each dimension its coordinate of random starts: where it stands among the mechanism's dimensions and the numbers
/// of all targets, so that a start does not depend on which targets a problem has.
std::vector<std::size_t> coordinates_of_starts(const Mechanism& mechanism) {
    std::vector<std::size_t> all;
    for (const Dimension& dimension : mechanism.dimensions)
        all.push_back(static_cast<std::size_t>(find_dimension(whole_of(mechanism), dimension.name)));
    return all;
}

}  // namespace

int start_candidates(const Problem& problem) {
    // With a path most of them are worth nothing, and the good ones are rare.
    return problem.path ? 400 : 16;
}

Start screened_start(const Program& program, std::uint64_t seed, int index, int candidates) {
    const auto n = static_cast<Index>(program.size());
    const Mechanism& mechanism = *program.problem->mechanism;
    const std::vector<std::size_t> coordinates = coordinates_of_starts(mechanism);
    const std::vector<InputTask> tasks = input_tasks(*program.problem);
    const std::size_t sampled_dimensions = whole_of(mechanism).dimensions.size() + 2;
    const LowDiscrepancy sequence(sampled_dimensions, seed, program.variant.family * 16 + program.variant.assembly);
    constexpr int tries = 40;  // draws for each candidate until the conditions of motion hold
    const auto base = static_cast<std::uint64_t>(index) * static_cast<std::uint64_t>(candidates * tries);

    Start best{VectorXd::Zero(n)};
    double least = unlimited;
    bool found = false;
    ProgramValues values;
    const auto consider = [&](VectorXd x, bool preferred) {
        if (program.path) fit_placement(program, x);
        for (const InputTask& task : tasks)
            task.is_function() ? fit_function(program, task, x) : fit_followed(program, task, x);
        settle_epigraphs(program, x);
        const double m = merit(program, x, values);
        if (found && !(m < least)) return;
        best = {std::move(x), preferred};
        least = m;
        found = true;
    };

    if (index == 0) {
        VectorXd x = program.reference;
        if (program.untimed_path()) set_path_angles(program, {0.5, 0.5, 0.5, 0, 0}, x);
        consider(std::move(x), true);
    }
    // Candidates that miss the conditions of motion are used only where none meets them.
    VectorXd closest;
    double closest_violation = unlimited;
    int accepted = 0;
    for (int draw = 0; draw < candidates * tries && accepted < candidates; ++draw) {
        const std::uint64_t k = base + static_cast<std::uint64_t>(draw);
        VectorXd x = VectorXd::Zero(n);
        for (std::size_t i = 0; i < program.variable_of.size(); ++i)
            if (program.variable_of[i] >= 0)
                x[program.variable_of[i]] = sampled(program.variables[static_cast<std::size_t>(program.variable_of[i])],
                                                    kind_of(program, i), sequence(k, coordinates[i]));
        if (program.untimed_path())
            set_path_angles(program,
                            {sequence(k, sampled_dimensions - 2), sequence(k, sampled_dimensions - 1), 0.5, 0, 0}, x);
        const double missed = linear_violation(program, x);
        if (missed == 0) {
            ++accepted;
            consider(std::move(x), false);
        } else if (missed < closest_violation) {
            closest_violation = missed;
            closest = std::move(x);
        }
    }
    if (accepted == 0 && closest.size() > 0) consider(std::move(closest), false);
    return best;
}

Eigen::VectorXd start_point(const Program& program, std::uint64_t seed, int index, int candidates) {
    return screened_start(program, seed, index, candidates).x;
}

}  // namespace mechwright
