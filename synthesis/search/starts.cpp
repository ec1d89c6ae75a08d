#include "synthesis/search/starts.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>
#include <vector>

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

const PathRoles& roles_of(const Program& program) { return program.problem->mechanism->point->roles; }

/// Beside a path no dimension is tied to another: each has a variable of its own, or none.
bool is_free(const Program& program, std::size_t dimension) { return program.variable_of[dimension] >= 0; }

const Variable& variable_of(const Program& program, std::size_t dimension) {
    return program.variables[static_cast<std::size_t>(program.variable_of[dimension])];
}

/// Whether a dimension belongs to the links, and grows with them.
bool grows_with_links(const Program& program, std::size_t dimension) {
    const PathRoles& roles = roles_of(program);
    const Dimension& d = program.problem->mechanism->dimensions[dimension];
    const auto placed = {roles.along, roles.across, roles.origin_x, roles.origin_y};
    return scales(d.kind) && !d.of_target && std::find(placed.begin(), placed.end(), dimension) == placed.end();
}

/// What of a placement is fitted, each one complex number.
struct Fitted {
    bool origin, size, point;
    Index count() const { return Index{origin} + Index{size} + Index{point}; }
};

/// The size is free where every dimension that grows with the links is, or stays 0.
Fitted fitted_of(const Program& program, const std::vector<double>& dimensions) {
    const PathRoles& roles = roles_of(program);
    const auto both = [&](std::size_t a, std::size_t b) { return is_free(program, a) && is_free(program, b); };
    bool size = is_free(program, roles.tilt);
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (grows_with_links(program, i)) size = size && (is_free(program, i) || dimensions[i] == 0);
    return {both(roles.origin_x, roles.origin_y), size, both(roles.along, roles.across)};
}

/// A placement as complex numbers: the guided point on its link, the origin, and Z of the tilt and the size.
struct Placement {
    Complex point, origin, turn;
};

Placement placement_of(const Program& program, const std::vector<double>& dimensions) {
    const PathRoles& roles = roles_of(program);
    return {{dimensions[roles.along], dimensions[roles.across]},
            {dimensions[roles.origin_x], dimensions[roles.origin_y]},
            std::polar(1.0, dimensions[roles.tilt])};
}

/// The guiding link at the crank angle of a target, without a placement: its own point and its direction.
struct GuidingLink {
    Complex point, direction;
};

/// Nothing where the mechanism does not assemble.
std::optional<GuidingLink> guiding_link(const Program& program, std::vector<double> dimensions, double crank_angle) {
    const PathRoles& roles = roles_of(program);
    const Mechanism& mechanism = *program.problem->mechanism;
    for (const std::size_t i : {roles.along, roles.across, roles.origin_x, roles.origin_y, roles.tilt})
        dimensions[i] = 0;
    double margin = 0;
    const auto guided_point = [&](double along) {
        dimensions[roles.along] = along;
        PathMiss miss{};
        miss_of_point(mechanism, program.variant.assembly, dimensions, crank_angle, {0, 0}, miss);
        margin = miss.margin;
        return -Complex(miss.miss.x, miss.miss.y);
    };
    const Complex point = guided_point(0), next = guided_point(1);
    if (!(margin >= 0)) return std::nullopt;
    return GuidingLink{point, next - point};
}

/// The guiding link at every target; empty where the mechanism does not assemble at one of them.
std::vector<GuidingLink> guiding_links(const Program& program, const std::vector<double>& dimensions,
                                       const VectorXd& x) {
    std::vector<GuidingLink> all;
    for (std::size_t k = 0; k < program.targets.size(); ++k) {
        const auto link = guiding_link(program, dimensions, path_angle(program, dimensions, x, k).angle);
        if (!link) return {};
        all.push_back(*link);
    }
    return all;
}

/// O, Z and Y, as far as they are fitted, by least squares with the weights of the targets.
Eigen::VectorXcd solved_placement(const Program& program, const Fitted& fitted, const Placement& now,
                                  const std::vector<GuidingLink>& links) {
    const auto n = static_cast<Index>(links.size());
    Eigen::MatrixXcd columns(n, fitted.count());
    Eigen::VectorXcd target(n);
    for (Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const auto& [p, w] = links[k];
        const double weight = std::sqrt(program.problem->path->weights[k]);
        const Complex of_links = fitted.point ? p : p + now.point * w;
        Complex known(0);
        Index column = 0;
        if (fitted.origin)
            columns(i, column++) = weight;
        else
            known += now.origin;
        if (fitted.size)
            columns(i, column++) = weight * of_links;
        else
            known += now.turn * of_links;
        if (fitted.point) columns(i, column++) = weight * w;
        target[i] = weight * (Complex(program.targets[k].x, program.targets[k].y) - known);
    }
    return columns.colPivHouseholderQr().solve(target);
}

