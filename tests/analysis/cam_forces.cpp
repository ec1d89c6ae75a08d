// The force between cam and follower with friction in the guide, against the equilibrium of the follower written out:
// the cam's push, the reactions of the guide's two edges and their friction, and the force along the guide.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "analysis/cam/contact_force.h"

namespace mechwright::cam {

namespace {

/// The push of the cam that balances a unit force along the guide, from three equations of equilibrium. The guide's
/// near edge is on the side to which the push drives the follower's end, the far edge on the other; friction acts
/// against the rising stem at both of its sides.
double push_of(double angle, const FollowerLoad<double>& l) {
    const double a = l.overhang, b = l.guide_length, d = l.stem_diameter, f = l.friction;
    Eigen::Matrix3d m;
    Eigen::Vector3d right;
    // Unknown: push N, reaction of the near edge, reaction of the far edge.
    m.row(0) << std::cos(angle), -f, -f;  // along the guide
    m.row(1) << std::sin(angle), -1, 1;   // across
    // Moments about the middle of the stem at the near edge: the push acts at the distance a before it, the far edge at
    // b behind it, friction at half the diameter on either side.
    m.row(2) << std::sin(angle) * a, -f * d / 2, -b + f * d / 2;
    right << 1, 0, 0;
    return m.colPivHouseholderQr().solve(right)(0);
}

}  // namespace

TEST(GuideFriction, IsThatOfTheEquilibrium) {
    FollowerLoad<double> l{};
    l.guide_length = 50;
    l.overhang = 28;
    l.stem_diameter = 10;
    l.friction = 0.1;
    for (const double angle : {0.05, 0.2, 0.4, 0.6}) {
        EXPECT_NEAR(1 / effective_cosine(l, std::cos(angle), std::sin(angle)), push_of(angle, l),
                    1e-12 * push_of(angle, l));
        EXPECT_EQ(effective_cosine(l, std::cos(angle), -std::sin(angle)),
                  effective_cosine(l, std::cos(angle), std::sin(angle)));
    }
    const double jam = jamming_angle(l);
    EXPECT_NEAR(effective_cosine(l, std::cos(jam), std::sin(jam)), 0, 1e-15);
    EXPECT_NEAR(std::tan(jam), 50 / (0.1 * (2 * 28 + 50 - 0.1 * 10)), 1e-13);
    l.friction = 0;
    EXPECT_EQ(effective_cosine(l, 0.8, 0.6), 0.8);
}

}  // namespace mechwright::cam
