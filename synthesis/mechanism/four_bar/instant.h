#pragma once
/// \file
/// Velocities and accelerations of a four-bar at one crank angle, crank-start, for unit angular velocity of the crank.

#include "analysis/four_bar.h"
#include "synthesis/mechanism/four_bar/formulas.h"
#include "synthesis/mechanism/four_bar/linkage_again.h"

namespace mechwright::four_bar {

enum class OfLink { coupler, rocker };
enum class Rate { velocity, acceleration };

/// Angular velocity of a link over that of the crank, or its change with the crank angle. Arguments: the links and the
/// crank angle.
template <OfLink link, Rate rate>
struct InstantRate {
    static constexpr std::size_t reads = links + 1;
    static constexpr std::size_t most = 1;
    template <class T>
    static std::size_t components(const Motion& motion, const std::array<T, reads>& x, Components<T> out) {
        const FourBar<T> m{x[0], x[1], x[2], x[3]};
        const auto p = pose(m, x[links], assembly_of(motion));
        const auto v = velocity(m, p);
        if constexpr (rate == Rate::velocity) {
            out[0] = link == OfLink::coupler ? v.coupler : v.rocker;
        } else {
            const auto a = acceleration(m, p, v);
            out[0] = link == OfLink::coupler ? a.coupler : a.rocker;
        }
        return p.assembled() ? 1 : (out[0] = T(std::numeric_limits<double>::quiet_NaN()), 1);
    }
};

/// The same in fifty digits: velocities from the loop rebuilt by circle intersection (linkage_again.h), accelerations
/// by differences of these.
template <OfLink link, Rate rate>
Digits50 instant_rate_again(const Motion& motion, std::span<const Digits50> arguments) {
    const auto m = again::linkage(motion.assembly, arguments);
    const auto ratio = [&](const Digits50& crank_angle) {
        const auto p = again::pose(m, crank_angle);
        if (!p.assembled()) return std::numeric_limits<Digits50>::quiet_NaN();
        const Vector<Digits50>& other = link == OfLink::coupler ? p.rocker : p.coupler;
        return Digits50(m.crank * cross(other, p.crank) / cross(p.coupler, p.rocker));
    };
    const Digits50& at = arguments[links];
    if constexpr (rate == Rate::velocity) return ratio(at);
    // Of fifty digits the difference keeps forty, and is wrong by its square.
    const Digits50 step = 1e-10;
    return (ratio(at + step) - ratio(at - step)) / (2 * step);
}

template <OfLink link, Rate rate>
Quantity instant_quantity(const char* name, const char* meaning) {
    using Formula = InstantRate<link, rate>;
    return {.name = name,
            .unit = Unit::none,
            .meaning = meaning,
            .reads = links,
            .defined = [](const Motion& motion) { return motion.has_instant; },
            .components = [](const Motion&) { return Formula::most; },
            .measure = measure_by<Formula>,
            .measure_again = instant_rate_again<link, rate>,
            .section = "instant"};
}

}  // namespace mechwright::four_bar
