// Curves as arcs: circles are met exactly, others within the tolerance, and what cannot be followed comes to an end.

#include "analysis/geometry/arc_fit.h"

#include <gtest/gtest.h>

#include <limits>

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
            const Vector<double> chord = end - vertices[k].at, a = p - vertices[k].at, b = p - end;
            least = std::min({least, std::hypot(a.x, a.y), std::hypot(b.x, b.y)});
            // Only arcs beside the point: it sees their chord under about a right angle or more.
            if (dot(a, b) > 0.01 * dot(chord, chord)) continue;
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
Vector<double> rounded(double t) { return {1e12 + std::cos(t), std::sin(t)}; }

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
    const double steps = 24 / 1.2e-4;
    EXPECT_LE(static_cast<double>(fitted(rounded, 0, 6, 1e-9).size()), 2 * steps);
}

}  // namespace
}  // namespace mechwright::testing
