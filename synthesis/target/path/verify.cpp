#include "synthesis/target/path/verify.h"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/golden_section.h"
#include "synthesis/mechanism/cycle.h"
#include "synthesis/verify/stretch_again.h"

namespace mechwright {

namespace {

constexpr double angular = 1e-9;      // radians, of stated crank angles and over the size of stated displacements
constexpr double least_step = 1e-12;  // the same, from point to point

double plain(const Digits50& value) { return value.convert_to<double>(); }

/// "point 3", of several targets "point 3 of 'foot'".
std::string nth(const ClaimedPath& path, std::size_t index) {
    if (path.parts.empty()) return fmt::format("point {}", index + 1);
    const PathPart& part = path.parts[path.target_of(index)];
    return fmt::format("point {} of '{}'", index - part.points.first + 1, part.name);
}

const Digits50& full_turn() { return boost::math::constants::two_pi<Digits50>(); }

Digits50 within_turn(const Digits50& angle) { return within_period(angle, full_turn()); }

/// The turns of the crank after which everything is where it was; infinite where a slide drives.
Digits50 cycle(const Rebuilt& design) { return cycle_again(*design.claim->mechanism); }

/// An input of the document as it counts inside, and in words with its unit.
Digits50 input_of(const Rebuilt& design, double stated) {
    return from_document(stated, input_unit(*design.claim->mechanism), design.claim->units);
}
std::string input_text(const Rebuilt& design, const Digits50& input) {
    return value_text(input, input_unit(*design.claim->mechanism), design.claim->units);
}
std::string inputs_word(const Rebuilt& design) { return std::string(input_word(*design.claim->mechanism)) + "s"; }

/// The error of each point against a limit; passes if every error is finite and within it.
template <class Error>
Check check_each(std::string name, const ClaimedPath& path, const Digits50& limit, const Error& error) {
    Digits50 worst = -1;
    std::size_t at = 0;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Digits50 e = error(i);
        if (!isfinite(e)) return {std::move(name), false, "the mechanism does not assemble at " + nth(path, i)};
        if (e <= worst) continue;
        worst = e;
        at = i;
    }
    return {std::move(name), worst <= limit,
            fmt::format("the greatest difference is {} at {}, allowed is {}", size_text(worst), nth(path, at),
                        size_text(limit))};
}

/// The distance between stated and real place of each point.
Check check_reached(const ClaimedPath& path, const RebuiltPath& rebuilt) {
    return check_each("reaches the points that are stated", path, angular * rebuilt.size,
                      [&](std::size_t i) -> Digits50 {
                          const Vector<Digits50> stated{path.reached[i].x, path.reached[i].y};
                          const Vector<Digits50> away = stated - rebuilt.reached[i];
                          return sqrt(dot(away, away));
                      });
}

/// The difference between stated and real direction of a guided body at each point.
Check check_faced(const ClaimedPath& path, const RebuiltPath& rebuilt, const Units& units) {
    return check_each("faces in the directions that are stated", path, angular, [&](std::size_t i) -> Digits50 {
        if (!path.guides_body_at(i)) return 0;
        const Digits50 stated = from_document(path.reached_directions[i], Unit::angle, units);
        const Digits50 off = within_turn(stated - rebuilt.directions[i]);
        return std::min(off, Digits50(full_turn() - off));
    });
}

/// Distances to a relative 1e-9, and to 1e-12 of the size of the drawing where they vanish; next to a limit to what the
/// rounding of doubles makes of them.
Check check_distances(const ClaimedPath& path, const RebuiltPath& rebuilt) {
    Check check{"distances from the target are as stated", true, {}};
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const Digits50& distance = rebuilt.distances[i];
        const Digits50 difference = abs(distance - path.distances[i]);
        if (difference <= 1e-9 * distance + 1e-12 * rebuilt.size + rebuilt.roundings[i]) continue;
        check.passed = false;
        check.detail = isfinite(distance) ? fmt::format("{} is {:.15g} away, stated is {:.15g}", nth(path, i),
                                                        distance.convert_to<double>(), path.distances[i])
                                          : "the mechanism does not assemble at " + nth(path, i);
        return check;
    }
    check.detail = fmt::format("all {} measured again", path.points.size());
    return check;
}

