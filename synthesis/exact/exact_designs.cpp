#include "synthesis/exact/exact_designs.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
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
    constexpr double rounding = 1e-11;
    const double moved = angle + turn * std::ceil((range.min - rounding - angle) / turn);
    return moved <= range.max + rounding ? std::clamp(moved, range.min, range.max) : angle;
}

void move_angles_into_ranges(const Problem& problem, Design& design) {
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::angle)
            design.dimensions[i] = moved_into(design.dimensions[i], problem.dimensions[i]);
}

/// By how much the loop closes, at least, on the way from the first target to the last, relative to its size; < 0 where
/// the linkage would have to be taken apart between them. Infinite without a path.
double least_closure(const Problem& problem, const Design& design) {
    constexpr double none = std::numeric_limits<double>::infinity();
    if (design.path_angles.size() < 2) return none;
    const auto& families = problem.mechanism->families;
    const auto limited =
        std::find_if(families.begin(), families.end(), [](const Family& f) { return f.assembly_margin != nullptr; });
    if (limited == families.end()) return none;
    const auto [from, to] = std::minmax_element(design.path_angles.begin(), design.path_angles.end());
    Motion motion;
    motion.assembly = design.assembly;
    motion.family = static_cast<std::size_t>(limited - families.begin());
    motion.full_turn = false;
    motion.from = *from;
    motion.to = *to;
    std::array<double, Quantity::most_components> components{};
    Measurement measurement;
    measurement.value = components;
    limited->assembly_margin->measure(motion, design.dimensions, measurement);
    const auto count = static_cast<std::ptrdiff_t>(limited->assembly_margin->components(motion));
    double size = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::length) size = std::max(size, design.dimensions[i]);
    return *std::min_element(components.begin(), components.begin() + count) / size;
}

/// What is given as one number is that number where it has come out so but for rounding.
void settle_given(const Problem& problem, Design& design) {
    constexpr double rounding = 1e-11;
    double size = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (scales(problem.mechanism->dimensions[i].kind)) size = std::max(size, std::abs(design.dimensions[i]));
    for (std::size_t i = 0; i < design.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double slack = rounding * (scales(problem.mechanism->dimensions[i].kind) ? size : 1);
        if (range.fixed() && std::abs(design.dimensions[i] - range.min) <= slack) design.dimensions[i] = range.min;
    }
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

}  // namespace

ExactDesign excluded_design(Design design, std::string defect) {
    ExactDesign out;
    out.solution.design = std::move(design);
    out.solution.objective = std::nan("");
    out.solution.violation = std::numeric_limits<double>::infinity();
    out.defect = std::move(defect);
    return out;
}

ExactDesign exact_design(const Problem& problem, Design design) {
    move_angles_into_ranges(problem, design);
    settle_given(problem, design);
    ExactDesign out{assess(problem, std::move(design)), {}};
    const Design& assessed = out.solution.design;
    const auto& assemblies = problem.assemblies;
    // At a change point between the targets a hair decides.
    constexpr double least = 1e-9;
    const double closure = least_closure(problem, assessed);
    if (std::string missed = miss_defect(problem, assessed); !missed.empty()) {
        out.defect = std::move(missed);
    } else if (!(closure > least)) {
        out.defect = "circuit: it does not assemble everywhere between the targets";
        out.solution.violation = std::max(out.solution.violation, least - closure);
        out.solution.feasible = false;
    } else if (std::find(assemblies.begin(), assemblies.end(), assessed.assembly) == assemblies.end()) {
        out.defect = "assembly: it is not the one that is asked for";
    } else if (std::string range = range_defect(problem, assessed); !range.empty()) {
        out.defect = std::move(range);
    } else if (!out.solution.feasible) {
        out.defect = std::isfinite(out.solution.violation)
                         ? fmt::format("requirements: violated by {:.3g}, relative", out.solution.violation)
                         : "requirements: a quantity that is asked for has no value";
    }
    return out;
}

ExactDesign exact_design(const Problem& problem, const GuidedLinkage& found) {
    Design design = design_of(problem, found);
    if (!found.one_assembly)
        return excluded_design(std::move(design), "branch: it has to be taken apart between the points");
    if (problem.path->prescribed_timing) {
        for (const double angle : problem.path->crank_angles)
            design.path_angles.push_back(design.dimensions[problem.mechanism->path_roles.start] + angle);
    } else if (const auto angles = in_order(found.crank_angles)) {
        design.path_angles = *angles;
    } else {
        return excluded_design(std::move(design), "order: the crank does not meet the points in their order");
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
