// Coupler curves: cognates draw the same one, and points move along them with the velocity of their position.

#include <cmath>

#include "analysis/numbers/dual.h"
#include "tests/properties/linkages.h"

namespace mechwright::test {

namespace {

Vector<double> drawn(const PathLinkage<double>& l, double crank_angle) {
    return placed(position(l.links, l.point, pose(l.links, crank_angle, l.assembly)), l.placement);
}

double distance(const Vector<double>& a, const Vector<double>& b) { return std::hypot(a.x - b.x, a.y - b.y); }

}  // namespace

RC_GTEST_PROP(CouplerCurves, AreSharedByCognates, (const AnyLinkage& l)) {
    const auto& m = l.links;
    const CouplerPoint<double> point{between(-1, 2) * m.coupler, between(-1, 2) * m.coupler};
    const double spread = std::hypot(point.along, point.across) / m.coupler;
    const double rest = std::hypot(m.coupler - point.along, point.across) / m.coupler;
    RC_PRE(spread > 1e-3 && rest > 1e-3);
    const double size = sum_of(m);
    const PathLinkage<double> original{
        m, point, {{size * between(-1, 1), size * between(-1, 1)}, between(-4, 4)}, l.assembly};
    const auto p = pose(m, l.crank_angle, l.assembly);
    const double toggle = std::abs(p.transmission_sine);
    RC_PRE(toggle > 1e-6);
    const auto target = drawn(original, l.crank_angle);
    const auto [first, second] = cognates(original);
    // Rounding of the lengths, to the size of the linkage, turns short links by its ratio to them; a toggle enlarges
    // it.
    const double short_links = 1 + size / std::min(m.coupler, m.rocker);
    const double tolerance = 16 * ulp * size * (1 + spread + rest) * short_links / toggle;
    RC_ASSERT(distance(drawn(second, l.crank_angle), target) <= tolerance);

    // The crank of the first turns as the original coupler; which of its assemblies is at work changes as that swings.
    const double turned_by = std::atan2(p.coupler.y, p.coupler.x);
    auto other = first;
    other.assembly = first.assembly == Assembly::open ? Assembly::crossed : Assembly::open;
    const double its_toggle = std::max(std::abs(pose(first.links, turned_by, first.assembly).transmission_sine), 1e-8);
    const double its_short_links = 1 + size / std::min(m.crank, m.rocker);
    RC_ASSERT(std::min(distance(drawn(first, turned_by), target), distance(drawn(other, turned_by), target)) <=
              tolerance * its_short_links / its_toggle);
}

RC_GTEST_PROP(CouplerCurves, AreRunThroughWithTheVelocityOfTheirPosition, (const AnyLinkage& l)) {
    using Angle = Dual<double, 1>;
    const auto& m = l.links;
    const CouplerPoint<double> point{between(-1, 2) * m.coupler, between(-1, 2) * m.coupler};
    const auto p = pose(m, l.crank_angle, l.assembly);
    RC_PRE(std::abs(p.transmission_sine) > 1e-3);
    const auto moving = position(converted<Angle>(m), CouplerPoint<Angle>{Angle(point.along), Angle(point.across)},
                                 pose(converted<Angle>(m), Angle::variable(l.crank_angle, 0), l.assembly));
    const auto v = velocity(m, p);
    const auto runs = velocity(m, point, p, v);
    const double steep = sum_of(m) / std::min(m.coupler, m.rocker) / std::pow(p.transmission_sine, 2);
    const double fast = 1 + std::abs(v.coupler) + std::abs(v.rocker) + m.crank / p.margins.diagonal;
    const double tolerance = 8 * ulp * steep * fast * (m.crank + m.coupler);
    RC_ASSERT(std::abs(moving.x.partial[0] - runs.x) <= tolerance);
    RC_ASSERT(std::abs(moving.y.partial[0] - runs.y) <= tolerance);
}

RC_GTEST_PROP(CouplerCurves, KeepTheirDigitsFarFromTheOrigin, (const AnyLinkage& l)) {
    // A drawing at an offset of 2^20 sizes, and a target whose distance from the pivot is exact.
    const auto& m = l.links;
    const double far = std::exp2(std::round(std::log2(sum_of(m))) + 20);
    const CouplerPoint<double> point{between(-1, 2) * m.coupler, between(-1, 2) * m.coupler};
    const auto local = position(m, point, pose(m, l.crank_angle, l.assembly));
    const Vector<double> near_target{far * 0x1p-20, -far * 0x1p-21};
    const Placement<double> home{{0, 0}, 0.75}, away{{far, -3 * far}, 0.75};
    const auto here = miss(local, home, near_target);
    const auto there = miss(local, away, away.origin + near_target);
    RC_ASSERT(here.x == there.x && here.y == there.y);
    const auto back = tilted(near_target - here, -0.75);
    RC_ASSERT(distance(back, local) <= 8 * ulp * far * 0x1p-20);
}

}  // namespace mechwright::test
