#include "synthesis/proof/prove.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "synthesis/mechanism/four_bar/four_bar.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/proof.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/proof/branch_and_bound.h"
#include "synthesis/proof/coupler_sextic.h"
#include "synthesis/proof/function_bound.h"
#include "synthesis/proof/timed_path_bound.h"

namespace mechwright {

namespace {

/// The bound in the problem's unit, and whether it meets the design.
bool report_bound(const LowerBound& found, double bound, std::string_view over, SearchReport& report) {
    report.bound = bound;
    report.boxes = found.boxes;
    if (!found.reached) return !found.ended;
    report.missed_chance = 0;
    report.proof = proof_by(fmt::format("branch and bound over {}, {} box{}: no design is better by a millionth", over,
                                        found.boxes, found.boxes == 1 ? "" : "es"),
                            BoundCertificate{});
    return true;
}

const Quantity& objective_of(const Problem& problem) {
    return problem.mechanism->quantities[problem.objective->terms.front().quantity];
}

bool prove_path(const Problem& problem, const Solution& best, SearchReport& report, const RunOptions& options,
                std::chrono::steady_clock::time_point deadline) {
    const four_bar::TimedPathBound bound(problem);
    const double sum = path_values(problem, best.design)->sum_of_squares;
    const LowerBound found = lower_bound(bound.boxes(), bound, (1 - closed_within) * sum, options, deadline);
    const Quantity& q = objective_of(problem);
    const double weights = std::accumulate(problem.path->weights.begin(), problem.path->weights.end(), 0.0);
    const double least = q.path == PathMeasure::sum_of_squares ? found.least : std::sqrt(found.least / weights);
    return report_bound(found, least, "the ratios of the links", report);
}

bool prove_function(const Problem& problem, const Solution& best, SearchReport& report, const RunOptions& options,
                    std::chrono::steady_clock::time_point deadline) {
    const FunctionBound bound(problem, best.design);
    const LowerBound found = lower_bound(bound.boxes(), bound, (1 - closed_within) * bound.error(), options, deadline);
    return report_bound(found, in_file_unit(found.least, objective_of(problem).unit, problem.units), "the scales",
                        report);
}

}  // namespace

std::string why_no_proof(const Problem& problem) {
    if (problem.function) return FunctionBound::why_not(problem);
    return four_bar::TimedPathBound::why_not(problem);
}

bool is_quickly_proved(const Problem& problem) {
    if (!FunctionBound::why_not(problem).empty()) return false;
    const auto first = problem.dimensions.begin() + static_cast<std::ptrdiff_t>(problem.mechanism->input->start);
    return std::all_of(first, first + Box::most, [](const DimensionRange& scale) { return scale.fixed(); });
}

std::optional<double> bound_of_untimed_path(const Problem& problem) {
    const std::optional<PathTarget>& path = problem.path;
    if (!is_four_bar(*problem.mechanism) || !path || path->prescribed_timing || path->guides_body() ||
        !path->parts.empty() || !problem.objective || problem.objective->terms.size() != 1 ||
        problem.objective->terms.front().maximize)
        return std::nullopt;
    const PathMeasure measure = objective_of(problem).path;
    if (measure == PathMeasure::none) return std::nullopt;
    const DistancesFromCouplerCurves least = least_distances_from_coupler_curves(path->points, path->weights);
    double bound = measure == PathMeasure::greatest ? least.greatest : least.sum_of_squares;
    if (measure == PathMeasure::root_mean_square)
        bound = std::sqrt(bound / std::accumulate(path->weights.begin(), path->weights.end(), 0.0));
    return bound > 0 ? std::optional(bound) : std::nullopt;
}

bool prove(const Problem& problem, const Solution& best, SearchReport& report, const RunOptions& options,
           std::chrono::steady_clock::time_point deadline) {
    return problem.function ? prove_function(problem, best, report, options, deadline)
                            : prove_path(problem, best, report, options, deadline);
}

}  // namespace mechwright
