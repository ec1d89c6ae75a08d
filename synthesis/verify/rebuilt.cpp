#include "synthesis/verify/rebuilt.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/result.h"
#include "synthesis/target/path/verify.h"
#include "synthesis/verify/motion_again.h"
#include "synthesis/verify/stretch_again.h"

namespace mechwright {

namespace {

constexpr double relative = 1e-9;         // of stated values
constexpr double angular = 1e-9;          // radians, of stated angles
constexpr double rounding = 1e-14;        // of values near zero, over the size of what they are computed from
constexpr double most_rounding = 1e-9;    // of points beside an end of the motion, over the same
constexpr double point_rounding = 1e-12;  // of distances, over the size of what a point is computed from

double plain(const Digits50& value) { return value.convert_to<double>(); }

Digits50 to_radians() { return boost::math::constants::pi<Digits50>() / 180; }

/// The range of the input that is given, the range of use, or that in which all targets are met.
std::optional<Vector<Digits50>> range_of(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    if (claim.crank_range)
        return Vector<Digits50>{from_document(claim.crank_range->x, input_unit(*claim.mechanism), claim.units),
                                from_document(claim.crank_range->y, input_unit(*claim.mechanism), claim.units)};
    if (claim.use) return range_of_use_again(design);
    const auto stretch = stretch_again(claim, design.dimensions);
    return stretch ? std::optional(Vector<Digits50>{stretch->from, stretch->to}) : std::nullopt;
}

/// The direction of the link that guides the point of a target, which is here.
Digits50 direction_of_link(const Rebuilt& design, std::size_t target, const Digits50& crank_angle,
                           const Vector<Digits50>& here) {
    const Mechanism& mechanism = *design.claim->mechanism;
    const PointGuidance& point = *mechanism.point;
    const Form form = mechanism.form(design.claim->assembly, target);
    if (const auto direction = mechanism.body_of(target)->direction)
        return direction(form, point.reads.of(design.dimensions), crank_angle);
    std::vector<Digits50> ahead = design.dimensions;
    ahead[mechanism.roles_of(target).along] += 1;
    const Vector<Digits50> link = point.point(form, point.reads.of(ahead), crank_angle) - here;
    return atan2(link.y, link.x);
}

/// How far the point of a target goes where each number that it is computed from is off by a few units of the last
/// place of a double, on the side on which the mechanism still assembles.
Digits50 moved_by_rounding(const Rebuilt& design, std::size_t target, const Digits50& crank_angle,
                           const Vector<Digits50>& here) {
    constexpr double few_units = 4 * std::numeric_limits<double>::epsilon();
    const Mechanism& mechanism = *design.claim->mechanism;
    const Form form = mechanism.form(design.claim->assembly, target);
    const auto way = [&](const Vector<Digits50>& there) {
        const Vector<Digits50> off = there - here;
        const Digits50 square = dot(off, off);
        return isfinite(square) ? Digits50(sqrt(square)) : Digits50(0);
    };
    const Digits50 turned = few_units * (unit_of_input(design) + abs(crank_angle));
    Digits50 moved = std::max(way(point_again(mechanism, form, design.dimensions, crank_angle + turned)),
                              way(point_again(mechanism, form, design.dimensions, crank_angle - turned)));
    for (const std::size_t k : mechanism.point->reads) {
        Digits50 most = 0;
        for (const double side : {few_units, -few_units}) {
            std::vector<Digits50> off = design.dimensions;
            off[k] *= 1 + Digits50(side);
            most = std::max(most, way(point_again(mechanism, form, off, crank_angle)));
        }
        moved += most;
    }
    return moved;
}

RebuiltPath rebuilt_path(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    const ClaimedPath& path = *claim.path;
    RebuiltPath result;
    result.size = design.longest;
    const auto grow = [&](const Digits50& length) { result.size = std::max<Digits50>(result.size, abs(length)); };
    for (std::size_t i = 0; i < design.dimensions.size(); ++i)
        if (claim.mechanism->dimensions[i].kind == DimensionKind::coordinate) grow(design.dimensions[i]);
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Vector<Digits50> target{path.points[i].x, path.points[i].y};
        grow(target.x);
        grow(target.y);
        result.crank_angles.push_back(from_document(path.crank_angles[i], input_unit(*claim.mechanism), claim.units));
        const std::size_t guided = path.target_of(i);
        result.reached.push_back(point_again(*claim.mechanism, claim.mechanism->form(claim.assembly, guided),
                                             design.dimensions, result.crank_angles.back()));
        const Vector<Digits50> miss = target - result.reached.back();
        Digits50 square = dot(miss, miss);
        if (!path.directions.empty() && !path.guides_body_at(i)) result.directions.emplace_back(0);
        if (path.guides_body_at(i)) {
            const Digits50 faces =
                direction_of_link(design, guided, result.crank_angles.back(), result.reached.back()) +
                design.dimensions[claim.mechanism->roles_of(guided).body];
            if (path.directions[i]) {
                const Digits50 asked = from_document(*path.directions[i], Unit::angle, claim.units);
                const Digits50 chord = 2 * path.body_length_at(i) * sin((faces - asked) / 2);
                square += chord * chord;
            }
            result.directions.push_back(faces);
        }
        result.distances.push_back(sqrt(square));
    }
    return result;
}

/// Sets the motion along which a path in any order is looked at, all of it, and what rounding does beside its ends.
void look_along_curve(Rebuilt& design, const Motion& whole) {
    RebuiltPath& path = *design.path;
    path.motion = whole;
    for (std::size_t i = 0; i < path.crank_angles.size(); ++i) {
        Digits50 moved = 0;
        if (is_beside_end(design, whole, plain(path.crank_angles[i])))
            moved = moved_by_rounding(design, design.claim->path->target_of(i), path.crank_angles[i], path.reached[i]);
        // Where rounding says nothing at all of a point, nothing that is stated is taken for right.
        path.roundings.push_back(std::min(moved, Digits50(most_rounding * path.size)));
    }
}

/// A mean of distances measured again, with the slack of its square.
struct MeanAgain {
    Digits50 sum = 0, slack = 0, weight = 0, greatest = 0, rounding = 0;

