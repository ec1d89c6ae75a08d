// How far convex outlines are apart: against closed forms, and against the gap in many directions.

#include "analysis/geometry/separation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace mechwright {

namespace {

using Outline2d = std::vector<Vector<double>>;

Outline2d outline_moved(Outline2d outline, const Vector<double>& by) {
    for (Vector<double>& corner : outline)
        corner = corner + by;
    return outline;
}

Outline2d random_outline(std::mt19937& random, std::size_t points) {
    std::uniform_real_distribution<double> number(-1, 1);
    Outline2d all, outline;
    for (std::size_t i = 0; i < points; ++i)
        all.push_back({number(random), number(random)});
    for (const std::size_t i : convex_hull(all))
        outline.push_back(all[i]);
    return outline;
}

TEST(Separation, OfKnownOutlines) {
    const Outline2d square{{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    EXPECT_EQ(separation(square, Outline2d{{5, 6}}).distance, 5);
    EXPECT_EQ(separation(square, Outline2d{{1, -3}}).distance, 3);
    EXPECT_EQ(separation(square, Outline2d{{1, 0.5}}).distance, -0.5);
    EXPECT_EQ(separation(square, Outline2d{{-1, 1}, {3, 1}}).distance, -1);  // a bar right through it
    EXPECT_EQ(separation(Outline2d{{0, 0}}, Outline2d{{3, 4}}).distance, 5);
    EXPECT_EQ(separation(Outline2d{{0, 0}, {4, 0}}, Outline2d{{2, 1}}).distance, 1);
    EXPECT_EQ(separation(Outline2d{{0, 0}, {4, 0}}, Outline2d{{5, 0}}).distance, 1);            // in line with it
    EXPECT_EQ(separation(Outline2d{{0, 0}, {4, 0}}, Outline2d{{1, -1}, {1, 3}}).distance, -1);  // bars that cross
    EXPECT_EQ(separation(Outline2d{{0, 0}, {4, 0}}, Outline2d{{6, 0}, {8, 0}}).distance, 2);
}

/// The greatest gap between parallel lines on which both lie: the distance, or the negative of the shortest way apart.
TEST(Separation, IsTheGreatestGapOfAllDirections) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-2, 2);
    int overlaps = 0;
    for (int i = 0; i < 2000; ++i) {
        const Outline2d a = random_outline(random, 1 + random() % 7),
                        b = outline_moved(random_outline(random, 1 + random() % 7), {number(random), number(random)});
        const Separation found = separation(a, b), back = separation(b, a);
        EXPECT_NEAR(found.distance, back.distance, 1e-14);
        if (found.distance < 0) ++overlaps;
        double shortest = 10;
        constexpr int directions = 720;
        for (int k = 0; k < directions; ++k) {
            const double angle = 2 * std::numbers::pi * k / directions;
            const Vector<double> way{std::cos(angle), std::sin(angle)};
            double reach = -10, near = 10;
            for (const Vector<double>& corner : a)
                reach = std::max(reach, dot(corner, way));
            for (const Vector<double>& corner : b)
                near = std::min(near, dot(corner, way));
            shortest = std::min(shortest, reach - near);
        }
        EXPECT_GE(found.distance, -shortest - 1e-14);
        EXPECT_NEAR(found.distance, -shortest, 2e-2);
    }
    EXPECT_GT(overlaps, 300);
}

TEST(ConvexHull, LeavesOutWhatIsInside) {
    const Outline2d points{{0, 0}, {1, 0.5}, {2, 0}, {1, 0}, {2, 2}, {0, 2}, {0, 0}};
    const std::vector<std::size_t> hull = convex_hull(points);
    ASSERT_EQ(hull.size(), 4u);
    double area = 0;
    for (std::size_t i = 0; i < hull.size(); ++i)
        area += 0.5 * cross(points[hull[i]], points[hull[(i + 1) % hull.size()]]);
    EXPECT_EQ(area, 4);
    EXPECT_EQ(convex_hull(Outline2d{{1, 1}, {1, 1}}).size(), 1u);
    EXPECT_EQ(convex_hull(Outline2d{{0, 0}, {2, 2}, {1, 1}}).size(), 2u);
    EXPECT_EQ(convex_hull(Outline2d{{3, 1}}).size(), 1u);
    // Points that are on a line but for rounding, in an order that is not that along it.
    const Outline2d upright{{-2e-13, 341}, {-1e-13, 400}, {0, 0}, {1e-13, 500}, {2e-13, 950}, {900, 300}};
    const std::vector<std::size_t> corners = convex_hull(upright);
    EXPECT_EQ(corners.size(), 3u);
    for (const std::size_t corner : {2u, 4u, 5u})
        EXPECT_NE(std::find(corners.begin(), corners.end(), corner), corners.end()) << corner;
}

}  // namespace

}  // namespace mechwright