Check check_prescribed(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    const auto start = [&](std::size_t i) -> const Digits50& {
        return design.dimensions[claim.mechanism->roles_of(claim.path->target_of(i)).start];
    };
    return check_each("meets the points at the prescribed " + inputs_word(design), *claim.path,
                      angular * unit_of_input(design), [&](std::size_t i) -> Digits50 {
                          const Digits50 due = start(i) + input_of(design, claim.path->prescribed_angles[i]);
                          const Digits50 off = within_period(design.path->crank_angles[i] - due, cycle(design));
                          return std::min<Digits50>(abs(off), cycle(design) - off);
                      });
}

/// The crank angles that are swept if the points of a target are met in order in a direction; nothing if they cannot
/// be: an angle is met twice, or the crank needs more than a cycle (exactly one is allowed where the last point is the
/// first again).
std::optional<SweptRange> swept_in_order(const Rebuilt& design, const PointRange& points, int direction) {
    const std::vector<Vector<double>>& asked = design.claim->path->points;
    const Vector<double>&first = asked[points.first], &last = asked[points.end() - 1];
    const bool ends_meet = points.count > 2 && first.x == last.x && first.y == last.y;
    const std::vector<Digits50>& angles = design.path->crank_angles;
    const Digits50 whole = cycle(design);
    Digits50 swept = 0;
    for (std::size_t i = points.first + 1; i < points.end(); ++i) {
        const Digits50 step = within_period(direction * (angles[i] - angles[i - 1]), whole);
        if (step < least_step * unit_of_input(design)) return std::nullopt;
        swept += step;
    }
    if (swept > whole + (ends_meet ? angular : -least_step)) return std::nullopt;
    const Digits50& begin = angles[points.first];
    return direction > 0 ? SweptRange{begin, begin + swept} : SweptRange{begin - swept, begin};
}

/// From the least to the greatest angle of some points.
SweptRange range_of(const std::vector<Digits50>& angles, const PointRange& points) {
    const auto from = angles.begin() + static_cast<std::ptrdiff_t>(points.first);
    const auto [least, greatest] = std::minmax_element(from, from + static_cast<std::ptrdiff_t>(points.count));
    return {*least, *greatest};
}

/// The sweeps by which the crank can meet the points of all targets: those of each by itself, in one direction.
std::vector<SweptRange> sweeps(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    const ClaimedPath& path = *claim.path;
    std::vector<SweptRange> ranges;
    if (path.prescribed_timing) {
        std::vector<Digits50> due;
        for (std::size_t i = 0; i < path.points.size(); ++i)
            due.push_back(design.dimensions[claim.mechanism->roles_of(path.target_of(i)).start] +
                          input_of(design, path.prescribed_angles[i]));
        for (std::size_t target = 0; target < path.targets(); ++target)
            ranges.push_back(range_of(due, path.points_of(target)));
        return {shortest_over(ranges, cycle(design))};
    }
    if (path.any_order) {
        if (design.motion.full_turn) return {{0, cycle(design)}};
        return {range_of(design.path->crank_angles, path.points_of(every_target))};
    }
    std::vector<SweptRange> possible;
    for (const int direction : {1, -1}) {
        ranges.clear();
        for (std::size_t target = 0; target < path.targets(); ++target)
            if (const auto range = swept_in_order(design, path.points_of(target), direction)) ranges.push_back(*range);
        if (ranges.size() == path.targets()) possible.push_back(shortest_over(ranges, cycle(design)));
    }
    return possible;
}

/// From the least to the greatest crank angle of the targets in the shortest stretch with all of them.
SweptRange stretch_between(const Rebuilt& design) {
    const ClaimedPath& path = *design.claim->path;
    std::vector<SweptRange> ranges;
    for (std::size_t target = 0; target < path.targets(); ++target)
        ranges.push_back(range_of(design.path->crank_angles, path.points_of(target)));
    return shortest_over(ranges, cycle(design));
}

/// Whether the targets are met as crank angles fall.
bool met_clockwise(const Rebuilt& design) {
    const ClaimedPath& path = *design.claim->path;
    const std::vector<Digits50>& angles = design.path->crank_angles;
    for (std::size_t target = 0; target < path.targets(); ++target)
        if (const PointRange points = path.points_of(target); points.count > 1)
            return angles[points.end() - 1] < angles[points.first];
    return false;
}

std::string range_text(const Rebuilt& design, const SweptRange& range) {
    return fmt::format("{} {} to {}", inputs_word(design), input_text(design, range.from),
                       input_text(design, range.to));
}

/// The curve of the guided point over the motion: evenly spaced samples in double, of which those are left out that the
/// rounding of the ends of a limited motion puts out of reach.
struct SampledCurve {
    std::size_t target = 0;  ///< of which it is the curve
    std::vector<double> crank_angles{};
    std::vector<Vector<double>> points{};
};

