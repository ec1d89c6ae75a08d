#include "synthesis/verify/proofs/cam_bound.h"

#include <limits>
#include <optional>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/cam_again.h"

namespace mechwright {

namespace {

using namespace cam;

const Digits50 nothing = 0;

/// Lift, velocity and acceleration over the cam angle, by differences of the lift.
template <template <class> class F>
std::optional<again::Derivatives<Digits50>> lift_of(const MotionProgram& program, std::size_t assembly,
                                                    std::span<const Digits50> dimensions, const CamPlace& place) {
    if (place.segment >= program.segments.size()) return std::nullopt;
    const auto p = parameters_of<Digits50>(program, slots<F>, dimensions, place.segment);
    const auto segment = segment_of(program, assembly, place.segment, p);
    const std::size_t count = segment.kind == SegmentKind::dwell ? 1 : pieces(segment);
    if (place.piece >= count || !(place.u >= 0 && place.u <= 1)) return std::nullopt;
    if (segment.kind == SegmentKind::dwell) return again::Derivatives<Digits50>{p.start_lift, 0, 0};
    constexpr double same_within = 1e-12;
    if (place.u < break_before(segment, place.piece) - same_within ||
        place.u > break_before(segment, place.piece + 1) + same_within)
        return std::nullopt;
    const again::Here<Digits50> here{&segment, p.start_lift, place.piece, Digits50(place.u)};
    return again::derivatives<Digits50>([&](const Digits50& t) { return here.lift(t); });
}

/// normal . x >= level for the centre of the cam, seen as in the formulas of the two rollers.
struct Row {
    Vector<Digits50> normal;
    Digits50 level;
};

/// Of a translating roller in (offset, height of the guide): |velocity - offset| cot(limit) <= height + lift.
Row translating_row(const WeightedHalfPlane& row, const again::Derivatives<Digits50>& lift) {
    const Digits50 cot = row.side / tan(Digits50(row.limit));
    return {{cot, 1}, cot * lift.first - lift.value};
}

/// Of an oscillating roller in the position of the cam centre (x along the arm where it starts, y to the side that it
/// swings away from): with the direction of the arm, a = (cos s, -sin s), and its left, b = (sin s, cos s),
/// |arm (velocity + sense) - sense a . x| <= tan(limit) b . x.
Row oscillating_row(const WeightedHalfPlane& row, const again::Derivatives<Digits50>& lift, const Digits50& arm,
                    int sense) {
    const Digits50 tangent = tan(Digits50(row.limit)), c = cos(lift.value), s = sin(lift.value);
    const Digits50 side = row.side * sense;
    return {{side * c + tangent * s, -side * s + tangent * c}, row.side * arm * (lift.first + sense)};
}

template <template <class> class F>
std::optional<Row> row_again(const MotionProgram& program, std::size_t assembly, std::span<const Digits50> dimensions,
                             const CamLimits& limits, const WeightedHalfPlane& row) {
    constexpr std::size_t arm = 2;
    using Origin = WeightedHalfPlane::Origin;
    if (row.origin == Origin::height) return Row{{0, 1}, 0};
    if (row.origin != Origin::pressure_angle) {
        if (Layout<F>::oscillating) return std::nullopt;
        return row.origin == Origin::least_offset ? Row{{1, 0}, limits.least_offset}
                                                  : Row{{-1, 0}, -limits.greatest_offset};
    }
    const auto lift = lift_of<F>(program, assembly, dimensions, row.place);
    if (!lift || (row.side != 1 && row.side != -1)) return std::nullopt;
    return Layout<F>::oscillating ? oscillating_row(row, *lift, dimensions[arm], sense_of(assembly))
                                  : translating_row(row, *lift);
}

template <template <class> class F>
Digits50 bound_by_rows(const MotionProgram& program, std::span<const Digits50> dimensions, const CamLimits& limits,
                       std::size_t dimension, const HalfPlaneCertificate::Part& part) {
    constexpr std::size_t arm = 2;
    if (dimension > (Layout<F>::oscillating ? 1U : 0U)) return nothing;
    const Vector<Digits50> target{Layout<F>::oscillating && dimension == 0 ? dimensions[arm] : Digits50(0), 0};
    Vector<Digits50> normal{0, 0};
    Digits50 missed = 0;
    for (const WeightedHalfPlane& one : part.rows) {
        const auto row = row_again<F>(program, part.assembly, dimensions, limits, one);
        if (!row || !(one.weight >= 0)) return nothing;
        normal = normal + Digits50(one.weight) * row->normal;
        missed += one.weight * (row->level - dot(row->normal, target));
    }
    if (!(missed > 0)) return nothing;
    const Digits50 length = sqrt(dot(normal, normal));
    return length > 0 ? Digits50(missed / length) : std::numeric_limits<Digits50>::infinity();
}

/// Under a translating face the radius of curvature is the base radius and s + s'' together.
Digits50 flat_bound(const again::Derivatives<Digits50>& lift, const CamLimits& limits) {
    return limits.radius - lift.value - lift.second;
}

/// The radius of curvature at pivot distance 1 with the face in line with its pivot, from the face as a line of the
/// cam.
template <class Here>
Digits50 swinging_radius(const Here& here, int sense, const Digits50& start_angle) {
    const OscillatingFlat<Digits50> unit{sin(start_angle), Digits50(1), Digits50(0), sense};
    const auto seen = [&](const Digits50& t) {
        again::Face<Digits50> line = again::face(unit, here.lift(t));
        line.direction -= sense * t;
        return line;
    };
    const auto [p, a] =
        again::derivatives_of_two<Digits50>(seen, &again::Face<Digits50>::distance, &again::Face<Digits50>::direction);
    const Digits50 slope = p.first / a.first;
    return p.value + (p.second - slope * a.second) / (a.first * a.first);
}

}  // namespace

Digits50 cam_bound(const Mechanism& mechanism, const MotionProgram& program, std::span<const Digits50> dimensions,
                   const CamLimits& limits, std::size_t dimension, const HalfPlaneCertificate::Part& part) {
    const CamKind kind = cam_kind(mechanism);
    if (kind.follower == CamFollower::flat || kind.contour != ContourKind::none) return nothing;
    return kind.oscillating ? bound_by_rows<OscillatingRoller>(program, dimensions, limits, dimension, part)
                            : bound_by_rows<TranslatingRoller>(program, dimensions, limits, dimension, part);
}

Digits50 cam_bound(const Mechanism& mechanism, const MotionProgram& program, std::span<const Digits50> dimensions,
                   const CamLimits& limits, std::size_t dimension, const CurvatureCertificate::Part& part) {
    const CamKind kind = cam_kind(mechanism);
    if (kind.follower != CamFollower::flat || kind.contour != ContourKind::none) return nothing;
    if (!kind.oscillating) {
        const auto lift = lift_of<TranslatingFlat>(program, part.assembly, dimensions, part.place);
        return lift && dimension == 0 ? flat_bound(*lift, limits) : nothing;
    }
    if (!lift_of<OscillatingFlat>(program, part.assembly, dimensions, part.place)) return nothing;
    constexpr std::size_t face_offset = 2;
    const auto p = parameters_of<Digits50>(program, slots<OscillatingFlat>, dimensions, part.place.segment);
    const auto segment = segment_of(program, part.assembly, part.place.segment, p);
    const again::Here<Digits50> here{&segment, p.start_lift, part.place.piece, Digits50(part.place.u)};
    const Digits50 offset = dimensions[face_offset], needed = limits.radius + offset;
    const Digits50 part_of_distance = swinging_radius(here, sense_of(part.assembly), limits.start_angle);
    Digits50 distance = limits.least_distance;
    if (needed > 0 && !(part_of_distance > 0)) return std::numeric_limits<Digits50>::infinity();
    if (needed > 0) distance = std::max<Digits50>(distance, needed / part_of_distance);
    return dimension == 1 ? distance : Digits50(distance * sin(limits.start_angle) - offset);
}

}  // namespace mechwright
