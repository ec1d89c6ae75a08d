// Curves as arcs: circles are met exactly, others within the tolerance, and what cannot be followed comes to an end.

#include "analysis/geometry/arc_fit.h"

#include <gtest/gtest.h>

#include <limits>
#include <numbers>

namespace mechwright::testing {
namespace {

using Curve = Vector<double> (*)(double);

std::vector<ArcVertex> fitted(Curve curve, double from, double to, double tolerance) {
    std::vector<ArcVertex> vertices;
    fit_arcs(curve, from, to, tolerance, vertices);
    return vertices;
}

double greatest_miss(Curve curve, double from, double to, const std::vector<ArcVertex>& vertices) {
    double greatest = 0;
    constexpr int samples = 5000;
    for (int i = 0; i <= samples; ++i) {
        const Vector<double> p = curve(from + (to - from) * i / samples);
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < vertices.size(); ++k) {
            const Vector<double> end = k + 1 < vertices.size() ? vertices[k + 1].at : curve(to);
            least = std::min(least, distance_from_arc(vertices[k], end, p));
        }
        greatest = std::max(greatest, least);
    }
    return greatest;
}

Vector<double> circle(double t) { return {3 + 5 * std::cos(t), -1 + 5 * std::sin(t)}; }
Vector<double> parabola(double t) { return {t, t * t}; }
Vector<double> corner(double t) { return {t, std::abs(t)}; }
Vector<double> cusp(double t) { return {t * t, t * t * t}; }
Vector<double> nowhere(double) { return {std::numeric_limits<double>::quiet_NaN(), 0}; }
Vector<double> rounded(double t) { return {1e13 + std::cos(t), std::sin(t)}; }

TEST(ArcFit, MeasuresToTheEndsOfAnArcBeyondThem) {
    // A quarter of the unit circle from (1, 0) to (0, 1).
    const ArcVertex quarter{{1, 0}, std::tan(0.125 * std::numbers::pi)};
    const Vector<double> end{0, 1};
    const double root = std::sqrt(0.5);
    EXPECT_NEAR(distance_from_arc(quarter, end, {2 * root, 2 * root}), 1, 1e-15);
    EXPECT_NEAR(distance_from_arc(quarter, end, {0.5 * root, 0.5 * root}), 0.5, 1e-15);
    EXPECT_NEAR(distance_from_arc(quarter, end, {-root, root}), std::hypot(root, 1 - root), 1e-15);
    EXPECT_NEAR(distance_from_arc(quarter, end, {1, -3}), 3, 1e-15);
    EXPECT_NEAR(distance_from_arc({{0, 0}, 0}, {2, 0}, {3, 1}), std::hypot(1, 1), 1e-15);
    EXPECT_NEAR(distance_from_arc({{0, 0}, 0}, {2, 0}, {1, -0.25}), 0.25, 1e-15);
}

TEST(ArcFit, MeetsCirclesWithArcsOfHalfATurn) {
    const auto vertices = fitted(circle, 0, 6.2, 1e-12);
    EXPECT_LE(vertices.size(), 3u);
    EXPECT_LE(greatest_miss(circle, 0, 6.2, vertices), 1e-12);
}

TEST(ArcFit, KeepsItsToleranceWithFewArcs) {
    std::size_t before = 1;
    for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
        const auto vertices = fitted(parabola, -2, 2, tolerance);
        EXPECT_LE(greatest_miss(parabola, -2, 2, vertices), tolerance);
        // Arcs have an error of third order: a hundredth of the tolerance takes 100^(1/3) = 4.6 times as many.
        EXPECT_LE(vertices.size(), before * 6 + 2);
        before = vertices.size();
    }
}

TEST(ArcFit, GoesRoundCornersAndCusps) {
    for (const Curve curve : {corner, cusp}) {
        const auto vertices = fitted(curve, -1, 1.5, 1e-6);
        EXPECT_LE(greatest_miss(curve, -1, 1.5, vertices), 1e-6);
        EXPECT_LE(vertices.size(), 500u);
    }
}

TEST(ArcFit, ComesToAnEndWhereNothingCanBeFollowed) {
    EXPECT_TRUE(fitted(nowhere, 0, 1, 1e-6).empty());
    // The tolerance is less than the rounding of the curve, which goes in steps: a few arcs for each of them.
    const double steps = 24 / 1.95e-3;
    EXPECT_LE(static_cast<double>(fitted(rounded, 0, 6, 1e-9).size()), 2 * steps);
}

}  // namespace
}  // namespace mechwright::testing
