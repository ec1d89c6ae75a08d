// Nothing depends on the unit of length: multiplying every length by a power of two changes no digit.

#include <cmath>

#include "tests/properties/linkages.h"

namespace mechwright::test {

namespace {

FourBar<double> scaled(const FourBar<double>& m, double k) {
    return {k * m.ground, k * m.crank, k * m.coupler, k * m.rocker};
}

bool same(const Vector<double>& a, const Vector<double>& b) { return a.x == b.x && a.y == b.y; }

/// Equal, or both not numbers (velocities at a toggle).
bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

double power_of_two() { return std::ldexp(1.0, *rc::gen::inRange(-40, 41)); }

}  // namespace

RC_GTEST_PROP(Scaling, KeepsEveryDigitOfAPose, (const AnyLinkage& l)) {
    const double k = power_of_two();
    const auto large = scaled(l.links, k);
    const auto p = pose(l.links, l.crank_angle, l.assembly), q = pose(large, l.crank_angle, l.assembly);
    RC_ASSERT(same(p.crank, q.crank) && same(p.coupler, q.coupler) && same(p.rocker, q.rocker));
    RC_ASSERT(p.transmission_sine == q.transmission_sine && p.transmission_cosine == q.transmission_cosine);
    RC_ASSERT(k * p.margins.diagonal == q.margins.diagonal);
    RC_ASSERT(k * p.margins.stretch == q.margins.stretch);
    RC_ASSERT(k * p.margins.fold == q.margins.fold);
    RC_ASSERT(p.assembled() == q.assembled());
    const auto half = half_turn(l.crank_angle);
    RC_ASSERT(transmission_angle(l.links, half) == transmission_angle(large, half));
}

RC_GTEST_PROP(Scaling, KeepsEveryDigitOfAMotion, (const AnyLinkage& l)) {
    const double k = power_of_two();
    const auto large = scaled(l.links, k);
    const CouplerPoint<double> point{between(-1, 2) * l.links.coupler, between(-1, 2) * l.links.coupler};
    const CouplerPoint<double> far{k * point.along, k * point.across};
    const auto p = pose(l.links, l.crank_angle, l.assembly), q = pose(large, l.crank_angle, l.assembly);
    const auto v = velocity(l.links, p), w = velocity(large, q);
    RC_ASSERT(same(v.coupler, w.coupler) && same(v.rocker, w.rocker));
    const auto a = acceleration(l.links, p, v), b = acceleration(large, q, w);
    RC_ASSERT(same(a.coupler, b.coupler) && same(a.rocker, b.rocker));
    RC_ASSERT(same(k * position(l.links, point, p), position(large, far, q)));
    RC_PRE(std::isfinite(a.coupler));
    RC_ASSERT(same(k * velocity(l.links, point, p, v), velocity(large, far, q, w)));
    RC_ASSERT(same(k * acceleration(l.links, point, p, v, a), acceleration(large, far, q, w, b)));
}

RC_GTEST_PROP(Scaling, KeepsEveryDigitOfTheClassAndTheRange, (const AnyLinkage& l)) {
    const double k = power_of_two();
    const auto large = scaled(l.links, k);
    RC_ASSERT(classify(l.links).kind == classify(large).kind);
    RC_ASSERT(k * grashof_margin(l.links) == grashof_margin(large));
    RC_ASSERT(k * closing_margin(l.links) == closing_margin(large));
    const auto range = assembled_range(l.links), same_range = assembled_range(large);
    RC_ASSERT(range.full_turn == same_range.full_turn && range.mirrored == same_range.mirrored);
    RC_ASSERT(range.from == same_range.from && range.to == same_range.to);
    const auto extremes = velocity_ratio_extremes(l.links, l.assembly, range);
    const auto same_extremes = velocity_ratio_extremes(large, l.assembly, range);
    RC_ASSERT(extremes.count == same_extremes.count);
    RC_ASSERT(extremes.at == same_extremes.at);
}

RC_GTEST_PROP(Scaling, KeepsEveryDigitOfTheLimits, (const TurningLinkage& l)) {
    RC_PRE(l.links.crank == shortest_of(l.links));
    const auto large = scaled(l.links, power_of_two());
    RC_ASSERT(swing(l.links) == swing(large));
    RC_ASSERT(stroke_excess(l.links) == stroke_excess(large));
    const auto a = limit_positions(l.links, l.assembly), b = limit_positions(large, l.assembly);
    RC_ASSERT(a.extended.crank_angle == b.extended.crank_angle && a.folded.crank_angle == b.folded.crank_angle);
    RC_ASSERT(a.extended.rocker_angle == b.extended.rocker_angle && a.folded.rocker_angle == b.folded.rocker_angle);
    RC_ASSERT(a.extended.transmission_angle == b.extended.transmission_angle);
    RC_ASSERT(a.folded.transmission_angle == b.folded.transmission_angle);
}

RC_GTEST_PROP(Scaling, KeepsEveryDigitOfTheCognates, (const AnyLinkage& l)) {
    const double k = power_of_two();
    const CouplerPoint<double> point{between(-1, 2) * l.links.coupler, between(-1, 2) * l.links.coupler};
    const Placement<double> home{{between(-3, 3), between(-3, 3)}, between(-4, 4)};
    const auto small = cognates(PathLinkage<double>{l.links, point, home, l.assembly});
    const auto large = cognates(PathLinkage<double>{
        scaled(l.links, k), {k * point.along, k * point.across}, {k * home.origin, home.tilt}, l.assembly});
    for (std::size_t i = 0; i < 2; ++i) {
        const FourBar<double> a = scaled(small[i].links, k), b = large[i].links;
        RC_ASSERT(a.ground == b.ground && a.crank == b.crank && a.coupler == b.coupler && a.rocker == b.rocker);
        RC_ASSERT(k * small[i].point.along == large[i].point.along &&
                  k * small[i].point.across == large[i].point.across);
        RC_ASSERT(same(k * small[i].placement.origin, large[i].placement.origin));
        RC_ASSERT(small[i].placement.tilt == large[i].placement.tilt);
    }
}

}  // namespace mechwright::test
