#include "synthesis/exact/place_family.h"

#include <algorithm>
#include <numbers>

#include "synthesis/exact/family_search.h"
#include "synthesis/exact/homotopy/guidance_linkages.h"
#include "synthesis/exact/poses/poses.h"
#include "synthesis/exact/poses/slider_crank_poses.h"

namespace mechwright {

namespace {

/// Of points alone one counts as a pose: its direction is what others are counted from.
std::size_t poses_of(const PathTarget& path) { return std::max<std::size_t>(path.poses(), 1); }

/// The directions at places of which some are chosen by numbers in (0, 1), a turn each.
struct ChosenDirections {
    std::vector<std::optional<double>> given;  ///< as the problem says them
    std::vector<std::size_t> chosen;           ///< the places whose directions the numbers are
    double reference = 0;                      ///< a direction that is given

    std::vector<std::optional<double>> at(std::span<const double> numbers) const {
        std::vector<std::optional<double>> all = given;
        for (std::size_t j = 0; j < chosen.size(); ++j)
            all[chosen[j]] = reference + std::numbers::pi * (2 * numbers[j] - 1);
        return all;
    }
};

/// So many of the places without a direction, spread among them, are to get one.
ChosenDirections chosen_directions(const PathTarget& path, std::size_t count) {
    ChosenDirections directions;
    for (std::size_t i = 0; i < path.points.size(); ++i)
        directions.given.push_back(path.faces(i) ? std::optional(path.directions[i]) : std::nullopt);
    if (path.poses() == 0) directions.given.front() = 0;
    std::vector<std::size_t> without;
    for (std::size_t i = 0; i < path.points.size(); ++i)
        if (directions.given[i])
            directions.reference = *directions.given[i];
        else
            without.push_back(i);
    for (std::size_t j = 0; j < count; ++j)
        directions.chosen.push_back(without[(2 * j + 1) * without.size() / (2 * count)]);
    return directions;
}

/// A linkage among the finitely many through places with some directions, and these as parameters.
struct FoundMember {
    homotopy::GuidanceTarget target;
    homotopy::GuidanceValues values{};
    std::optional<ExactDesign> design;
};

/// Linkages through six places or more, slider-cranks through five: what the homotopy of poses and points finds.
struct GuidedFamily {
    const Problem& problem;
    const RunEnd& end;
    ChosenDirections directions;
    const homotopy::StartSystem& start;

    homotopy::GuidanceTarget target_at(std::span<const double> numbers) const {
        std::vector<homotopy::GuidedPlace> places;
        const auto all = directions.at(numbers);
        for (std::size_t i = 0; i < all.size(); ++i)
            places.push_back({{problem.path->points[i].x, problem.path->points[i].y}, all[i]});
        return homotopy::guidance_target(places, start.system.second);
    }

    /// The best of all solutions. A path that needs care is let go: another member will do.
    FoundMember best_at(std::span<const double> numbers) const {
        FoundMember best{target_at(numbers), {}, {}};
        for (homotopy::GuidancePath& path :
             homotopy::track(start.system, start.solutions, start.parameters, best.target.parameters, {}, 1, end)) {
            if (!is_design(path, best.target)) continue;
            for (const homotopy::GuidanceValues& member : homotopy::orbit_members(start.system, path.point))
                if (auto design = exact_design(problem, best.target, member))
                    if (keep_better(problem, best.design, *std::move(design))) best.values = member;
        }
        return best;
    }

    /// The one that a member becomes as the directions move.
    std::optional<ExactDesign> moved_from(const FoundMember& member, std::span<const double> numbers) const {
        if (!member.design) return {};
        const homotopy::GuidanceTarget target = target_at(numbers);
        homotopy::GuidancePath path =
            homotopy::track(start.system, {member.values}, member.target.parameters, target.parameters, {}, 1, end)
                .front();
        if (!is_design(path, target)) return {};
        return exact_design(problem, target, path.point);
    }

    bool is_design(homotopy::GuidancePath& path, const homotopy::GuidanceTarget& target) const {
        return path.end == homotopy::PathEnd::reached &&
               homotopy::refined_to_regular(start.system, path.point, target.parameters) &&
               homotopy::is_real(path.point);
    }
};

ExactDesigns through_many(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    constexpr std::size_t most_paths =
        24000;  // of all members that are examined: about as many seconds for each system
    const std::size_t count = free_directions(problem);
    const homotopy::GuidanceSystem system{poses_of(*problem.path) + count, *second_dyad(problem)};
    const GuidedFamily guided{problem, end, chosen_directions(*problem.path, count), homotopy::start_system(system)};
    DesignFamily family;
    family.numbers = count;
    family.member = [&](std::span<const double> numbers) { return guided.best_at(numbers).design; };
    family.near = [&](std::span<const double> numbers) -> FamilyMember {
        return [&guided, from = guided.best_at(numbers)](std::span<const double> beside) {
            return guided.moved_from(from, beside);
        };
    };
    family.examined = static_cast<int>(most_paths / homotopy::orbits_of(system));
    return search_family(problem, family, options, end);
}

/// With directions at all of a few places they are poses, and dyads through them have numbers of their own.
ExactDesigns through_few(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const PathTarget& path = *problem.path;
    const bool with_rocker = second_dyad(problem) == homotopy::SecondDyad::rocker;
    const std::size_t places = path.points.size(), count = places - poses_of(path);
    const ChosenDirections directions = chosen_directions(path, count);
    DesignFamily family;
    family.numbers = count + (with_rocker ? 2 * numbers_of_dyad(places) : numbers_of_slider_crank(places));
    family.member = [&](std::span<const double> numbers) {
        std::vector<double> all;
        for (const std::optional<double>& direction : directions.at(numbers.first(count)))
            all.push_back(*direction);
        const PoseTargets targets = pose_targets(problem, all);
        const auto of_dyads = numbers.subspan(count);
        return with_rocker ? member_of_poses(targets, of_dyads) : slider_crank_of_poses(targets, of_dyads);
    };
    return search_family(problem, family, options, end);
}

}  // namespace

std::optional<ExactDesign> exact_design(const Problem& problem, const homotopy::GuidanceTarget& target,
                                        const homotopy::GuidanceValues& solution) {
    return exact_design(problem, homotopy::parts_of(solution, target.system),
                        homotopy::displacements_of(solution, target), homotopy::place_of(target));
}

std::size_t conditions_said_by(const PathTarget& path) { return path.points.size() + poses_of(path); }

std::size_t free_directions(const Problem& problem) {
    const std::size_t said = conditions_said_by(*problem.path), all = conditions_of(problem);
    return said < all ? all - said : 0;
}

ExactDesigns place_family_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    // Poses in the place of all points leave whole families of linkages: of four-bars up to five, of slider-cranks up
    // to four.
    const std::size_t few = conditions_of(problem) / 2;
    return problem.path->points.size() > few ? through_many(problem, options, end) : through_few(problem, options, end);
}

}  // namespace mechwright
