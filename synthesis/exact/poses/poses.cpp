#include "synthesis/exact/poses/poses.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/exact/guided_parts.h"
#include "synthesis/exact/poses/counted_dyads.h"
#include "synthesis/exact/poses/timed_crank.h"
#include "synthesis/mechanism/four_bar/four_bar.h"

namespace mechwright {

namespace {

using Complex = std::complex<double>;

/// Those of the rocker's, from the crank's.
PivotRanges rocker_pivot_ranges(const PoseTargets& g, Complex crank_pivot) {
    const Problem& problem = *g.problem;
    if (!is_four_bar(*problem.mechanism)) return {crank_pivot, true, 0, anywhere, 0, 2 * std::numbers::pi};
    const DimensionRange &ground = problem.dimensions[0],
                         &tilt = problem.dimensions[problem.mechanism->point->roles.tilt];
    return {crank_pivot, true, ground.min / g.place.size, ground.max / g.place.size, tilt.min, tilt.max};
}

bool is_same(const Dyad& a, const Dyad& b) {
    constexpr double same_within = 1e-7;
    return std::abs(a.fixed - b.fixed) + std::abs(a.moving - b.moving) <=
           same_within * (1 + std::abs(a.fixed) + std::abs(a.moving));
}

/// Every four-bar of a crank dyad and those of the rocker.
template <class Take>
void for_each_linkage(const PoseTargets& g, const Dyad& crank, std::span<const Displacement> displacements,
                      const std::vector<Dyad>& rockers, const Take& take) {
    std::vector<Displacement> places{{0, 1}};
    places.insert(places.end(), displacements.begin(), displacements.end());
    for (const Dyad& rocker : rockers) {
        if (is_same(crank, rocker)) continue;
        if (auto design = exact_design(*g.problem, {crank, homotopy::SecondDyad::rocker, rocker}, places, g.place))
            take(*std::move(design));
    }
}

}  // namespace

std::optional<ExactDesign> member_of_poses(const PoseTargets& g, std::span<const double> numbers) {
    const std::size_t each = numbers_of_dyad(g.places());
    std::optional<ExactDesign> best;
    for (const Dyad& crank : dyads_of(g.displacements, numbers.first(each), crank_pivot_ranges(g)))
        for_each_linkage(g, crank, g.displacements,
                         dyads_of(g.displacements, numbers.subspan(each), rocker_pivot_ranges(g, crank.fixed)),
                         [&](ExactDesign design) { keep_better(*g.problem, best, std::move(design)); });
    return best;
}

namespace {

std::optional<ExactDesign> member_of_timed_points(const PoseTargets& g, std::span<const double> numbers) {
    const std::size_t each = numbers_of_dyad(g.places());
    std::optional<ExactDesign> best;
    for (const Dyad& seen :
         dyads_of(g.displacements, numbers.first(each), crank_pivot_ranges(g), line_of_crank_pin(g))) {
        const TimedCrank crank = timed_crank(g, seen);
        for_each_linkage(g, crank.dyad, crank.displacements,
                         dyads_of(crank.displacements, numbers.subspan(each), rocker_pivot_ranges(g, seen.fixed)),
                         [&](ExactDesign design) { keep_better(*g.problem, best, std::move(design)); });
    }
    return best;
}

/// How the coupler turns with a crank at five points, in fifty digits; nothing without a proof of the crank.
std::vector<ExactDisplacement> exact_coupler(const PoseTargets& g, const std::optional<CertifiedDyad>& seen) {
    std::vector<ExactDisplacement> all;
    if (!seen) return all;
    const auto& a = seen->fixed;
    const auto& x = seen->moving;
    const Vector<Digits50> first = x - a;
    for (const auto& [shift, turn] : exact_displacements(g)) {
        const Vector<Digits50> now{shift.x - a.x + (x.x * turn.x - x.y * turn.y),
                                   shift.y - a.y + (x.x * turn.y + x.y * turn.x)};
        const Digits50 square = dot(first, first);
        all.push_back({shift, {dot(first, now) / square, cross(first, now) / square}});
    }
    return all;
}

ExactDesigns through_five_poses(const PoseTargets& g) {
    ExactDesigns out;
    bool complete = true;
    SolutionCounts counts;
    const std::vector<RealDyad> real = counted_dyads(g.displacements, exact_displacements(g), counts, complete);
    counts.real = real.size();
    counts.certified = certified_of(real);
    std::vector<Dyad> dyads;
    for (const RealDyad& one : real)
        dyads.push_back(one.dyad);
    for (const Dyad& crank : dyads)
        for_each_linkage(g, crank, g.displacements, dyads,
                         [&](ExactDesign design) { add_design(out, std::move(design)); });
    out.counts = counts;
    out.evaluations = static_cast<long>(counts.tracked);
    if (complete)
        out.proof = proof_by(
            fmt::format("Burmester: all 4 dyads through five poses are accounted for, {} of them real", counts.real),
            CountCertificate{});
    return out;
}

ExactDesigns through_five_timed_points(const PoseTargets& g) {
    ExactDesigns out;
    bool complete = true;
    SolutionCounts counts;
    const std::vector<RealDyad> cranks = counted_dyads(g.displacements, exact_displacements(g), counts, complete);
    for (const auto& [seen, proof] : cranks) {
        const TimedCrank crank = timed_crank(g, seen);
        const std::vector<RealDyad> rockers =
            counted_dyads(crank.displacements, exact_coupler(g, proof), counts, complete);
        for (const RealDyad& rocker : rockers)
            for_each_linkage(g, crank.dyad, crank.displacements, {rocker.dyad}, [&](ExactDesign design) {
                ++counts.real;
                if (rocker.proof) ++counts.certified;
                add_design(out, std::move(design));
            });
    }
    out.counts = counts;
    out.evaluations = static_cast<long>(counts.tracked);
    if (complete)
        out.proof = proof_by(
            fmt::format("Burmester, twice: of all 4 cranks at five points with their timing {} are real; the 4 dyads "
                        "that go with each of these are accounted for",
                        cranks.size()),
            CountCertificate{});
    return out;
}

}  // namespace

std::string why_no_poses(const Problem& problem) {
    if (const std::string why = why_no_parts(problem); !why.empty()) return why;
    if (!problem.path || !problem.path->guides_body()) return "it needs [poses]";
    if (problem.path->prescribed_timing) return "it needs poses that are met at any crank angle: timing = \"free\"";
    const std::string why = why_not_so_many_targets("four-bars", problem.path->points.size(), "poses");
    return why.empty() && problem.path->points.size() < 5 ? why_no_family(problem) : why;
}

ExactDesigns pose_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    constexpr int few = 256;  // where the motion of each says when it is in its poses
    const PoseTargets g = pose_targets(problem);
    const auto of_drive = dimensions_of_drive(problem);
    const std::vector<std::size_t> searched = of_drive.value_or(std::vector<std::size_t>{});
    if (g.places() == 5 && searched.empty()) return with_count_noted(problem, through_five_poses(g));
    const auto member = [&](std::span<const double> numbers) {
        if (searched.empty()) return member_of_poses(g, numbers);
        Problem driven = problem;
        for (std::size_t i = 0; i < searched.size(); ++i) {
            DimensionRange& range = driven.dimensions[searched[i]];
            range.min += numbers[i] * (range.max - range.min);
            range.max = range.min;
        }
        PoseTargets same = g;
        same.problem = &driven;
        return member_of_poses(same, numbers.subspan(searched.size()));
    };
    DesignFamily family{searched.size() + 2 * numbers_of_dyad(g.places()), member};
    if (of_drive) family.examined = few;
    return search_family(problem, family, options, end);
}

std::string why_no_timed_points(const Problem& problem) {
    if (!is_four_bar(*problem.mechanism))
        return "at given crank angles it guides by four-bars, slider-cranks and geared five-bars alone";
    if (has_ties(problem)) return "dimensions are tied to others";
    if (!problem.path || problem.path->guides_body()) return "it needs a [path]";
    if (!problem.path->prescribed_timing) return "it needs timing = \"prescribed\"";
    return why_not_so_many_targets("four-bars", problem.path->points.size(), "points at given crank angles");
}

ExactDesigns timed_point_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const PoseTargets g = pose_targets(problem);
    if (g.places() == 5) return with_count_noted(problem, through_five_timed_points(g));
    const DesignFamily family{2 * numbers_of_dyad(g.places()),
                              [&](std::span<const double> numbers) { return member_of_timed_points(g, numbers); }};
    return search_family(problem, family, options, end);
}

}  // namespace mechwright
