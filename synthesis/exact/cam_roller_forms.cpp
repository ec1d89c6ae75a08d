#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/exact/closed_form.h"
#include "synthesis/exact/half_planes.h"
#include "synthesis/exact/smallest_design.h"
#include "synthesis/mechanism/cam/quantities.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/variant.h"

namespace mechwright {

namespace {

using namespace cam;

/// A limit on the pressure angle in a segment, from one side. In suitable coordinates of the cam centre it is a
/// half-plane for every cam angle.
struct AngleLimit {
    std::size_t segment;
    double limit;
    int sign;  ///< +1: the angle is at most the limit, -1: at least its negative
};

/// Of a translating follower in (offset, guide height): tan of the angle is (s' - e) / (d + s).
template <class T>
struct GuideRow {
    T x, y, level;
};

template <class T>
GuideRow<T> row_of(const TranslatingRoller<double>&, const AngleLimit& limit, const Lift<T>& lift) {
    const double cot = 1 / std::tan(limit.limit);
    return {T(limit.sign * cot), T(1), T(limit.sign * cot) * lift.v - lift.s};
}

/// Of an oscillating follower in the position of the cam centre seen from the pivot, x along the arm at its lowest
/// position: tan of the angle is (l v + sigma l - sigma c cos psi) / (c sin psi).
template <class T>
GuideRow<T> row_of(const OscillatingRoller<double>& f, const AngleLimit& limit, const Lift<T>& lift) {
    using std::cos, std::sin;
    const double tangent = std::tan(limit.limit), side = limit.sign * f.sense;
    const T c = cos(lift.s), s = sin(lift.s);
    return {T(tangent) * s + T(side) * c, T(tangent) * c - T(side) * s,
            T(limit.sign * f.arm_length) * (lift.v + T(static_cast<double>(f.sense)))};
}

/// What the problem asks beside the size, as far as half-planes can say it.
struct SizeTask {
    std::vector<AngleLimit> limits;
    bool pivot_distance = false;  ///< it is to be least, not the prime radius
};

template <template <class> class F>
std::optional<std::size_t> size_asked(const Problem& problem) {
    if (!problem.objective || problem.objective->terms.size() != 1) return std::nullopt;
    const ObjectiveTerm& term = problem.objective->terms.front();
    const auto measure = problem.mechanism->quantities[term.quantity].measure;
    if (term.maximize) return std::nullopt;
    if (measure == &measure_dimension<F, 0>) return 0;
    if (Layout<F>::oscillating && measure == &measure_dimension<F, 1>) return 1;
    return std::nullopt;
}

/// Limits from above on pressure angles; other requirements are looked at when the size is known.
template <template <class> class F>
std::vector<AngleLimit> angle_limits(const Problem& problem) {
    std::vector<AngleLimit> limits;
    for (const Requirement& r : problem.requirements) {
        const auto measure = problem.mechanism->quantities[r.quantity].measure;
        const Kinds kinds = measure == &Extremes<F, PressureAngle, in_rises, true>::measure     ? in_rises
                            : measure == &Extremes<F, PressureAngle, in_returns, true>::measure ? in_returns
                            : measure == &Extremes<F, PressureAngle, anywhere, true>::measure   ? anywhere
                                                                                                : nullptr;
        if (kinds == nullptr || !r.max || !(*r.max > 0 && *r.max < std::numbers::pi / 2)) continue;
        for (std::size_t i = 0; i < problem.program->segments.size(); ++i)
            if (kinds(problem.program->segments[i].kind))
                for (const int sign : {1, -1})
                    limits.push_back({i, *r.max, sign});
    }
    return limits;
}

/// Free are the prime radius and offset, or prime radius and pivot distance; an arm may be as short as is allowed, for
/// everything scales with it. The roller is as small as is allowed.
template <template <class> class F>
bool covers(const Problem& problem) {
    constexpr std::size_t arm = 2, roller = Layout<F>::shape - 1;
    if (!problem.program || problem.mechanism->families[0].assembly_margin->measure != &ExistenceMargin<F>::measure)
        return false;
    if (!size_asked<F>(problem) || angle_limits<F>(problem).empty()) return false;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const bool may_be_free = i < 2 || i == roller || (Layout<F>::oscillating && i == arm);
        if (!may_be_free && !problem.dimensions[i].fixed()) return false;
    }
    if (problem.dimensions[0].fixed()) return false;
    return !Layout<F>::oscillating || !problem.dimensions[1].fixed();
}

std::vector<HalfPlane> fixed_rows(const Problem& problem, const TranslatingRoller<double>&) {
    const DimensionRange& offset = problem.dimensions[1];
    return {{{0, 1}, 0}, {{1, 0}, offset.min}, {{-1, 0}, -offset.max}};
}

std::vector<HalfPlane> fixed_rows(const Problem&, const OscillatingRoller<double>&) { return {{{0, 1}, 0}}; }

/// Rows are added where the cam centre violates them most, until none is violated but by rounding. Each step is the
/// optimum of fewer half-planes than there are, so that the last one, which violates none, is the optimum of all.
template <template <class> class F>
std::optional<ClosestPoint> closest_centre(const Problem& problem, const Motion& motion, std::span<const double> d,
                                           const std::vector<AngleLimit>& limits, const Vector<double>& target) {
    constexpr int most_steps = 100;
    constexpr double rounding = 1e-14;
    const auto follower = follower_of<F, double>(d, motion.assembly);
    std::vector<HalfPlane> rows = fixed_rows(problem, follower);
    ClosestPoint centre{target};
    for (int step = 0; step < most_steps; ++step) {
        bool added = false;
        double scale = std::hypot(centre.at.x, centre.at.y);
        for (const HalfPlane& row : rows)
            scale = std::max(scale, std::abs(row.level) / std::hypot(row.normal.x, row.normal.y));
        for (const AngleLimit& limit : limits) {
            const PlacedSegment placed = placed_segment<F>(motion, d, limit.segment);
            const auto violation = [&]<class T>(const Lift<T>& lift) {
                const auto row = row_of(follower, limit, lift);
                return T(row.level - row.x * T(centre.at.x) - row.y * T(centre.at.y));
            };
            const Place place = greatest_places<1>(placed.segment, limit.segment, placed.start_lift, violation)[0];
            const auto row = row_of(follower, limit, lift_at(placed.segment, place.piece, place.u, placed.start_lift));
            const double size = std::hypot(row.x, row.y);
            const double missed = row.level - row.x * centre.at.x - row.y * centre.at.y;
            if (step > 0 && !(missed > rounding * scale * size)) continue;
            rows.push_back({{row.x, row.y}, row.level});
            added = true;
        }
        if (!added) return centre;
        const auto next = closest_point(target, rows, rounding * scale);
        if (!next) return std::nullopt;
        centre = *next;
    }
    return centre;
}

void place_centre(std::vector<double>& d, const TranslatingRoller<double>&, const Vector<double>& centre) {
    d[0] = std::hypot(centre.x, centre.y);
    d[1] = centre.x;
}

void place_centre(std::vector<double>& d, const OscillatingRoller<double>& f, const Vector<double>& centre) {
    d[0] = std::hypot(centre.x - f.arm_length, centre.y);
    d[1] = std::hypot(centre.x, centre.y);
}

std::string certificate(const ClosestPoint& centre, const Problem& problem) {
    std::string text = fmt::format(
        "half-planes: for every cam angle a limit on the pressure angle is a half-plane for the {}, so that the least "
        "size is the distance to a convex region; {} half-plane{} bind{}, multiplier{}",
        problem.mechanism->dimensions[1].name == "offset" ? "offset and height of the guide"
                                                          : "position of the cam centre",
        centre.binding_count, centre.binding_count == 1 ? "" : "s", centre.binding_count == 1 ? "s" : "",
        centre.binding_count == 1 ? "" : "s");
    for (std::size_t i = 0; i < centre.binding_count; ++i)
        text += fmt::format("{} {:.6g}", i == 0 ? "" : " and", centre.multiplier[i]);
    return text + ", none negative";
}

template <template <class> class F>
std::optional<ClosedFormOutcome> solve(const Problem& problem) {
    const bool pivot = *size_asked<F>(problem) == 1;
    const auto limits = angle_limits<F>(problem);
    std::optional<ClosedFormOutcome> best;
    bool undecided = false;
    for (const std::size_t assembly : problem.assemblies) {
        const Motion motion = motion_of(problem, 0, assembly);
        Design design = smallest_design(problem, assembly);
        std::vector<double>& d = design.dimensions;
        const auto follower = follower_of<F, double>(std::span<const double>(d), assembly);
        Vector<double> target{};
        if constexpr (Layout<F>::oscillating)
            if (!pivot) target.x = follower.arm_length;
        const auto centre = closest_centre<F>(problem, motion, d, limits, target);
        ClosedFormOutcome outcome;
        if (!centre) {
            outcome.infeasible = true;
            outcome.argument =
                "half-planes: no position of the cam centre meets the limits on the pressure angle at every "
                "cam angle";
            for (std::size_t i = 0; i < d.size(); ++i)
                d[i] =
                    problem.dimensions[i].start.value_or(0.5 * (problem.dimensions[i].min + problem.dimensions[i].max));
            outcome.best = assess(problem, std::move(design));
        } else {
            place_centre(d, follower, centre->at);
            outcome.argument = certificate(*centre, problem);
            const std::size_t size = pivot ? 1 : 0;
            if (d[size] > problem.dimensions[size].max * (1 + problem.solver.tolerance)) {
                outcome.infeasible = true;
                outcome.argument +=
                    fmt::format("; the least {} is {:.9g}", problem.mechanism->dimensions[size].name, d[size]);
                d[size] = problem.dimensions[size].max;
            } else if (!Layout<F>::oscillating && d[0] < problem.dimensions[0].min) {
                d[0] = problem.dimensions[0].min;  // a higher guide meets the limits too
            }
            outcome.best = assess(problem, std::move(design));
            if (!outcome.infeasible && !outcome.best->feasible) {
                undecided = true;
                continue;
            }
        }
        keep_smaller(best, std::move(outcome));
    }
    return undecided ? std::nullopt : best;
}

}  // namespace

ClosedForm translating_cam_closed_form() {
    return {
        covers<TranslatingRoller>, solve<TranslatingRoller>,
        "cams with roller or knife-edge followers under limits on the pressure angle, of least prime radius or pivot "
        "distance"};
}

ClosedForm oscillating_cam_closed_form() { return {covers<OscillatingRoller>, solve<OscillatingRoller>, {}}; }

}  // namespace mechwright
