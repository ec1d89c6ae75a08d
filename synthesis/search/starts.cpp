#include "synthesis/search/starts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/program/path/path_outputs.h"
#include "synthesis/search/path_timing.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// Lengths are sampled evenly in their logarithm over at most this part of their greatest value.
constexpr double widest_ratio = 1e-3;

DimensionKind kind_of(const Program& program, std::size_t dimension) {
    return program.problem->mechanism->dimensions[dimension].kind;
}

/// A value of variable v at the fraction u of its range.
double sampled(const Variable& v, DimensionKind kind, double u) {
    if (kind != DimensionKind::length) return v.lower + u * (v.upper - v.lower);
    const double low = std::max(v.lower, widest_ratio * v.upper);
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

}  // namespace

void fit_placement(const Program& program, VectorXd& x) {
    const PathRoles& roles = program.problem->mechanism->point->roles;
    const auto variable = [&](std::size_t dimension) { return program.variable_of[dimension]; };
    const bool free_point = variable(roles.along) >= 0 && variable(roles.across) >= 0;
    const bool free_origin = variable(roles.origin_x) >= 0 && variable(roles.origin_y) >= 0;
    bool free_size = variable(roles.tilt) >= 0;
    for (std::size_t i = 0; i < program.variable_of.size(); ++i)
        if (kind_of(program, i) == DimensionKind::length) free_size = free_size && variable(i) >= 0;
    const int unknowns = (free_point ? 1 : 0) + (free_origin ? 1 : 0) + (free_size ? 1 : 0);
    const auto n = static_cast<Index>(program.targets.size());
    if (unknowns == 0 || n < unknowns) return;

    std::vector<double> dimensions = program.dimensions;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (variable(i) >= 0) dimensions[i] = x[variable(i)];
    const Complex point(dimensions[roles.along], dimensions[roles.across]);
    const Complex origin(dimensions[roles.origin_x], dimensions[roles.origin_y]);
    const Complex direction = std::polar(1.0, dimensions[roles.tilt]);
    const double start = dimensions[roles.start];
    for (const std::size_t i : {roles.along, roles.across, roles.origin_x, roles.origin_y, roles.tilt})
        dimensions[i] = 0;
    const auto guided_point = [&](double along, double crank_angle, double& margin) {
        dimensions[roles.along] = along;
        PathMiss miss{};
        program.problem->mechanism->point->miss(program.problem->mechanism->form(program.variant.assembly), dimensions,
                                                crank_angle, {0, 0}, miss);
        margin = miss.margin;
        return -Complex(miss.miss.x, miss.miss.y);
    };

    Eigen::MatrixXcd columns(n, unknowns);
    Eigen::VectorXcd target(n);
    Complex facing(0);  ///< from the guiding link to the directions of a guided body, summed
    for (Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const double angle = program.untimed_path() ? x[static_cast<Index>(program.first_path_angle + k)]
                                                    : start + program.problem->path->crank_angles[k];
        double margin = 0;
        const Complex p = guided_point(0, angle, margin);
        const Complex w = guided_point(1, angle, margin) - p;
        if (!(margin >= 0)) return;
        const double weight = std::sqrt(program.problem->path->weights[k]);
        if (program.problem->path->faces(k))
            facing += weight * weight * std::conj(w) * std::polar(1.0, program.problem->path->directions[k]);
        Complex known(0);
        Index column = 0;
        if (free_origin)
            columns(i, column++) = weight;
        else
            known += origin;
        if (free_size)
            columns(i, column++) = weight * (free_point ? p : p + point * w);
        else
            known += direction * (free_point ? p : p + point * w);
        if (free_point) columns(i, column++) = weight * w;
        target[i] = weight * (Complex(program.targets[k].x, program.targets[k].y) - known);
    }
    const Eigen::VectorXcd solved = columns.colPivHouseholderQr().solve(target);
    if (!solved.real().allFinite() || !solved.imag().allFinite()) return;

    const auto set = [&](std::size_t dimension, double value) {
        const Variable& v = program.variables[static_cast<std::size_t>(variable(dimension))];
        x[variable(dimension)] = std::clamp(value, v.lower, v.upper);
    };
    Index column = 0;
    if (free_origin) {
        set(roles.origin_x, solved[column].real());
        set(roles.origin_y, solved[column].imag());
        ++column;
    }
    Complex turn = direction;
    if (free_size) {
        const Complex z = solved[column++];
        const double size = std::abs(z);
        if (!(size > 0)) return;
        turn = z / size;
        for (std::size_t i = 0; i < program.variable_of.size(); ++i)
            if (kind_of(program, i) == DimensionKind::length) set(i, size * x[variable(i)]);
        const Variable& tilt = program.variables[static_cast<std::size_t>(variable(roles.tilt))];
        x[variable(roles.tilt)] = into_range(std::arg(z), tilt.lower, tilt.upper);
        if (!free_point && variable(roles.along) >= 0) set(roles.along, size * point.real());
        if (!free_point && variable(roles.across) >= 0) set(roles.across, size * point.imag());
    }
    if (program.problem->path->guides_body() && variable(roles.body) >= 0) {
        const Variable& v = program.variables[static_cast<std::size_t>(variable(roles.body))];
        x[variable(roles.body)] = into_range(std::arg(facing / turn), v.lower, v.upper);
    }
    if (free_point) {
        const Complex fitted = solved[column] / turn;
        set(roles.along, fitted.real());
        set(roles.across, fitted.imag());
    }
}