void set_length(const Program& program, std::size_t dimension, double value, VectorXd& x) {
    const Variable& v = variable_of(program, dimension);
    x[program.variable_of[dimension]] = std::clamp(value, v.lower, v.upper);
}

void set_angle(const Program& program, std::size_t dimension, double angle, VectorXd& x) {
    const Variable& v = variable_of(program, dimension);
    x[program.variable_of[dimension]] = into_range(angle, v.lower, v.upper);
}

/// Makes the links larger, and with them a guided point that is not fitted by itself.
void resize_links(const Program& program, const Fitted& fitted, double size, VectorXd& x) {
    const PathRoles& roles = roles_of(program);
    for (std::size_t i = 0; i < program.variable_of.size(); ++i) {
        const bool grows = grows_with_links(program, i) || (!fitted.point && (i == roles.along || i == roles.across));
        if (grows && is_free(program, i)) set_length(program, i, size * x[program.variable_of[i]], x);
    }
}

/// Turns a guided body so that it faces as it is asked to, in the mean of all directions that are given.
void turn_body(const Program& program, const std::vector<GuidingLink>& links, const Complex& turn, VectorXd& x) {
    const PathTarget& path = *program.problem->path;
    Complex facing(0);  ///< from the guiding link to the directions
    for (std::size_t k = 0; k < links.size(); ++k)
        if (path.faces(k))
            facing += path.weights[k] * std::conj(links[k].direction) * std::polar(1.0, path.directions[k]);
    set_angle(program, roles_of(program).body, std::arg(facing / turn), x);
}

}  // namespace

void fit_placement(const Program& program, VectorXd& x) {
    const PathRoles& roles = roles_of(program);
    const std::vector<double> dimensions = dimensions_at(program, x);
    const Fitted fitted = fitted_of(program, dimensions);
    const auto n = static_cast<Index>(program.targets.size());
    if (fitted.count() == 0 || n < fitted.count()) return;
    const std::vector<GuidingLink> links = guiding_links(program, dimensions, x);
    if (links.empty()) return;
    const Placement now = placement_of(program, dimensions);
    const Eigen::VectorXcd solved = solved_placement(program, fitted, now, links);
    if (!solved.real().allFinite() || !solved.imag().allFinite()) return;

    Index column = 0;
    if (fitted.origin) {
        const Complex origin = solved[column++];
        set_length(program, roles.origin_x, origin.real(), x);
        set_length(program, roles.origin_y, origin.imag(), x);
    }
    Complex turn = now.turn;
    if (fitted.size) {
        const Complex z = solved[column++];
        const double size = std::abs(z);
        if (!(size > 0)) return;
        turn = z / size;
        resize_links(program, fitted, size, x);
        set_angle(program, roles.tilt, std::arg(z), x);
    }
    if (program.problem->path->guides_body() && is_free(program, roles.body)) turn_body(program, links, turn, x);
    if (fitted.point) {
        const Complex point = solved[column] / turn;
        set_length(program, roles.along, point.real(), x);
        set_length(program, roles.across, point.imag(), x);
    }
}

namespace {

/// Lengths that come close to the function, within their ranges.
void fit_function(const Program& program, VectorXd& x) {
    const Mechanism& mechanism = *program.problem->mechanism;
    std::vector<double> dimensions = dimensions_at(program, x);
    const std::size_t start = mechanism.input->start;
    const auto turns = [&](std::size_t dimension) { return program.variable_of[dimension] >= 0; };
    const std::span<double, 4> scales(dimensions.data() + start, 4);
    if (!mechanism.function->fit(*program.problem->function, dimensions, scales, turns(start), turns(start + 2)))
        return;
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
    const std::size_t numbers = shape.numbers.size();
    for (std::size_t k = 0; k < numbers; ++k)
        free[k] = program.variable_of[shape.place + k] >= 0;
    std::array<double, Reads::most> room;
    const Mechanism& mechanism = *program.problem->mechanism;
    shape.fit(mechanism.form(program.variant.assembly),
              deviation_from(mechanism, shape.name).reads.of(dimensions, room),
              std::span(dimensions).subspan(shape.place, numbers), free);
    for (std::size_t k = 0; k < numbers; ++k) {
        if (!free[k]) continue;
        const std::ptrdiff_t v = program.variable_of[shape.place + k];
        const Variable& variable = program.variables[static_cast<std::size_t>(v)];
        x[v] = std::clamp(dimensions[shape.place + k], variable.lower, variable.upper);
    }
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
        if (program.problem->function) fit_function(program, x);
        if (program.problem->followed) fit_followed(program, x);
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
            if (program.variable_of[i] >= 0 && !program.problem->dimensions[i].tied())
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
