#include "synthesis/verify/stretch_again.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <limits>

#include "synthesis/mechanism/cycle.h"
#include "synthesis/problem/input_tasks.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

namespace {

constexpr double angular = 1e-9;  // radians

}  // namespace

Digits50 within_period(const Digits50& angle, const Digits50& period) {
    return isfinite(period) ? Digits50(angle - period * floor(angle / period)) : angle;
}

Digits50 cycle_again(const Mechanism& mechanism) {
    if (!comes_round(mechanism)) return std::numeric_limits<Digits50>::infinity();
    return boost::math::constants::two_pi<Digits50>() * turns_of_cycle(mechanism);
}

SweptRange shortest_over(const std::vector<SweptRange>& ranges, const Digits50& period) {
    std::optional<SweptRange> shortest;
    if (!isfinite(period)) {
        shortest = ranges.front();
        for (const SweptRange& range : ranges)
            shortest = {std::min(shortest->from, range.from), std::max(shortest->to, range.to)};
        return *shortest;
    }
    for (const SweptRange& first : ranges) {
        SweptRange one = first;
        for (const SweptRange& range : ranges) {
            const Digits50 ahead = within_period(range.from - first.from, period);
            // What begins where the first does may by rounding seem to begin a turn later.
            const Digits50 begin = period - ahead < angular ? Digits50(0) : ahead;
            one.to = std::max<Digits50>(one.to, first.from + begin + (range.to - range.from));
        }
        if (!shortest || one.to - one.from < shortest->to - shortest->from - angular) shortest = one;
    }
    return *shortest;
}

std::optional<SweptRange> stretch_again(const Claim& claim, std::span<const Digits50> dimensions) {
    std::vector<SweptRange> ranges;
    const std::vector<InputTask> tasks = input_tasks(claim);
    if (tasks.empty() || (claim.path && claim.path->closed)) return std::nullopt;
    if (claim.path) {
        const ClaimedPath& path = *claim.path;
        const Unit unit = input_unit(*claim.mechanism);
        if (path.crank_angles.size() != path.points.size()) return std::nullopt;
        for (std::size_t target = 0; target < path.targets(); ++target) {
            const PointRange points = path.points_of(target);
            const auto from = path.crank_angles.begin() + static_cast<std::ptrdiff_t>(points.first);
            const auto [least, greatest] = std::minmax_element(from, from + static_cast<std::ptrdiff_t>(points.count));
            ranges.push_back({from_document(*least, unit, claim.units), from_document(*greatest, unit, claim.units)});
        }
    }
    for (const InputTask& task : tasks) {
        const Digits50 start = dimensions[task.start], end = start + dimensions[task.start + 1];
        ranges.push_back({std::min(start, end), std::max(start, end)});
    }
    return shortest_over(ranges, cycle_again(*claim.mechanism));
}

}  // namespace mechwright
