#include "synthesis/exact/places.h"

#include <fmt/format.h>

#include "synthesis/exact/homotopy/certify.h"
#include "synthesis/exact/homotopy/guidance_linkages.h"
#include "synthesis/exact/place_family.h"
#include "synthesis/mechanism/slider_crank/slider_crank.h"
#include "synthesis/program/work_sharing.h"

namespace mechwright {

namespace {

/// How a kind is spoken of, and what passes places.
struct Words {
    std::string_view linkages, most_points, most_places;
};

Words words_of(const Problem& problem) {
    const std::string_view linkages = is_linkage(problem)                   ? "linkages"
                                      : is_slider_crank(*problem.mechanism) ? "slider-cranks"
                                                                            : "four-bars";
    if (second_dyad(problem) == homotopy::SecondDyad::rocker)
        return {linkages, "nine", "4 poses and 2 points, 3 and 4, 2 and 6, or 1 and 8"};
    return {linkages, "eight", "4 poses and 1 point, 3 and 3, 2 and 5, or 1 and 7"};
}

std::string why_not_so_many_points(const Problem& problem) {
    const std::size_t points = problem.path->points.size();
    const Words words = words_of(problem);
    if (points < 2) return fmt::format("it needs from two to {} points, and there is one", words.most_points);
    if (points < conditions_of(problem)) return {};
    return fmt::format(
        "it finds {} through up to {} points, and there are {}: through more no linkage passes in general; "
        "least-squares finds the closest",
        words.linkages, words.most_points, points);
}

/// "3 poses and 1 point"
std::string counted(std::size_t poses, std::size_t points) {
    return fmt::format("{} pose{} and {} point{}", poses, poses == 1 ? "" : "s", points, points == 1 ? "" : "s");
}

std::string why_not_these(const Problem& problem) {
    const PathTarget& path = *problem.path;
    if (path.points.size() < 2) return "it needs two places or more, and there is one";
    if (conditions_said_by(path) <= conditions_of(problem)) return {};
    const std::size_t poses = path.poses(), points = path.points.size() - poses;
    const Words words = words_of(problem);
    return fmt::format(
        "there are {}; it finds {} through up to {}: more leave no linkage in general, and least-squares finds the "
        "closest",
        counted(poses, points), words.linkages, words.most_places);
}

/// What is given beside too few places to say all of it: a member of the family that has it is not found by chance.
std::string why_not_given(const Problem& problem) {
    if (free_directions(problem) == 0) return {};
    if (is_linkage(problem)) return why_no_family(problem);
    const Mechanism& own = problem.mechanism->plain ? *problem.mechanism->plain : *problem.mechanism;
    for (std::size_t i = 0; i < own.dimensions.size(); ++i)
        if (problem.dimensions[i].fixed())
            return fmt::format(
                "a family of {} passes so few places, and '{}' has one value besides: give it a range, or use "
                "least-squares",
                words_of(problem).linkages, own.dimensions[i].name);
    return {};
}

std::string why_points_coincide(const PathTarget& path) {
    for (std::size_t i = 0; i < path.points.size(); ++i)
        for (std::size_t j = i + 1; j < path.points.size(); ++j)
            if (path.points[i].x == path.points[j].x && path.points[i].y == path.points[j].y &&
                !(path.faces(i) && path.faces(j)))
                return fmt::format("points {} and {} are the same: different ones are needed", i + 1, j + 1);
    return {};
}

std::vector<homotopy::GuidedPlace> places_of(const PathTarget& path) {
    std::vector<homotopy::GuidedPlace> places;
    for (std::size_t i = 0; i < path.points.size(); ++i)
        places.push_back(
            {{path.points[i].x, path.points[i].y}, path.faces(i) ? std::optional(path.directions[i]) : std::nullopt});
    return places;
}

struct RealSolution {
    homotopy::GuidanceValues values;
    bool certified = false;
};

/// The real ones, each from its certificate where there is one.
std::vector<RealSolution> real_solutions(const std::vector<homotopy::GuidanceValues>& all,
                                         const homotopy::GuidanceTarget& target,
                                         const std::vector<homotopy::GuidedPlace>& places, int jobs,
                                         const RunEnd& end) {
    std::vector<RealSolution> real;
    for (const homotopy::GuidanceValues& solution : all)
        if (homotopy::is_real(solution)) real.push_back({solution});
    const auto exact = homotopy::exact_parameters(target, places);
    share_work(static_cast<int>(real.size()), jobs, [&](int i) {
        if (end.reached()) return;
        RealSolution& solution = real[static_cast<std::size_t>(i)];
        const auto proof = homotopy::certify(target.system, solution.values, exact);
        solution.certified = proof && proof->real;
        for (std::size_t k = 0; solution.certified && k < solution.values.size(); ++k)
            solution.values[k] = homotopy::detail::rounded(proof->solution[k]);
    });
    return real;
}

/// What shows that all solutions are known.
std::string argument(const Problem& problem, const homotopy::GuidanceSystem& system, const SolutionCounts& counts) {
    const PathTarget& path = *problem.path;
    const std::size_t points = path.points.size() - path.poses();
    const auto named = [&](std::string_view rockers, std::string_view rams, std::string_view blocks) {
        if (system.second == homotopy::SecondDyad::ram) return rams;
        return system.second == homotopy::SecondDyad::block ? blocks : rockers;
    };
    const std::string_view orbits =
        system.poses > 1 ? named("pairs of dyads", "slider-cranks", "inverted slider-cranks")
                         : named("cognate triplets", "cognate pairs of slider-cranks", "inverted slider-cranks");
    std::string text = fmt::format(
        "homotopy: all {} {} through {} are accounted for, {} of them real", counts.tracked, orbits,
        path.guides_body() ? counted(system.poses, points) : fmt::format("{} points", words_of(problem).most_points),
        counts.real);
    const std::string_view evidence = homotopy::evidence_of(system);
    return text + fmt::format("; that there are no more {}", evidence == "the literature"
                                                                 ? "is known from the literature"
                                                                 : fmt::format("is found by {}, not proven", evidence));
}

}  // namespace

std::string why_no_places(const Problem& problem) {
    if (const std::string no_parts = why_no_parts(problem); !no_parts.empty()) return no_parts;
    if (!problem.path) return "it needs a [path] or [poses]";
    if (problem.path->prescribed_timing || problem.path->any_order)
        return "it needs points that are met in their order at any crank angle: timing = \"free\"";
    const PathTarget& path = *problem.path;
    const std::string why = path.guides_body() ? why_not_these(problem) : why_not_so_many_points(problem);
    if (!why.empty()) return why;
    const std::string given = why_not_given(problem);
    return given.empty() ? why_points_coincide(path) : given;
}

ExactDesigns place_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    if (free_directions(problem) > 0) return place_family_designs(problem, options, end);
    const std::vector<homotopy::GuidedPlace> places = places_of(*problem.path);
    const homotopy::GuidanceTarget target = homotopy::guidance_target(places, *second_dyad(problem));
    const homotopy::GuidanceSystem& system = target.system;
    const bool given = options.start_system && options.start_system->system == system;
    const homotopy::StartSystem& start = given ? *options.start_system : homotopy::start_system(system);
    const auto found = homotopy::solve_guidance(start, target.parameters, options.jobs, end);
    ExactDesigns out;
    out.counts = SolutionCounts{found.tracked, found.solutions.size(), found.at_infinity, found.singular, 0, 0, 0};
    out.evaluations = static_cast<long>(found.tracked);
    const std::vector<RealSolution> real = real_solutions(found.solutions, target, places, options.jobs, end);
    out.stopped = end.reached();
    out.counts->real = real.size();
    for (const RealSolution& solution : real) {
        if (solution.certified) ++out.counts->certified;
        for (const homotopy::GuidanceValues& member : homotopy::orbit_members(system, solution.values))
            if (auto design = exact_design(problem, target, member)) add_design(out, *std::move(design));
    }
    rank(problem, out);
    if (found.singular > 0) out.note = some_are_singular;
    if (!found.complete() || found.singular > 0 || out.stopped) return out;
    out.proof = proof_by(argument(problem, system, *out.counts), CountCertificate{});
    claim_no_more_than_seen(problem, out);
    return out;
}

}  // namespace mechwright
