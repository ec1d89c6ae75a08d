#include "synthesis/exact/poses/slider_crank_timed.h"

#include <fmt/format.h>

#include "synthesis/exact/poses/slider_crank_poses.h"
#include "synthesis/exact/poses/timed_crank.h"

namespace mechwright {

namespace {

/// A crank leaves as much to choose as a dyad through poses, and its ram as one of the poses that it makes.
std::optional<ExactDesign> member(const PoseTargets& g, std::span<const double> numbers) {
    const std::size_t of_crank = numbers_of_dyad(g.places());
    std::optional<ExactDesign> best;
    for (const Dyad& seen :
         dyads_of(g.displacements, numbers.first(of_crank), crank_pivot_ranges(g), line_of_crank_pin(g))) {
        const TimedCrank crank = timed_crank(g, seen);
        const auto ram = slider_through(crank.displacements, numbers.subspan(of_crank));
        if (!ram) continue;
        std::vector<Displacement> displacements{{0, 1}};
        displacements.insert(displacements.end(), crank.displacements.begin(), crank.displacements.end());
        if (auto design = slider_crank_design(*g.problem, g.place, crank.dyad, *ram, displacements))
            keep_better(*g.problem, best, *std::move(design));
    }
    return best;
}

}  // namespace

std::string why_no_slider_crank_timed_points(const Problem& problem) {
    if (has_ties(problem)) return "dimensions are tied to others";
    if (problem.path->guides_body()) return "it needs a [path]";
    const std::size_t points = problem.path->points.size();
    if (points < 2) return "it needs from two to four points at given crank angles, and there is one";
    if (points > 4)
        return fmt::format(
            "it finds slider-cranks through up to four points at given crank angles, and there are {}: through more "
            "none passes in general; least-squares finds the closest",
            points);
    return {};
}

ExactDesigns slider_crank_timed_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const PoseTargets g = pose_targets(problem);
    const DesignFamily family{numbers_of_slider_crank(g.places()),
                              [&](std::span<const double> numbers) { return member(g, numbers); }};
    return search_family(problem, family, options, end);
}

}  // namespace mechwright
