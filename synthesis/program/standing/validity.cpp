#include "synthesis/program/standing/validity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/target/path/rows/nearest_point.h"
#include "synthesis/target/path/rows/stretch.h"

namespace mechwright {

namespace {

constexpr double endless = std::numeric_limits<double>::infinity();
/// At a prescribed crank angle that its range begins or ends with a design may stand at its limit; at all others it
/// keeps from that, as what passes a limit may go on in either assembly.
double margin_at_targets(const Problem& problem, const Design& design) {
    const auto& angles = design.path_angles;
    if (angles.empty()) return endless;
    const auto [first, last] = std::minmax_element(angles.begin(), angles.end());
    const double sure = sure_part * longest_length(*problem.mechanism, design.dimensions);
    double least = endless;
    for (std::size_t i = 0; i < design.path_angles.size(); ++i) {
        PathMiss miss{};
        miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly, problem.path->target_of(i)),
                      design.dimensions, design.path_angles[i], problem.path->points[i], miss);
        const bool at_end = angles[i] == *first || angles[i] == *last;
        const double margin = miss.margin - (problem.path->prescribed_timing && at_end ? 0 : sure);
        if (!(margin >= least)) least = margin;
    }
    return least;
}

/// Whether a target has points whose order counts.
bool has_order(const Mechanism& mechanism, const PathTarget& path, const PointRange& points) {
    return !path.prescribed_timing && !path.any_order && points.count >= least_ordered(mechanism);
}

/// The least turn of the crank from a point to the next of any target, all in the direction from the first to the last
/// of one of them.
double least_advance(const Mechanism& mechanism, const PathTarget& path, const std::vector<double>& angles) {
    double least = endless, direction = 0;
    for (std::size_t target = 0; target < path.targets(); ++target) {
        const PointRange points = path.points_of(target);
        if (!has_order(mechanism, path, points)) continue;
        if (direction == 0) direction = angles[points.end() - 1] > angles[points.first] ? 1 : -1;
        for (std::size_t i = points.first + 1; i < points.end(); ++i)
            least = std::min(least, direction * (angles[i] - angles[i - 1]));
    }
    return least;
}

/// By how much less than a turn, or a longer cycle, the crank meets all points of any target.
double least_rest_of_cycle(const Mechanism& mechanism, const PathTarget& path, const std::vector<double>& angles) {
    const double cycle = cycle_of(mechanism);
    double least = endless;
    for (std::size_t target = 0; target < path.targets(); ++target) {
        const PointRange points = path.points_of(target);
        if (has_order(mechanism, path, points))
            least = std::min(least, cycle - std::abs(angles[points.end() - 1] - angles[points.first]));
    }
    return least;
}

/// What a mechanism needs beside conditions on its dimensions to make its full turn, relative to its size.
void add_margin_of_full_turn(const Problem& problem, const Design& design, std::vector<ValidityMargin>& all) {
    const Motion motion = motion_of(problem, design);
    const Family& family = problem.mechanism->families[motion.family];
    if (!family.full_turn || !family.assembly_margin) return;
    const double relative = least_component(*family.assembly_margin, motion, design.dimensions) /
                            longest_length(*problem.mechanism, design.dimensions);
    all.push_back({family.assembly_margin->meaning, std::isnan(relative) ? -endless : relative, true});
}

/// A search of limited motions may end at a change point, where the links could turn fully but for the side on which
/// they go on: no design passes verification there. One that is given is shown for what it is.
void add_conditions_of_full_turn(const Problem& problem, const Design& design, std::vector<ValidityMargin>& all) {
    const Motion motion = motion_of(problem, design);
    const bool is_given = std::all_of(problem.dimensions.begin(), problem.dimensions.end(),
                                      [](const DimensionRange& d) { return d.fixed() || d.tied(); });
    if (is_given || !motion.full_turn) return;
    for (const LinearCondition& condition : problem.mechanism->families[motion.family].conditions) {
        double value = 0;
        for (std::size_t i = 0; i < condition.coefficients.size(); ++i)
            value += condition.coefficients[i] * design.dimensions[i];
        if (!(value > 0)) all.push_back({condition.name, -endless, false});
    }
}

void add_margin_between_targets(const Problem& problem, const Design& design, std::vector<ValidityMargin>& all) {
    const Motion whole = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
    if (needs_stretch(problem, problem.mechanism->families[whole.family]))
        all.push_back(
            {"it stays assembled from the first target to the last", least_margin_along(problem, design), false});
}

void add_margins_of_path(const Problem& problem, const Design& design, std::vector<ValidityMargin>& all) {
    const Motion whole = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
    if (problem.path->closed)
        all.push_back({"the crank goes round the closed path", whole.full_turn ? 0 : -endless, false});
    all.push_back({"it assembles at every target", margin_at_targets(problem, design), false});
    add_margin_between_targets(problem, design, all);
    const PathTarget& path = *problem.path;
    if (design.path_angles.size() != path.points.size()) return;
    const double advance = least_advance(*problem.mechanism, path, design.path_angles);
    if (advance == endless) return;
    all.push_back({"the targets are met in their order", advance, true});
    if (!comes_round(*problem.mechanism)) return;
    all.push_back({"the targets are met within " + cycle_words(*problem.mechanism) + " of the crank",
                   least_rest_of_cycle(*problem.mechanism, path, design.path_angles), true});
}

}  // namespace

std::vector<ValidityMargin> validity_margins(const Problem& problem, const Design& design) {
    std::vector<ValidityMargin> all;
    add_margin_of_full_turn(problem, design, all);
    add_conditions_of_full_turn(problem, design, all);
    all.push_back(
        {"it assembles over the range of crank angles", assembles_over_range(problem, design) ? 0 : -endless, false});
    if (problem.path)
        add_margins_of_path(problem, design, all);
    else if (covers_several(problem))
        add_margin_between_targets(problem, design, all);
    return all;
}

}  // namespace mechwright
