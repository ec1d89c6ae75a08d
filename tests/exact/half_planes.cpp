// Closest points of intersections of half-planes, and what is said of regions without one.

#include "synthesis/exact/closed_form/half_planes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace mechwright {
namespace {

using Plane = HalfPlane<double>;

double distance_shown(const Vector<double>& target, const std::vector<Plane>& planes, const ClosestPoint& closest) {
    std::vector<HalfPlane<Digits50>> binding;
    std::vector<Digits50> weights;
    for (std::size_t i = 0; i < closest.binding_count; ++i) {
        const Plane& plane = planes[closest.binding[i]];
        binding.push_back({{plane.normal.x, plane.normal.y}, plane.level});
        weights.emplace_back(closest.weight[i]);
    }
    return distance_by_weights<Digits50>({target.x, target.y}, binding, weights).convert_to<double>();
}

Plane plane_at(double direction, double level, double size = 1) {
    return {{size * std::cos(direction), size * std::sin(direction)}, size * level};
}

TEST(HalfPlanes, CornersOfNearlyParallelBoundariesAreFound) {
    for (double angle = 1e-3; angle > 1e-15; angle /= 3) {
        // A wedge whose corner is the closest point: both boundaries pass through (1, 0).
        const std::vector<Plane> wedge{plane_at(angle, std::cos(angle)), plane_at(-angle, std::cos(angle))};
        const ClosestPoint closest = closest_point({0, 0}, wedge);
        EXPECT_EQ(closest.region, Region::holds_the_point) << angle;
        EXPECT_NEAR(closest.at.x, 1, 1e-15) << angle;
        EXPECT_NEAR(distance_shown({0, 0}, wedge, closest), 1, 1e-15) << angle;
    }
}

// Tangents of a circle about the target: the region outside all of them is far or empty; inside one it is a cap.
TEST(HalfPlanes, ManyTangentsOfAnArcKeepTheirClosestPoint) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> part(-1, 1);
    for (int round = 0; round < 200; ++round) {
        const double spread = std::pow(10, -8 + 8 * std::abs(part(random)));
        std::vector<Plane> planes;
        for (int i = 0; i < 12; ++i)
            planes.push_back(plane_at(0.3 + spread * part(random), 2, std::exp(5 * part(random))));
        const ClosestPoint closest = closest_point({0, 0}, planes);
        ASSERT_EQ(closest.region, Region::holds_the_point);
        for (const Plane& plane : planes)
            EXPECT_GE(dot(plane.normal, closest.at), plane.level - 4e-15 * std::hypot(plane.normal.x, plane.normal.y));
        const double distance = std::hypot(closest.at.x, closest.at.y);
        EXPECT_NEAR(distance_shown({0, 0}, planes, closest), distance, 1e-14 * distance);
        // Of all pairs none keeps a point farther away.
        for (std::size_t i = 0; i < planes.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const ClosestPoint two = closest_point({0, 0}, std::vector<Plane>{planes[i], planes[j]});
                EXPECT_LE(std::hypot(two.at.x, two.at.y), distance * (1 + 1e-15));
            }
    }
}

TEST(HalfPlanes, EmptyRegionsAreShownByWeights) {
    const double third = 2 * std::numbers::pi / 3;
    for (const double gap : {1.0, 1e-6, 1e-12, 1e-15}) {
        const std::vector<Plane> triangle{plane_at(0, gap), plane_at(third, gap, 7), plane_at(2 * third, gap, 0.1)};
        const ClosestPoint closest = closest_point({3, 4}, triangle);
        ASSERT_EQ(closest.region, Region::is_empty) << gap;
        EXPECT_EQ(closest.binding_count, 3u);
        EXPECT_GT(distance_shown({3, 4}, triangle, closest), 1e14 * gap) << gap;
    }
    const std::vector<Plane> opposite{{{1, 0}, 1}, {{0, 1}, 5}, {{-2, 0}, -1}};
    EXPECT_EQ(closest_point({0, 0}, opposite).region, Region::is_empty);
    const std::vector<Plane> touching{{{1, 0}, 1}, {{0, 1}, 5}, {{-2, 0}, -2}};
    EXPECT_EQ(closest_point({0, 0}, touching).region, Region::holds_the_point);
    EXPECT_EQ(closest_point({0, 0}, touching).at.y, 5);
}

TEST(HalfPlanes, NegativeWeightsShowNothing) {
    const std::vector<Plane> planes{{{1, 0}, 1}, {{-1, 0}, -2}};
    const std::vector<double> good{1, 0}, bad{1, -0.5};
    EXPECT_EQ(distance_by_weights<double>({0, 0}, planes, good), 1);
    EXPECT_EQ(distance_by_weights<double>({0, 0}, planes, bad), 0);
}

}  // namespace
}  // namespace mechwright
