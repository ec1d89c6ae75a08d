#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "synthesis/exact/closed_form/closed_form.h"
#include "synthesis/exact/closed_form/half_planes.h"
#include "synthesis/exact/closed_form/smallest_design.h"
#include "synthesis/mechanism/cam/cam.h"
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
template <class T, class U>
HalfPlane<T> row_of(const TranslatingRoller<U>&, int sign, const U& tangent, const Lift<T>& lift) {
    const T cot(sign / tangent);
    return {{cot, T(1)}, cot * lift.v - lift.s};
}

/// Of an oscillating follower in the position of the cam centre seen from the pivot, x along the arm at its lowest
/// position: tan of the angle is (l v + sigma l - sigma c cos psi) / (c sin psi).
template <class T, class U>
HalfPlane<T> row_of(const OscillatingRoller<U>& f, int sign, const U& tangent, const Lift<T>& lift) {
    using std::cos, std::sin;
    const double side = sign * f.sense;
    const T c = cos(lift.s), s = sin(lift.s);
    return {{T(tangent) * s + T(side) * c, T(tangent) * c - T(side) * s},
            T(sign * f.arm_length) * (lift.v + T(static_cast<double>(f.sense)))};
}

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
        for (std::size_t i = 0; i < program_of(*problem.mechanism)->segments.size(); ++i)
            if (kinds(program_of(*problem.mechanism)->segments[i].kind))
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
    if (!program_of(*problem.mechanism) ||
        problem.mechanism->families[0].assembly_margin->measure != &ExistenceMargin<F>::measure)
        return false;
    if (!size_asked<F>(problem) || angle_limits<F>(problem).empty()) return false;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i) {
        const bool may_be_free = i < 2 || i == roller || (Layout<F>::oscillating && i == arm);
        if (!may_be_free && !problem.dimensions[i].fixed()) return false;
    }
    if (problem.dimensions[0].fixed()) return false;
    return !Layout<F>::oscillating || !problem.dimensions[1].fixed();
}

/// A half-plane of the region that the cam centre has to lie in, and where it comes from.
struct Row {
    std::optional<AngleLimit> limit;  ///< none: where the guide may stand
    SegmentPlace place{};             ///< on the segment of the limit
    HalfPlane<double> plane;
};

std::vector<Row> fixed_rows(const Problem& problem, const TranslatingRoller<double>&) {
    const DimensionRange& offset = problem.dimensions[1];
    return {{{}, {}, {{0, 1}, 0}}, {{}, {}, {{1, 0}, offset.min}}, {{}, {}, {{-1, 0}, -offset.max}}};
}

std::vector<Row> fixed_rows(const Problem&, const OscillatingRoller<double>&) { return {{{}, {}, {{0, 1}, 0}}}; }

struct Centre {
    ClosestPoint closest;
    std::vector<Row> rows;
};

HalfPlaneCertificate::Part part_of(const Centre& centre, std::size_t assembly) {
    HalfPlaneCertificate::Part part{assembly};
    for (std::size_t i = 0; i < centre.closest.binding_count; ++i) {
        const std::size_t at = centre.closest.binding[i];
        const Row& row = centre.rows[at];
        WeightedHalfPlane one;
        one.weight = centre.closest.weight[i];
        if (row.limit) {
            one.place = {row.limit->segment, row.place.piece, row.place.u};
            one.limit = row.limit->limit;
            one.side = row.limit->sign;
        } else {  // in the order of fixed_rows
            one.origin = static_cast<WeightedHalfPlane::Origin>(at + 1);
        }
        part.rows.push_back(one);
    }
    return part;
}