    void add(const Digits50& w, const Digits50& square, const Digits50& slack_of_square, const Digits50& distance) {
        sum += w * square;
        slack += w * slack_of_square;
        weight += w;
        greatest = std::max(greatest, distance);
    }
};

/// Over the points of a target that stands alone, or of one of several, by the weights that are given.
MeanAgain mean_again(const RebuiltPath& path, const PointRange& points, const std::vector<double>& weights,
                     const Digits50& slack) {
    MeanAgain mean;
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const Digits50& d = path.distances[i];
        const Digits50 of_point = slack + path.roundings[i];
        mean.add(weights[i - points.first], d * d, (2 * d + of_point) * of_point, d);
        mean.rounding = std::max(mean.rounding, path.roundings[i]);
    }
    return mean;
}

/// Over several targets: the mean square of each with its weight.
MeanAgain mean_of_targets(const RebuiltPath& path, const std::vector<PathPart>& targets, const Digits50& slack) {
    MeanAgain mean;
    for (const PathPart& target : targets) {
        const MeanAgain one = mean_again(path, target.points, target.weights, slack);
        mean.add(target.weight, one.sum / one.weight, one.slack / one.weight, one.greatest);
        mean.rounding = std::max(mean.rounding, one.rounding);
    }
    return mean;
}

