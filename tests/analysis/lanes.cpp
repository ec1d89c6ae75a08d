// Lanes hold the bits of plain double arithmetic, whatever their number and whatever instruction set does the work.

#include "analysis/numbers/lanes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/four_bar/path/screening.h"
#include "tests/analysis/random_linkages.h"

namespace mechwright::test {
namespace {

template <class T>
class LanesOf : public ::testing::Test {};

using Widths = ::testing::Types<Lanes<2>, Lanes<4>, Lanes<8>, Lanes<4, 2>, Lanes<8, 2>>;
TYPED_TEST_SUITE(LanesOf, Widths);

TYPED_TEST(LanesOf, CalculateLikePlainNumbers) {
    Random random(1);
    TypeParam a;
    TypeParam b;
    for (std::size_t i = 0; i < a.lane.size(); ++i) {
        a.lane[i] = random.between(-2, 2);
        b.lane[i] = random.between(-2, 2);
    }
    const TypeParam sum = a + b, difference = a - b, product = a * b, quotient = a / b, negative = -a, size = abs(a),
                    root = root_or_zero(a), long_side = hypotenuse(a, b), least = select(a < b, a, b),
                    at_least = select(a >= b, a, b);
    for (std::size_t i = 0; i < a.lane.size(); ++i) {
        const double x = a.lane[i], y = b.lane[i];
        EXPECT_EQ(sum.lane[i], x + y);
        EXPECT_EQ(difference.lane[i], x - y);
        EXPECT_EQ(product.lane[i], x * y);
        EXPECT_EQ(quotient.lane[i], x / y);
        EXPECT_EQ(negative.lane[i], -x);
        EXPECT_EQ(size.lane[i], std::abs(x));
        EXPECT_EQ(root.lane[i], x > 0 ? std::sqrt(x) : 0);
        EXPECT_EQ(long_side.lane[i], hypotenuse(x, y));
        EXPECT_EQ(least.lane[i], x < y ? x : y);
        EXPECT_EQ(at_least.lane[i], x >= y ? x : y);
    }
}

struct Candidates {
    std::vector<FourBarGroup> groups;
    explicit Candidates(std::size_t count) : groups(count) {
        Random random(2);
        for (FourBarGroup& g : groups)
            for (std::size_t lane = 0; lane < 8; ++lane) {
                const auto m = turning_linkage(random, 1e-9);
                const std::array<double, 4> links{m.ground, m.crank, m.coupler, m.rocker};
                for (std::size_t i = 0; i < 4; ++i)
                    g.links[i][lane] = links[i];
                g.along[lane] = random.between(-1, 1);
                g.across[lane] = random.between(-1, 1);
            }
    }
};

class EveryInstructionSet : public ::testing::TestWithParam<InstructionSet> {
protected:
    void SetUp() override {
        if (!is_available(GetParam())) GTEST_SKIP() << "this processor does not have it";
    }
};

TEST_P(EveryInstructionSet, GivesTheCouplerPointsOfPlainNumbersToTheLastBit) {
    const Candidates all(500);
    std::vector<PointGroup> points(all.groups.size());
    for (const double angle : {0.0, 0.4, 2.0, 3.14159, 5.5})
        for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
            const HalfTurn<double> half = half_turn(angle);
            coupler_points(GetParam(), assembly, all.groups, half, points);
            for (std::size_t g = 0; g < all.groups.size(); ++g)
                for (std::size_t lane = 0; lane < 8; ++lane) {
                    const auto& m = all.groups[g].links;
                    const FourBar<double> links{m[0][lane], m[1][lane], m[2][lane], m[3][lane]};
                    const CouplerPoint<double> point{all.groups[g].along[lane], all.groups[g].across[lane]};
                    const auto expected = position(links, point, pose(links, half, assembly));
                    ASSERT_EQ(points[g].x[lane], expected.x);
                    ASSERT_EQ(points[g].y[lane], expected.y);
                }
        }
}

/// Points that a linkage passes, turned, made larger and moved: nothing is left of them, and the size is found.
TEST_P(EveryInstructionSet, ScreensALinkageThatPassesThePoints) {
    const Candidates all(40);
    for (const FourBarGroup& g : all.groups) {
        const FourBar<double> links{g.links[0][3], g.links[1][3], g.links[2][3], g.links[3][3]};
        std::vector<ScreenedPoint> points;
        for (int i = 0; i < 12; ++i) {
            const double angle = 0.3 + i * 0.4;
            const auto half = half_turn(angle);
            const auto p =
                position(links, CouplerPoint<double>{g.along[3], g.across[3]}, pose(links, half, Assembly::open));
            const Vector<double> placed = Vector<double>{5, -2} + turned(p, {3 * std::cos(0.7), 3 * std::sin(0.7)});
            points.push_back({placed, 1.0 + i % 3, {half.cosine, half.sine}});
        }
        const Screened free = four_bar_screening(GetParam(), 0, g.links, points, {true, true, true});
        EXPECT_LT(std::abs(free.score[3]), 1e-9);
        EXPECT_NEAR(free.size[3], 3, 1e-6);
        const Screened given_tilt =
            four_bar_screening(GetParam(), 0, g.links, points, {true, true, false, {std::cos(0.7), std::sin(0.7)}});
        EXPECT_LT(std::abs(given_tilt.score[3]), 1e-9);
        EXPECT_NEAR(given_tilt.size[3], 3, 1e-6);
        // At half the size something is left: the screening that must not choose it sees more than the one that may.
        const Screened given_size = four_bar_screening(GetParam(), 0, g.links, points, {true, false, true});
        EXPECT_GE(given_size.score[3], free.score[3]);
        EXPECT_EQ(given_size.size[3], 1);
    }
}

TEST_P(EveryInstructionSet, ScreensWithTheSameDigits) {
    const Candidates all(100);
    std::vector<ScreenedPoint> points;
    for (int i = 0; i < 18; ++i) {
        const auto half = half_turn(0.35 * i);
        points.push_back({{std::cos(0.35 * i), 0.6 * std::sin(0.5 * i)}, 1, {half.cosine, half.sine}});
    }
    for (const FourBarGroup& g : all.groups)
        for (const std::size_t assembly : {0u, 1u}) {
            const Screened expected =
                four_bar_screening(InstructionSet::baseline, assembly, g.links, points, {true, true, true});
            const Screened here = four_bar_screening(GetParam(), assembly, g.links, points, {true, true, true});
            EXPECT_EQ(here.score, expected.score);
            EXPECT_EQ(here.size, expected.size);
        }
}

INSTANTIATE_TEST_SUITE_P(Screening, EveryInstructionSet,
                         ::testing::Values(InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512));

}  // namespace
}  // namespace mechwright::test
