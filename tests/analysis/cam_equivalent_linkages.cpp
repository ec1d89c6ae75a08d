// A cam moves its follower, for an instant, like a linkage through the centre of curvature of its pitch curve: a
// slider-crank for a translating roller, a four-bar for an oscillating one. Velocity and acceleration must be those of
// the law, by formulas that know nothing of cams.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/cam/roller_follower.h"
#include "analysis/cam/segment.h"
#include "analysis/four_bar.h"
#include "analysis/slider_crank.h"

namespace mechwright::cam {

namespace {

Vector<double> centre_of_curvature(const PitchPoint<double>& p) { return p.position - (1 / curvature(p)) * normal(p); }

const std::array laws{Law::harmonic, Law::cycloidal, Law::modified_sine, Law::polynomial_345, Law::kloomok_muffley};

}  // namespace

TEST(EquivalentLinkages, OfTranslatingRollersAreSliderCranks) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(0, 1);
    int tested = 0;
    for (int i = 0; i < 200; ++i) {
        const TranslatingRoller<double> f{40 + 20 * part(random), 20 * part(random) - 10, 5, 1};
        const SegmentKind kind = i % 2 == 0 ? SegmentKind::rise : SegmentKind::fall;
        const Segment<double> s{kind,
                                {SegmentLaw::Form::law, laws[static_cast<std::size_t>(i) % laws.size()], false},
                                1.2 + part(random),
                                20};
        const double u = part(random);
        std::size_t piece = 0;
        while (u > break_before(s, piece + 1))
            ++piece;
        const Lift<double> lift = lift_at(s, piece, u, kind == SegmentKind::rise ? 0.0 : 20.0);
        const PitchPoint<double> p = pitch_point(f, lift);
        if (!(curvature(p) > 1e-3)) continue;
        const Vector<double> c = centre_of_curvature(p);
        // Seen along the guide, the slide lies to the right of the cam centre by the offset.
        const SliderCrank<double> m{std::hypot(c.x, c.y), 1 / curvature(p), -f.offset};
        const auto pose_here = pose(m, std::atan2(-c.x, c.y));
        const auto v = velocity(m, pose_here);
        EXPECT_NEAR(pose_here.position, p.position.y, 1e-11);
        EXPECT_NEAR(v.ram, lift.v, 1e-10);
        EXPECT_NEAR(acceleration(m, pose_here, v).ram, lift.a, 1e-8 * (1 + std::abs(lift.a)));
        ++tested;
    }
    EXPECT_GT(tested, 100);
}

TEST(EquivalentLinkages, OfOscillatingRollersAreFourBars) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> part(0, 1);
    int tested = 0;
    for (int i = 0; i < 200; ++i) {
        const OscillatingRoller<double> f{35 + 10 * part(random), 90, 80, 5, 1};
        const SegmentKind kind = i % 2 == 0 ? SegmentKind::rise : SegmentKind::fall;
        const Segment<double> s{kind,
                                {SegmentLaw::Form::law, laws[static_cast<std::size_t>(i) % laws.size()], false},
                                1.5 + part(random),
                                0.3};
        const double u = part(random);
        std::size_t piece = 0;
        while (u > break_before(s, piece + 1))
            ++piece;
        const Lift<double> lift = lift_at(s, piece, u, kind == SegmentKind::rise ? 0.0 : 0.3);
        const PitchPoint<double> p = pitch_point(f, lift);
        if (!(curvature(p) > 1e-3)) continue;
        const Vector<double> c = centre_of_curvature(p);
        const FourBar<double> m{f.pivot_distance, std::hypot(c.x, c.y), 1 / curvature(p), f.arm_length};
        const Vector<double> to_pivot{f.pivot_distance - c.x, -c.y};
        const Assembly assembly = cross(to_pivot, p.position - c) > 0 ? Assembly::open : Assembly::crossed;
        const auto pose_here = pose(m, std::atan2(c.y, c.x), assembly);
        const auto v = velocity(m, pose_here);
        // The arm rises clockwise, the rocker's angle is counted counter-clockwise.
        EXPECT_NEAR(v.rocker, -lift.v, 1e-10);
        EXPECT_NEAR(acceleration(m, pose_here, v).rocker, -lift.a, 1e-8 * (1 + std::abs(lift.a)));
        ++tested;
    }
    EXPECT_GT(tested, 100);
}

}  // namespace mechwright::cam