std::optional<Measured> measured_path(const RebuiltPath& path, const ClaimedPath& claimed, const Quantity& quantity) {
    const Digits50 slack = point_rounding * path.size;
    const PointRange points = claimed.points_of(quantity.of_target);
    for (std::size_t i = points.first; i < points.end(); ++i)
        if (!isfinite(path.distances[i])) return std::nullopt;
    const bool several = !claimed.parts.empty();
    const MeanAgain mean =
        several && quantity.of_target == every_target
            ? mean_of_targets(path, claimed.parts, slack)
            : mean_again(path, points, several ? claimed.parts[quantity.of_target].weights : claimed.weights, slack);
    switch (quantity.path) {
        case PathMeasure::sum_of_squares: return Measured{mean.sum, relative * mean.sum + mean.slack};
        case PathMeasure::root_mean_square: {
            const Digits50 root = mean.weight > 0 ? Digits50(sqrt(mean.sum / mean.weight)) : Digits50(0);
            return Measured{root, relative * root + slack + mean.rounding};
        }
        case PathMeasure::greatest: return Measured{mean.greatest, relative * mean.greatest + slack + mean.rounding};
        case PathMeasure::none: break;
    }
    return std::nullopt;
}

std::optional<Measured> measured(const Rebuilt& design, const Quantity& quantity) {
    if (quantity.path != PathMeasure::none) {
        if (!design.path) return std::nullopt;
        return measured_path(*design.path, *design.claim->path, quantity);
    }
    // Over a given range in which the mechanism comes apart nothing has a value.
    const Motion& motion = motion_of(design, quantity);
    const bool given = (design.claim->crank_range || design.claim->use) && !quantity.whole;
    if (!is_defined(quantity, motion) || (given && !all_passed(design.of_motion))) return std::nullopt;
    const Digits50 value = measure_again(quantity, motion, design.dimensions);
    if (!isfinite(value)) return std::nullopt;
    switch (quantity.unit) {
        case Unit::angle: return Measured{value, angular};
        case Unit::rate:
        case Unit::none: return Measured{value, relative * abs(value) + rounding};
        case Unit::force: return Measured{value, relative * abs(value) + rounding * design.strongest};
        case Unit::torque: return Measured{value, relative * abs(value) + rounding * design.strongest * design.longest};
        case Unit::length: return Measured{value, relative * abs(value) + rounding * design.added};
        case Unit::area: return Measured{value, relative * abs(value) + rounding * design.longest * design.added};
        case Unit::curvature: return Measured{value, relative * abs(value) + rounding / design.longest};
    }
    return std::nullopt;
}

}  // namespace

Rebuilt rebuilt(const Claim& claim) {
    const Mechanism& mechanism = *claim.mechanism;
    Rebuilt design{&claim, {}, {}, {}, {}, {}, 0, 0, 0, {}};
    for (std::size_t i = 0; i < claim.design.size(); ++i) {
        const DimensionKind kind = mechanism.dimensions[i].kind;
        design.dimensions.push_back(from_document(claim.design[i], unit_of(kind), claim.units));
        design.rounded.push_back(plain(design.dimensions.back()));
        // The lifts of a cam's segments are lengths of either sign.
        if (mechanism.dimensions[i].of_segment && kind == DimensionKind::coordinate)
            design.longest = std::max<Digits50>(design.longest, abs(design.dimensions.back()));
        if (kind == DimensionKind::length) design.longest = std::max(design.longest, design.dimensions.back());
    }
    if (mechanism.size) design.longest = mechanism.size(mechanism.form(0), design.rounded);
    for (std::size_t i = 0; i < claim.design.size(); ++i) {
        const DimensionKind kind = mechanism.dimensions[i].kind;
        if (kind == DimensionKind::force) design.strongest += abs(design.dimensions[i]);
        if (kind == DimensionKind::rate) design.strongest += abs(design.dimensions[i]) * design.longest;
    }
    if (claim.path && claim.path->crank_angles.size() == claim.path->points.size()) design.path = rebuilt_path(design);
    const auto over = [&](const std::optional<Vector<Digits50>>& range) {
        Motion motion = motion_again(mechanism, claim.assembly, design.dimensions, range);
        motion.settings = claim.settings;
        motion.function = claim.function.get();
        motion.followed = claim.followed ? claim.followed->shape : Followed::nothing;
        motion.asked = claim.over_input.get();
        motion.has_instant = claim.has_instant;
        motion.is_range_of_use = claim.use.has_value();
        return motion;
    };
    design.motion = over(range_of(design));
    const bool asked_whole = std::any_of(mechanism.quantities.begin(), mechanism.quantities.end(),
                                         [](const Quantity& quantity) { return quantity.whole; });
    design.whole = asked_whole ? over(std::nullopt) : design.motion;
    if (design.path)
        look_along_curve(design, claim.path->any_order && claim.crank_range ? over(std::nullopt) : design.motion);
    design.of_motion = mechanism.check_motion(design.motion, design.dimensions);
    design.added = design.longest;
    if (const int total = find_quantity(mechanism, "total-length"); total >= 0) {
        const Quantity& quantity = mechanism.quantities[static_cast<std::size_t>(total)];
        const Digits50 lengths = measure_again(quantity, design.motion, design.dimensions);
        if (isfinite(lengths)) design.added = std::max(design.added, lengths);
    }
    return design;
}

