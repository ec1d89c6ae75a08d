#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/input.h"
#include "synthesis/program/quantity_block.h"
#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

void evaluate_outputs(const Program& program, const VectorXd& x, bool derivatives, Outputs& out,
                      bool with_path = true) {
    set_dimensions(program, x, out.dimensions);
    out.value.setZero(static_cast<Index>(program.outputs));
    if (derivatives) out.jacobian.setZero(static_cast<Index>(program.outputs), static_cast<Index>(program.size()));
    out.assembled = true;
    for (const QuantityBlock& block : program.blocks)
        out.assembled = evaluate_block(program, block, x, derivatives, out) && out.assembled;
    if (with_path && program.path) out.assembled = evaluate_path(program, x, derivatives, out) && out.assembled;
}

double value_of(const LinearForm& form, const VectorXd& outputs, const VectorXd& x) {
    double value = form.constant;
    for (const LinearTerm& t : form.outputs)
        value += t.factor * outputs[static_cast<Index>(t.index)];
    for (const LinearTerm& t : form.variables)
        value += t.factor * x[static_cast<Index>(t.index)];
    return value;
}

/// Adds the gradient of a form to numbers that lie `stride` apart.
void add_gradient(const LinearForm& form, const MatrixXd& jacobian, double* gradient, Index stride) {
    for (const LinearTerm& t : form.outputs) {
        const double* from = jacobian.data() + t.index;
        for (Index i = 0; i < jacobian.cols(); ++i)
            gradient[i * stride] += t.factor * from[i * jacobian.rows()];
    }
    for (const LinearTerm& t : form.variables)
        gradient[static_cast<Index>(t.index) * stride] += t.factor;
}

/// The reciprocal square of a variable's range, by which distances from the reference are measured.
double reference_weight(const Variable& v) {
    const double range = v.upper - v.lower;
    return 1 / (range * range);
}

bool is_dimension(const Program& program, std::size_t variable) {
    return std::find(program.variable_of.begin(), program.variable_of.end(), static_cast<std::ptrdiff_t>(variable)) !=
           program.variable_of.end();
}

}  // namespace

void evaluate(const Program& program, const VectorXd& x, bool derivatives, ProgramValues& out) {
    Outputs& outputs = out.outputs;
    evaluate_outputs(program, x, derivatives, outputs);
    const auto n = static_cast<Index>(program.size());
    const auto m = static_cast<Index>(program.rows.size());
    out.assembled = outputs.assembled;
    out.objective = value_of(program.objective, outputs.value, x);
    out.rows.resize(m);
    for (Index r = 0; r < m; ++r)
        out.rows[r] = value_of(program.rows[static_cast<std::size_t>(r)].form, outputs.value, x);
    if (derivatives) {
        out.gradient.setZero(n);
        out.jacobian.setZero(m, n);
        add_gradient(program.objective, outputs.jacobian, out.gradient.data(), 1);
        for (Index r = 0; r < m; ++r)
            add_gradient(program.rows[static_cast<std::size_t>(r)].form, outputs.jacobian, out.jacobian.data() + r, m);
    }
    if (!program.closest_to_reference) return;
    for (std::size_t i = 0; i < program.size(); ++i) {
        if (!is_dimension(program, i)) continue;
        const auto k = static_cast<Index>(i);
        const double weight = reference_weight(program.variables[i]);
        const double away = x[k] - program.reference[k];
        out.objective += weight * away * away;
        if (derivatives) out.gradient[k] += 2 * weight * away;
    }
}

std::vector<std::size_t> rows_beside_path(const Program& program) {
    const auto of_path = [&](const LinearTerm& t) {
        const auto within = [&](const QuantityBlock& block) {
            return t.index >= block.first && t.index < block.first + block.count;
        };
        return std::none_of(program.blocks.begin(), program.blocks.end(), within);
    };
    const auto is_no_dimension = [&](const LinearTerm& t) { return t.index >= program.dimension_variables; };
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < program.rows.size(); ++r) {
        const LinearForm& form = program.rows[r].form;
        if (std::none_of(form.outputs.begin(), form.outputs.end(), of_path) &&
            std::none_of(form.variables.begin(), form.variables.end(), is_no_dimension))
            rows.push_back(r);
    }
    return rows;
}

