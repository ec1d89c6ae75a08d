// Limit positions, swing and time ratio against fifty digits of an independent formula: the angles of the two limit
// triangles by the law of cosines.

#include <cmath>

#include "tests/analysis/precise.h"
#include "tests/properties/linkages.h"

namespace mechwright::test {

namespace {

/// The angle between the sides a and b of a triangle, opposite to c.
Precise between_sides(const Precise& a, const Precise& b, const Precise& c) {
    const Precise cosine = (a * a + b * b - c * c) / (2 * a * b);
    return cosine >= 1 ? Precise(0) : cosine <= -1 ? acos(Precise(-1)) : Precise(acos(cosine));
}

struct Limits {
    Precise swing, excess;
    Precise extended_crank, folded_crank, extended_rocker, folded_rocker, extended_transmission, folded_transmission;
};

Limits limits_of(const FourBar<double>& links) {
    const auto m = precise(links);
    const Precise reach = m.coupler + m.crank, back = m.coupler - m.crank;
    Limits l;
    l.extended_rocker = between_sides(m.ground, m.rocker, reach);
    l.folded_rocker = between_sides(m.ground, m.rocker, back);
    l.extended_crank = between_sides(m.ground, reach, m.rocker);
    l.folded_crank = between_sides(m.ground, back, m.rocker);
    l.extended_transmission = between_sides(reach, m.rocker, m.ground);
    l.folded_transmission = between_sides(back, m.rocker, m.ground);
    l.swing = l.extended_rocker - l.folded_rocker;
    l.excess = l.folded_crank - l.extended_crank;
    return l;
}

}  // namespace

RC_GTEST_PROP(Limits, HaveASwingWithAllItsDigits, (const CrankRocker& l)) {
    const auto& m = l.links;
    RC_ASSERT(digits(swing(m), limits_of(m).swing) >= 14.5);
}

RC_GTEST_PROP(Limits, HaveASwingWithAllItsDigitsForTheSmallestCranks, (const CrankRocker& l)) {
    FourBar<double> tiny = l.links;
    tiny.crank *= 1e-6;
    RC_ASSERT(digits(swing(tiny), limits_of(tiny).swing) >= 14.5);
}

RC_GTEST_PROP(Limits, HaveAStrokeAsExactAsItsSquaresAllow, (const CrankRocker& l)) {
    const auto& m = l.links;
    // The excess is proportional to coupler^2 + rocker^2 - ground^2 - crank^2: where that difference cancels, so it
    // does.
    const double squares =
        std::abs(m.coupler * m.coupler - m.ground * m.ground + m.rocker * m.rocker - m.crank * m.crank);
    const double sum = m.coupler * m.coupler + m.ground * m.ground + m.rocker * m.rocker + m.crank * m.crank;
    RC_PRE(squares > 0);
    RC_ASSERT(digits(stroke_excess(m), limits_of(m).excess) >= 14.5 - std::log10(sum / squares));
}

RC_GTEST_PROP(Limits, HaveAnglesWithAllTheirDigits, (const CrankRocker& l)) {
    const auto& m = l.links;
    const Limits exact = limits_of(m);
    const Precise half_turn = acos(Precise(-1));
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
        const auto limits = limit_positions(m, assembly);
        const double side = side_of(assembly);
        RC_ASSERT(digits(limits.extended.crank_angle, side * exact.extended_crank) >= 14.5);
        RC_ASSERT(digits(limits.folded.crank_angle, half_turn + side * exact.folded_crank) >= 14.5);
        RC_ASSERT(digits(limits.extended.rocker_angle, side * (half_turn - exact.extended_rocker)) >= 14.5);
        RC_ASSERT(digits(limits.folded.rocker_angle, side * (half_turn - exact.folded_rocker)) >= 14.5);
        RC_ASSERT(digits(limits.extended.transmission_angle, exact.extended_transmission) >= 14.5);
        RC_ASSERT(digits(limits.folded.transmission_angle, exact.folded_transmission) >= 14.5);
    }
}

// The ends of a limited range are where the diagonal is coupler + rocker or their difference.
RC_GTEST_PROP(Limits, HaveARangeThatEndsAtItsToggles, (const AnyLinkage& l)) {
    const auto& m = l.links;
    const auto range = assembled_range(m);
    RC_PRE(!range.full_turn);
    const auto exact = precise(m);
    const Precise to_stretch = between_sides(exact.ground, exact.crank, exact.coupler + exact.rocker);
    const Precise to_fold = between_sides(exact.ground, exact.crank, abs(exact.coupler - exact.rocker));
    const bool folds = m.ground != m.crank && to_fold > 0, stretches = to_stretch < acos(Precise(-1));
    RC_ASSERT(range.mirrored == (folds && stretches));
    if (folds) RC_ASSERT(digits(range.from, to_fold) >= 14.5);
    if (stretches) RC_ASSERT(digits(range.to, to_stretch) >= 14.5);
    if (folds && !stretches) RC_ASSERT(digits(range.to, 2 * acos(Precise(-1)) - to_fold) >= 14.5);
    if (stretches && !folds) RC_ASSERT(range.from == -range.to);
}

RC_GTEST_PROP(Limits, HaveTheTransmissionAngleExtremesAtTheGroundLine, (const TurningLinkage& l)) {
    const auto& m = l.links;
    const auto extremes = transmission_extremes_of_full_turn();
    const double least = transmission_angle(m, extremes.at[0]), greatest = transmission_angle(m, extremes.at[1]);
    const double here = transmission_angle(m, half_turn(l.crank_angle));
    RC_ASSERT(least <= here + 4 * ulp && here <= greatest + 4 * ulp);
    const auto exact = precise(m);
    RC_ASSERT(digits(least, between_sides(exact.coupler, exact.rocker, abs(exact.ground - exact.crank))) >= 14.5);
    RC_ASSERT(digits(greatest, between_sides(exact.coupler, exact.rocker, exact.ground + exact.crank)) >= 14.5);
}

}  // namespace mechwright::test
