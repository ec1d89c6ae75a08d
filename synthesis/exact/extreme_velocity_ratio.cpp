#include "synthesis/exact/extreme_velocity_ratio.h"

#include <cmath>
#include <numbers>

#include "synthesis/exact/sized_linkage.h"
#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/mechanism/four_bar/four_bar.h"

namespace mechwright {

namespace {

bool is_extreme_velocity_ratio(const Quantity& quantity) {
    return is_measured_by<four_bar::VelocityRatioExtreme<1>>(quantity) ||
           is_measured_by<four_bar::VelocityRatioExtreme<-1>>(quantity);
}

const Requirement* required_extreme(const Problem& problem) {
    for (const Requirement& r : problem.requirements)
        if (r.equal && is_extreme_velocity_ratio(problem.mechanism->quantities[r.quantity])) return &r;
    return nullptr;
}

/// The four-bar on ground 1 of an extreme ratio m. The coupler's line meets the ground's in P, the instant centre of
/// rocker against crank, whose distances from the pivots have the ratio m; the ratio is extreme where the line from P
/// to Q, where crank and rocker meet, is square to the coupler (Freudenstein; Theory of Machines, section 9-5). `angle`
/// is that of the coupler's line against the ground, `distance` that of Q from P, either side. With p and p + 1 the
/// places of the pivots from P, the pins stand along the coupler's line at
///     p cos(angle) / (1 + p sin(angle) / distance), likewise for p + 1.
struct ExtremePose {
    SizedLinkage linkage;
    std::size_t assembly;
};

ExtremePose four_bar_of(double ratio, double angle, double distance) {
    const double p = ratio / (1 - ratio);
    const double c = std::cos(angle), s = std::sin(angle);
    const auto pin = [&](double pivot) { return pivot * c / (1 + pivot * s / distance); };
    const double crank_pin = pin(p), rocker_pin = pin(p + 1);
    // From the pivots, along the coupler's line and to its left.
    const double crank = std::hypot(crank_pin - p * c, p * s);
    const double rocker = std::hypot(rocker_pin - (p + 1) * c, (p + 1) * s);
    const double coupler = rocker_pin - crank_pin;
    // The line from crank pin to rocker pivot, and the rocker pin on which side of it.
    const double to_pivot_across = -(p + 1) * s;
    return {{1, crank, std::abs(coupler), rocker}, coupler * to_pivot_across < 0 ? std::size_t{0} : std::size_t{1}};
}

std::optional<ExactDesign> member(const Problem& problem, double ratio, std::span<const double> numbers) {
    const double angle = std::numbers::pi * (numbers[0] - 0.5);
    const double distance = std::tan(std::numbers::pi * (numbers[1] - 0.5));
    const auto [linkage, assembly] = four_bar_of(ratio, angle, distance);
    if (!linkage.has_lengths()) return {};
    Design design = design_of(problem, linkage);
    design.assembly = assembly;
    return exact_design(problem, std::move(design));
}

}  // namespace

bool requires_extreme_velocity_ratio(const Problem& problem) {
    return is_four_bar(*problem.mechanism) && required_extreme(problem);
}

std::string why_no_extreme_velocity_ratio(const Problem& problem) {
    if (has_ties(problem)) return "dimensions are tied to others";
    const double ratio = *required_extreme(problem)->equal;
    if (ratio == 0 || ratio == 1)
        return "the theorem gives no four-bar whose extreme velocity ratio is 0 or 1: at 0 the rocker stands still, "
               "at 1 the coupler is parallel to the ground link";
    return {};
}

ExactDesigns extreme_velocity_ratio_designs(const Problem& problem, const RunOptions& options, const RunEnd& end) {
    const double ratio = *required_extreme(problem)->equal;
    const DesignFamily family{2, [&](std::span<const double> numbers) { return member(problem, ratio, numbers); }};
    return search_family(problem, family, options, end);
}

}  // namespace mechwright
