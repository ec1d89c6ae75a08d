// Functions sampled in panels: their zeros and integrals against closed forms.

#include "analysis/numbers/resolved.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace mechwright::test {
namespace {

template <class Function>
std::vector<double> zeros_in(const Function& g, double from, double to, std::size_t first = 1) {
    std::vector<double> zeros;
    Panels(g, from, to, {.first = first}).zeros(g, [&](double s) { zeros.push_back(s); });
    return zeros;
}

template <class Function>
double integral_of(const Function& f, const Stretch& stretch) {
    return Panels([&](double s) { return f(stretch.at(s)) * stretch.speed(s); }, 0, 1, {.within = 1e-14}).integral();
}

TEST(Resolved, ZerosAreAllFound) {
    const auto zeros = zeros_in([](double x) { return std::sin(x * x); }, 0.5, 12);
    ASSERT_EQ(zeros.size(), 45u);
    for (std::size_t k = 0; k < zeros.size(); ++k)
        EXPECT_NEAR(zeros[k], std::sqrt(static_cast<double>(k + 1) * std::numbers::pi), 2e-15);
}

TEST(Resolved, PairsOfZerosAreFoundHoweverClose) {
    for (const double half : {1e-1, 1e-3, 1e-5})
        for (const double middle : {0.1234, 3.0, 5.1}) {
            const auto g = [&](double x) { return (std::cos(half) - std::cos(x - middle)) * (2 + std::sin(3 * x)); };
            const auto zeros = zeros_in(g, 0, 6.25, 6);
            ASSERT_EQ(zeros.size(), 2u) << half << ' ' << middle;
            EXPECT_NEAR(zeros[0], middle - half, 1e-16 / half + 1e-15);
            EXPECT_NEAR(zeros[1], middle + half, 1e-16 / half + 1e-15);
        }
}

TEST(Resolved, ThreeZerosAreFoundHoweverClose) {
    for (const double half : {1e-1, 3e-2, 1e-2, 3e-3, 1e-3, 1e-4})
        for (double middle = 3; middle < 3.5; middle += 0.0123) {
            const auto g = [&](double x) {
                return (std::cos(half) - std::cos(x - middle)) * std::sin(x - middle - 0.1 * half);
            };
            const auto slope = [&](double x) {
                return std::sin(x - middle) * std::sin(x - middle - 0.1 * half) +
                       (std::cos(half) - std::cos(x - middle)) * std::cos(x - middle - 0.1 * half);
            };
            std::vector<double> zeros;
            Panels(g, 1.3, 4.7, {.first = 3}).zeros(g, slope, [&](double x) { zeros.push_back(x); });
            ASSERT_EQ(zeros.size(), 3u) << half << ' ' << middle;
            EXPECT_NEAR(zeros[0], middle - half, 1e-16 / half + 1e-15);
            EXPECT_NEAR(zeros[1], middle + 0.1 * half, 1e-16 / half + 1e-15);
            EXPECT_NEAR(zeros[2], middle + half, 1e-16 / half + 1e-15);
        }
}

TEST(Resolved, SteepPlacesAreSampledFinely) {
    // A flip of half a turn, as a link makes that passes close by a change point: its slope has a pole at 2 + i width.
    for (const double width : {1e-2, 1e-4, 1e-6}) {
        const auto g = [&](double x) { return std::atan((x - 2) / width) + 0.3 * std::sin(x); };
        const auto zeros = zeros_in(g, 0, 6, 6);
        ASSERT_EQ(zeros.size(), 1u);
        EXPECT_NEAR(g(zeros[0]), 0, 1e-9);
    }
}

TEST(Resolved, SharesOfAStretchAreThoseOfItsPlaces) {
    for (const bool first : {false, true})
        for (const bool last : {false, true}) {
            const Stretch stretch{-1.5, 2.5, first, last};
            for (const double share : {0.0, 1e-6, 1e-3, 0.2, 0.5, 0.7, 0.999, 1.0})
                EXPECT_NEAR(stretch.share_of(stretch.at(share)), share, 1e-9) << first << last;
        }
}

TEST(Resolved, IntegralsAreExactToRounding) {
    EXPECT_NEAR(integral_of([](double x) { return std::exp(x); }, {0, 3}), std::exp(3) - 1, 2e-14);
    EXPECT_NEAR(integral_of([](double x) { return 1 / (1 + 1e4 * x * x); }, {-1, 2}),
                (std::atan(200) + std::atan(100)) / 100, 1e-16);
    // Half a circle has roots at both ends, a parabola on its side at one.
    EXPECT_NEAR(integral_of([](double x) { return std::sqrt((x - 1) * (3 - x)); }, {1, 3, true, true}),
                std::numbers::pi / 2, 1e-15);
    EXPECT_NEAR(integral_of([](double x) { return std::sqrt(4 - x); }, {0, 4, false, true}), 16.0 / 3, 2e-15);
    EXPECT_NEAR(integral_of([](double x) { return std::abs(x - 0.7); }, {0, 1}), 0.29, 1e-14);
}

/// Between the last node of a panel and its end a kink changes no value at a node, but where its neighbour leads to.
TEST(Resolved, KinksBesideEndsOfPanelsAreNoneOfAnIntegral) {
    for (double off = 1e-3; off > 1e-7; off *= 0.3)
        for (const double kink : {0.5 - off, 0.5 + off, 0.375 + off / 3}) {
            const Panels panels([&](double x) { return std::abs(x - kink); }, 0, 1,
                                {.within = 1e-14, .continuous = true});
            EXPECT_NEAR(panels.integral(), (kink * kink + (1 - kink) * (1 - kink)) / 2, 1e-14) << kink;
        }
    const Panels at_ends([](double x) { return std::abs(x - 2e-4); }, 0, 1, {.within = 1e-14, .at_ends = true});
    EXPECT_NEAR(at_ends.integral(), (2e-4 * 2e-4 + (1 - 2e-4) * (1 - 2e-4)) / 2, 1e-14);
}

}  // namespace
}  // namespace mechwright::test
