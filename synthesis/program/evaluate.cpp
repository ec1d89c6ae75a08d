#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "synthesis/program/program.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr std::size_t most_reads = 64;  ///< dimensions a quantity can depend on
constexpr std::size_t most_pairs = most_reads * (most_reads + 1) / 2;
constexpr std::size_t most_path_reads = 16;  ///< dimensions a path can depend on
constexpr std::size_t most_path_pairs = most_path_reads * (most_path_reads + 1) / 2;

/// All outputs at a point.
struct Outputs {
    bool assembled = true;
    VectorXd value;
    MatrixXd jacobian;  ///< [output][variable]; empty unless asked for
};

std::vector<double> dimensions_at(const Program& program, const VectorXd& x) {
    std::vector<double> dimensions = program.dimensions;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (program.variable_of[i] >= 0) dimensions[i] = x[program.variable_of[i]];
    return dimensions;
}

void evaluate_block(const Program& program, const QuantityBlock& block, std::span<const double> dimensions,
                    bool derivatives, Outputs& out) {
    const std::size_t reads = block.quantity->reads;
    assert(reads <= most_reads);
    std::array<double, Quantity::most_components> value;
    std::array<double, Quantity::most_components * most_reads> gradient;
    Measurement measurement{value, {}, {}};
    if (derivatives) measurement.gradient = gradient;
    block.quantity->measure(block.motion, dimensions, measurement);
    for (std::size_t k = 0; k < block.count; ++k) {
        const auto row = static_cast<Index>(block.first + k);
        out.value[row] = value[k];
        if (!derivatives) continue;
        for (std::size_t i = 0; i < reads; ++i)
            if (program.variable_of[i] >= 0) out.jacobian(row, program.variable_of[i]) = gradient[k * reads + i];
    }
}

/// The crank angle at a point of the path, and the variable it depends on (-1: none).
struct PathAngle {
    double angle;
    std::ptrdiff_t variable;
};

PathAngle path_angle(const Program& program, std::span<const double> dimensions, const VectorXd& x, std::size_t point) {
    if (program.untimed_path()) {
        const auto variable = static_cast<std::ptrdiff_t>(program.first_path_angle + point);
        return {x[variable], variable};
    }
    const std::size_t start = program.problem->mechanism->path_roles.start;
    return {dimensions[start] + program.problem->path->crank_angles[point], program.variable_of[start]};
}

/// One residual of a point, of which there are two, for a guided body four: what is missed in x and y, and in the
/// direction that the body faces.
struct Residual {
    double value;
    std::array<double, most_path_reads> gradient;
    std::array<double, most_path_pairs> hessian;
};

/// Squared distance at one point with what its derivatives need.
struct PointTerms {
    std::array<Residual, 4> residuals;
    std::size_t count;                                     ///< of them
    std::size_t arguments;                                 ///< dimensions and crank angle
    std::array<std::ptrdiff_t, most_path_reads> variable;  ///< of each of the arguments
    double margin;
    double square;

    std::span<const Residual> all() const { return std::span(residuals).first(count); }
    /// The derivative of the square by an argument.
    double slope(std::size_t argument) const {
        double sum = 0;
        for (const Residual& r : all())
            sum += r.value * r.gradient[argument];
        return 2 * sum;
    }
};

/// Where one pair of residuals is written to.
PathMiss into(Residual& x, Residual& y, int order) {
    PathMiss miss{};
    if (order >= 1) {
        miss.gradient_x = x.gradient;
        miss.gradient_y = y.gradient;
    }
    if (order >= 2) {
        miss.hessian_x = x.hessian;
        miss.hessian_y = y.hessian;
    }
    return miss;
}

/// Times the length of a guided body.
void scale(Residual& r, double length, std::size_t arguments, int order) {
    r.value *= length;
    for (std::size_t k = 0; order >= 1 && k < arguments; ++k)
        r.gradient[k] *= length;
    for (std::size_t k = 0; order >= 2 && k < arguments * (arguments + 1) / 2; ++k)
        r.hessian[k] *= length;
}

