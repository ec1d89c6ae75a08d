#include "synthesis/exact/geared/geared_points.h"

#include <fmt/format.h>

#include "synthesis/exact/family_search.h"
#include "synthesis/exact/geared/geared_five_bar.h"
#include "synthesis/exact/geared/geared_rows.h"
#include "synthesis/exact/poses/counted_dyads.h"
#include "synthesis/exact/poses/pose_targets.h"

namespace mechwright {

namespace {

/// Both cranks as bodies whose poses are the points with the angles by which they have turned.
struct TimedCranks {
    PoseTargets driving;
    std::vector<Displacement> driven;
    std::vector<Displacement> places;  ///< of the guided point: all of them, the first among them
    std::vector<double> turned;        ///< the driving crank, radians from the first
    double speed = 1;                  ///< of the driven crank, over that of the driving one
};

TimedCranks timed_cranks(const Problem& problem, const GearedFiveBar& bars) {
    TimedCranks cranks{pose_targets(problem), {}, {{0, 1}}, {0}, *speed_of_driven(problem, bars)};
    const std::vector<double>& angles = problem.path->crank_angles;
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const Displacement& first = cranks.driving.displacements[i - 1];
        cranks.turned.push_back(angles[i] - angles[0]);
        cranks.driven.push_back({first.shift, std::polar(1.0, cranks.speed * cranks.turned[i])});
        cranks.places.push_back(first);
    }
    return cranks;
}

/// The driven crank's displacements in fifty digits: the ratio of the gears is as the file has it.
std::vector<ExactDisplacement> exact_driven(const TimedCranks& cranks, const Problem& problem,
                                            const GearedFiveBar& bars) {
    std::vector<ExactDisplacement> exact = exact_displacements(cranks.driving);
    const std::vector<double>& angles = problem.path->crank_angles;
    const Digits50 ratio(*ratio_of_gears(problem, bars));
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const Digits50 turned = Digits50(angles[i + 1]) - angles[0];
        const Digits50 by = bars.drives_first ? ratio : 1 / ratio;
        exact[i].turn = {cos(by * turned), sin(by * turned)};
    }
    return exact;
}

ExactDesign design_of(const Problem& problem, const GearedFiveBar& bars, const TimedCranks& cranks, const Dyad& driving,
                      const Dyad& driven) {
    return geared_design(problem, bars, {driving, driven, cranks.places, cranks.turned}, cranks.driving.place);
}

/// Of a dyad that both cranks have, where they turn alike, no five-bar is made.
bool coincide(const Dyad& a, const Dyad& b) {
    constexpr double same_point_within = 1e-7;
    return std::abs(a.fixed - b.fixed) + std::abs(a.moving - b.moving) <=
           same_point_within * (1 + std::abs(a.fixed) + std::abs(a.moving));
}

ExactDesigns through_five(const Problem& problem, const GearedFiveBar& bars) {
    const TimedCranks cranks = timed_cranks(problem, bars);
    ExactDesigns out;
    bool complete = true;
    SolutionCounts counts;
    const auto driving =
        counted_dyads(cranks.driving.displacements, exact_displacements(cranks.driving), counts, complete);
    const auto driven = counted_dyads(cranks.driven, exact_driven(cranks, problem, bars), counts, complete);
    for (const RealDyad& one : driving)
        for (const RealDyad& other : driven) {
            if (coincide(one.dyad, other.dyad)) continue;
            ++counts.real;
            if (one.proof && other.proof) ++counts.certified;
            add_design(out, design_of(problem, bars, cranks, one.dyad, other.dyad));
        }
    out.counts = counts;
    out.evaluations = static_cast<long>(counts.tracked);
    if (complete)
        out.proof = proof_by(
            fmt::format("Burmester, twice: all 4 cranks that drive through five points with their timing and all 4 "
                        "that follow are accounted for, {} and {} of them real",
                        driving.size(), driven.size()),
            CountCertificate{});
    return with_count_noted(problem, std::move(out));
}

std::optional<ExactDesign> member(const Problem& problem, const GearedFiveBar& bars, const TimedCranks& cranks,
                                  std::span<const double> numbers) {
    const DrawingPlace& place = cranks.driving.place;
    const std::size_t each = numbers_of_dyad(cranks.places.size());
    const auto driven = dyads_of(cranks.driven, numbers.subspan(each), pivot_ranges(problem, bars.driven, place));
    std::optional<ExactDesign> best;
    for (const Dyad& one :
         dyads_of(cranks.driving.displacements, numbers.first(each), pivot_ranges(problem, bars.driving, place)))
        for (const Dyad& other : driven)
            if (!coincide(one, other)) keep_better(problem, best, design_of(problem, bars, cranks, one, other));
    return best;
}

/// Coordinates of pivots that are given beside the points.
std::string why_not_given(const Problem& problem, const GearedFiveBar& bars) {
    if (problem.dimensions[problem.mechanism->point->roles.start].fixed())
        return "a family of geared five-bars passes so few points, and the crank angle that they are counted from has "
               "one "
               "value: give 'crank-start' in [path] a range";
    const std::size_t open = numbers_of_dyad(problem.path->points.size());
    std::size_t given = 0;
    for (const GearedCrank* crank : {&bars.driving, &bars.driven}) {
        const std::size_t of_pivot = given_coordinates(problem, *crank);
        if (of_pivot > open) return "both coordinates of a pivot are given: then at most three points can be met";
        given += of_pivot;
    }
    return why_no_geared_family(problem, given);
}

/// Whether the points leave no more to choose than the file gives of the pivots.
bool is_all_given(const Problem& problem, const GearedFiveBar& bars) {
    const std::size_t open = numbers_of_dyad(problem.path->points.size());
    return given_coordinates(problem, bars.driving) == open && given_coordinates(problem, bars.driven) == open;
}

ExactDesigns of_given_pivots(const Problem& problem, const GearedFiveBar& bars, const TimedCranks& cranks) {
    const std::vector<double> none(2 * numbers_of_dyad(cranks.places.size()), 0.5);
    ExactDesigns out;
    if (auto design = member(problem, bars, cranks, none)) add_design(out, *std::move(design));
    out.evaluations = out.starts = 1;
    return out;
}

}  // namespace

std::string why_no_geared_timed_points(const Problem& problem) {
    if (has_ties(problem)) return "dimensions are tied to others";
    const GearedFiveBar bars = *geared_five_bar(problem);
    if (const std::string why = why_no_geared_design(problem, bars); !why.empty()) return why;
    const std::size_t points = problem.path->points.size();
    const std::string why = why_not_so_many_targets("geared five-bars", points, "points at given crank angles");
    return why.empty() && points < 5 ? why_not_given(problem, bars) : why;
}

ExactDesigns geared_timed_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const GearedFiveBar bars = *geared_five_bar(problem);
    const std::size_t points = problem.path->points.size();
    if (points == 5) return through_five(problem, bars);
    const TimedCranks cranks = timed_cranks(problem, bars);
    if (is_all_given(problem, bars)) return of_given_pivots(problem, bars, cranks);
    const DesignFamily family{2 * numbers_of_dyad(points),
                              [&](std::span<const double> numbers) { return member(problem, bars, cranks, numbers); }};
    return search_family(problem, family, options, end);
}

}  // namespace mechwright
