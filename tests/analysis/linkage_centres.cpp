// Instant centres: against velocities, three links in line, and the figures that one draws for them.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "analysis/four_bar/pose.h"
#include "analysis/linkage/measuring/instant_centres.h"
#include "tests/analysis/known_linkages.h"
#include "tests/analysis/made_linkage.h"
#include "tests/degree.h"

namespace mechwright::test {
namespace {

using linkage::InstantCentre;
using linkage::LinkMotion;
using InTime = Series<double, 1>;
using CentreKind = InstantCentre::Kind;

std::vector<LinkMotion> motions_at(const MadeLinkage& made, double degrees, const std::vector<std::int8_t>& sides) {
    std::vector<InTime> drives(made.s.drives.size(), InTime::variable(degrees * degree));
    const Placed<InTime> placed(made, drives, sides);
    EXPECT_TRUE(placed.closed);
    return linkage::motions_of(placed.pose);
}

InstantCentre centre_of(const std::vector<InstantCentre>& all, std::size_t first, std::size_t second) {
    for (const InstantCentre& one : all)
        if (one.first == first && one.second == second) return one;
    throw "no such pair";
}

/// In homogeneous coordinates, of length 1 for places of the linkage's size.
struct Homogeneous {
    double x, y, w;
};
Homogeneous homogeneous(const InstantCentre& centre, double size) {
    if (centre.kind == CentreKind::at_infinity) return {centre.at.x, centre.at.y, 0};
    const double x = centre.at.x / size, y = centre.at.y / size, length = std::hypot(x, y, 1.0);
    return {x / length, y / length, 1 / length};
}

double volume(const Homogeneous& a, const Homogeneous& b, const Homogeneous& c) {
    return a.x * (b.y * c.w - b.w * c.y) - a.y * (b.x * c.w - b.w * c.x) + a.w * (b.x * c.y - b.y * c.x);
}

/// Both links have one velocity at their centre, or all over; three links have theirs in line.
void expect_centres(const std::vector<LinkMotion>& motions, double size) {
    const std::vector<InstantCentre> all = linkage::instant_centres(motions);
    ASSERT_EQ(all.size(), motions.size() * (motions.size() - 1) / 2);
    for (const InstantCentre& one : all) {
        const LinkMotion &a = motions[one.first], &b = motions[one.second];
        if (one.kind == CentreKind::at_infinity) {
            EXPECT_NEAR(std::hypot(one.at.x, one.at.y), 1, 1e-14);
            const Vector<double> slip = a.velocity_at(b.at) - b.velocity;
            EXPECT_NEAR(dot(slip, one.at), 0, 1e-12 * std::hypot(slip.x, slip.y));
            EXPECT_GT(std::hypot(slip.x, slip.y), 0);
            continue;
        }
        ASSERT_EQ(one.kind, CentreKind::place) << one.first << one.second;
        const Vector<double> difference = a.velocity_at(one.at) - b.velocity_at(one.at);
        const double far = std::hypot(one.at.x, one.at.y) + size;
        EXPECT_NEAR(std::hypot(difference.x, difference.y), 0,
                    1e-13 * far * (std::abs(a.turning) + std::abs(b.turning) + 1));
    }
    for (std::size_t c = 2; c < motions.size(); ++c)
        for (std::size_t b = 1; b < c; ++b)
            for (std::size_t a = 0; a < b; ++a)
                EXPECT_NEAR(volume(homogeneous(centre_of(all, a, b), size), homogeneous(centre_of(all, a, c), size),
                                   homogeneous(centre_of(all, b, c), size)),
                            0, 1e-11)
                    << a << b << c;
}

/// Where two lines meet, each through two places.
Vector<double> meeting(const Vector<double>& a, const Vector<double>& b, const Vector<double>& c,
                       const Vector<double>& d) {
    const Vector<double> along = b - a, other = d - c;
    return a + (cross(c - a, other) / cross(along, other)) * along;
}

void expect_at(const InstantCentre& centre, const Vector<double>& at, double within) {
    ASSERT_EQ(centre.kind, CentreKind::place);
    EXPECT_NEAR(centre.at.x, at.x, within);
    EXPECT_NEAR(centre.at.y, at.y, within);
}

TEST(InstantCentres, OfAFourBarAreItsPinsAndWhereItsLinksMeet) {
    const FourBar<double> m{100, 40, 110, 80};
    const MadeLinkage made = four_bar_linkage(m);
    for (const std::int8_t side : {std::int8_t{1}, std::int8_t{-1}})
        for (const double angle : {20.0, 77.0, 150.0, 200.0, 311.0}) {
            const auto motions = motions_at(made, angle, std::vector<std::int8_t>{side});
            const auto all = linkage::instant_centres(motions);
            const auto p = pose(m, angle * degree, side > 0 ? Assembly::open : Assembly::crossed);
            const Vector<double> a{0, 0}, b = m.crank * p.crank, d{m.ground, 0}, c = d + m.rocker * p.rocker;
            expect_at(centre_of(all, 0, 1), a, 1e-12);
            expect_at(centre_of(all, 1, 2), b, 1e-12);
            expect_at(centre_of(all, 2, 3), c, 1e-10);
            expect_at(centre_of(all, 0, 3), d, 1e-10);
            const Vector<double> coupler = meeting(a, b, c, d), cranks = meeting(b, c, a, d);
            expect_at(centre_of(all, 0, 2), coupler, 1e-10 * (1 + std::hypot(coupler.x, coupler.y)));
            expect_at(centre_of(all, 1, 3), cranks, 1e-10 * (1 + std::hypot(cranks.x, cranks.y)));
            // The cranks turn as their distances from the centre of both, inversely.
            EXPECT_NEAR(motions[3].turning * (cranks.x - d.x), motions[1].turning * cranks.x,
                        1e-10 * std::abs(cranks.x));
        }
}

TEST(InstantCentres, OfASliderCrankHaveTheSlidesAtInfinity) {
    const SliderCrank<double> m{50, 120, 15};
    const MadeLinkage made = slider_crank_linkage(m);
    for (const double angle : {10.0, 95.0, 170.0, 290.0}) {
        const auto motions = motions_at(made, angle, std::vector<std::int8_t>{1});
        const auto all = linkage::instant_centres(motions);
        const auto p = pose(m, angle * degree);
        const Vector<double> b = m.crank * p.crank, c{p.position, m.offset};
        const InstantCentre slide = centre_of(all, 0, 3);
        ASSERT_EQ(slide.kind, CentreKind::at_infinity);
        EXPECT_NEAR(slide.at.x, 0, 1e-15);
        EXPECT_NEAR(std::abs(slide.at.y), 1, 1e-15);
        // Of the rod: on the crank's line, above the slider. Of crank and slider: where the rod meets the upright.
        expect_at(centre_of(all, 0, 2), meeting({0, 0}, b, c, c + Vector<double>{0, 1}), 1e-9);
        expect_at(centre_of(all, 1, 3), meeting(b, c, {0, 0}, {0, 1}), 1e-9);
        expect_centres(motions, 120);
    }
}

TEST(InstantCentres, OfThreeLinksAreInLine) {
    for (const double angle : {0.0, 90.0, 200.0})
        expect_centres(motions_at(jansen(), angle, sides_of(jansen(), {{"Y", -1}, {"W", 1}, {"U", -1}})), 60);
    for (const bool watt : {true, false})
        for (const double angle : {33.0, 185.0, 305.0})
            expect_centres(motions_at(six_bar(watt), angle, std::vector<std::int8_t>(2, 1)), 5);
}

TEST(InstantCentres, OfLinksThatMoveAlikeAreEverywhereOrNowhereNear) {
    // A parallelogram: its coupler moves along a circle without turning, as a second crank does alike.
    const MadeLinkage made = four_bar_linkage({100, 40, 100, 40});
    const auto all = linkage::instant_centres(motions_at(made, 70, std::vector<std::int8_t>{1}));
    EXPECT_EQ(centre_of(all, 1, 3).kind, CentreKind::at_infinity);
    const InstantCentre coupler = centre_of(all, 0, 2);
    ASSERT_EQ(coupler.kind, CentreKind::at_infinity);
    EXPECT_NEAR(std::abs(coupler.at.x), std::cos(70 * degree), 1e-12);  // along the cranks
    EXPECT_NEAR(std::abs(coupler.at.y), std::sin(70 * degree), 1e-12);
    std::vector<LinkMotion> alike{{{0, 0}, {0, 0}, 0}, {{1, 2}, {0.5, 0}, 1}, {{2, 2}, {0.5, 1}, 1}};
    EXPECT_EQ(centre_of(linkage::instant_centres(alike), 1, 2).kind, CentreKind::everywhere);
}

}  // namespace
}  // namespace mechwright::test