void evaluate_point(const Program& program, std::span<const double> dimensions, const VectorXd& x, std::size_t point,
                    int order, PointTerms& t) {
    const Mechanism& mechanism = *program.problem->mechanism;
    const PathTarget& target = *program.problem->path;
    const PathAngle angle = path_angle(program, dimensions, x, point);
    const std::size_t reads = target.guides_body() ? mechanism.pose_reads : mechanism.path_reads;
    auto& r = t.residuals;
    t.arguments = reads + 1;
    PoseMiss miss{into(r[0], r[1], order), into(r[2], r[3], order)};
    if (target.guides_body()) {
        const double direction = target.directions[point];
        mechanism.pose_miss(program.variant.assembly, dimensions, angle.angle, program.targets[point],
                            {std::cos(direction), std::sin(direction)}, miss);
        t.count = 4;
        r[2].value = miss.turn.miss.x;
        r[3].value = miss.turn.miss.y;
        const double length = target.body_length / program.length;
        scale(r[2], length, t.arguments, order);
        scale(r[3], length, t.arguments, order);
    } else {
        mechanism.path_miss(program.variant.assembly, dimensions, angle.angle, program.targets[point], miss.place);
        t.count = 2;
    }
    r[0].value = miss.place.miss.x;
    r[1].value = miss.place.miss.y;
    t.margin = miss.place.margin;
    t.square = 0;
    for (const Residual& residual : t.all())
        t.square += residual.value * residual.value;
    if (order == 0) return;
    std::copy_n(program.variable_of.begin(), reads, t.variable.begin());
    t.variable[reads] = angle.variable;
}

double weight_sum(const Program& program) {
    double sum = 0;
    for (const double w : program.problem->path->weights)
        sum += w;
    return sum;
}

void evaluate_path(const Program& program, std::span<const double> dimensions, const VectorXd& x, bool derivatives,
                   Outputs& out) {
    const PathBlock& path = *program.path;
    const PathTarget& target = *program.problem->path;
    PointTerms t;
    double sum = 0;
    VectorXd sum_gradient;
    if (derivatives) sum_gradient = VectorXd::Zero(static_cast<Index>(program.size()));
    for (std::size_t i = 0; i < program.targets.size(); ++i) {
        evaluate_point(program, dimensions, x, i, derivatives ? 1 : 0, t);
        if (!(t.margin >= 0)) {
            out.assembled = false;
            return;
        }
        const double w = target.weights[i];
        const double distance = std::sqrt(t.square);
        sum += w * t.square;
        const auto square_row = static_cast<Index>(path.squares.value_or(0) + i);
        const auto distance_row = static_cast<Index>(path.distances.value_or(0) + i);
        if (path.squares) out.value[square_row] = t.square;
        if (path.distances) out.value[distance_row] = distance;
        if (!derivatives) continue;
        for (std::size_t k = 0; k < t.arguments; ++k) {
            if (t.variable[k] < 0) continue;
            const double g = t.slope(k);
            sum_gradient[t.variable[k]] += w * g;
            if (path.squares) out.jacobian(square_row, t.variable[k]) += g;
            if (path.distances && distance > 0) out.jacobian(distance_row, t.variable[k]) += g / (2 * distance);
        }
    }
    const double weights = weight_sum(program);
    if (path.sum) {
        out.value[static_cast<Index>(*path.sum)] = sum;
        if (derivatives) out.jacobian.row(static_cast<Index>(*path.sum)) = sum_gradient.transpose();
    }
    if (path.rms) {
        const double rms = std::sqrt(sum / weights);
        out.value[static_cast<Index>(*path.rms)] = rms;
        if (derivatives && rms > 0)
            out.jacobian.row(static_cast<Index>(*path.rms)) = sum_gradient.transpose() / (2 * weights * rms);
    }
}

void evaluate_outputs(const Program& program, const VectorXd& x, bool derivatives, Outputs& out) {
    const std::vector<double> dimensions = dimensions_at(program, x);
    out.assembled = true;
    out.value.setZero(static_cast<Index>(program.outputs));
    if (derivatives) out.jacobian.setZero(static_cast<Index>(program.outputs), static_cast<Index>(program.size()));
    for (const QuantityBlock& block : program.blocks)
        evaluate_block(program, block, dimensions, derivatives, out);
    if (program.path) evaluate_path(program, dimensions, x, derivatives, out);
}

double value_of(const LinearForm& form, const VectorXd& outputs, const VectorXd& x) {
    double value = form.constant;
    for (const LinearTerm& t : form.outputs)
        value += t.factor * outputs[static_cast<Index>(t.index)];
    for (const LinearTerm& t : form.variables)
        value += t.factor * x[static_cast<Index>(t.index)];
    return value;
}

