#include "synthesis/study/allocation.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <boost/math/special_functions/erf.hpp>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/work_sharing.h"

namespace mechwright {

namespace {

double variance_of(const LimitShares& shares, const std::vector<double>& times) {
    double variance = 0;
    for (std::size_t i = 0; i < shares.size(); ++i)
        variance += shares[i] * times[i] * times[i];
    return variance;
}

/// A limit of a requirement that the design keeps, with the room that is left to it.
struct KeptLimit {
    std::size_t quantity;
    double room;                     ///< in inner units; not a number where the quantity has no value
    std::string text;                ///< "swing <= 61"
    std::vector<double> deviations;  ///< standard deviation of the quantity that each tolerance makes as given
};

std::vector<KeptLimit> limits_of(const TolerancedDesign& design) {
    std::vector<KeptLimit> limits;
    const Problem& problem = design.problem;
    for (const Requirement& requirement : problem.requirements) {
        const Quantity& quantity = problem.mechanism->quantities[requirement.quantity];
        const auto value = quantity_value(problem, requirement.quantity, design.nominal.design);
        const auto add = [&](double limit, double room, std::string_view relation) {
            const double shown = in_file_unit(limit, quantity.unit, problem.units);
            limits.push_back(
                {requirement.quantity, room, fmt::format("{} {} {:.6g}", quantity.name, relation, shown), {}});
        };
        const double here = value.value_or(std::numeric_limits<double>::quiet_NaN());
        if (requirement.min) add(*requirement.min, here - *requirement.min, ">=");
        if (requirement.max) add(*requirement.max, *requirement.max - here, "<=");
    }
    return limits;
}

/// By how much a quantity is off for a standard deviation of each tolerance.
std::optional<std::vector<double>> deviations_of(const TolerancedDesign& design, const Study& study,
                                                 std::size_t quantity) {
    auto made = changes_of(design, study, quantity);
    for (std::size_t i = 0; made && i < study.deviations.size(); ++i)
        (*made)[i] *= standard_deviation(study.deviations[i], design.sizes[i]);
    return made;
}

/// The standard deviations below which a share of a normal distribution lies.
double deviations_below(double share) { return std::numbers::sqrt2 * boost::math::erf_inv(2 * share - 1); }

bool is_stopped(const StudyRunOptions& options) {
    return (options.stop != nullptr && *options.stop) || std::chrono::steady_clock::now() > options.deadline;
}

bool meets_limits(const Piece& piece) {
    const auto& requirements = piece.problem.requirements;
    return std::all_of(requirements.begin(), requirements.end(), [&](const Requirement& requirement) {
        const auto value = quantity_value(piece.problem, requirement.quantity, piece.solution.design);
        return value && !(requirement.min && *value < *requirement.min) &&
               !(requirement.max && *value > *requirement.max);
    });
}

/// The share of pieces that meet every limit, as low as it may be by the chance of those drawn: two standard errors
/// less than it is among them. They are drawn from other numbers than those of the study, which is to confirm it.
double share_within(const TolerancedDesign& design, Study study, const StudyRunOptions& options) {
    constexpr std::uint64_t least_pieces = 2000, most_pieces = 20000;
    constexpr int parts = 64;
    const std::uint64_t pieces = std::clamp(study.count, least_pieces, most_pieces);
    study.seed = mixed(study.seed);
    std::atomic<std::uint64_t> within = 0;
    share_work(parts, options.jobs, [&](int part) {
        for (auto number = static_cast<std::uint64_t>(part); number < pieces && !is_stopped(options); number += parts)
            within += meets_limits(sample(design, study, number));
    });
    const auto all = static_cast<double>(pieces);
    const double share = static_cast<double>(within) / all;
    return share - 2 * std::sqrt(share * (1 - share) / all);
}

/// The cheapest tolerances that leave every limit so many standard deviations of its quantity away from the design.
AllocatedTolerances allocated_at(double deviations, const std::vector<KeptLimit>& limits, const Allocation& wanted) {
    AllocatedTolerances allocated;
    std::vector<LimitShares> shares;
    for (const KeptLimit& limit : limits) {
        shares.emplace_back();
        for (const double made : limit.deviations)
            shares.back().push_back(std::pow(deviations * made / limit.room, 2));
    }
    allocated.times = cheapest_tolerances(shares, wanted.weights, wanted.exponent);
    constexpr double reached = 1e-6;
    for (std::size_t j = 0; j < limits.size(); ++j)
        if (variance_of(shares[j], allocated.times) > 1 - reached) allocated.limits.push_back(limits[j].text);
    return allocated;
}

}  // namespace

std::vector<double> cheapest_tolerances(const std::vector<LimitShares>& limits, const std::vector<double>& weights,
                                        double exponent) {
    constexpr int most_rounds = 20000;
    constexpr double settled = 1e-13;
    std::vector<double> multipliers(limits.size(), 1.0);
    std::vector<double> times(weights.size());
    for (int round = 0; round < most_rounds; ++round) {
        for (std::size_t i = 0; i < weights.size(); ++i) {
            double price = 0;
            for (std::size_t j = 0; j < limits.size(); ++j)
                price += multipliers[j] * limits[j][i];
            const double stationary = std::pow(exponent * weights[i] / (2 * price), 1 / (exponent + 2));
            times[i] = price > 0 ? std::min(stationary, widest_times) : widest_times;
        }
        // A limit that is passed gets dearer, one with room cheaper; with one limit a whole step would end at once.
        double change = 0;
        for (std::size_t j = 0; j < limits.size(); ++j) {
            const double variance = variance_of(limits[j], times);
            multipliers[j] *= std::pow(variance, (exponent + 2) / 4);
            change = std::max(change, multipliers[j] > settled ? std::abs(variance - 1) : std::max(variance - 1, 0.0));
        }
        if (change < settled) break;
    }
    double most = 0;
    for (const LimitShares& limit : limits)
        most = std::max(most, variance_of(limit, times));
    if (most > 1)
        for (double& one : times)
            one /= std::sqrt(most);
    return times;
}

namespace {

/// Fills in what tolerances do to each limit; why there can be none, where a limit leaves no room.
std::string why_no_room(const TolerancedDesign& design, const Study& study, std::vector<KeptLimit>& limits) {
    for (KeptLimit& limit : limits) {
        if (!(limit.room > 0))
            return fmt::format(
                "no tolerance keeps {}: the design itself {}; a wider limit, or a design with room to spare, is needed",
                limit.text, limit.room == 0 ? "is at this limit, with pieces on both sides" : "misses it");
        auto made = deviations_of(design, study, limit.quantity);
        if (!made)
            return fmt::format(
                "what tolerances do to {} is not known: a piece that is off by one has no such value; "
                "write closer ones in [study.tolerance]",
                limit.text);
        limit.deviations = std::move(*made);
    }
    return {};
}

/// The widest of the cheapest tolerances with which the share of pieces is that which is wanted; `share_of` says what
/// it is with some. One straight limit lets it through at so many standard deviations; several, or curved ones, ask for
/// more.
template <class ShareOf>
AllocatedTolerances widest_of(const std::vector<KeptLimit>& limits, const Allocation& wanted, const ShareOf& share_of) {
    constexpr double step = 1.25, close = 1.01, most = 100;
    const auto at = [&](double deviations) {
        AllocatedTolerances allocated = allocated_at(deviations, limits, wanted);
        allocated.share = share_of(allocated.times);
        return allocated;
    };
    double enough = deviations_below(wanted.share), too_few = enough;
    AllocatedTolerances widest = at(enough);
    while (widest.share < wanted.share && enough < most) {
        too_few = enough;
        enough *= step;
        widest = at(enough);
    }
    while (widest.share >= wanted.share && enough > close * too_few) {
        const double middle = std::sqrt(too_few * enough);
        AllocatedTolerances wider = at(middle);
        (wider.share < wanted.share ? too_few : enough) = middle;
        if (wider.share >= wanted.share) widest = std::move(wider);
    }
    return widest;
}

}  // namespace

bool allocate_tolerances(const Study& study, const StudyRunOptions& options, TolerancedDesign& design,
                         std::string& why) {
    const Allocation& wanted = *study.allocation;
    std::vector<KeptLimit> limits = limits_of(design);
    why = why_no_room(design, study, limits);
    if (!why.empty()) return false;
    const std::vector<double> given = design.sizes;
    const auto widen = [&](const std::vector<double>& times) {
        for (std::size_t i = 0; i < given.size(); ++i)
            design.sizes[i] = given[i] * times[i];
    };
    AllocatedTolerances allocated = widest_of(limits, wanted, [&](const std::vector<double>& times) {
        widen(times);
        return share_within(design, study, options);
    });
    if (is_stopped(options)) {
        why = "tolerances were being allocated when the study was ended; none are known yet";
        return false;
    }
    if (allocated.share < wanted.share) {
        why = fmt::format("no tolerances were found with which {:.6g}% of the pieces meet all limits",
                          100 * wanted.share);
        return false;
    }
    widen(allocated.times);
    for (std::size_t i = 0; i < given.size(); ++i) {
        allocated.usual_cost += wanted.weights[i];
        allocated.cost += wanted.weights[i] / std::pow(allocated.times[i], wanted.exponent);
    }
    design.allocated = std::move(allocated);
    return true;
}

}  // namespace mechwright