bool evaluate_beside_path(const Program& program, std::span<const std::size_t> rows, const VectorXd& x,
                          bool derivatives, RowsBesidePath& out) {
    evaluate_outputs(program, x, derivatives, out.outputs, false);
    const auto m = static_cast<Index>(rows.size());
    out.value.resize(m);
    if (derivatives) out.jacobian.setZero(m, static_cast<Index>(program.size()));
    for (Index r = 0; r < m; ++r) {
        const LinearForm& form = program.rows[rows[static_cast<std::size_t>(r)]].form;
        out.value[r] = value_of(form, out.outputs.value, x);
        if (derivatives) add_gradient(form, out.outputs.jacobian, out.jacobian.data() + r, m);
    }
    return out.value.allFinite() && (!derivatives || out.jacobian.allFinite());
}

void lagrangian_hessian(const Program& program, const VectorXd& x, double weight, const VectorXd& multipliers,
                        LagrangianHessian& out) {
    VectorXd& on_output = out.weights;
    on_output.setZero(static_cast<Index>(program.outputs));
    const auto add = [&](const LinearForm& form, double factor) {
        for (const LinearTerm& t : form.outputs)
            on_output[static_cast<Index>(t.index)] += factor * t.factor;
    };
    add(program.objective, weight);
    for (std::size_t r = 0; r < program.rows.size(); ++r)
        add(program.rows[r].form, multipliers[static_cast<Index>(r)]);

    const auto n = static_cast<Index>(program.size());
    out.value.setZero(n, n);
    set_dimensions(program, x, out.dimensions);
    const auto counts = [&](const QuantityBlock& block) {
        return (on_output.segment(static_cast<Index>(block.first), static_cast<Index>(block.count)).array() != 0).any();
    };
    for (const QuantityBlock& block : program.blocks)
        if (counts(block)) add_block_hessian(program, block, x, out);
    if (program.path) add_path_hessian(program, x, out);
    if (program.closest_to_reference)
        for (std::size_t i = 0; i < program.size(); ++i)
            if (is_dimension(program, i))
                out.value(static_cast<Index>(i), static_cast<Index>(i)) +=
                    2 * weight * reference_weight(program.variables[i]);
}

double violation(const Program& program, const VectorXd& x, const ProgramValues& values) {
    if (!values.assembled) return unlimited;
    double worst = 0;
    for (std::size_t r = 0; r < program.rows.size(); ++r) {
        const double c = values.rows[static_cast<Index>(r)];
        worst = std::max({worst, program.rows[r].lower - c, c - program.rows[r].upper});
    }
    for (std::size_t i = 0; i < program.size(); ++i) {
        const double v = x[static_cast<Index>(i)];
        worst = std::max({worst, program.variables[i].lower - v, v - program.variables[i].upper});
    }
    return worst;
}

VectorXd within_bounds(const Program& program, VectorXd x) {
    for (std::size_t i = 0; i < program.size(); ++i) {
        double& v = x[static_cast<Index>(i)];
        v = std::clamp(v, program.variables[i].lower, program.variables[i].upper);
    }
    return x;
}

void settle_epigraphs(const Program& program, VectorXd& x) {
    if (program.epigraphs.empty()) return;
    Outputs outputs;
    evaluate_outputs(program, x, false, outputs);
    if (!outputs.assembled) return;
    for (const Epigraph& e : program.epigraphs) {
        double worst = e.above ? -unlimited : unlimited;
        for (const LinearTerm& t : e.outputs) {
            const double y = t.factor * outputs.value[static_cast<Index>(t.index)];
            worst = e.above ? std::max(worst, y) : std::min(worst, y);
        }
        x[static_cast<Index>(e.variable)] = worst;
    }
}

