// Convex parts that cover polygons and what is outside of them: against rays that are crossed, and distances from
// sides.

#include "analysis/geometry/convex_pieces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace mechwright {

namespace {

/// A polygon about the origin with many inward corners.
Corners random_star(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> radius(0.3, 1);
    Corners star;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(count);
        star.push_back(radius(random) * Vector<double>{std::cos(angle), std::sin(angle)});
    }
    return star;
}

bool is_in_star(const Vector<double>& at, const Corners& star) {
    bool inside = false;
    for (std::size_t i = 0; i < star.size(); ++i) {
        const Vector<double>&a = star[i], &b = star[(i + 1) % star.size()];
        if ((a.y > at.y) != (b.y > at.y) && at.x < a.x + (at.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside;
}

double from_border(const Vector<double>& at, const Corners& polygon) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector<double> side = polygon[(i + 1) % polygon.size()] - polygon[i], way = at - polygon[i];
        const double share = std::clamp(dot(way, side) / dot(side, side), 0.0, 1.0);
        const Vector<double> from = way - share * side;
        nearest = std::min(nearest, std::hypot(from.x, from.y));
    }
    return nearest;
}

double from_pieces(const Vector<double>& at, const std::vector<Corners>& pieces) {
    double least = std::numeric_limits<double>::infinity();
    for (const Corners& piece : pieces)
        least = std::min(least, piece.size() == 2
                                    ? separation_from_half_plane(Corners{at}, piece.front(), piece.back()).distance
                                    : separation(Corners{at}, piece).distance);
    return least;
}

/// Out of the pieces the distance is that from the polygon's border; in them it is less than 0, and no deeper.
void expect_covered(const Vector<double>& at, const Corners& polygon, const std::vector<Corners>& pieces, bool in) {
    const double distance = from_border(at, polygon), found = from_pieces(at, pieces);
    if (in) {
        EXPECT_LT(found, 0) << at.x << ' ' << at.y;
        EXPECT_GE(found, -distance - 1e-12) << at.x << ' ' << at.y;
    } else {
        EXPECT_NEAR(found, distance, 1e-12) << at.x << ' ' << at.y;
    }
}

TEST(ConvexPieces, CoverStarsAndWhatIsOutsideOfThem) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> number(-1.5, 1.5);
    for (int k = 0; k < 60; ++k) {
        const Corners star = random_star(random, 4 + static_cast<std::size_t>(k % 9));
        const auto inside = convex_pieces(star), outside = convex_pieces_outside(star);
        ASSERT_TRUE(inside && outside);
        for (int i = 0; i < 200; ++i) {
            const Vector<double> at{number(random), number(random)};
            const bool in = is_in_star(at, star);
            expect_covered(at, star, *inside, in);
            expect_covered(at, star, *outside, !in);
        }
    }
}

TEST(ConvexPieces, AreCoveredWhereTheyMeet) {
    const Corners l{{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}};
    const auto pieces = convex_pieces(l), outside = convex_pieces_outside(l);
    ASSERT_TRUE(pieces && outside);
    ASSERT_EQ(pieces->size(), 2u);
    EXPECT_NEAR(from_pieces({0.5, 1}, *pieces), -0.5, 1e-15);  // between its bars
    EXPECT_NEAR(from_pieces({3, 0.5}, *pieces), -0.5, 1e-15);
    // On the line from (4, 1) to (1, 3), along which the convex hull is cut: as deep as in the quarter beyond the
    // corner.
    EXPECT_NEAR(from_pieces({2.5, 2}, *outside), -1, 1e-12);
}

TEST(ConvexPieces, AreNotOfPolygonsWhoseSidesMeet) {
    EXPECT_FALSE(crossing_of_sides({{0, 0}, {4, 0}, {4, 1}, {1, 1}, {1, 3}, {0, 3}}));
    const auto bow = crossing_of_sides({{0, 0}, {2, 2}, {2, 0}, {0, 2}});
    ASSERT_TRUE(bow);
    EXPECT_NEAR(bow->x, 1, 1e-15);
    EXPECT_NEAR(bow->y, 1, 1e-15);
    EXPECT_TRUE(crossing_of_sides({{0, 0}, {4, 0}, {4, 3}, {2, 0}, {0, 3}}));          // a corner on a side
    EXPECT_TRUE(crossing_of_sides({{0, 0}, {4, 0}, {4, 1}, {3, 0}, {1, 0}, {0, 1}}));  // sides in one line
}

}  // namespace

}  // namespace mechwright