/// Rows are added where the cam centre violates them most, until none is violated but by rounding. Each step is the
/// optimum of fewer half-planes than there are, so that the last one, which violates none, is the optimum of all; and
/// where these few have no point, there is none.
template <template <class> class F>
Centre closest_centre(const Problem& problem, const Motion& motion, std::span<const double> d,
                      const std::vector<AngleLimit>& limits, const Vector<double>& target) {
    constexpr int most_steps = 100;
    constexpr double zero_within = 1e-14;
    const auto follower = follower_of<F, double>(d, motion.assembly);
    Centre centre{{.at = target}, fixed_rows(problem, follower)};
    std::vector<Row>& rows = centre.rows;
    std::vector<HalfPlane<double>> planes;
    for (const Row& row : rows)
        planes.push_back(row.plane);
    for (int step = 0; step < most_steps; ++step) {
        const Vector<double>& at = centre.closest.at;
        double scale = std::hypot(at.x, at.y);
        for (const HalfPlane<double>& plane : planes)
            scale = std::max(scale, std::abs(plane.level) / std::hypot(plane.normal.x, plane.normal.y));
        bool added = false;
        for (const AngleLimit& limit : limits) {
            const double tangent = std::tan(limit.limit);
            const PlacedSegment placed = placed_segment<F>(motion, d, limit.segment);
            const auto violation = [&]<class T>(const Lift<T>& lift) {
                const auto row = row_of(follower, limit.sign, tangent, lift);
                return T(row.level - row.normal.x * T(at.x) - row.normal.y * T(at.y));
            };
            const SegmentPlace place =
                greatest_places<1>(placed.segment, limit.segment, placed.start_lift, violation)[0];
            const auto row =
                row_of(follower, limit.sign, tangent, lift_at(placed.segment, place.piece, place.u, placed.start_lift));
            const double missed = row.level - dot(row.normal, at);
            if (step > 0 && !(missed > zero_within * scale * std::hypot(row.normal.x, row.normal.y))) continue;
            rows.push_back({limit, place, row});
            planes.push_back(row);
            added = true;
        }
        if (!added) return centre;
        centre.closest = closest_point(target, planes);
        if (centre.closest.region != Region::holds_the_point) return centre;
    }
    return centre;
}

/// The distance from the target that no cam centre can have less of, by the binding rows, in fifty digits.
template <template <class> class F>
Digits50 certified_distance(const Motion& motion, std::span<const double> d, const Centre& centre,
                            const Vector<double>& target) {
    const std::vector<Digits50> dimensions(d.begin(), d.end());
    const std::span<const Digits50> fine(dimensions);
    const auto follower = follower_of<F, Digits50>(fine, motion.assembly);
    std::vector<HalfPlane<Digits50>> planes;
    std::vector<Digits50> weights;
    for (std::size_t i = 0; i < centre.closest.binding_count; ++i) {
        const auto& [limit, place, plane] = centre.rows[centre.closest.binding[i]];
        weights.emplace_back(centre.closest.weight[i]);
        if (!limit) {
            planes.push_back({{plane.normal.x, plane.normal.y}, plane.level});
            continue;
        }
        const auto p = parameters_of<Digits50>(program_of(motion), slots<F>, fine, limit->segment);
        const auto segment = segment_of(program_of(motion), motion.assembly, limit->segment, p);
        planes.push_back(row_of(follower, limit->sign, Digits50(tan(Digits50(limit->limit))),
                                lift_at(segment, place.piece, Digits50(place.u), p.start_lift)));
    }
    return distance_by_weights<Digits50>({target.x, target.y}, planes, weights);
}

void place_centre(std::vector<double>& d, const TranslatingRoller<double>&, const Vector<double>& centre) {
    d[0] = std::hypot(centre.x, centre.y);
    d[1] = centre.x;
}

void place_centre(std::vector<double>& d, const OscillatingRoller<double>& f, const Vector<double>& centre) {
    d[0] = std::hypot(centre.x - f.arm_length, centre.y);
    d[1] = std::hypot(centre.x, centre.y);
}

std::string region_of(const Problem& problem) {
    return problem.mechanism->dimensions[1].name == "offset" ? "offset and height of the guide"
                                                             : "position of the cam centre";
}

std::string argument_of(const Centre& centre, const Problem& problem) {
    const ClosestPoint& closest = centre.closest;
    std::string text = fmt::format(
        "half-planes: for every cam angle a limit on the pressure angle is a half-plane for the {}, so that the least "
        "size is the distance to a convex region; {} half-plane{} bind{}, multiplier{}",
        region_of(problem), closest.binding_count, closest.binding_count == 1 ? "" : "s",
        closest.binding_count == 1 ? "s" : "", closest.binding_count == 1 ? "" : "s");
    for (std::size_t i = 0; i < closest.binding_count; ++i)
        text += fmt::format("{} {:.6g}", i == 0 ? "" : " and", closest.weight[i]);
    return text + ", none negative";
}

/// Limits that hold for everything that still counts as meeting them.
std::optional<std::vector<AngleLimit>> loosened(std::vector<AngleLimit> limits, double tolerance) {
    for (AngleLimit& limit : limits) {
        limit.limit += 2 * tolerance * std::max(limit.limit, 1.0);
        if (!(limit.limit < std::numbers::pi / 2)) return std::nullopt;
    }
    return limits;
}

Problem loosened(Problem problem) {
    for (DimensionRange& range : problem.dimensions) {
        if (range.fixed()) continue;
        const double slack = 2 * problem.solver.tolerance * std::max(std::abs(range.min), std::abs(range.max));
        range.min -= slack;
        range.max += slack;
    }
    return problem;
}