template <class Row>
void add_gradient(const LinearForm& form, const MatrixXd& jacobian, Row&& gradient) {
    for (const LinearTerm& t : form.outputs)
        gradient += t.factor * jacobian.row(static_cast<Index>(t.index));
    for (const LinearTerm& t : form.variables)
        gradient[static_cast<Index>(t.index)] += t.factor;
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
    Outputs outputs;
    evaluate_outputs(program, x, derivatives, outputs);
    const auto n = static_cast<Index>(program.size());
    const auto m = static_cast<Index>(program.rows.size());
    out.assembled = outputs.assembled && outputs.value.allFinite() && (!derivatives || outputs.jacobian.allFinite());
    out.objective = value_of(program.objective, outputs.value, x);
    out.rows.resize(m);
    for (Index r = 0; r < m; ++r)
        out.rows[r] = value_of(program.rows[static_cast<std::size_t>(r)].form, outputs.value, x);
    if (derivatives) {
        out.gradient.setZero(n);
        out.jacobian.setZero(m, n);
        add_gradient(program.objective, outputs.jacobian, out.gradient.transpose());
        for (Index r = 0; r < m; ++r)
            add_gradient(program.rows[static_cast<std::size_t>(r)].form, outputs.jacobian, out.jacobian.row(r));
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

namespace {

/// The second derivatives of weighted outputs of one block, added to the full matrix.
void add_block_hessian(const Program& program, const QuantityBlock& block, std::span<const double> dimensions,
                       const VectorXd& weights, MatrixXd& hessian) {
    const std::size_t reads = block.quantity->reads;
    const std::size_t pairs = reads * (reads + 1) / 2;
    std::array<double, Quantity::most_components> value;
    std::array<double, Quantity::most_components * most_reads> gradient;
    std::array<double, Quantity::most_components * most_pairs> second;
    block.quantity->measure(block.motion, dimensions, {value, gradient, second});
    for (std::size_t k = 0; k < block.count; ++k) {
        const double w = weights[static_cast<Index>(block.first + k)];
        if (w == 0) continue;
        for (std::size_t i = 0, at = k * pairs; i < reads; ++i)
            for (std::size_t j = 0; j <= i; ++j, ++at) {
                const std::ptrdiff_t a = program.variable_of[i];
                const std::ptrdiff_t b = program.variable_of[j];
                if (a < 0 || b < 0) continue;
                hessian(a, b) += w * second[at];
                if (a != b) hessian(b, a) += w * second[at];
            }
    }
}

/// The same for the path. With q the squared distance of a point, a sum takes q, the root of the mean q / (2 W rms)
/// less the square of its gradient, a distance q / (2 d) less the square of its gradient.
void add_path_hessian(const Program& program, std::span<const double> dimensions, const VectorXd& x,
                      const VectorXd& weights, MatrixXd& hessian) {
    const PathBlock& path = *program.path;
    const PathTarget& target = *program.problem->path;
    const auto weight_at = [&](const std::optional<std::size_t>& output, std::size_t offset) {
        return output ? weights[static_cast<Index>(*output + offset)] : 0.0;
    };
    const double on_sum = weight_at(path.sum, 0);
    const double on_rms = weight_at(path.rms, 0);
    const double total = weight_sum(program);
    PointTerms t;
    double rms = 0;
    if (on_rms != 0) {
        for (std::size_t i = 0; i < program.targets.size(); ++i) {
            evaluate_point(program, dimensions, x, i, 0, t);
            rms += target.weights[i] * t.square;
        }
        rms = std::sqrt(rms / total);
    }
    VectorXd sum_gradient = VectorXd::Zero(static_cast<Index>(program.size()));
    for (std::size_t i = 0; i < program.targets.size(); ++i) {
        const double w = target.weights[i];
        const double on_square = weight_at(path.squares, i);
        const double on_distance = weight_at(path.distances, i);
        if (on_sum == 0 && on_rms == 0 && on_square == 0 && on_distance == 0) continue;
        evaluate_point(program, dimensions, x, i, 2, t);
        const double distance = std::sqrt(t.square);
        const double on_q = on_sum * w + on_square + (rms > 0 ? on_rms * w / (2 * total * rms) : 0) +
                            (distance > 0 ? on_distance / (2 * distance) : 0);
        const double on_gradient_square = distance > 0 ? on_distance / (4 * t.square * distance) : 0;
        std::array<double, most_path_reads> g;
        for (std::size_t k = 0; k < t.arguments; ++k) {
            g[k] = t.slope(k);
            if (t.variable[k] >= 0) sum_gradient[t.variable[k]] += w * g[k];
        }
        for (std::size_t k = 0, at = 0; k < t.arguments; ++k)
            for (std::size_t l = 0; l <= k; ++l, ++at) {
                const std::ptrdiff_t a = t.variable[k];
                const std::ptrdiff_t b = t.variable[l];
                if (a < 0 || b < 0) continue;
                double q = 0;
                for (const Residual& r : t.all())
                    q += 2 * (r.gradient[k] * r.gradient[l] + r.value * r.hessian[at]);
                const double h = on_q * q - on_gradient_square * g[k] * g[l];
                hessian(a, b) += h;
                if (k != l) hessian(b, a) += h;
            }
    }
    if (rms > 0) hessian -= on_rms / (4 * total * total * rms * rms * rms) * sum_gradient * sum_gradient.transpose();
}

}  // namespace

bool path_residuals(const Program& program, const VectorXd& x, bool derivatives, PathResiduals& out) {
    const std::vector<double> dimensions = dimensions_at(program, x);
    const std::size_t each = residuals_per_point(program);
    const auto rows = static_cast<Index>(each * program.targets.size());
    const auto columns = static_cast<Index>(program.dimension_variables);
    out.value.resize(rows);
    if (derivatives) {
        out.jacobian.setZero(rows, columns);
        out.by_angle.setZero(program.untimed_path() ? rows : 0);
    }
    PointTerms t;
    for (std::size_t i = 0; i < program.targets.size(); ++i) {
        evaluate_point(program, dimensions, x, i, derivatives ? 1 : 0, t);
        if (!(t.margin >= 0)) return false;
        const double w = std::sqrt(program.problem->path->weights[i]);
        for (std::size_t c = 0; c < each; ++c) {
            const auto row = static_cast<Index>(each * i + c);
            const Residual& r = t.residuals[c];
            out.value[row] = w * r.value;
            for (std::size_t k = 0; derivatives && k < t.arguments; ++k) {
                const std::ptrdiff_t v = t.variable[k];
                if (v >= 0) (v >= columns ? out.by_angle[row] : out.jacobian(row, v)) += w * r.gradient[k];
            }
        }
    }
    return out.value.allFinite() && (!derivatives || out.jacobian.allFinite());
}

std::size_t residuals_per_point(const Program& program) { return program.problem->path->guides_body() ? 4 : 2; }

MatrixXd lagrangian_hessian(const Program& program, const VectorXd& x, double weight, const VectorXd& multipliers) {
    VectorXd on_output = VectorXd::Zero(static_cast<Index>(program.outputs));
    const auto add = [&](const LinearForm& form, double factor) {
        for (const LinearTerm& t : form.outputs)
            on_output[static_cast<Index>(t.index)] += factor * t.factor;
    };
    add(program.objective, weight);
    for (std::size_t r = 0; r < program.rows.size(); ++r)
        add(program.rows[r].form, multipliers[static_cast<Index>(r)]);

    const auto n = static_cast<Index>(program.size());
    MatrixXd hessian = MatrixXd::Zero(n, n);
    const std::vector<double> dimensions = dimensions_at(program, x);
    for (const QuantityBlock& block : program.blocks) {
        const auto part = on_output.segment(static_cast<Index>(block.first), static_cast<Index>(block.count));
        if ((part.array() != 0).any()) add_block_hessian(program, block, dimensions, on_output, hessian);
    }
    if (program.path) add_path_hessian(program, dimensions, x, on_output, hessian);
    if (program.closest_to_reference)
        for (std::size_t i = 0; i < program.size(); ++i)
            if (is_dimension(program, i))
                hessian(static_cast<Index>(i), static_cast<Index>(i)) +=
                    2 * weight * reference_weight(program.variables[i]);
    return hessian;
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

void settle_epigraphs(const Program& program, VectorXd& x) {
    if (program.epigraphs.empty()) return;
    Outputs outputs;
    evaluate_outputs(program, x, false, outputs);
    if (!outputs.assembled || !outputs.value.allFinite()) return;
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
    while (angle > greatest)
        angle -= turn;
    while (angle < least)
        angle += turn;
    return std::min(angle, greatest);
}

Design design_at(const Program& program, const VectorXd& x) {
    Design design;
    design.assembly = program.variant.assembly;
    design.dimensions = dimensions_at(program, x);
    const auto& kinds = program.problem->mechanism->dimensions;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        double& value = design.dimensions[i];
        const DimensionRange& range = program.problem->dimensions[i];
        if (scales(kinds[i].kind))
            value *= program.length;
        else if (program.variable_of[i] >= 0 && range.any_angle())
            value = into_range(value, range.min, range.max);
    }
    if (program.path)
        for (std::size_t i = 0; i < program.targets.size(); ++i)
            design.path_angles.push_back(path_angle(program, design.dimensions, x, i).angle);
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
            x[static_cast<Index>(program.first_path_angle + i)] = design.path_angles[i];
    settle_epigraphs(program, x);
    return x;
}

}  // namespace mechwright