const Motion& motion_of(const Rebuilt& design, const Quantity& quantity) {
    return quantity.whole ? design.whole : design.motion;
}

Digits50 unit_of_input(const Rebuilt& design) {
    return input_unit(*design.claim->mechanism) == Unit::angle ? Digits50(1) : design.longest;
}

bool is_beside_end(const Rebuilt& design, const Motion& motion, double input) {
    const double beside = 1e-6 * plain(unit_of_input(design));
    return !motion.full_turn && input > motion.from && input < motion.to &&
           std::min(input - motion.from, motion.to - input) < beside;
}

bool turns_fully(const Rebuilt& design) {
    return motion_again(*design.claim->mechanism, design.claim->assembly, design.dimensions, std::nullopt).full_turn;
}

Measurements::Measurements(const Rebuilt& rebuilt)
    : design(&rebuilt), known(rebuilt.claim->mechanism->quantities.size()) {}

const std::optional<Measured>& Measurements::of(std::size_t quantity) {
    auto& entry = known[quantity];
    if (!entry) entry.emplace(measured(*design, design->claim->mechanism->quantities[quantity]));
    return *entry;
}

Digits50 Measurements::end_rounding(std::size_t quantity) {
    const Quantity& q = design->claim->mechanism->quantities[quantity];
    const auto& value = of(quantity);
    const Motion& motion = motion_of(*design, q);
    if (!value || motion.full_turn || q.path != PathMeasure::none) return 0;
    const double step =
        8 * std::numeric_limits<double>::epsilon() * std::max({1.0, std::abs(motion.from), std::abs(motion.to)});
    Motion inside = motion;
    inside.from += step;
    inside.to -= step;
    if (!(inside.from < inside.to)) return 0;
    const Digits50 there = measure_again(q, inside, design->dimensions);
    return isfinite(there) ? Digits50(abs(there - value->value)) : Digits50(0);
}

Digits50 from_document(double number, Unit unit, const Units& units) {
    return unit == Unit::angle && units.degrees ? number * to_radians() : Digits50(number);
}

Digits50 in_document(const Digits50& value, Unit unit, const Units& units) {
    return unit == Unit::angle && units.degrees ? Digits50(value / to_radians()) : value;
}

std::string value_text(const Digits50& value, Unit unit, const Units& units) {
    const std::string label = unit_label(unit, units);
    return fmt::format("{:.15g}{}{}", plain(in_document(value, unit, units)), label.empty() ? "" : " ", label);
}

std::string size_text(const Digits50& value) { return value == 0 ? "0" : fmt::format("{:.2g}", plain(value)); }

}  // namespace mechwright