double into_range(double angle, double least, double greatest) {
    constexpr double turn = 2 * std::numbers::pi;
    // In one step: a range may be so far away that single turns would never lead there.
    if (angle > greatest) angle -= turn * std::ceil((angle - greatest) / turn);
    if (angle < least) angle += turn * std::ceil((least - angle) / turn);
    return std::clamp(angle, least, greatest);
}

namespace {

/// A dimension in the user's lengths: where the program's is at an end of its range, or beside it by the rounding of
/// the product, at the very end.
double unscaled(const Program& program, std::size_t dimension, double value) {
    const DimensionRange& range = program.problem->dimensions[dimension];
    if (program.variable_of[dimension] < 0) return value * program.length;
    const Variable& v = program.variables[static_cast<std::size_t>(program.variable_of[dimension])];
    if (value == v.lower && v.lower == range.min / program.length) return range.min;
    if (value == v.upper) return range.max;
    const double plain = value * program.length;
    constexpr double few_units = 4 * std::numeric_limits<double>::epsilon();
    if (std::abs(plain - range.min) <= few_units * std::abs(range.min)) return range.min;
    if (std::abs(plain - range.max) <= few_units * std::abs(range.max)) return range.max;
    return plain;
}

/// The crank angle at a point of a path, or the displacement in the user's lengths: at an end of the stroke, or beside
/// it by rounding, at the very end.
double input_at_point(const Program& program, const Design& design, const VectorXd& x, std::size_t point) {
    const Problem& problem = *program.problem;
    if (!program.untimed_path())
        return design.dimensions[problem.mechanism->roles_of(problem.path->target_of(point)).start] +
               problem.path->crank_angles[point];
    const double input = x[static_cast<Index>(program.first_path_angle + point)] * unit_of_input(program);
    constexpr double few_units = 4 * std::numeric_limits<double>::epsilon();
    if (const auto reach = reach_of_input(*problem.mechanism))
        for (const double end : *reach)
            if (std::abs(input - end) <= few_units * std::abs(end)) return end;
    return input;
}

}  // namespace

Design design_at(const Program& program, const VectorXd& x) {
    Design design;
    design.assembly = program.variant.assembly;
    design.dimensions = dimensions_at(program, x);
    const auto& kinds = program.problem->mechanism->dimensions;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        double& value = design.dimensions[i];
        const DimensionRange& range = program.problem->dimensions[i];
        if (range.fixed())
            value = range.min;
        else if (scales(kinds[i].kind))
            value = unscaled(program, i, value);
        else if (program.variable_of[i] >= 0 && turns_freely(*program.problem, i))
            value = into_range(value, range.min, range.max);
    }
    // Of what the others are now.
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (const DimensionRange& range = program.problem->dimensions[i]; range.tied())
            design.dimensions[i] = range.tie.at(std::span<const double>(design.dimensions));
    if (program.path)
        for (std::size_t i = 0; i < program.targets.size(); ++i)
            design.path_angles.push_back(input_at_point(program, design, x, i));
    return design;
}

VectorXd point_of(const Program& program, const Design& design) {
    VectorXd x = VectorXd::Zero(static_cast<Index>(program.size()));
    const auto& kinds = program.problem->mechanism->dimensions;
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (program.variable_of[i] >= 0)
            x[program.variable_of[i]] = design.dimensions[i] / (scales(kinds[i].kind) ? program.length : 1);
    if (program.untimed_path())
        for (std::size_t i = 0; i < program.targets.size(); ++i)
            x[static_cast<Index>(program.first_path_angle + i)] = design.path_angles[i] / unit_of_input(program);
    settle_epigraphs(program, x);
    return x;
}

}  // namespace mechwright
