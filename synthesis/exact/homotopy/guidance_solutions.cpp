#include "synthesis/exact/homotopy/guidance_solutions.h"

#include <algorithm>
#include <cmath>

#include "analysis/numbers/low_discrepancy.h"

namespace mechwright::homotopy {

namespace {

/// With twice the digits: to go on where double has to stop, the few that are left for as long as it takes, and to be
/// sure of not changing from path to path.
constexpr TrackingOptions careful{1e-5, 1e-8, 1e-16, 1500};
constexpr TrackingOptions patient{1e-5, 1e-8, 1e-20, 30000};
constexpr TrackingOptions most_careful{1e-8, 1e-11, 1e-17, 20000};
/// A solution whose last correction in extended precision is greater than this part of it is not regular.
constexpr double regular_below = 1e-11;
/// Paths that come this near to the target belong to what lies there: a linkage of this size to one that is infinite.
constexpr double near_the_end = 1 - 1e-3;
constexpr double infinite_beyond = 1e5;
/// More paths than this without a regular end say that the target is special, and not that they need more care.
constexpr std::size_t most_in_need_of_care = 900;
/// More ends than this that are missing are not looked for by another way.
constexpr std::size_t most_missing = 150;

double size_of(const GuidanceValues& u) {
    double greatest = 0;
    for (const Complex<double>& z : u)
        greatest = std::max(greatest, norm(z));
    return std::sqrt(greatest);
}

/// Couplers without length, or whose point is a pin: whole families of these solve the equations and are no linkages.
bool is_degenerate(const GuidanceValues& u) {
    using S = GuidanceSystem;
    constexpr double least = 1e-13;  // the points lie about 1 apart
    for (const Complex<double>& z : {u[S::x], u[S::x_conjugate], u[S::y], u[S::y_conjugate], u[S::x] - u[S::y],
                                     u[S::x_conjugate] - u[S::y_conjugate]})
        if (!(norm(z) > least * least)) return true;
    return false;
}

/// Whether the conjugates are those of the numbers, to a part of their size.
bool is_real_within(double part, const GuidanceValues& u) {
    double size = 0, apart = 0;
    for (std::size_t i = 0; i < u.size(); i += 2) {
        size = std::max({size, norm(u[i]), norm(u[i + 1])});
        apart = std::max(apart, norm(u[i] - Complex<double>{u[i + 1].re, -u[i + 1].im}));
    }
    return apart <= part * part * size;
}

}  // namespace

bool refined_to_regular(const GuidanceSystem& system, GuidanceValues& u, const GuidanceParameters& target) {
    return refine(system, u, target) < regular_below && !is_degenerate(u);
}

namespace {

struct Ends {
    const StartSystem& start;
    const GuidanceParameters& target;
    int jobs;
    const RunEnd& end;
    std::vector<GuidancePath> paths;
    std::vector<bool> regular;

    void refine_end(std::size_t i) {
        constexpr double nearly_real = 1e-4;
        if (end.reached() && !is_real_within(nearly_real, paths[i].point)) return;  // no time for what is of no use
        regular[i] = paths[i].end == PathEnd::reached && refined_to_regular(start.system, paths[i].point, target);
    }

    /// With twice the digits, from where they stopped or from their beginning.
    void track_again(const std::vector<std::size_t>& which, const TrackingOptions& options, bool from_beginning) {
        std::vector<GuidancePath> starts;
        for (const std::size_t i : which) {
            const bool stopped = !from_beginning && paths[i].end == PathEnd::too_slow;
            starts.push_back(stopped ? paths[i] : beginning_at(start.solutions[i]));
        }
        const auto again = track_wide(start.system, starts, start.parameters, target, options, jobs, end);
        for (std::size_t k = 0; k < which.size(); ++k) {
            paths[which[k]] = again[k];
            refine_end(which[k]);
        }
    }

    std::vector<std::size_t> not_regular() const {
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < paths.size(); ++i)
            if (!regular[i]) which.push_back(i);
        return which;
    }

    /// Paths that end at the same place as others.
    std::vector<std::size_t> meeting() const {
        SeenOrbits seen;
        std::vector<bool> meets(paths.size(), false);
        for (std::size_t i = 0; i < paths.size(); ++i) {
            if (!regular[i]) continue;
            if (const auto other = seen.find_or_keep(orbit_of(start.system, paths[i].point), i))
                meets[i] = meets[*other] = true;
        }
        std::vector<std::size_t> which;
        for (std::size_t i = 0; i < paths.size(); ++i)
            if (meets[i]) which.push_back(i);
        return which;
    }
};

/// Parameters that have nothing to do with those of any start or target.
GuidanceParameters detour(const GuidanceParameters& start) {
    GuidanceParameters p{};
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (norm(start[i]) == 0) continue;  // the system does not have it
        const auto part = [i](std::uint64_t k) {
            return std::ldexp(static_cast<double>(mixed(2 * i + k) >> 11), -53) - 0.5;
        };
        p[i] = {2 * part(0), 2 * part(1)};
    }
    return p;
}