Vector<double> curve_point(const Rebuilt& design, std::size_t target, double crank_angle) {
    const Claim& claim = *design.claim;
    const Vector<Digits50> p = point_again(*claim.mechanism, claim.mechanism->form(claim.assembly, target),
                                           design.dimensions, Digits50(crank_angle));
    return {plain(p.x), plain(p.y)};
}

double distance_between(const Vector<double>& a, const Vector<double>& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The motion over which the curve along a target is looked at: a point that is met beside an end may count by more
/// than it is away from the end itself, and the curve is looked at up to where it is met.
Motion motion_of_curve(const Rebuilt& design, std::size_t target) {
    Motion motion = design.path->motion;
    const PointRange points = design.claim->path->points_of(target);
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const double at = plain(design.path->crank_angles[i]);
        if (!is_beside_end(design, design.path->motion, at)) continue;
        if (at - design.path->motion.from < design.path->motion.to - at)
            motion.from = std::max(motion.from, at);
        else
            motion.to = std::min(motion.to, at);
    }
    return motion;
}

/// A full turn is sampled from a step before it to a step after it, so that every place of it has neighbours.
SampledCurve sampled_curve(const Rebuilt& design, std::size_t target) {
    constexpr int steps = 720, doublings = 40;
    constexpr double rounding = 1e-14;  // of a step
    const Motion motion = motion_of_curve(design, target);
    const double step = (motion.full_turn ? plain(cycle(design)) : motion.to - motion.from) / steps;
    const int beyond = motion.full_turn ? 1 : 0;
    SampledCurve curve{target};
    for (int i = -beyond; i <= steps + beyond; ++i) {
        double angle = (motion.full_turn ? 0 : motion.from) + i * step;
        Vector<double> p = curve_point(design, target, angle);
        // At an end of the motion its rounding may be too much: there the curve begins a little inside.
        double inwards = i == 0 ? rounding * step : i == steps ? -rounding * step : 0;
        for (int k = 0; k < doublings && inwards != 0 && !std::isfinite(p.x); ++k, inwards *= 2) {
            angle += inwards;
            p = curve_point(design, target, angle);
        }
        if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
        curve.crank_angles.push_back(angle);
        curve.points.push_back(p);
    }
    return curve;
}

/// The least distance from a target around the k-th sample of the curve, by golden sections between its neighbours, to
/// half the digits of a double: a least value is flat.
double refined_distance(const Rebuilt& design, const SampledCurve& curve, std::size_t k, const Vector<double>& target) {
    const auto away = [&](double angle) { return distance_between(curve_point(design, curve.target, angle), target); };
    const double left = curve.crank_angles[k - std::min<std::size_t>(k, 1)];
    const double right = curve.crank_angles[std::min(k + 1, curve.points.size() - 1)];
    constexpr int steps = 40;  // the steps of a curve are below 0.01 rad, to 1e-10 rad
    return away(greatest_between([&](double angle) { return -away(angle); }, left, right, steps));
}

/// The least distance of the curve from a target: every sample is refined that is nearer than its neighbours and could
/// hide, between them, a place nearer than what is stated.
double least_distance(const Rebuilt& design, const SampledCurve& curve, const Vector<double>& target, double stated) {
    const auto& points = curve.points;
    const auto away = [&](std::size_t k) { return distance_between(points[k], target); };
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::size_t before = k - std::min<std::size_t>(k, 1), after = std::min(k + 1, points.size() - 1);
        least = std::min(least, away(k));
        if (away(k) > away(before) || away(k) > away(after)) continue;
        const double reach = distance_between(points[before], points[k]) + distance_between(points[k], points[after]);
        if (away(k) - 2 * reach < stated) least = std::min(least, refined_distance(design, curve, k, target));
    }
    return least;
}

/// No place of the curve that is guided along a target is nearer to a point of it than is stated.
Check check_nearest(const Rebuilt& design) {
    const ClaimedPath& path = *design.claim->path;
    Check check{"every point counts by the nearest point of the curve", true, {}};
    for (std::size_t target = 0; target < path.targets() && check.passed; ++target) {
        const SampledCurve curve = sampled_curve(design, target);
        if (curve.points.empty()) return {check.name, false, "the mechanism assembles nowhere"};
        check.detail = fmt::format("no place between {} points of the curve is closer", curve.points.size());
        const PointRange points = path.points_of(target);
        for (std::size_t i = points.first; i < points.end(); ++i) {
            const double stated = plain(design.path->distances[i]);
            const double least = least_distance(design, curve, path.points[i], stated);
            if (stated <= least + angular * plain(design.path->size)) continue;
            check.passed = false;
            check.detail =
                fmt::format("{} is {:.15g} away, a point of the curve only {:.15g}", nth(path, i), stated, least);
            break;
        }
    }
    return check;
}

