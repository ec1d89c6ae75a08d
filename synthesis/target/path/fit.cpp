#include "synthesis/target/path/fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <optional>
#include <vector>

#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Complex = std::complex<double>;

const PathRoles& roles_of(const Program& program) { return program.problem->mechanism->point->roles; }

/// Beside a path no dimension is tied to another: each has a variable of its own, or none.
bool is_free(const Program& program, std::size_t dimension) {
    return dimension != no_dimension && program.variable_of[dimension] >= 0;
}

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
    bool size = is_free(program, roles.tilt) && !program.problem->mechanism->model_over;
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
    const auto at = [&](std::size_t i) { return i == no_dimension ? 0 : dimensions[i]; };
    return {
        {at(roles.along), at(roles.across)}, {at(roles.origin_x), at(roles.origin_y)}, std::polar(1.0, at(roles.tilt))};
}

/// The guiding link at the crank angle of a target, without a placement: its own point and its direction. Where the
/// point has no coordinates of its own it is the guided point, and no direction is known.
struct GuidingLink {
    Complex point, direction;
};

/// Nothing where the mechanism does not assemble.
std::optional<GuidingLink> guiding_link(const Program& program, std::vector<double> dimensions, double crank_angle) {
    const PathRoles& roles = roles_of(program);
    const Mechanism& mechanism = *program.problem->mechanism;
    for (const std::size_t i : {roles.along, roles.across, roles.origin_x, roles.origin_y, roles.tilt})
        if (i != no_dimension) dimensions[i] = 0;
    double margin = 0;
    const auto guided_point = [&](double along) {
        if (roles.along != no_dimension) dimensions[roles.along] = along;
        PathMiss miss{};
        miss_of_point(mechanism, program.form(), dimensions, crank_angle, {0, 0}, miss);
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
    const bool is_placed =
        roles.origin_x != no_dimension && roles.origin_y != no_dimension && roles.tilt != no_dimension;
    if (!is_placed || fitted.count() == 0 || n < fitted.count()) return;
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
    const bool turns = roles.along != no_dimension && is_free(program, roles.body);
    if (program.problem->path->guides_body() && turns) turn_body(program, links, turn, x);
    if (fitted.point) {
        const Complex point = solved[column] / turn;
        set_length(program, roles.along, point.real(), x);
        set_length(program, roles.across, point.imag(), x);
    }
}

}  // namespace mechwright
