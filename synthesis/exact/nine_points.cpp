#include "synthesis/exact/nine_points.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/exact/homotopy/nine_point_linkages.h"
#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"

namespace mechwright {

namespace {

constexpr std::size_t nine = 9;
/// The dimensions that place a four-bar and its coupler point: ground, crank, coupler, rocker, point along and across,
/// origin and tilt.
constexpr std::size_t placing_dimensions = 9;

std::string why_points_do_not_do(const std::vector<Vector<double>>& points) {
    if (points.size() != nine)
        return fmt::format("it finds four-bars through nine points, and there are {}: {}", points.size(),
                           points.size() > nine
                               ? "through more no linkage passes in general; least-squares finds the closest"
                               : "through fewer pass whole families; least-squares finds members of them");
    for (std::size_t i = 0; i < nine; ++i)
        for (std::size_t j = i + 1; j < nine; ++j)
            if (points[i].x == points[j].x && points[i].y == points[j].y)
                return fmt::format("points {} and {} are the same: nine different ones are needed", i + 1, j + 1);
    return {};
}

homotopy::NinePointTarget target_of(const PathTarget& path) {
    std::array<homotopy::Complex<double>, nine> points;
    for (std::size_t i = 0; i < nine; ++i)
        points[i] = {path.points[i].x, path.points[i].y};
    return homotopy::nine_point_target(points);
}

/// An angle of a full turn, moved by whole turns into its range where that can be done.
double into_range(double angle, const DimensionRange& range) {
    constexpr double turn = 2 * std::numbers::pi;
    const double moved = angle + turn * std::ceil((range.min - angle) / turn);
    return moved <= range.max ? moved : angle;
}

Design design_of(const Problem& problem, const homotopy::LinkageThroughPoints& found) {
    const auto& [links, point, placement, assembly] = found.linkage;
    const std::array<double, placing_dimensions> values{
        links.ground,       links.crank,        links.coupler,
        links.rocker,       point.along,        point.across,
        placement.origin.x, placement.origin.y, into_range(placement.tilt, problem.dimensions[8])};
    Design design;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
        design.dimensions.push_back(i < values.size() ? values[i] : problem.dimensions[i].min);
    design.assembly = assembly == Assembly::open ? 0 : 1;
    return design;
}

/// Which dimension lies farthest outside its range, where that is more than rounding.
std::string range_defect(const Problem& problem, const Design& design) {
    std::string defect;
    double worst = problem.solver.tolerance;
    for (std::size_t i = 0; i < placing_dimensions; ++i) {
        const DimensionRange& range = problem.dimensions[i];
        const double value = design.dimensions[i];
        const double size = std::max({std::abs(range.min), std::abs(range.max), 1e-300});
        const double beyond = std::max(range.min - value, value - range.max) / size;
        if (beyond <= worst) continue;
        worst = beyond;
        const Dimension& dimension = problem.mechanism->dimensions[i];
        const auto outside = [&](double x) { return in_file_unit(x, unit_of(dimension.kind), problem.units); };
        defect = fmt::format("range: {} is {:.6g}, asked for {:.6g} to {:.6g}", dimension.name, outside(value),
                             outside(range.min), outside(range.max));
    }
    return defect;
}

/// What excludes a design, as far as it shows at the points: the rest is for verification.
std::string defect_of(const Problem& problem, const homotopy::LinkageThroughPoints& found, const Solution& solution) {
    if (!found.one_assembly) return "branch: it has to be taken apart between the points";
    if (solution.design.path_angles.empty()) return "order: the crank does not meet the points in their order";
    const auto& assemblies = problem.assemblies;
    if (std::find(assemblies.begin(), assemblies.end(), solution.design.assembly) == assemblies.end())
        return "assembly: it is not the one that is asked for";
    if (std::string range = range_defect(problem, solution.design); !range.empty()) return range;
    if (!solution.feasible) return fmt::format("requirements: violated by {:.3g}, relative", solution.violation);
    return {};
}

void add_member(const Problem& problem, const homotopy::NinePointTarget& target,
                const homotopy::NinePointValues& member, ExactDesigns& out) {
    const auto found = homotopy::linkage_of(member, target);
    if (!found) return;
    Design design = design_of(problem, *found);
    const auto angles = homotopy::in_order(found->crank_angles);
    Solution solution;
    if (angles && found->one_assembly) {
        design.path_angles = *angles;
        solution = assess(problem, std::move(design));
    } else {
        solution.design = std::move(design);
        solution.objective = std::nan("");
        solution.violation = std::numeric_limits<double>::infinity();
    }
    std::string defect = defect_of(problem, *found, solution);
    if (defect.empty())
        out.designs.push_back(std::move(solution));
    else
        out.excluded.push_back({std::move(solution), std::move(defect)});
}

}  // namespace

std::string why_no_nine_points(const Problem& problem) {
    if (problem.mechanism != &four_bar_mechanism()) return "it knows four-bars alone";
    if (!problem.path || problem.path->guides_body()) return "it needs a [path]";
    if (problem.path->prescribed_timing || problem.path->any_order)
        return "it needs points that are met in their order at any crank angle: timing = \"free\"";
    if (has_ties(problem)) return "dimensions are tied to others";
    return why_points_do_not_do(problem.path->points);
}

ExactDesigns nine_point_designs(const Problem& problem, int jobs) {
    const homotopy::NinePointTarget target = target_of(*problem.path);
    const auto found = homotopy::solve_nine_points(homotopy::nine_point_start(), target.parameters, jobs);
    ExactDesigns out;
    out.counts = {found.tracked, found.solutions.size(), found.at_infinity, found.singular, 0, 0};
    out.complete = found.complete();
    for (const homotopy::NinePointValues& solution : found.solutions) {
        if (!homotopy::is_real(solution)) continue;
        ++out.counts.real;
        for (const homotopy::NinePointValues& member : homotopy::orbit_members(solution))
            add_member(problem, target, member, out);
    }
    std::stable_sort(out.designs.begin(), out.designs.end(),
                     [&](const Solution& a, const Solution& b) { return preferred(problem, a, b); });
    return out;
}

}  // namespace mechwright