Check check_closed(const Rebuilt& design) {
    const bool passed = turns_fully(design);
    return {"the crank goes round the closed path", passed, passed ? "it turns fully" : "it does not turn fully"};
}

Check check_order(const Rebuilt& design, const std::vector<SweptRange>& possible) {
    const bool passed = !possible.empty();
    const Mechanism& mechanism = *design.claim->mechanism;
    const std::string within = comes_round(mechanism) ? " within " + cycle_words(mechanism) : "";
    return {"meets the points in order" + (within.empty() ? " along the stroke" : within + " of the crank"), passed,
            passed ? range_text(design, possible.front())
                   : "the " + inputs_word(design) + " neither rise nor fall from point to point" + within};
}

/// One of the sweeps must lie on one branch in one assembled range.
Check check_sweep(const Rebuilt& design, const std::vector<SweptRange>& possible) {
    Check check{"stays assembled on one branch along the path", false, "the points are not met in order"};
    for (const SweptRange& range : possible) {
        Motion motion = design.motion;
        motion.full_turn = false;
        motion.from = range.from.convert_to<double>();
        motion.to = range.to.convert_to<double>();
        const auto checks = design.claim->mechanism->check_motion(motion, design.dimensions);
        const auto failed = std::find_if(checks.begin(), checks.end(), [](const Check& c) { return !c.passed; });
        check.passed = failed == checks.end();
        check.detail = range_text(design, range);
        if (check.passed) break;
        check.detail += ": " + failed->detail;
    }
    return check;
}

}  // namespace

std::optional<Vector<Digits50>> range_of_use_again(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    if (!design.path) return Vector<Digits50>{1, 0};
    const SweptRange between = stretch_between(design);
    Digits50 before = input_of(design, claim.use->before);
    Digits50 after = input_of(design, claim.use->after);
    if (met_clockwise(design)) std::swap(before, after);
    return Vector<Digits50>{between.from - before, between.to + after};
}

Check check_range_of_use(const Rebuilt& design, Stated parts) {
    const Claim& claim = *design.claim;
    Check check{"the range of use is as stated", false, "it is not said at which crank angles they are"};
    if (!design.path) return check;
    const Vector<Digits50> used = *range_of_use_again(design);
    check.detail = range_text(design, {used.x, used.y});
    if (parts != Stated::everything) return check.passed = true, check;
    if (!claim.used_angles) return check.detail += ", which is not stated", check;
    const Digits50 off = std::max<Digits50>(abs(input_of(design, claim.used_angles->x) - used.x),
                                            abs(input_of(design, claim.used_angles->y) - used.y));
    check.passed = off <= angular * unit_of_input(design);
    if (!check.passed) check.detail += fmt::format(", stated are {} to {}", claim.used_angles->x, claim.used_angles->y);
    return check;
}

std::vector<Check> check_path(const Rebuilt& design, Stated parts) {
    const ClaimedPath& path = *design.claim->path;
    const std::size_t count = path.points.size();
    const bool reached = path.reached.size() == count && path.reached_directions.size() == path.directions.size();
    if (!design.path || path.distances.size() != count || (parts == Stated::everything && !reached))
        return {{"says for every point of the path where it is met", false,
                 fmt::format("{} points have {} crank angles, {} reached points and {} distances", count,
                             path.crank_angles.size(), path.reached.size(), path.distances.size())}};
    std::vector<Check> checks;
    if (parts == Stated::everything) checks.push_back(check_reached(path, *design.path));
    checks.push_back(check_distances(path, *design.path));
    if (parts == Stated::everything && !path.directions.empty())
        checks.push_back(check_faced(path, *design.path, design.claim->units));
    const auto possible = sweeps(design);
    checks.push_back(path.prescribed_timing ? check_prescribed(design)
                     : path.any_order       ? check_nearest(design)
                                            : check_order(design, possible));
    if (path.closed) checks.push_back(check_closed(design));
    checks.push_back(check_sweep(design, possible));
    return checks;
}

}  // namespace mechwright
