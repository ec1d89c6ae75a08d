#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "analysis/quick_return.h"
#include "analysis/slider_crank/best_slider_crank.h"
#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/exact/family_size.h"
#include "synthesis/mechanism/crank_shaper/layout.h"
#include "synthesis/mechanism/quick_return/formulas.h"
#include "synthesis/mechanism/quick_return/transmission.h"
#include "synthesis/mechanism/slider_crank/layout.h"
#include "synthesis/mechanism/whitworth/layout.h"
#include "synthesis/program/assess.h"
#include "synthesis/proof/known_limits.h"

namespace mechwright {

namespace {

using namespace quick_return;

/// What the closed forms of ram-driving mechanisms are asked.
struct RamTask {
    double time_ratio = 0;
    double stroke = 0;                         ///< 0: not required
    std::optional<double> least_transmission;  ///< required
    bool best_transmission = false;            ///< asked for
};

template <template <class> class Drive>
bool is_transmission(const Quantity& quantity) {
    // The angle at the ram never exceeds a right one, so that least and worst are the same.
    return is_measured_by<TransmissionAngleWorst<Drive>>(quantity) ||
           is_measured_by<TransmissionAngleMin<Drive>>(quantity);
}

/// The task a problem poses, or nothing if it asks for anything else.
template <template <class> class Drive>
std::optional<RamTask> ram_task(const Problem& problem) {
    if (problem.path || problem.crank_range) return std::nullopt;
    RamTask task;
    for (const Requirement& r : problem.requirements) {
        const Quantity& q = problem.mechanism->quantities[r.quantity];
        if (is_measured_by<TimeRatio<Drive>>(q) && r.equal && task.time_ratio == 0)
            task.time_ratio = *r.equal;
        else if (is_measured_by<Stroke<Drive>>(q) && r.equal && *r.equal > 0 && task.stroke == 0)
            task.stroke = *r.equal;
        else if (is_transmission<Drive>(q) && r.min && !r.max && !task.least_transmission)
            task.least_transmission = *r.min;
        else
            return std::nullopt;
    }
    if (problem.objective) {
        const Objective& objective = *problem.objective;
        if (objective.terms.size() != 1 || !objective.terms.front().maximize) return std::nullopt;
        if (!is_transmission<Drive>(problem.mechanism->quantities[objective.terms.front().quantity]))
            return std::nullopt;
        task.best_transmission = true;
    }
    return task.time_ratio > 1 ? std::optional(task) : std::nullopt;
}

template <template <class> class Drive>
bool covers(const Problem& problem) {
    return ram_task<Drive>(problem).has_value();
}

double preferred_value(const DimensionRange& range) { return range.start.value_or(0.5 * (range.min + range.max)); }

double within(const DimensionRange& range, double value) { return std::clamp(value, range.min, range.max); }

/// A design with every dimension at its preferred value, to be overwritten where the closed form says more.
Design preferred_design(const Problem& problem) {
    Design design;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(preferred_value(range));
    design.assembly = problem.assemblies.front();
    return design;
}

/// The transmission angle that is required, or else to be greatest.
std::size_t transmission_asked(const Problem& problem, bool required) {
    if (!required) return problem.objective->terms.front().quantity;
    for (const Requirement& r : problem.requirements)
        if (problem.mechanism->quantities[r.quantity].name.starts_with("transmission-angle")) return r.quantity;
    return 0;
}

/// What a best design says of a problem: it is the answer, proves that there is none, or lies outside the ranges.
/// `limit` is the name of what limits the transmission angle (synthesis/proof/known_limits.h).
std::optional<ClosedFormOutcome> concluded(const Problem& problem, const RamTask& task, double best_transmission,
                                           Design design, std::string limit, std::string argument) {
    ClosedFormOutcome outcome;
    outcome.infeasible =
        task.least_transmission && best_transmission < *task.least_transmission - problem.solver.tolerance;
    outcome.best = assess(problem, std::move(design));
    if (outcome.infeasible || problem.objective)
        outcome.proof = proof_by(
            std::move(argument),
            LimitCertificate{std::move(limit), transmission_asked(problem, outcome.infeasible), best_transmission});
    else
        outcome.proof = proof_by(std::move(argument), GivenCertificate{});
    if (!outcome.infeasible && !outcome.best->feasible) return std::nullopt;
    return outcome;
}

double least_transmission_of(const SliderCrank<double>& m) {
    return std::acos(std::min(1.0, (m.crank + std::abs(m.offset)) / m.rod));
}

std::optional<ClosedFormOutcome> solve_slider_crank(const Problem& problem) {
    const RamTask task = *ram_task<SliderCrank>(problem);
    const auto unit = best_transmission_slider_crank(task.stroke > 0 ? task.stroke : 1, task.time_ratio);
    if (!unit) {
        auto none = proof_by_limits(problem);
        return none ? std::optional(
                          ClosedFormOutcome{.best = std::nullopt, .infeasible = true, .proof = std::move(none)})
                    : std::nullopt;
    }
    for (const double side : {1.0, -1.0}) {
        const std::array<UnitDimension, 3> dimensions{{{0, unit->crank}, {1, unit->rod}, {2, side * unit->offset}}};
        const auto size = task.stroke > 0 ? std::optional(1.0) : size_in_ranges(problem, dimensions);
        if (!size) continue;
        Design design = preferred_design(problem);
        for (const auto& [index, value] : dimensions)
            design.dimensions[index] =
                problem.dimensions[index].fixed() ? problem.dimensions[index].min : *size * value;
        auto outcome = concluded(problem, task, least_transmission_of(*unit), std::move(design), "ratio-family",
                                 "closed form: all slider-cranks of this time ratio form one one-parameter family and "
                                 "its mirror image; this is the only maximum of the least transmission angle in it");
        if (outcome) return outcome;
    }
    return std::nullopt;
}

/// Two lengths of a given ratio (second / first) in the ranges of two dimensions.
bool set_pair(const Problem& problem, Design& design, std::size_t first, std::size_t second, double ratio) {
    const std::array<UnitDimension, 2> pair{{{first, 1}, {second, ratio}}};
    const auto size = size_in_ranges(problem, pair);
    if (!size) return false;
    design.dimensions[first] = within(problem.dimensions[first], *size);
    design.dimensions[second] = within(problem.dimensions[second], *size * ratio);
    return true;
}

/// The sine of half the angle by which the slow stroke exceeds half a turn: of both slotted drives the ratio of crank
/// and centre distance, for Whitworth's with the slide square to the line of centres.
double slotted_ratio(double time_ratio) { return std::cos(std::numbers::pi / (1 + time_ratio)); }

std::optional<ClosedFormOutcome> solve_crank_shaper(const Problem& problem) {
    constexpr std::size_t centre_distance = 0, crank = 1, lever = 2, rod = 3, ram_distance = 4;
    const RamTask task = *ram_task<CrankShaper>(problem);
    const double ratio = slotted_ratio(task.time_ratio);
    const bool best = task.best_transmission || task.least_transmission;
    Design design = preferred_design(problem);
    std::vector<double>& d = design.dimensions;
    if (!set_pair(problem, design, centre_distance, crank, ratio)) return std::nullopt;
    // The height of the rod pin varies between that of the upright lever and that at the ends of its swing; the slope
    // of the rod is least for a ram line half way and the longest rod.
    const double ends = std::sqrt((1 - ratio) * (1 + ratio)), half_way = 0.5 * (1 + ends);
    const DimensionRange &levers = problem.dimensions[lever], &ram_lines = problem.dimensions[ram_distance];
    if (task.stroke > 0)
        d[lever] = task.stroke / (2 * ratio);
    else if (best)  // as short as it can be, but as long as brings its pin to the lowest ram line
        d[lever] = within(levers, ram_lines.min / half_way);
    if (best || !ram_lines.start) d[ram_distance] = within(ram_lines, half_way * d[lever]);
    if (best) d[rod] = problem.dimensions[rod].max;
    const double at_ends = d[lever] * ends;
    const double slope = std::max(d[lever] - d[ram_distance], d[ram_distance] - at_ends) / d[rod];
    return concluded(
        problem, task, std::acos(std::clamp(slope, -1.0, 1.0)), std::move(design), "lever",
        best ? "closed form: the time ratio fixes crank over centre distance, the stroke the lever; the rod "
               "slopes least with the longest rod and the ram line half way between the extreme heights of "
               "its pin"
             : "closed form: the time ratio fixes crank over centre distance, the stroke the lever");
}

std::optional<ClosedFormOutcome> solve_whitworth(const Problem& problem) {
    constexpr std::size_t centre_distance = 0, crank = 1, arm = 2, rod = 3, slide_angle = 4;
    const RamTask task = *ram_task<Whitworth>(problem);
    const bool best = task.best_transmission || task.least_transmission;
    Design design = preferred_design(problem);
    std::vector<double>& d = design.dimensions;
    if (!problem.dimensions[slide_angle].start)
        d[slide_angle] = within(problem.dimensions[slide_angle], std::numbers::pi / 2);
    const double ratio = slotted_ratio(task.time_ratio) / std::abs(std::sin(d[slide_angle]));
    if (!(ratio < 1) || !set_pair(problem, design, crank, centre_distance, ratio)) return std::nullopt;
    if (task.stroke > 0)
        d[arm] = task.stroke / 2;
    else if (best)
        d[arm] = problem.dimensions[arm].min;
    if (best) d[rod] = problem.dimensions[rod].max;
    const double transmission = std::acos(std::min(1.0, d[arm] / d[rod]));
    return concluded(problem, task, transmission, std::move(design), "arm",
                     best ? "closed form: the time ratio fixes centre distance over crank, the stroke the arm; the rod "
                            "slopes least when it is longest"
                          : "closed form: the time ratio fixes centre distance over crank, the stroke the arm");
}

}  // namespace

ClosedForm slider_crank_closed_form() {
    return {
        covers<SliderCrank>, solve_slider_crank,
        "slider-cranks, crank shapers and Whitworth drives with the time ratio (> 1) and perhaps the stroke required "
        "as equalities and, if anything more, the greatest least transmission angle"};
}

ClosedForm crank_shaper_closed_form() { return {covers<CrankShaper>, solve_crank_shaper, {}}; }

ClosedForm whitworth_closed_form() { return {covers<Whitworth>, solve_whitworth, {}}; }

}  // namespace mechwright