/// Regular ends of all solutions by way of other parameters: those that are not known yet are added, and are no longer
/// missing.
void add_by_another_way(const StartSystem& start, const GuidanceParameters& target, int jobs, const RunEnd& end,
                        GuidanceSolutions& found) {
    const GuidanceParameters between = detour(start.parameters);
    std::vector<GuidanceValues> middle;
    for (const GuidancePath& path : track(start.system, start.solutions, start.parameters, between, {}, jobs, end))
        if (path.end == PathEnd::reached) middle.push_back(path.point);
    SeenOrbits seen;
    for (std::size_t i = 0; i < found.solutions.size(); ++i)
        seen.find_or_keep(orbit_of(start.system, found.solutions[i]), i);
    for (const GuidancePath& path : track(start.system, middle, between, target, {}, jobs, end)) {
        GuidanceValues solution = path.point;
        if (path.end != PathEnd::reached || !refined_to_regular(start.system, solution, target)) continue;
        if (seen.find_or_keep(orbit_of(start.system, solution), found.solutions.size())) continue;
        found.solutions.push_back(solution);
        for (std::size_t* missing : {&found.lost, &found.singular, &found.at_infinity})
            if (*missing > 0) {
                --*missing;
                break;
            }
    }
}

}  // namespace

GuidanceSolutions solve_guidance(const StartSystem& start, const GuidanceParameters& target, int jobs,
                                 const RunEnd& end) {
    Ends ends{start, target, jobs, end, track(start.system, start.solutions, start.parameters, target, {}, jobs, end),
              {}};
    ends.regular.resize(ends.paths.size());
    for (std::size_t i = 0; i < ends.paths.size(); ++i)
        ends.refine_end(i);
    const bool whole = !end.reached();
    if (const auto which = ends.not_regular(); whole && which.size() <= most_in_need_of_care)
        ends.track_again(which, careful, false);
    if (const auto which = ends.not_regular(); whole && which.size() <= most_missing)
        ends.track_again(which, patient, false);
    if (const auto which = ends.meeting(); whole && which.size() <= most_missing)
        ends.track_again(which, most_careful, true);

    GuidanceSolutions found;
    found.tracked = ends.paths.size();
    SeenOrbits seen;
    for (std::size_t i = 0; i < ends.paths.size(); ++i) {
        const GuidancePath& path = ends.paths[i];
        const bool at_the_end = path.reached >= near_the_end;
        if (ends.regular[i] && !seen.find_or_keep(orbit_of(start.system, path.point), i))
            found.solutions.push_back(path.point);
        else if (path.end == PathEnd::diverged || (at_the_end && !(size_of(path.point) < infinite_beyond)))
            ++found.at_infinity;
        else
            ++(at_the_end && !ends.regular[i] ? found.singular : found.lost);
    }
    const std::size_t missing = found.tracked - found.solutions.size();
    if (missing > 0 && missing <= most_missing && !end.reached()) add_by_another_way(start, target, jobs, end, found);
    return found;
}

GuidanceTarget guidance_target(const std::vector<GuidedPlace>& places, SecondDyad second) {
    GuidanceTarget target;
    target.system.second = second;
    const auto is_pose = [](const GuidedPlace& place) { return place.direction.has_value(); };
    const auto first = std::find_if(places.begin(), places.end(), is_pose);
    // With points alone the first of them is as good as a pose.
    const std::size_t reference = first == places.end() ? 0 : static_cast<std::size_t>(first - places.begin());
    target.origin = places[reference].point;
    double sum = 0;
    for (const GuidedPlace& place : places)
        sum += norm(place.point - target.origin);
    // A power of two: scaling costs no digits.
    if (sum > 0) target.size = std::exp2(std::round(0.5 * std::log2(sum / static_cast<double>(places.size() - 1))));
    target.places.resize(places.size());
    std::size_t next = 0;
    const auto take = [&](std::size_t i) {
        const Complex<double> d = (1 / target.size) * (places[i].point - target.origin);
        target.places[i] = next;
        target.parameters[next] = d;
        target.parameters[GuidanceSystem::first_conjugate + next] = {d.re, -d.im};
        return next++;
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (i == reference || !is_pose(places[i])) continue;
        const double turned = *places[i].direction - *places[reference].direction;
        target.parameters[GuidanceSystem::first_turn + take(i)] = {std::cos(turned), std::sin(turned)};
        ++target.system.poses;
    }
    for (std::size_t i = 0; i < places.size(); ++i)
        if (i != reference && !is_pose(places[i])) take(i);
    return target;
}

GuidanceSystem::Parameters<Digits50> exact_parameters(const GuidanceTarget& target,
                                                      const std::vector<GuidedPlace>& places) {
    using S = GuidanceSystem;
    const auto reference = std::find(target.places.begin(), target.places.end(), std::nullopt) - target.places.begin();
    const GuidedPlace& first = places[static_cast<std::size_t>(reference)];
    S::Parameters<Digits50> exact{};
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (!target.places[i]) continue;
        const std::size_t k = *target.places[i];
        const Digits50 x = (Digits50(places[i].point.re) - first.point.re) / target.size;
        const Digits50 y = (Digits50(places[i].point.im) - first.point.im) / target.size;
        exact[k] = {x, y};
        exact[S::first_conjugate + k] = {x, -y};
        if (k + 1 >= target.system.poses) continue;
        const Digits50 turned = Digits50(*places[i].direction) - *first.direction;
        exact[S::first_turn + k] = {cos(turned), sin(turned)};
    }
    return exact;
}

bool is_real(const GuidanceValues& u) { return is_real_within(1e-9, u); }

}  // namespace mechwright::homotopy
