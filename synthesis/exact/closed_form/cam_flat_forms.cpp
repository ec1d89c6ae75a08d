#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/exact/closed_form/smallest_design.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/quantities.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

using namespace cam;

/// The greatest least radius of curvature that is required; 0 where none is, for a cusp is none.
double least_radius(const Problem& problem) {
    double least = 0;
    for (const Requirement& r : problem.requirements)
        if (problem.mechanism->quantities[r.quantity].measure ==
                &Extremes<TranslatingFlat, ProfileRadius, anywhere, false>::measure &&
            r.min)
            least = std::max(least, *r.min);
    return least;
}

bool covers(const Problem& problem) {
    if (!program_of(*problem.mechanism) || !problem.objective || problem.objective->terms.size() != 1) return false;
    const ObjectiveTerm& term = problem.objective->terms.front();
    if (term.maximize || problem.mechanism->quantities[term.quantity].measure != &measure_dimension<TranslatingFlat, 0>)
        return false;
    return std::all_of(problem.dimensions.begin() + 1, problem.dimensions.end(),
                       [](const DimensionRange& range) { return range.fixed(); });
}

/// The place of a motion at which a formula of the lift is least, with its value there.
template <template <class> class F, class Formula>
std::pair<double, CamPlace> least_over_turn(const Motion& motion, std::span<const double> dimensions,
                                            const Formula& formula) {
    std::pair<double, CamPlace> least{std::numeric_limits<double>::infinity(), {}};
    for (std::size_t i = 0; i < program_of(motion).segments.size(); ++i) {
        const PlacedSegment placed = placed_segment<F>(motion, dimensions, i);
        const auto deficit = [&]<class T>(const Lift<T>& lift) { return T(-formula(lift)); };
        const SegmentPlace at = greatest_places<1>(placed.segment, i, placed.start_lift, deficit)[0];
        const double value = formula(lift_at(placed.segment, at.piece, at.u, placed.start_lift));
        if (value < least.first) least = {value, {i, at.piece, at.u}};
    }
    return least;
}

/// Room for what the tolerance lets pass, where that there is no design is to be shown.
double room(const Problem& problem, double limit) { return 2 * problem.solver.tolerance * std::abs(limit); }

/// The radius of curvature is the base radius and s + s'' together, so that the least base radius follows from the
/// least s + s'' over the turn (Carver and Quinn).
std::optional<ClosedFormOutcome> solve(const Problem& problem, std::size_t assembly) {
    const DimensionRange& range = problem.dimensions[0];
    const double radius = least_radius(problem);
    const Motion motion = motion_of(problem, 0, assembly);
    Design design = smallest_design(problem, assembly);
    const auto [least, place] = least_over_turn<TranslatingFlat>(
        motion, design.dimensions, []<class T>(const Lift<T>& lift) { return T(lift.s + lift.a); });
    const double base = std::max(radius - least, range.min);
    ClosedFormOutcome outcome;
    outcome.infeasible = radius - room(problem, radius) - least > range.max + room(problem, range.max);
    if (outcome.infeasible) outcome.least = base;
    design.dimensions[0] = std::clamp(base, range.min, range.max);
    outcome.best = assess(problem, std::move(design));
    if (!outcome.infeasible && !outcome.best->feasible) return std::nullopt;  // something else is asked too
    outcome.proof = proof_by(
        fmt::format("closed form: under a flat face the radius of curvature is base radius + s + s'', and the least "
                    "s + s'' over the turn is {:.9g}{}",
                    least, outcome.infeasible ? fmt::format("; the least base radius is {:.9g}", base) : ""),
        CurvatureCertificate{0, {{assembly, place}}});
    return outcome;
}

std::optional<ClosedFormOutcome> solve_all(const Problem& problem) {
    return best_of_assemblies<CurvatureCertificate>(problem,
                                                    [&](std::size_t assembly) { return solve(problem, assembly); });
}

/// What is asked of an oscillating face: the angle that it starts at, and a radius of curvature.
struct SwingTask {
    double start_angle = 0;
    double radius = 0;
    std::size_t size = 0;  ///< the dimension that is to be least
};

