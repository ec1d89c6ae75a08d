#include "synthesis/verify/proofs/bounds_again.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>
#include <vector>

#include "synthesis/mechanism/possible_values.h"
#include "synthesis/proof/coupler_sextic.h"
#include "synthesis/verify/error_again.h"
#include "synthesis/verify/proofs/function_bound_again.h"
#include "synthesis/verify/proofs/timed_path_again.h"
#include "synthesis/verify/proofs/untimed_path_again.h"

namespace mechwright {

namespace {

using claims::Json;
using claims::member;

constexpr std::size_t scales = 4;
using Scales = std::array<Digits50, scales>;

struct ScaleRanges {
    std::array<DigitsRange, scales> range;
    bool given;  ///< all of them
};

ScaleRanges scale_ranges(const ProofContext& c) {
    const Mechanism& mechanism = *c.problem.mechanism;
    ScaleRanges ranges{{}, true};
    for (std::size_t k = 0; k < scales; ++k) {
        DigitsRange& range = ranges.range[k] = range_again(c, mechanism.input->start + k, Strictness::exact);
        // A start that may be anywhere is taken once round.
        const bool angle = mechanism.dimensions[mechanism.input->start + k].kind == DimensionKind::angle;
        const Digits50& turn = boost::math::constants::two_pi<Digits50>();
        if (angle && k % 2 == 0) range.greatest = std::min<Digits50>(range.greatest, range.least + turn);
        ranges.given = ranges.given && range.least == range.greatest;
    }
    return ranges;
}

/// Places of a box: the design's, some ever closer to it, and some spread evenly (additive recurrence of the root of
/// x^5 = x + 1).
std::vector<Scales> some_of(const ScaleRanges& ranges, const Scales& design) {
    constexpr int even = 150, near = 50;
    constexpr double root = 1.1673039782614187;
    std::vector<Scales> all{design};
    for (int i = 1; i <= even + near; ++i) {
        const double size = i <= even ? 1 : std::pow(2.0, (even - i) / 4.0);
        Scales place;
        double step = 1;
        for (std::size_t k = 0; k < scales; ++k) {
            step /= root;
            const auto& [least, greatest] = ranges.range[k];
            const Digits50 there = least + std::fmod(0.5 + i * step, 1.0) * (greatest - least);
            place[k] = i <= even ? there : Digits50(design[k] + size * (there - design[k]));
        }
        all.push_back(place);
    }
    return all;
}

/// Shares of the range at which linkages are held against the function: where the design errs most, and the extremes of
/// a Chebyshev polynomial.
std::vector<double> shares_of(const ProofContext& c, const ErrorAgain& error) {
    constexpr std::size_t most_own = 8, others = 6;
    std::vector<double> shares;
    std::vector<ExtremeAgain> own = error.extremes();
    std::sort(own.begin(), own.end(),
              [](const ExtremeAgain& a, const ExtremeAgain& b) { return abs(a.error) > abs(b.error); });
    for (std::size_t i = 0; i < std::min(own.size(), most_own); ++i)
        shares.push_back(own[i].share);
    const auto& parts = c.design.claim->function->parts;
    for (std::size_t k = 0; k < others; ++k) {
        const double share = 0.5 - 0.5 * std::cos(std::numbers::pi * static_cast<double>(k) / (others - 1));
        const auto sample = static_cast<std::size_t>(share * static_cast<double>(parts.empty() ? 0 : parts.size() - 1));
        shares.push_back(parts.empty() ? share : parts[sample].x);
    }
    std::sort(shares.begin(), shares.end());
    shares.erase(std::unique(shares.begin(), shares.end()), shares.end());
    return shares;
}

Finding check_function(const ProofContext& c, const Digits50& bound) {
    const std::string_view name = c.problem.mechanism->name;
    if (name != "four-bar" && name != "slider-crank") return fails("nothing is known of such functions");
    const LoopKind kind = name == "four-bar" ? LoopKind::four_bar : LoopKind::slider_crank;
    const ErrorAgain error(c.design, input_tasks(*c.design.claim).front());
    const std::vector<double> shares = shares_of(c, error);
    const std::size_t first = c.problem.mechanism->input->start;
    Scales own;
    for (std::size_t k = 0; k < scales; ++k)
        own[k] = c.design.dimensions[first + k];
    const ScaleRanges ranges = scale_ranges(c);
    const std::vector<Scales> all = ranges.given ? std::vector<Scales>{own} : some_of(ranges, own);
    for (const Scales& scale : all) {
        std::vector<AskedPlace> places;
        for (const double share : shares)
            places.push_back({scale[0] + scale[1] * share, scale[2] + scale[3] * error.part(share)});
        if (!every_linkage_errs(kind, places, bound))
            return fails("a linkage that errs by less than the bound is not excluded" +
                         std::string(ranges.given ? "" : " at one of the scales tried"));
    }
    if (ranges.given) return holds("every linkage errs by the bound somewhere, covered again in fifty digits");
    return holds(
        fmt::format("every linkage errs by the bound somewhere, in fifty digits, at {} places of the scales; "
                    "the boxes between them are not covered again",
                    all.size()));
}

Finding check_path(const ProofContext& c, const Digits50& bound, PathMeasure measure) {
    const auto found = search_timed_path(c.design);
    Digits50 weights = 0;
    for (const double w : c.design.claim->path->weights)
        weights += w;
    const Digits50 least = bound * bound * weights;
    const Digits50 sum = measure == PathMeasure::sum_of_squares ? bound : least;
    if (found.least < sum)
        return fails(fmt::format("a four-bar has the sum of squares {:.12g}, below {:.12g}", found.least,
                                 sum.convert_to<double>()));
    return holds(
        fmt::format("none of {} other four-bars of any ratios, placed as well as can be, comes below it; the "
                    "boxes between them are not covered again",
                    found.linkages));
}

/// The weights that the bound was found with are found again: whatever they are, what they prove is proven.
Finding check_untimed_path(const ProofContext& c, const Digits50& bound, PathMeasure measure) {
    const PathTarget& path = *c.problem.path;
    const DistancesFromCouplerCurves found = least_distances_from_coupler_curves(path.points, path.weights);
    const bool greatest = measure == PathMeasure::greatest;
    const std::vector<double>& witness = greatest ? found.weights_of_greatest : found.weights_of_sum;
    if (witness.size() != path.points.size()) return fails("nothing is known of curves near these points");
    const MissedPoints missed{path.points, path.weights, witness};
    Digits50 sum = bound;
    if (measure == PathMeasure::root_mean_square)
        sum = bound * bound * std::accumulate(path.weights.begin(), path.weights.end(), Digits50(0));
    if (greatest ? no_curve_comes_within(missed, bound) : no_curve_has_lesser_sum(missed, sum))
        return holds("no coupler curve comes nearer to the points, proven again in fifty digits");
    return fails("it is above what is proven of all coupler curves");
}

/// Whether nothing is better than a bound of an objective, in the units of the analysis.
Finding check_least(const ProofContext& c, const Quantity& quantity, const Digits50& bound) {
    const Claim& claim = *c.design.claim;
    if (claim.function && &quantity == &deviation_from(*claim.mechanism, "function")) return check_function(c, bound);
    const bool points = claim.mechanism->name == "four-bar" && claim.path && claim.path->directions.empty() &&
                        quantity.path != PathMeasure::none && c.problem.path && c.problem.path->parts.empty();
    if (points && !claim.path->prescribed_timing) return check_untimed_path(c, bound, quantity.path);
    if (points && quantity.path != PathMeasure::greatest) return check_path(c, bound, quantity.path);
    return fails("no bound of such an objective is known");
}

constexpr double rounding_of_bounds = 1e-9;

/// A bound as the document states it, and the value of the objective where there is a design.
struct StatedBound {
    double least;
    std::optional<double> reached;
};

std::optional<StatedBound> stated_bound(const ProofContext& c) {
    const Json* bound = member(c.search, "bound");
    const Json* objective = member(c.document, "objective");
    const Json* value = objective && objective->is_object() ? member(*objective, "value") : nullptr;
    if (!bound || !bound->is_number()) return {};
    StatedBound stated{bound->get<double>(), {}};
    if (value && value->is_number()) stated.reached = value->get<double>();
    return stated;
}

/// That nothing is better than the bound, but for rounding.
Finding check_least(const ProofContext& c, double stated) {
    const Quantity* quantity = single_objective(c, false);
    if (!quantity) return fails("one quantity is to be least for this");
    if (stated <= 0 && possible_values(quantity->name).least >= 0)
        return holds(fmt::format("{} cannot be negative", quantity->name));
    return check_least(c, *quantity, from_document(stated, quantity->unit, c.problem.units) * (1 - rounding_of_bounds));
}

}  // namespace

Finding check_bound_again(const ProofContext& c) {
    constexpr double closed_within = 1.1e-6;
    const auto stated = stated_bound(c);
    if (c.infeasible || !stated || !stated->reached) return fails("there is no bound of an objective");
    const double least = stated->least, reached = *stated->reached;
    if (!(least >= (1 - closed_within) * reached && least <= (1 + rounding_of_bounds) * reached))
        return fails(fmt::format("the bound {} does not meet the objective {}", least, reached));
    return check_least(c, least);
}

Finding check_bound_below(const ProofContext& c) {
    const auto stated = stated_bound(c);
    if (!stated) return fails("it is no number");
    if (stated->reached && !(stated->least <= (1 + rounding_of_bounds) * *stated->reached))
        return fails(fmt::format("the bound {} is above the objective {}", stated->least, *stated->reached));
    return check_least(c, stated->least);
}

}  // namespace mechwright
