// What every pose of every four-bar has in common.

#include <cmath>

#include "analysis/numbers/dual.h"
#include "tests/analysis/precise.h"
#include "tests/properties/linkages.h"

namespace mechwright::test {

namespace {

constexpr double rounding = 24 * ulp;

}  // namespace

RC_GTEST_PROP(EveryPose, ClosesItsLoop, (const AnyLinkage& l)) {
    const auto& m = l.links;
    const auto p = pose(m, l.crank_angle, l.assembly);
    RC_PRE(p.assembled());
    const Vector<double> gap =
        m.crank * p.crank + m.coupler * p.coupler - m.rocker * p.rocker - Vector<double>{m.ground, 0};
    RC_ASSERT(std::hypot(gap.x, gap.y) <= 2 * ulp * sum_of(m));
}

RC_GTEST_PROP(EveryPose, HasUnitDirections, (const AnyLinkage& l, double beyond)) {
    // Also where the linkage does not assemble.
    const double angle = std::isfinite(beyond) && std::abs(beyond) < 1e6 ? l.crank_angle + beyond : l.crank_angle;
    const auto p = pose(l.links, angle, l.assembly);
    for (const auto& u : {p.crank, p.coupler, p.rocker})
        RC_ASSERT(std::abs(dot(u, u) - 1) <= rounding);
    const double sine = p.transmission_sine, cosine = p.transmission_cosine;
    RC_ASSERT(std::abs(sine * sine + cosine * cosine - 1) <= rounding);
    RC_ASSERT(sine * side_of(l.assembly) >= 0);
}

RC_GTEST_PROP(EveryPose, HasTheTransmissionAngleBetweenCouplerAndRocker, (const AnyLinkage& l)) {
    const auto p = pose(l.links, l.crank_angle, l.assembly);
    RC_ASSERT(std::abs(cross(p.coupler, p.rocker) - p.transmission_sine) <= rounding);
    RC_ASSERT(std::abs(dot(p.coupler, p.rocker) - p.transmission_cosine) <= rounding);
    const double mu = transmission_angle(l.links, half_turn(l.crank_angle));
    RC_ASSERT(std::abs(std::sin(mu) - std::abs(p.transmission_sine)) <= rounding);
    RC_ASSERT(std::abs(std::cos(mu) - p.transmission_cosine) <= rounding);
}

RC_GTEST_PROP(EveryPose, IsTheMirrorImageOfTheOtherAssemblyAboutTheDiagonal, (const AnyLinkage& l)) {
    const auto& m = l.links;
    const auto open = pose(m, l.crank_angle, Assembly::open), crossed = pose(m, l.crank_angle, Assembly::crossed);
    RC_ASSERT(open.crank.x == crossed.crank.x && open.crank.y == crossed.crank.y);
    RC_ASSERT(open.transmission_sine == -crossed.transmission_sine);
    RC_ASSERT(open.transmission_cosine == crossed.transmission_cosine);
    const Vector<double> diagonal = Vector<double>{m.ground, 0} - m.crank * open.crank;
    const double size = m.ground + m.crank;
    for (const auto& [one, other] :
         {std::array{open.coupler, crossed.coupler}, std::array{open.rocker, crossed.rocker}}) {
        RC_ASSERT(std::abs(dot(diagonal, one) - dot(diagonal, other)) <= 4 * ulp * size);
        RC_ASSERT(std::abs(cross(diagonal, one) + cross(diagonal, other)) <= 4 * ulp * size);
    }
    // The open assembly has the rocker pin to the left of the line from crank pin to rocker pivot.
    RC_ASSERT(cross(diagonal, open.coupler) >= -4 * ulp * size);
}

RC_GTEST_PROP(EveryPose, MirrorsAboutTheGroundLineWhenTheCrankTurnsBack, (const AnyLinkage& l)) {
    const Assembly other = l.assembly == Assembly::open ? Assembly::crossed : Assembly::open;
    const auto p = pose(l.links, l.crank_angle, l.assembly), q = pose(l.links, -l.crank_angle, other);
    for (const auto& [one, mirrored] :
         {std::array{p.crank, q.crank}, std::array{p.coupler, q.coupler}, std::array{p.rocker, q.rocker}}) {
        RC_ASSERT(one.x == mirrored.x);
        RC_ASSERT(one.y == -mirrored.y);
    }
    RC_PRE(p.transmission_sine != 0);
    const auto v = velocity(l.links, p), w = velocity(l.links, q);
    RC_ASSERT(v.coupler == w.coupler && v.rocker == w.rocker);
    const auto a = acceleration(l.links, p, v), b = acceleration(l.links, q, w);
    RC_ASSERT(a.coupler == -b.coupler && a.rocker == -b.rocker);
}

RC_GTEST_PROP(EveryPose, TurnsWithTheVelocitiesOfItsDerivative, (const AnyLinkage& l)) {
    using Angle = Dual<double, 1>;
    const auto p = pose(l.links, l.crank_angle, l.assembly);
    RC_PRE(std::abs(p.transmission_sine) > 1e-3);
    const auto moving = pose(converted<Angle>(l.links), Angle::variable(l.crank_angle, 0), l.assembly);
    const auto v = velocity(l.links, p);
    const auto rate = [](const Vector<Angle>& u) { return u.x.value * u.y.partial[0] - u.y.value * u.x.partial[0]; };
    // The margins are rounded to the size of the linkage: relative to them, and so relative to the velocity, that is
    // size / shorter link / sine^2. The derivative goes over the diagonal, the velocity does not.
    const double shorter = std::min(l.links.coupler, l.links.rocker);
    const double steep = sum_of(l.links) / shorter / std::pow(p.transmission_sine, 2);
    const double fast = 1 + std::abs(v.coupler) + std::abs(v.rocker) + l.links.crank / p.margins.diagonal;
    const double tolerance = 4 * ulp * steep * fast;
    RC_ASSERT(std::abs(rate(moving.crank) - 1) <= 4 * ulp);
    RC_ASSERT(std::abs(rate(moving.coupler) - v.coupler) <= tolerance);
    RC_ASSERT(std::abs(rate(moving.rocker) - v.rocker) <= tolerance);
}

// Whether a linkage assembles with its crank on the ground line, decided by the exact sum of four lengths.
RC_GTEST_PROP(EveryPose, AssemblesOnTheGroundLineExactlyWhereTheLengthsSay, (const AnyLinkage& l)) {
    FourBar<double> m = l.links;
    const auto turn = [](double x) { return std::nextafter(x, 0); };
    // A linkage with a toggle on the ground line to within rounding, one unit less, one unit more.
    const bool zero = *rc::gen::arbitrary<bool>();
    const double d = zero ? std::abs(m.ground - m.crank) : m.ground + m.crank;
    m.rocker = *rc::gen::element(d - m.coupler, m.coupler - d, m.coupler + d, m.rocker);
    RC_PRE(m.rocker > 1e-9 * (m.ground + m.crank + m.coupler));
    const HalfTurn<double> half = zero ? HalfTurn<double>{1, 0} : HalfTurn<double>{0, 1};
    for (const double rocker : {m.rocker, turn(m.rocker), std::nextafter(m.rocker, 1e300)}) {
        m.rocker = rocker;
        const Precise exact = zero ? abs(Precise(m.ground) - m.crank) : Precise(m.ground) + m.crank;
        const bool assembles = exact <= Precise(m.coupler) + m.rocker && exact >= abs(Precise(m.coupler) - m.rocker);
        RC_ASSERT(pose(m, half, l.assembly).assembled() == assembles);
    }
}

}  // namespace mechwright::test
