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

/// A link that is nothing beside the others.
std::string degenerate_defect(const Problem& problem, const Design& design) {
    constexpr double least_ratio = 1e-6;
    double shortest = std::numeric_limits<double>::infinity(), longest = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i) {
        if (problem.mechanism->dimensions[i].kind != DimensionKind::length) continue;
        shortest = std::min(shortest, design.dimensions[i]);
        longest = std::max(longest, design.dimensions[i]);
    }
    if (shortest >= least_ratio * longest) return {};
    return fmt::format("degenerate: its shortest link is {:.1g} of its longest", shortest / longest);
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

/// An angle of a full turn, moved by whole turns into its range where that can be done. In a range of more than a turn
/// it stays where it is.
double moved_into(double angle, const DimensionRange& range) {
    constexpr double turn = 2 * std::numbers::pi;
    constexpr double same_within = 1e-11;
    if (range.max - range.min > turn + same_within && angle >= range.min && angle <= range.max) return angle;
    const double moved = angle + turn * std::ceil((range.min - same_within - angle) / turn);
    return moved <= range.max + same_within ? std::clamp(moved, range.min, range.max) : angle;
}

/// By how much the loop closes, at least, on the way from the first target to the last, relative to its size; < 0 where
/// the linkage would have to be taken apart between them. Infinite without a path. It is least at an end, or where the
/// crank stands along the ground link, or across a slide.
double closure_along_path(const Problem& problem, const Design& design) {
    constexpr double quarter = 0.5 * std::numbers::pi;
    double least = std::numeric_limits<double>::infinity();
    if (design.path_angles.empty()) return least;
    const auto consider = [&](double crank_angle) {
        PathMiss miss{};
        miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly), design.dimensions, crank_angle,
                      {0, 0}, miss);
        least = std::min(least, miss.margin);
    };
    const auto [from, to] = std::minmax_element(design.path_angles.begin(), design.path_angles.end());
    consider(*from);
    consider(*to);
    for (double k = std::ceil(*from / quarter); k * quarter < *to; ++k)
        consider(k * quarter);
    double size = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::length) size = std::max(size, design.dimensions[i]);
    return least / size;
}

/// What is given as one number is that number where it has come out so but for rounding.
void settle_given(const Problem& problem, Design& design) {
    constexpr double same_within = 1e-11;
    double size = 0;
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (scales(problem.mechanism->dimensions[i].kind)) size = std::max(size, std::abs(design.dimensions[i]));
    for (std::size_t i = 0; i < design.dimensions.size(); ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double slack = same_within * (scales(problem.mechanism->dimensions[i].kind) ? size : 1);
        if (range.fixed() && std::abs(design.dimensions[i] - range.min) <= slack) design.dimensions[i] = range.min;
    }
}

Design design_of(const Problem& problem, const GuidedLinkage& found) {
    const auto& [links, point, placement, assembly] = found.linkage;
    const PathRoles& roles = problem.mechanism->point->roles;
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

/// What excludes a design; empty if nothing does.
std::string defect_of(const Problem& problem, const Solution& solution) {
    constexpr double least_closure = 1e-6;  // nearer to a change point a hair decides which way a linkage goes
    const Design& design = solution.design;
    if (std::string degenerate = degenerate_defect(problem, design); !degenerate.empty()) return degenerate;
    if (std::string missed = miss_defect(problem, design); !missed.empty()) return missed;
    const double closure = closure_along_path(problem, design);
    if (!(closure >= 0)) return "circuit: it does not assemble everywhere between the targets";
    if (closure < least_closure)
        return fmt::format("change point: between the targets its loop closes by only {:.1g} of its size", closure);
    const auto& assemblies = problem.assemblies;
    if (std::find(assemblies.begin(), assemblies.end(), design.assembly) == assemblies.end())
        return "assembly: it is not the one that is asked for";
    if (std::string range = range_defect(problem, design); !range.empty()) return range;
    if (solution.feasible) return {};
    return std::isfinite(solution.violation)
               ? fmt::format("requirements: violated by {:.3g}, relative", solution.violation)
               : "requirements: a quantity that is asked for has no value";
}

}  // namespace

void move_angles_into_ranges(const Problem& problem, Design& design) {
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (problem.mechanism->dimensions[i].kind == DimensionKind::angle)
            design.dimensions[i] = moved_into(design.dimensions[i], problem.dimensions[i]);
}

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
    out.defect = defect_of(problem, out.solution);
    if (!out.defect.empty() && out.solution.feasible) {
        out.solution.feasible = false;
        out.solution.violation = 1;
    }
    return out;
}

ExactDesign exact_design(const Problem& problem, Design design, const std::vector<double>& crank_angles) {
    std::optional<ExactDesign> best;
    for (std::vector<double>& angles : in_order(crank_angles)) {
        Design one = design;
        one.path_angles = std::move(angles);
        keep_better(problem, best, exact_design(problem, std::move(one)));
    }
    return best ? *std::move(best)
                : excluded_design(std::move(design), "order: the crank does not meet the targets in their order");
}

ExactDesign exact_design(const Problem& problem, const GuidedLinkage& found) {
    Design design = design_of(problem, found);
    if (!found.one_assembly)
        return excluded_design(std::move(design), "branch: it has to be taken apart between the targets");
    if (!problem.path->prescribed_timing) return exact_design(problem, std::move(design), found.crank_angles);
    for (const double angle : problem.path->crank_angles)
        design.path_angles.push_back(design.dimensions[problem.mechanism->point->roles.start] + angle);
    return exact_design(problem, std::move(design));
}

void add_design(ExactDesigns& out, ExactDesign design) {
    if (design.defect.empty())
        out.designs.push_back(std::move(design.solution));
    else
        out.excluded.push_back({std::move(design.solution), std::move(design.defect)});
}

bool keep_better(const Problem& problem, std::optional<ExactDesign>& best, ExactDesign design) {
    const auto is_better = [&] {
        if (best->defect.empty() != design.defect.empty()) return design.defect.empty();
        return preferred(problem, design.solution, best->solution);
    };
    const bool better = !best || is_better();
    if (better) best = std::move(design);
    return better;
}

void rank(const Problem& problem, ExactDesigns& out) {
    std::stable_sort(out.designs.begin(), out.designs.end(),
                     [&](const Solution& a, const Solution& b) { return preferred(problem, a, b); });
}

}  // namespace mechwright
