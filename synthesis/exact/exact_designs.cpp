#include "synthesis/exact/exact_designs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "synthesis/mechanism/mechanism.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

/// Distances from targets that are met, over the size of what they are computed from.
constexpr double met_within = 1e-9;

/// Which dimension lies farthest outside its range, where that is more than rounding.
std::string range_defect(const Problem& problem, const Design& design) {
    std::string defect;
    double worst = problem.solver.tolerance;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double value = design.dimensions[i];
        const double size = std::max({std::abs(range.min), std::abs(range.max), 1e-300});
        const double beyond = std::max(range.min - value, value - range.max) / size;
        if (beyond <= worst) continue;
        worst = beyond;
        const Dimension& dimension = problem.mechanism->dimensions[i];
        const auto outside = [&](double x) { return in_file_unit(x, unit_of(dimension.kind), problem.units); };
        defect =
            fmt::format("range: {} is {:.6g}, asked for {:.6g}", dimension.name, outside(value), outside(range.min));
        if (!range.fixed()) defect += fmt::format(" to {:.6g}", outside(range.max));
    }
    return defect;
}

/// The target that is missed most, where that is more than rounding: a solution that is none.
std::string miss_defect(const Problem& problem, const Design& design) {
    if (!problem.path) return {};
    const auto values = path_values(problem, design);
    if (!values) return "branch: it does not assemble at every target";
    double size = 0;
    for (const Vector<double>& point : problem.path->points)
        size = std::max({size, std::abs(point.x), std::abs(point.y)});
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (scales(problem.mechanism->dimensions[i].kind)) size = std::max(size, std::abs(design.dimensions[i]));
    if (values->greatest <= met_within * size) return {};
    return fmt::format("accuracy: a target is missed by {:.3g}", values->greatest);
}

/// An angle of a full turn, moved by whole turns into its range where that can be done.
double moved_into(double angle, const DimensionRange& range) {
    constexpr double turn = 2 * std::numbers::pi;
    const double moved = angle + turn * std::ceil((range.min - angle) / turn);
    return moved <= range.max ? moved : angle;
}

void move_angles_into_ranges(const Problem& problem, Design& design) {
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::angle)
            design.dimensions[i] = moved_into(design.dimensions[i], problem.dimensions[i]);
}

Design design_of(const Problem& problem, const GuidedLinkage& found) {
    const auto& [links, point, placement, assembly] = found.linkage;
    const PathRoles& roles = problem.mechanism->path_roles;
    Design design;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.min);
    auto& d = design.dimensions;
    d[0] = links.ground;
    d[1] = links.crank;
    d[2] = links.coupler;
    d[3] = links.rocker;
    d[roles.along] = point.along;
    d[roles.across] = point.across;
    d[roles.origin_x] = placement.origin.x;
    d[roles.origin_y] = placement.origin.y;
    d[roles.tilt] = placement.tilt;
    const auto& directions = problem.path->directions;
    const auto first = std::find_if(directions.begin(), directions.end(), [](double a) { return !std::isnan(a); });
    if (first != directions.end()) d[roles.body] = *first - found.coupler_direction;
    if (problem.path->prescribed_timing)
        d[roles.start] = found.crank_angles.front() - problem.path->crank_angles.front();
    design.assembly = assembly == Assembly::open ? 0 : 1;
    move_angles_into_ranges(problem, design);
    return design;
}

ExactDesign without_value(Design design, std::string defect) {
    ExactDesign out;
    out.solution.design = std::move(design);
    out.solution.objective = std::nan("");
    out.solution.violation = std::numeric_limits<double>::infinity();
    out.defect = std::move(defect);
    return out;
}

}  // namespace

ExactDesign exact_design(const Problem& problem, Design design) {
    ExactDesign out{assess(problem, std::move(design)), {}};
    const Design& assessed = out.solution.design;
    const auto& assemblies = problem.assemblies;
    if (std::string missed = miss_defect(problem, assessed); !missed.empty())
        out.defect = std::move(missed);
    else if (std::find(assemblies.begin(), assemblies.end(), assessed.assembly) == assemblies.end())
        out.defect = "assembly: it is not the one that is asked for";
    else if (std::string range = range_defect(problem, assessed); !range.empty())
        out.defect = std::move(range);
    else if (!out.solution.feasible)
        out.defect = std::isfinite(out.solution.violation)
                         ? fmt::format("requirements: violated by {:.3g}, relative", out.solution.violation)
                         : "requirements: a quantity that is asked for has no value";
    return out;
}

ExactDesign exact_design(const Problem& problem, const GuidedLinkage& found) {
    Design design = design_of(problem, found);
    if (!found.one_assembly)
        return without_value(std::move(design), "branch: it has to be taken apart between the points");
    if (problem.path->prescribed_timing) {
        for (const double angle : problem.path->crank_angles)
            design.path_angles.push_back(design.dimensions[problem.mechanism->path_roles.start] + angle);
    } else if (const auto angles = in_order(found.crank_angles)) {
        design.path_angles = *angles;
    } else {
        return without_value(std::move(design), "order: the crank does not meet the points in their order");
    }
    return exact_design(problem, std::move(design));
}

void add_design(ExactDesigns& out, ExactDesign design) {
    if (design.defect.empty())
        out.designs.push_back(std::move(design.solution));
    else
        out.excluded.push_back({std::move(design.solution), std::move(design.defect)});
}

void keep_better(const Problem& problem, std::optional<ExactDesign>& best, ExactDesign design) {
    const auto is_better = [&] {
        if (best->defect.empty() != design.defect.empty()) return design.defect.empty();
        return preferred(problem, design.solution, best->solution);
    };
    if (!best || is_better()) best = std::move(design);
}

void rank(const Problem& problem, ExactDesigns& out) {
    std::stable_sort(out.designs.begin(), out.designs.end(),
                     [&](const Solution& a, const Solution& b) { return preferred(problem, a, b); });
}

}  // namespace mechwright