namespace {

/// Lengths that come close to the function, within their ranges.
void fit_function(const Program& program, VectorXd& x) {
    const Mechanism& mechanism = *program.problem->mechanism;
    std::vector<double> dimensions = dimensions_at(program, x);
    const std::size_t scales = mechanism.input->start;
    const auto turns = [&](std::size_t start) { return program.variable_of[start] >= 0; };
    if (!mechanism.function->fit(*program.problem->function, dimensions, turns(scales), turns(scales + 2))) return;
    for (std::size_t i = 0; i < dimensions.size(); ++i) {
        const std::ptrdiff_t v = program.variable_of[i];
        if (v < 0 || program.problem->dimensions[i].tied()) continue;
        const Variable& variable = program.variables[static_cast<std::size_t>(v)];
        x[v] = std::clamp(dimensions[i], variable.lower, variable.upper);
    }
}

/// The line or arc that the guided point of x is closest to, as far as it is free.
void fit_followed(const Program& program, VectorXd& x) {
    const FollowedShape& shape = *followed_shape_of(*program.problem->mechanism, *program.problem->followed);
    std::vector<double> dimensions = dimensions_at(program, x);
    std::array<bool, 3> free{};
    for (std::size_t k = 0; k < shape.parameters; ++k)
        free[k] = program.variable_of[shape.place + k] >= 0;
    shape.fit(program.problem->mechanism->form(program.variant.assembly), dimensions, free);
    for (std::size_t k = 0; k < shape.parameters; ++k) {
        if (!free[k]) continue;
        const std::ptrdiff_t v = program.variable_of[shape.place + k];
        const Variable& variable = program.variables[static_cast<std::size_t>(v)];
        x[v] = std::clamp(dimensions[shape.place + k], variable.lower, variable.upper);
    }
}

}  // namespace

int start_candidates(const Problem& problem) {
    // With a path most of them are worth nothing, and the good ones are rare.
    return problem.path ? 400 : 16;
}

Eigen::VectorXd start_point(const Program& program, std::uint64_t seed, int index, int candidates) {
    const auto n = static_cast<Index>(program.size());
    const std::size_t sampled_dimensions = program.variable_of.size() + 2;
    const LowDiscrepancy sequence(sampled_dimensions, seed, program.variant.family * 16 + program.variant.assembly);
    constexpr int tries = 40;  // draws for each candidate until the conditions of motion hold
    const auto base = static_cast<std::uint64_t>(index) * static_cast<std::uint64_t>(candidates * tries);

    VectorXd best = VectorXd::Zero(n);
    double least = unlimited;
    bool found = false;
    ProgramValues values;
    const auto consider = [&](VectorXd x) {
        if (program.path) fit_placement(program, x);
        if (program.problem->function) fit_function(program, x);
        if (program.problem->followed) fit_followed(program, x);
        settle_epigraphs(program, x);
        const double m = merit(program, x, values);
        if (found && !(m < least)) return;
        best = std::move(x);
        least = m;
        found = true;
    };

    if (index == 0) {
        VectorXd x = program.reference;
        if (program.untimed_path()) set_path_angles(program, {0.5, 0.5, 0.5, 0, 0}, x);
        consider(std::move(x));
    }
    // Candidates that miss the conditions of motion are used only where none meets them.
    VectorXd closest;
    double closest_violation = unlimited;
    int accepted = 0;
    for (int draw = 0; draw < candidates * tries && accepted < candidates; ++draw) {
        const std::uint64_t k = base + static_cast<std::uint64_t>(draw);
        VectorXd x = VectorXd::Zero(n);
        for (std::size_t i = 0; i < program.variable_of.size(); ++i)
            if (program.variable_of[i] >= 0 && !program.problem->dimensions[i].tied())
                x[program.variable_of[i]] = sampled(program.variables[static_cast<std::size_t>(program.variable_of[i])],
                                                    kind_of(program, i), sequence(k, i));
        if (program.untimed_path())
            set_path_angles(program,
                            {sequence(k, sampled_dimensions - 2), sequence(k, sampled_dimensions - 1), 0.5, 0, 0}, x);
        const double missed = linear_violation(program, x);
        if (missed == 0) {
            ++accepted;
            consider(std::move(x));
        } else if (missed < closest_violation) {
            closest_violation = missed;
            closest = std::move(x);
        }
    }
    if (accepted == 0 && closest.size() > 0) consider(std::move(closest));
    return best;
}

}  // namespace mechwright
