#include "synthesis/mechanism/four_bar/measure_again.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "synthesis/mechanism/four_bar/four_bar.h"
#include "tests/verify/random_linkages.h"

namespace mechwright {

namespace {

using namespace four_bar;
using namespace test;

constexpr double thirty_digits = 1e-30;

::testing::AssertionResult agree(const Digits50& again, const Digits50& closed_form, double relative) {
    const Digits50 size = abs(closed_form) > 1 ? Digits50(abs(closed_form)) : Digits50(1);
    const Digits50 error = abs(again - closed_form) / size;
    if (error <= relative) return ::testing::AssertionSuccess();
    return ::testing::AssertionFailure() << again.str(30) << " again, " << closed_form.str(30)
                                         << " in closed form: relative difference " << error.str(3);
}

Assembly assembly_of(std::size_t index) { return index == 0 ? Assembly::open : Assembly::crossed; }

std::string describe(const FourBar<double>& m) {
    std::ostringstream text;
    text << std::setprecision(17) << m.ground << ' ' << m.crank << ' ' << m.coupler << ' ' << m.rocker;
    return text.str();
}

void expect_strokes_agree(const FourBar<double>& m, std::size_t assembly, double relative) {
    const auto fine = converted<Digits50>(m);
    const auto dimensions = dimensions_of(m);
    const Motion motion = full_turn(0, assembly);
    const Digits50 pi_50 = pi<Digits50>();
    const Digits50 excess = abs(stroke_excess(fine));
    EXPECT_TRUE(agree(swing_again(motion, dimensions), swing(fine), relative)) << describe(m);
    EXPECT_TRUE(agree(time_ratio_again(motion, dimensions), (pi_50 + excess) / (pi_50 - excess), relative))
        << describe(m);
    EXPECT_TRUE(agree(swing_again(motion, dimensions), swing(m), 1e-13)) << describe(m);
}

void expect_transmission_agrees(const FourBar<double>& m, const Motion& motion, double relative) {
    const auto fine = converted<Digits50>(m);
    const auto dimensions = dimensions_of(m);
    Digits50 least = 4, greatest = 0;
    const auto extremes =
        motion.full_turn ? transmission_extremes_of_full_turn() : transmission_extremes(motion.from, motion.to);
    for (std::size_t k = 0; k < extremes.count; ++k) {
        const bool end = !motion.full_turn && k < 2;
        const HalfTurn<double>& at = extremes.at[k];
        const HalfTurn<Digits50> half =
            end ? half_turn(Digits50(k == 0 ? motion.from : motion.to)) : HalfTurn<Digits50>{at.cosine, at.sine};
        const Digits50 angle = transmission_angle(fine, half);
        least = std::min(least, angle);
        greatest = std::max(greatest, angle);
    }
    const Digits50 worst = std::min(least, Digits50(pi<Digits50>() - greatest));
    EXPECT_TRUE(agree(transmission_angle_min_again(motion, dimensions), least, relative)) << describe(m);
    EXPECT_TRUE(agree(transmission_angle_max_again(motion, dimensions), greatest, relative)) << describe(m);
    EXPECT_TRUE(agree(transmission_angle_worst_again(motion, dimensions), worst, relative)) << describe(m);
}

/// The analysis finds the places in double; the ratio is stationary there, so that it is good to twice their digits.
void expect_velocity_ratio_agrees(const FourBar<double>& m, const Motion& motion, double relative) {
    const auto fine = converted<Digits50>(m);
    const auto dimensions = dimensions_of(m);
    const Assembly assembly = assembly_of(motion.assembly);
    const auto extremes = velocity_ratio_extremes(m, assembly, {motion.full_turn, motion.from, motion.to});
    Digits50 least = 1e30, greatest = -1e30;
    for (std::size_t k = 0; k < extremes.count; ++k) {
        const Digits50 value = velocity_ratio(fine, Digits50(extremes.at[k]), assembly);
        least = std::min(least, value);
        greatest = std::max(greatest, value);
    }
    EXPECT_TRUE(agree(velocity_ratio_min_again(motion, dimensions), least, relative)) << describe(m);
    EXPECT_TRUE(agree(velocity_ratio_max_again(motion, dimensions), greatest, relative)) << describe(m);
}

TEST(MeasureAgain, AgreesWithTheClosedFormsOnCrankRockers) {
    for (const auto& m : random_linkages(FourBarClass::crank_rocker, 120, 1))
        for (const std::size_t assembly : {0, 1}) {
            expect_strokes_agree(m, assembly, thirty_digits);
            expect_transmission_agrees(m, full_turn(0, assembly), thirty_digits);
            expect_velocity_ratio_agrees(m, full_turn(0, assembly), 1e-22);
        }
}

TEST(MeasureAgain, AgreesWithTheClosedFormsOnDragLinks) {
    for (const auto& m : random_linkages(FourBarClass::double_crank, 100, 2))
        for (const std::size_t assembly : {0, 1}) {
            expect_transmission_agrees(m, full_turn(1, assembly), thirty_digits);
            expect_velocity_ratio_agrees(m, full_turn(1, assembly), 1e-22);
        }
}

TEST(MeasureAgain, AgreesWithTheClosedFormsOverPartOfTheAssembledRange) {
    Random random(3);
    for (const FourBarClass kind : {FourBarClass::crank_rocker, FourBarClass::double_crank, FourBarClass::double_rocker,
                                    FourBarClass::rocker_crank, FourBarClass::triple_rocker})
        for (const auto& m : random_linkages(kind, 40, 4)) {
            const auto range = assembled_range(m);
            const double from = random.between(range.from, range.to), to = random.between(range.from, range.to);
            const Motion motion =
                limited(std::min(from, to), std::max(from, to), static_cast<std::size_t>(random.coin()));
            expect_transmission_agrees(m, motion, thirty_digits);
            expect_velocity_ratio_agrees(m, motion, 1e-18);
        }
}

TEST(MeasureAgain, KeepsItsDigitsCloseToChangePoints) {
    for (int k = 4; k <= 40; k += 2) {
        const double margin = std::ldexp(1.0, -k);
        // p + q - s - l is the margin: the longest link is in turn the ground, the coupler and the rocker.
        for (const FourBar<double>& m : {FourBar<double>{6 - margin, 1, 3, 4}, FourBar<double>{3, 1, 6 - margin, 4},
                                         FourBar<double>{3, 1, 4, 6 - margin}})
            for (const std::size_t assembly : {0, 1}) {
                expect_strokes_agree(m, assembly, thirty_digits);
                expect_transmission_agrees(m, full_turn(0, assembly), thirty_digits);
                EXPECT_NEAR(grashof_margin_again({}, dimensions_of(m)).convert_to<double>(), margin, 1e-30);
            }
    }
}

/// The rocker turns a corner there, where it is extreme without its slope being zero.
TEST(MeasureAgain, SeesTheCornersAtChangePoints) {
    const double nearly = 1e-20;  // the corner is looked at from beside it
    for (const FourBar<double>& m : {FourBar<double>{6, 1, 3, 4}, FourBar<double>{3, 1, 6, 4},
                                     FourBar<double>{3, 1, 4, 6}, FourBar<double>{5, 2, 5, 2}})
        for (const std::size_t assembly : {0, 1})
            expect_strokes_agree(m, assembly, nearly);
    // A coupler that folds onto a crank of its length lets the rocker stand still.
    for (const FourBar<double>& m : {FourBar<double>{5, 2, 2, 5}, FourBar<double>{1, 1, 1, 1}})
        for (const std::size_t assembly : {0, 1}) {
            EXPECT_TRUE(
                agree(swing_again(full_turn(0, assembly), dimensions_of(m)), swing(converted<Digits50>(m)), nearly))
                << describe(m);
            EXPECT_TRUE(isnan(time_ratio_again(full_turn(0, assembly), dimensions_of(m))));
            EXPECT_TRUE(std::isnan(stroke_excess(m)));
        }
}

TEST(MeasureAgain, SeesTheFastMotionOfALinkageCloseToAChangePoint) {
    for (int k = 4; k <= 32; k += 4) {
        const FourBar<double> m{6 - std::ldexp(1.0, -k), 1, 3, 4};
        expect_velocity_ratio_agrees(m, full_turn(0, 0), 1e-12);
        expect_velocity_ratio_agrees(m, full_turn(0, 1), 1e-12);
    }
}

/// A hair inside the toggle, which is known to fifty digits from the law of cosines, the ratio has its sign already.
void expect_sign_at_toggle(const FourBar<double>& m, bool stretched, bool lower_end) {
    const auto fine = converted<Digits50>(m);
    const Digits50 third_side = stretched ? Digits50(fine.coupler + fine.rocker) : Digits50(fine.coupler - fine.rocker);
    const Digits50 hair("1e-40");
    const Digits50 cosine = (fine.ground * fine.ground + fine.crank * fine.crank - third_side * third_side) /
                            (2 * fine.ground * fine.crank);
    const Digits50 toggle = lower_end ? Digits50(-acos(cosine)) : Digits50(acos(cosine));
    // Below a stretched dyad's angle and above a folded one's the linkage assembles.
    const Digits50 inside = stretched == lower_end ? Digits50(toggle + hair) : Digits50(toggle - hair);
    for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
        const bool positive = velocity_ratio(fine, inside, assembly) > 0;
        EXPECT_EQ(velocity_ratio_at_toggle(m, toggle.convert_to<double>(), assembly) > 0, positive) << describe(m);
    }
}

TEST(MeasureAgain, KnowsTheSignOfAnInfiniteVelocityRatio) {
    Random random(5);
    for (int k = 0; k < 300; ++k) {
        const double ground = random.between(1, 5), crank = random.between(1, 5);
        // From well inside the range to next to the change point.
        const double side = ground + crank - std::exp(random.between(-20, 0));
        const double coupler = side * random.between(0.2, 0.8);
        const FourBar<double> stretched{ground, crank, coupler, side - coupler};
        const FourBar<double> folded{ground, crank, side + coupler, coupler};
        const FourBar<double> rocker_longer{ground, crank, coupler, side + coupler};
        for (const bool lower_end : {false, true}) {
            expect_sign_at_toggle(stretched, true, lower_end);
            expect_sign_at_toggle(folded, false, lower_end);
            expect_sign_at_toggle(rocker_longer, false, lower_end);
        }
    }
}

/// Ranges end at toggles next to change points: what the search states is what is measured again.
TEST(MeasureAgain, AgreesOnInfiniteVelocityRatiosNextToChangePoints) {
    const auto& quantities = four_bar_mechanism()->quantities;
    for (const double lack : {1e-3, 1e-7, 1.1e-11, 1e-13}) {
        const FourBar<double> m{7.59877756315332, 16.94244939177149, 8.294785058077364,
                                7.59877756315332 + 16.94244939177149 - 8.294785058077364 - lack};
        const auto range = assembled_range(m);
        const auto dimensions = dimensions_of(m);
        for (const std::size_t assembly : {0, 1}) {
            const Motion motion = limited(range.from, range.to, assembly);
            EXPECT_EQ(velocity_ratio_min_again(motion, dimensions), -std::numeric_limits<Digits50>::infinity()) << lack;
            EXPECT_EQ(velocity_ratio_max_again(motion, dimensions), std::numeric_limits<Digits50>::infinity()) << lack;
            const std::vector<double> d{m.ground, m.crank, m.coupler, m.rocker, 0, 0, 0, 0, 0, 0};
            for (const Quantity& q : quantities) {
                if (q.name != "velocity-ratio-min" && q.name != "velocity-ratio-max") continue;
                std::array<double, Quantity::most_components> components{};
                measure(q, motion, d, {std::span(components).first(q.components(motion)), {}, {}});
                EXPECT_TRUE(std::isinf(components[0])) << q.name << ' ' << lack;
            }
        }
    }
}

TEST(MeasureAgain, KeepsItsDigitsForTinyCranks) {
    for (const double crank : {1e-3, 1e-6, 1e-9})
        expect_strokes_agree({1, crank, 0.8, 0.7}, 0, thirty_digits);
}

TEST(MeasureAgain, MeasuresOneTurnWhereTheRangeIsALongerOne) {
    const FourBar<double> m{4, 1, 3, 3.5};
    const auto dimensions = dimensions_of(m);
    EXPECT_TRUE(agree(transmission_angle_min_again(limited(-9, 9), dimensions),
                      transmission_angle_min_again(full_turn(0), dimensions), thirty_digits));
    EXPECT_TRUE(agree(velocity_ratio_max_again(limited(1, 20), dimensions),
                      velocity_ratio_max_again(full_turn(0), dimensions), thirty_digits));
}

TEST(MeasureAgain, SumsAndDividesTheLengths) {
    const auto dimensions = dimensions_of({6, 2, 5, 4});
    EXPECT_EQ(total_length_again({}, dimensions), 17);
    EXPECT_EQ(link_ratio_again({}, dimensions), 3);
    EXPECT_EQ(grashof_margin_again({}, dimensions), 1);
}

TEST(MeasureAgain, HasNoStrokesForALinkageThatIsNoCrankRocker) {
    const auto dimensions = dimensions_of({1, 3, 4, 3.5});
    EXPECT_TRUE(isnan(swing_again(full_turn(1), dimensions)));
    EXPECT_TRUE(isnan(time_ratio_again(full_turn(1), dimensions)));
}

TEST(MeasureAgain, HasNoExtremesOverWhatIsNoMotion) {
    const auto dimensions = dimensions_of({4, 1, 3, 3.5});
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Motion& motion : {limited(1, 0), limited(nan, 1), limited(0, nan), limited(0, 1e300)}) {
        EXPECT_TRUE(isnan(transmission_angle_min_again(motion, dimensions)));
        EXPECT_TRUE(isnan(velocity_ratio_max_again(motion, dimensions)));
    }
}

