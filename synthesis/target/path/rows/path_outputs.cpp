#include "synthesis/target/path/rows/path_outputs.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "synthesis/mechanism/input.h"

namespace mechwright {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr std::size_t most_arguments = PointGuidance::most_reads + 1;  ///< dimensions, then the crank angle
constexpr std::size_t most_pairs = most_arguments * (most_arguments + 1) / 2;

/// One residual of a point, of which there are two, for a guided body four: what is missed in x and y, and in the
/// direction that the body faces.
struct Residual {
    double value;
    std::array<double, most_arguments> gradient;
    std::array<double, most_pairs> hessian;
};

/// Squared distance at one point with what its derivatives need.
struct PointTerms {
    std::array<Residual, 4> residuals;
    std::size_t count;                                    ///< of them
    std::size_t arguments;                                ///< dimensions and crank angle
    std::array<std::ptrdiff_t, most_arguments> variable;  ///< of each of the arguments
    double margin;
    double square;

    std::span<const Residual> all() const& { return std::span(residuals).first(count); }
    std::span<const Residual> all() const&& = delete;  // they would be gone
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

void set_zero(Residual& r, std::size_t arguments, int order) {
    r.value = 0;
    if (order >= 1) std::fill_n(r.gradient.begin(), arguments, 0.0);
    if (order >= 2) std::fill_n(r.hessian.begin(), arguments * (arguments + 1) / 2, 0.0);
}

/// Derivatives by arguments of which some are tied to others, as those by the variables that they follow from.
void by_variables(const Program& program, const Reads& reads, int order, PointTerms& t) {
    constexpr int most = static_cast<int>(most_arguments);
    using Square = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, most, most>;
    const auto n = static_cast<Index>(t.arguments);
    std::array<std::ptrdiff_t, most_arguments> variable;
    std::size_t count = 0;
    Square by = Square::Zero(n, n);
    const auto add = [&](Index argument, std::ptrdiff_t v, double factor) {
        const auto end = variable.begin() + static_cast<std::ptrdiff_t>(count);
        const auto at = std::find(variable.begin(), end, v) - variable.begin();
        if (at == static_cast<std::ptrdiff_t>(count)) {
            assert(count < most_arguments);  // there are fewer variables of dimensions
            if (at == by.cols()) by.conservativeResizeLike(Square::Zero(n, at + 1));
            variable[count++] = v;
        }
        by(argument, at) += factor;
    };
    for (std::size_t i = 0; i < reads.size(); ++i)
        for (const LinearTerm& term : program.follows[reads[i]])
            add(static_cast<Index>(i), static_cast<std::ptrdiff_t>(term.index), term.factor);
    if (t.variable[reads.size()] >= 0) add(n - 1, t.variable[reads.size()], 1);
    const auto m = static_cast<Index>(count);
    const Square follows = by.leftCols(m);
    for (std::size_t c = 0; c < t.count; ++c) {
        Residual& r = t.residuals[c];
        const Eigen::Map<const VectorXd> gradient(r.gradient.data(), n);
        Eigen::Map<VectorXd>(r.gradient.data(), m) =
            Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most, 1>(follows.transpose() * gradient);
        if (order < 2) continue;
        Square second(n, n);
        for (Index k = 0, at = 0; k < n; ++k)
            for (Index l = 0; l <= k; ++l, ++at)
                second(k, l) = second(l, k) = r.hessian[static_cast<std::size_t>(at)];
        const Square whole = follows.transpose() * Square(second * follows);
        for (Index k = 0, at = 0; k < m; ++k)
            for (Index l = 0; l <= k; ++l, ++at)
                r.hessian[static_cast<std::size_t>(at)] = whole(k, l);
    }
    t.variable = variable;
    t.arguments = count;
}

void evaluate_point(const Program& program, std::span<const double> dimensions, const VectorXd& x, std::size_t point,
                    int order, PointTerms& t) {
    const Mechanism& mechanism = *program.problem->mechanism;
    const PathTarget& target = *program.problem->path;
    const PathAngle angle = path_angle(program, dimensions, x, point);
    const std::size_t guided = target.target_of(point);
    const bool body = target.guides_body_at(point);
    const Reads& reads = body ? mechanism.body_of(guided)->reads : mechanism.point->reads;
    auto& r = t.residuals;
    t.arguments = reads.size() + 1;
    t.count = residuals_per_point(program);
    PoseMiss miss{into(r[0], r[1], order), into(r[2], r[3], order)};
    if (body) {
        const double direction = target.faces(point) ? target.directions[point] : 0;
        miss_of_body(mechanism, program.form(guided), dimensions, angle.angle, program.targets[point],
                     {std::cos(direction), std::sin(direction)}, miss);
        r[2].value = miss.turn.miss.x;
        r[3].value = miss.turn.miss.y;
        const double length = target.faces(point) ? target.body_length_at(point) / program.length : 0;
        scale(r[2], length, t.arguments, order);
        scale(r[3], length, t.arguments, order);
    } else {
        miss_of_point(mechanism, program.form(guided), dimensions, angle.angle, program.targets[point], miss.place);
        // Beside poses a point that has no direction misses none.
        for (std::size_t c = 2; c < t.count; ++c)
            set_zero(r[c], t.arguments, order);
    }
    r[0].value = miss.place.miss.x;
    r[1].value = miss.place.miss.y;
    t.margin = miss.place.margin;
    t.square = 0;
    for (const Residual& residual : t.all())
        t.square += residual.value * residual.value;
    if (order == 0) return;
    bool tied = false;
    for (std::size_t i = 0; i < reads.size(); ++i) {
        t.variable[i] = program.variable_of[reads[i]];
        tied = tied || program.problem->dimensions[reads[i]].tied();
    }
    t.variable[reads.size()] = angle.variable;
    if (tied) by_variables(program, reads, order, t);
}

/// Whether a point counts in a mean.
bool counts(const PathBlock::Mean& mean, const PathTarget& target, std::size_t point) {
    return mean.of_target == every_target || target.target_of(point) == mean.of_target;
}

double weight_sum(const PathTarget& target, const PathBlock::Mean& mean) {
    const PointRange points = target.points_of(mean.of_target);
    double sum = 0;
    for (std::size_t i = points.first; i < points.end(); ++i)
        sum += target.weights[i];
    return sum;
}

/// Sums and means, once the sums are known.
void write_means(const Program& program, bool derivatives, Outputs& out) {
    for (std::size_t m = 0; m < program.path->means.size(); ++m) {
        const PathBlock::Mean& mean = program.path->means[m];
        const auto column = static_cast<Index>(m);
        const double sum = out.path_sums[column];
        if (mean.sum) {
            out.value[static_cast<Index>(*mean.sum)] = sum;
            if (derivatives)
                out.jacobian.row(static_cast<Index>(*mean.sum)) = out.path_gradients.col(column).transpose();
        }
        if (!mean.rms) continue;
        const double weights = weight_sum(*program.problem->path, mean);
        const double rms = std::sqrt(sum / weights);
        out.value[static_cast<Index>(*mean.rms)] = rms;
        if (derivatives && rms > 0)
            out.jacobian.row(static_cast<Index>(*mean.rms)) =
                out.path_gradients.col(column).transpose() / (2 * weights * rms);
    }
}

}  // namespace

void set_dimensions(const Program& program, const VectorXd& x, std::vector<double>& dimensions) {
    dimensions = program.dimensions;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        for (const LinearTerm& term : program.follows[i])
            dimensions[i] += term.factor * x[static_cast<Index>(term.index)];
}

std::vector<double> dimensions_at(const Program& program, const VectorXd& x) {
    std::vector<double> dimensions;
    set_dimensions(program, x, dimensions);
    return dimensions;
}

double unit_of_input(const Program& program) {
    return input_unit(*program.problem->mechanism) == Unit::length ? program.length : 1;
}

std::optional<std::array<double, 2>> stroke_of(const Program& program) {
    const auto reach = reach_of_input(*program.problem->mechanism);
    if (!reach) return {};
    return std::array{(*reach)[0] / program.length, (*reach)[1] / program.length};
}

PathAngle path_angle(const Program& program, std::span<const double> dimensions, const VectorXd& x, std::size_t point) {
    if (program.untimed_path()) {
        const auto variable = static_cast<std::ptrdiff_t>(program.first_path_angle + point);
        return {x[variable], variable};
    }
    const std::size_t start = program.problem->mechanism->roles_of(program.problem->path->target_of(point)).start;
    return {dimensions[start] + program.problem->path->crank_angles[point] / unit_of_input(program),
            program.variable_of[start]};
}

bool evaluate_path(const Program& program, const VectorXd& x, bool derivatives, Outputs& out) {
    const PathBlock& path = *program.path;
    const PathTarget& target = *program.problem->path;
    PointTerms t;
    const auto means = static_cast<Index>(path.means.size());
    const auto mean = [&](Index m) -> const PathBlock::Mean& { return path.means[static_cast<std::size_t>(m)]; };
    out.path_sums.setZero(means);
    if (derivatives) out.path_gradients.setZero(static_cast<Index>(program.size()), means);
    for (std::size_t i = 0; i < program.targets.size(); ++i) {
        evaluate_point(program, out.dimensions, x, i, derivatives ? 1 : 0, t);
        if (!(t.margin >= 0)) return false;
        const double w = target.weights[i];
        const double distance = std::sqrt(t.square);
        for (Index m = 0; m < means; ++m)
            if (counts(mean(m), target, i)) out.path_sums[m] += w * t.square;
        const auto square_row = static_cast<Index>(path.squares.value_or(0) + i);
        const auto distance_row = static_cast<Index>(path.distances.value_or(0) + i);
        const auto miss_row = static_cast<Index>(path.misses.value_or(0) + i * t.count);
        if (path.squares) out.value[square_row] = t.square;
        if (path.distances) out.value[distance_row] = distance;
        for (std::size_t c = 0; path.misses && c < t.count; ++c)
            out.value[miss_row + static_cast<Index>(c)] = t.residuals[c].value;
        if (!derivatives) continue;
        for (std::size_t k = 0; k < t.arguments; ++k) {
            if (t.variable[k] < 0) continue;
            const double g = t.slope(k);
            for (Index m = 0; m < means; ++m)
                if (counts(mean(m), target, i)) out.path_gradients(t.variable[k], m) += w * g;
            if (path.squares) out.jacobian(square_row, t.variable[k]) += g;
            if (path.distances && distance > 0) out.jacobian(distance_row, t.variable[k]) += g / (2 * distance);
            for (std::size_t c = 0; path.misses && c < t.count; ++c)
                out.jacobian(miss_row + static_cast<Index>(c), t.variable[k]) += t.residuals[c].gradient[k];
        }
    }
    write_means(program, derivatives, out);
    // What is not finite at a point shows in the sum of all.
    return std::isfinite(out.path_sums[0]) && (!derivatives || out.path_gradients.col(0).allFinite());
}

namespace {

double root_mean_square(const Program& program, const VectorXd& x, const PathBlock::Mean& mean,
                        std::span<const double> dimensions) {
    const PathTarget& target = *program.problem->path;
    const PointRange points = target.points_of(mean.of_target);
    PointTerms t;
    double sum = 0;
    for (std::size_t i = points.first; i < points.end(); ++i) {
        evaluate_point(program, dimensions, x, i, 0, t);
        sum += target.weights[i] * t.square;
    }
    return std::sqrt(sum / weight_sum(target, mean));
}

}  // namespace

void add_path_hessian(const Program& program, const VectorXd& x, LagrangianHessian& out) {
    const PathBlock& path = *program.path;
    const PathTarget& target = *program.problem->path;
    const auto weight_at = [&](const std::optional<std::size_t>& output, std::size_t offset) {
        return output ? out.weights[static_cast<Index>(*output + offset)] : 0.0;
    };
    const std::size_t each = residuals_per_point(program), means = path.means.size();
    PointTerms t;
    VectorXd& roots = out.path_roots;
    roots.setZero(static_cast<Index>(means));
    for (std::size_t m = 0; m < means; ++m)
        if (weight_at(path.means[m].rms, 0) != 0)
            roots[static_cast<Index>(m)] = root_mean_square(program, x, path.means[m], out.dimensions);
    MatrixXd& hessian = out.value;
    out.path_gradients.setZero(static_cast<Index>(program.size()), static_cast<Index>(means));
    for (std::size_t i = 0; i < program.targets.size(); ++i) {
        const double w = target.weights[i];
        const double on_square = weight_at(path.squares, i);
        const double on_distance = weight_at(path.distances, i);
        std::array<double, 4> on_miss{};
        for (std::size_t c = 0; c < each; ++c)
            on_miss[c] = weight_at(path.misses, i * each + c);
        const bool misses = std::any_of(on_miss.begin(), on_miss.end(), [](double weight) { return weight != 0; });
        double by_sums = 0, by_roots = 0;
        bool in_mean = false;
        for (std::size_t m = 0; m < means; ++m) {
            const PathBlock::Mean& mean = path.means[m];
            if (!counts(mean, target, i)) continue;
            const double on_sum = weight_at(mean.sum, 0), on_rms = weight_at(mean.rms, 0);
            const double rms = roots[static_cast<Index>(m)];
            in_mean = in_mean || on_sum != 0 || on_rms != 0;
            by_sums += on_sum * w;
            if (rms > 0) by_roots += on_rms * w / (2 * weight_sum(target, mean) * rms);
        }
        if (!in_mean && on_square == 0 && on_distance == 0 && !misses) continue;
        evaluate_point(program, out.dimensions, x, i, 2, t);
        const double distance = std::sqrt(t.square);
        const double on_q = by_sums + on_square + by_roots + (distance > 0 ? on_distance / (2 * distance) : 0);
        const double on_gradient_square = distance > 0 ? on_distance / (4 * t.square * distance) : 0;
        std::array<double, most_arguments> g;
        for (std::size_t k = 0; k < t.arguments; ++k) {
            g[k] = t.slope(k);
            for (std::size_t m = 0; t.variable[k] >= 0 && m < means; ++m)
                if (counts(path.means[m], target, i))
                    out.path_gradients(t.variable[k], static_cast<Index>(m)) += w * g[k];
        }
        for (std::size_t k = 0, at = 0; k < t.arguments; ++k)
            for (std::size_t l = 0; l <= k; ++l, ++at) {
                const std::ptrdiff_t a = t.variable[k];
                const std::ptrdiff_t b = t.variable[l];
                if (a < 0 || b < 0) continue;
                double q = 0;
                for (const Residual& r : t.all())
                    q += 2 * (r.gradient[k] * r.gradient[l] + r.value * r.hessian[at]);
                double h = on_q * q - on_gradient_square * g[k] * g[l];
                for (std::size_t c = 0; misses && c < each; ++c)
                    h += on_miss[c] * t.residuals[c].hessian[at];
                hessian(a, b) += h;
                if (k != l) hessian(b, a) += h;
            }
    }
    for (std::size_t m = 0; m < means; ++m) {
        const double rms = roots[static_cast<Index>(m)];
        if (!(rms > 0)) continue;
        const double on_rms = weight_at(path.means[m].rms, 0), total = weight_sum(target, path.means[m]);
        const auto gradient = out.path_gradients.col(static_cast<Index>(m));
        hessian.noalias() -=
            (on_rms / (4 * total * total * rms * rms * rms) * gradient).lazyProduct(gradient.transpose());
    }
}

bool path_residuals(const Program& program, const VectorXd& x, bool derivatives, PathResiduals& out) {
    set_dimensions(program, x, out.dimensions);
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
        evaluate_point(program, out.dimensions, x, i, derivatives ? 1 : 0, t);
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

}  // namespace mechwright