std::optional<SwingTask> swing_task(const Problem& problem) {
    if (!program_of(*problem.mechanism) || !problem.objective || problem.objective->terms.size() != 1)
        return std::nullopt;
    const ObjectiveTerm& term = problem.objective->terms.front();
    const auto asked = problem.mechanism->quantities[term.quantity].measure;
    const bool size =
        asked == &measure_dimension<OscillatingFlat, 0> || asked == &measure_dimension<OscillatingFlat, 1>;
    if (term.maximize || !size || problem.dimensions[0].fixed() || problem.dimensions[1].fixed()) return std::nullopt;
    if (!std::all_of(problem.dimensions.begin() + 2, problem.dimensions.end(),
                     [](const DimensionRange& range) { return range.fixed(); }))
        return std::nullopt;
    SwingTask task;
    task.size = asked == &measure_dimension<OscillatingFlat, 0> ? 0 : 1;
    for (const Requirement& r : problem.requirements) {
        const auto measure = problem.mechanism->quantities[r.quantity].measure;
        if (measure == &measure_at_start<OscillatingFlat, StartAngle> && r.equal) task.start_angle = *r.equal;
        if (measure == &Extremes<OscillatingFlat, ProfileRadius, anywhere, false>::measure && r.min)
            task.radius = std::max(task.radius, *r.min);
    }
    return task.start_angle > 0 ? std::optional(task) : std::nullopt;
}

bool covers_swing(const Problem& problem) { return swing_task(problem).has_value(); }

/// For a given start angle the radius of curvature is pivot distance times g, less the face offset, where g depends on
/// the motion alone: the least g over the turn gives the least pivot distance, or shows that there is none.
std::optional<ClosedFormOutcome> solve_swing(const Problem& problem, std::size_t assembly) {
    const SwingTask task = *swing_task(problem);
    const Motion motion = motion_of(problem, 0, assembly);
    Design design = smallest_design(problem, assembly);
    std::vector<double>& d = design.dimensions;
    const auto [least, place] = least_over_turn<OscillatingFlat>(motion, d, [&]<class T>(const Lift<T>& lift) {
        // At pivot distance 1 with the face in line with its pivot.
        const OscillatingFlat<T> unit{T(std::sin(task.start_angle)), T(1), T(0), sense_of(assembly)};
        return T(face_contact(unit, lift).radius);
    });
    const double offset = d[2], needed = task.radius + offset;
    const DimensionRange &bases = problem.dimensions[0], &distances = problem.dimensions[1];
    const double distance = needed / least;
    // The start angle may be missed by the tolerance: g changes by less than a few times that.
    const double tolerance = problem.solver.tolerance, greatest_part = least + 10 * tolerance;
    const bool none =
        needed > room(problem, needed) &&
        (greatest_part < 0 || (needed - room(problem, needed)) / greatest_part > distances.max * (1 + 2 * tolerance));
    ClosedFormOutcome outcome;
    outcome.infeasible = none;
    if (none && least > 0) outcome.least = distance;
    if (!none && !(least > 0)) return std::nullopt;
    std::string argument = fmt::format(
        "closed form: for this start angle the radius of curvature is the pivot distance times {:.9g}, less the "
        "face offset, where it is least",
        least);
    if (none)
        argument +=
            least > 0 ? fmt::format("; the least pivot distance is {:.9g}", distance) : ": no pivot distance is enough";
    d[1] = none ? distances.max : std::max(distance, distances.min);
    d[0] = std::clamp(d[1] * std::sin(task.start_angle) - offset, bases.min, bases.max);
    outcome.best = assess(problem, std::move(design));
    if (!none && !outcome.best->feasible) return std::nullopt;
    outcome.proof = proof_by(std::move(argument), CurvatureCertificate{none ? 1 : task.size, {{assembly, place}}});
    return outcome;
}

std::optional<ClosedFormOutcome> solve_all_swings(const Problem& problem) {
    return best_of_assemblies<CurvatureCertificate>(
        problem, [&](std::size_t assembly) { return solve_swing(problem, assembly); });
}

}  // namespace

ClosedForm swinging_flat_cam_closed_form() { return {covers_swing, solve_all_swings, {}}; }

ClosedForm flat_cam_closed_form() {
    return {covers, solve_all, "cams with translating flat followers, of least base radius for a radius of curvature"};
}

}  // namespace mechwright