TEST(PathPointAgain, AgreesWithTheAnalysis) {
    Random random(5);
    for (const auto& m : random_linkages(FourBarClass::crank_rocker, 100, 6)) {
        auto dimensions = dimensions_of(m);
        for (std::size_t i = 4; i < 10; ++i)
            dimensions[i] = random.between(-3, 3);
        const Digits50 crank_angle = random.between(-7, 7);
        const std::size_t assembly = static_cast<std::size_t>(random.coin());
        const auto fine = converted<Digits50>(m);
        const auto p = pose(fine, crank_angle, assembly_of(assembly));
        const auto expected = placed(position(fine, CouplerPoint<Digits50>{dimensions[4], dimensions[5]}, p),
                                     {{dimensions[6], dimensions[7]}, dimensions[8]});
        const auto again = four_bar_path_point({nullptr, assembly}, dimensions, crank_angle);
        EXPECT_TRUE(agree(again.x, expected.x, thirty_digits)) << describe(m);
        EXPECT_TRUE(agree(again.y, expected.y, thirty_digits)) << describe(m);
    }
}

TEST(PathPointAgain, IsNotANumberWhereTheLinkageDoesNotAssemble) {
    const auto point = four_bar_path_point({}, dimensions_of({4, 3, 2, 2.5}), pi<Digits50>());
    EXPECT_TRUE(isnan(point.x));
    EXPECT_TRUE(isnan(point.y));
}

}  // namespace

}  // namespace mechwright
