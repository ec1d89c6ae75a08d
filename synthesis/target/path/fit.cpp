#include "synthesis/target/path/fit.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <complex>
#include <numeric>
#include <optional>
#include <vector>

#include "synthesis/target/path/rows/path_outputs.h"

namespace mechwright {

namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Complex = std::complex<double>;

/// Of the point that a target guides; the placement is the same for all.
const PathRoles& roles_of(const Program& program, std::size_t target = 0) {
    return program.problem->mechanism->roles_of(target);
}

std::size_t targets_of(const Program& program) { return program.problem->path->targets(); }

/// Whether a dimension has a variable of its own.
bool is_free(const Program& program, std::size_t dimension) {
    return dimension != no_dimension && program.variable_of[dimension] >= 0;
}

const Variable& variable_of(const Program& program, std::size_t dimension) {
    return program.variables[static_cast<std::size_t>(program.variable_of[dimension])];
}

/// Whether a dimension belongs to the links, and grows with them.
bool grows_with_links(const Program& program, std::size_t dimension) {
    const Dimension& d = program.problem->mechanism->dimensions[dimension];
    if (!scales(d.kind) || d.of_target) return false;
    for (std::size_t target = 0; target < targets_of(program); ++target) {
        const PathRoles& roles = roles_of(program, target);
        const auto placed = {roles.along, roles.across, roles.origin_x, roles.origin_y};
        if (std::find(placed.begin(), placed.end(), dimension) != placed.end()) return false;
    }
    return true;
}

/// What of a placement is fitted, each one complex number; of each target whether its point is.
struct Fitted {
    bool origin, size;
    std::vector<bool> point;
    Index count() const {
        return Index{origin} + Index{size} + static_cast<Index>(std::count(point.begin(), point.end(), true));
    }
    /// The column of a target's point.
    Index column_of(std::size_t target) const {
        const auto before = point.begin() + static_cast<std::ptrdiff_t>(target);
        return Index{origin} + Index{size} + static_cast<Index>(std::count(point.begin(), before, true));
    }
};

/// Whether a dimension is a sum of multiples of others, which grows when they do.
bool is_of_others(const Program& program, std::size_t dimension) {
    const DimensionRange& range = program.problem->dimensions[dimension];
    return range.tied() && range.tie.constant == 0;
}

/// The size is free where every dimension that grows with the links is, or stays 0.
Fitted fitted_of(const Program& program, const std::vector<double>& dimensions) {
    const PathRoles& roles = roles_of(program);
    const auto both = [&](std::size_t a, std::size_t b) { return is_free(program, a) && is_free(program, b); };
    const Mechanism& mechanism = *program.problem->mechanism;
    const bool has_own_lengths = is_described(mechanism) && mechanism.model_over;
    bool size = is_free(program, roles.tilt) && !has_own_lengths;
    for (std::size_t i = 0; i < dimensions.size(); ++i)
        if (grows_with_links(program, i))
            size = size && (is_free(program, i) || is_of_others(program, i) || dimensions[i] == 0);
    Fitted fitted{both(roles.origin_x, roles.origin_y), size, {}};
    for (std::size_t target = 0; target < targets_of(program); ++target)
        fitted.point.push_back(both(roles_of(program, target).along, roles_of(program, target).across));
    return fitted;
}

/// A placement as complex numbers: the origin, Z of the tilt and the size, and each guided point on its link.
struct Placement {
    Complex origin, turn;
    std::vector<Complex> points{};
};

Placement placement_of(const Program& program, const std::vector<double>& dimensions) {
    const PathRoles& roles = roles_of(program);
    const auto at = [&](std::size_t i) { return i == no_dimension ? 0 : dimensions[i]; };
    Placement placement{{at(roles.origin_x), at(roles.origin_y)}, std::polar(1.0, at(roles.tilt))};
    for (std::size_t target = 0; target < targets_of(program); ++target)
        placement.points.emplace_back(at(roles_of(program, target).along), at(roles_of(program, target).across));
    return placement;
}

/// The guiding link at the crank angle of a target, without a placement: its own point and its direction. Where the
/// point has no coordinates of its own it is the guided point, and no direction is known.
struct GuidingLink {
    Complex point, direction;
};

/// Nothing where the mechanism does not assemble.
std::optional<GuidingLink> guiding_link(const Program& program, std::size_t target, std::vector<double>& dimensions,
                                        double crank_angle) {
    const PathRoles& roles = roles_of(program, target);
    const Mechanism& mechanism = *program.problem->mechanism;
    for (const std::size_t i : {roles.along, roles.across, roles.origin_x, roles.origin_y, roles.tilt})
        if (i != no_dimension) dimensions[i] = 0;
    double margin = 0;
    const auto guided_point = [&](double along) {
        if (roles.along != no_dimension) dimensions[roles.along] = along;
        PathMiss miss{};
        miss_of_point(mechanism, program.form(target), dimensions, crank_angle, {0, 0}, miss);
        margin = miss.margin;
        return -Complex(miss.miss.x, miss.miss.y);
    };
    const Complex point = guided_point(0);
    if (!(margin >= 0)) return std::nullopt;
    return GuidingLink{point, roles.along == no_dimension ? Complex(0) : guided_point(1) - point};
}

/// The guiding link at every target; empty where the mechanism does not assemble at one of them.
std::vector<GuidingLink> guiding_links(const Program& program, const std::vector<double>& dimensions,
                                       const VectorXd& x) {
    std::vector<GuidingLink> all(program.targets.size());
    std::vector<double> own = dimensions;
    for (const std::size_t k : spread_out(all.size())) {
        const auto link = guiding_link(program, program.problem->path->target_of(k), own,
                                       path_angle(program, dimensions, x, k).angle);
        if (!link) return {};
        all[k] = *link;
    }
    return all;
}

/// O, Z and Y, as far as they are fitted, by least squares with the weights of the targets.
Eigen::VectorXcd solved_placement(const Program& program, const Fitted& fitted, const Placement& now,
                                  const std::vector<GuidingLink>& links) {
    const auto n = static_cast<Index>(links.size());
    Eigen::MatrixXcd columns = Eigen::MatrixXcd::Zero(n, fitted.count());
    Eigen::VectorXcd target(n);
    for (Index i = 0; i < n; ++i) {
        const auto k = static_cast<std::size_t>(i);
        const auto& [p, w] = links[k];
        const double weight = std::sqrt(program.problem->path->weights[k]);
        const std::size_t guided = program.problem->path->target_of(k);
        const bool point = fitted.point[guided];
        const Complex of_links = point ? p : p + now.points[guided] * w;
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
        if (point) columns(i, fitted.column_of(guided)) = weight * w;
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
    const auto is_of_kept_point = [&](std::size_t i) {
        for (std::size_t target = 0; target < targets_of(program); ++target) {
            const PathRoles& roles = roles_of(program, target);
            if (!fitted.point[target] && (i == roles.along || i == roles.across)) return true;
        }
        return false;
    };
    for (std::size_t i = 0; i < program.variable_of.size(); ++i) {
        const bool grows = grows_with_links(program, i) || is_of_kept_point(i);
        if (grows && is_free(program, i)) set_length(program, i, size * x[program.variable_of[i]], x);
    }
}

/// Turns the guided body of a target so that it faces as it is asked to, in the mean of all directions that are given.
void turn_body(const Program& program, std::size_t target, const std::vector<GuidingLink>& links, const Complex& turn,
               VectorXd& x) {
    const PathTarget& path = *program.problem->path;
    const PointRange points = path.points_of(target);
    Complex facing(0);  ///< from the guiding link to the directions
    for (std::size_t k = points.first; k < points.end(); ++k)
        if (path.faces(k))
            facing += path.weights[k] * std::conj(links[k].direction) * std::polar(1.0, path.directions[k]);
    set_angle(program, roles_of(program, target).body, std::arg(facing / turn), x);
}

bool has_poses(const PathTarget& path, std::size_t target) {
    return path.parts.empty() ? path.guides_body() : path.parts[target].guides_body;
}

/// Whether the numbers of a placement that are free can be told from so many targets.
bool can_fit(const Program& program, const Fitted& fitted) {
    const PathRoles& roles = roles_of(program);
    const bool is_placed =
        roles.origin_x != no_dimension && roles.origin_y != no_dimension && roles.tilt != no_dimension;
    return is_placed && fitted.count() > 0 && static_cast<Index>(program.targets.size()) >= fitted.count();
}

void fit_to(const Program& program, const std::vector<double>& dimensions, const Fitted& fitted,
            const std::vector<GuidingLink>& links, VectorXd& x) {
    const PathRoles& roles = roles_of(program);
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
    for (std::size_t target = 0; target < targets_of(program); ++target) {
        const PathRoles& own = roles_of(program, target);
        if (own.along != no_dimension && is_free(program, own.body) && has_poses(*program.problem->path, target))
            turn_body(program, target, links, turn, x);
        if (!fitted.point[target]) continue;
        const Complex point = solved[fitted.column_of(target)] / turn;
        set_length(program, own.along, point.real(), x);
        set_length(program, own.across, point.imag(), x);
    }
}

}  // namespace

void fit_placement(const Program& program, VectorXd& x) {
    const std::vector<double> dimensions = dimensions_at(program, x);
    const Fitted fitted = fitted_of(program, dimensions);
    if (!can_fit(program, fitted)) return;
    const std::vector<GuidingLink> links = guiding_links(program, dimensions, x);
    if (!links.empty()) fit_to(program, dimensions, fitted, links, x);
}

/// By steps of nearly the golden section of n.
std::vector<std::size_t> spread_out(std::size_t n) {
    constexpr double golden = 0.6180339887498949;
    auto step = std::max<std::size_t>(1, static_cast<std::size_t>(golden * static_cast<double>(n)));
    while (std::gcd(step, n) != 1)
        ++step;
    std::vector<std::size_t> all(n);
    for (std::size_t i = 0; i < n; ++i)
        all[i] = i * step % n;
    return all;
}

bool fit_assembled(const Program& program, VectorXd& x) {
    const std::vector<double> dimensions = dimensions_at(program, x);
    const std::vector<GuidingLink> links = guiding_links(program, dimensions, x);
    if (links.empty()) return false;
    const Fitted fitted = fitted_of(program, dimensions);
    if (can_fit(program, fitted)) fit_to(program, dimensions, fitted, links, x);
    return true;
}

}  // namespace mechwright
