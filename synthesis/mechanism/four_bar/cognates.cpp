#include "synthesis/mechanism/four_bar/cognates.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace mechwright::four_bar {

namespace {

using Linkage = PathLinkage<double>;

Linkage linkage_of(std::span<const double> d) {
    return {{d[0], d[1], d[2], d[3]}, {d[4], d[5]}, {{d[6], d[7]}, d[8]}, Assembly::open};
}

double longest_of(const Linkage& m) {
    return std::max({m.links.ground, m.links.crank, m.links.coupler, m.links.rocker});
}

bool alike(const Linkage& a, const Linkage& b) {
    constexpr double within = 1e-5;
    const double size = std::max(longest_of(a), longest_of(b));
    const std::array<double, 8> apart{a.links.ground - b.links.ground,
                                      a.links.crank - b.links.crank,
                                      a.links.coupler - b.links.coupler,
                                      a.links.rocker - b.links.rocker,
                                      a.point.along - b.point.along,
                                      a.point.across - b.point.across,
                                      a.placement.origin.x - b.placement.origin.x,
                                      a.placement.origin.y - b.placement.origin.y};
    return std::all_of(apart.begin(), apart.end(), [&](double d) { return std::abs(d) <= within * size; }) &&
           std::abs(std::sin(0.5 * (a.placement.tilt - b.placement.tilt))) <= within;
}

}  // namespace

Linkage from_other_pivot(const Linkage& m) {
    const auto& [x, y] = m.placement.origin;
    const Vector<double> other{x + m.links.ground * std::cos(m.placement.tilt),
                               y + m.links.ground * std::sin(m.placement.tilt)};
    return {{m.links.ground, m.links.rocker, m.links.coupler, m.links.crank},
            {m.links.coupler - m.point.along, -m.point.across},
            {other, m.placement.tilt + std::acos(-1.0)},
            m.assembly};
}

bool are_cognates(std::span<const double> a, std::span<const double> b) {
    const Linkage first = linkage_of(a), second = linkage_of(b);
    if (alike(first, second)) return false;
    const auto [one, other] = cognates(first);
    for (const Linkage& m : {one, other})
        if (alike(m, second) || alike(from_other_pivot(m), second)) return true;
    return alike(from_other_pivot(first), second);
}

}  // namespace mechwright::four_bar