template <template <class> class F>
Vector<double> target_of(std::span<const double> d, std::size_t size) {
    return {Layout<F>::oscillating && size == 0 ? d[2] : 0, 0};
}

/// That no design is small enough, whatever the tolerance lets pass, without a design to show. Nothing where that is
/// not proven. `asked` is the least size by the limits as they stand, or infinite.
template <template <class> class F>
std::optional<ClosedFormOutcome> why_none(const Problem& given, std::size_t assembly, std::size_t size, double asked) {
    const auto limits = loosened(angle_limits<F>(given), given.solver.tolerance);
    if (!limits) return std::nullopt;
    const Problem problem = loosened(given);
    const Motion motion = motion_of(problem, 0, assembly);
    const std::vector<double> d = smallest_design(problem, assembly).dimensions;
    const Vector<double> target = target_of<F>(d, size);
    const Centre centre = closest_centre<F>(problem, motion, d, *limits, target);
    const Digits50 least = certified_distance<F>(motion, d, centre, target);
    if (!(least > problem.dimensions[size].max)) return std::nullopt;
    ClosedFormOutcome outcome{.best = std::nullopt, .infeasible = true};
    HalfPlaneCertificate certificate{size, {part_of(centre, assembly)}};
    if (centre.closest.region == Region::is_empty) {
        outcome.proof = proof_by(
            fmt::format("half-planes: for every cam angle a limit on the pressure angle is a half-plane for the {}, "
                        "and {} of them exclude each other",
                        region_of(problem), centre.closest.binding_count),
            std::move(certificate));
        return outcome;
    }
    outcome.least = std::isfinite(asked) ? asked : least.convert_to<double>();
    outcome.proof =
        proof_by(argument_of(centre, problem) +
                     fmt::format("; the least {} is {:.9g}", problem.mechanism->dimensions[size].name, outcome.least),
                 std::move(certificate));
    return outcome;
}

/// Every dimension at its preferred value, or in the middle of its range.
Design middle_design(const Problem& problem, std::size_t assembly) {
    Design design;
    design.assembly = assembly;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.start.value_or(0.5 * (range.min + range.max)));
    return design;
}

/// The smallest cam of one assembly, or a proof that there is none; nothing where neither can be said.
template <template <class> class F>
std::optional<ClosedFormOutcome> solve(const Problem& problem, std::size_t assembly) {
    const std::size_t size = *size_asked<F>(problem);
    const Motion motion = motion_of(problem, 0, assembly);
    Design design = smallest_design(problem, assembly);
    std::vector<double>& d = design.dimensions;
    const Vector<double> target = target_of<F>(d, size);
    const Centre centre = closest_centre<F>(problem, motion, d, angle_limits<F>(problem), target);
    double least = std::numeric_limits<double>::infinity();
    if (centre.closest.region == Region::holds_the_point) {
        place_centre(d, follower_of<F, double>(std::span<const double>(d), assembly), centre.closest.at);
        const double bound = certified_distance<F>(motion, d, centre, target).template convert_to<double>();
        least = d[size];
        const bool proven = d[size] - bound <= 1e-12 * d[size];
        if (!Layout<F>::oscillating && d[0] < problem.dimensions[0].min)
            d[0] = problem.dimensions[0].min;  // a higher guide meets the limits too
        Solution best = assess(problem, design);
        if (best.feasible && proven)
            return ClosedFormOutcome{.best = std::move(best),
                                     .proof = proof_by(argument_of(centre, problem),
                                                       HalfPlaneCertificate{size, {part_of(centre, assembly)}})};
    }
    auto outcome = why_none<F>(problem, assembly, size, least);
    if (!outcome) return std::nullopt;
    if (centre.closest.region == Region::holds_the_point)
        d[size] = problem.dimensions[size].max;
    else
        design = middle_design(problem, assembly);
    outcome->best = assess(problem, std::move(design));
    return outcome;
}

template <template <class> class F>
std::optional<ClosedFormOutcome> solve_all(const Problem& problem) {
    return best_of_assemblies<HalfPlaneCertificate>(problem,
                                                    [&](std::size_t assembly) { return solve<F>(problem, assembly); });
}

}  // namespace

ClosedForm translating_cam_closed_form() {
    return {
        covers<TranslatingRoller>, solve_all<TranslatingRoller>,
        "cams with roller or knife-edge followers under limits on the pressure angle, of least prime radius or pivot "
        "distance"};
}

ClosedForm oscillating_cam_closed_form() { return {covers<OscillatingRoller>, solve_all<OscillatingRoller>, {}}; }

}  // namespace mechwright
