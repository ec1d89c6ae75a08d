// Finding the stationary points of a measure, and the derivatives of its extreme value.

#include "analysis/numbers/extremes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/quick_return.h"
#include "analysis/quick_return/extremes.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

template <class Function>
std::vector<double> zeros_of(const Function& g, const std::vector<double>& grid) {
    std::vector<double> zeros;
    zeros_on_grid(g, std::span<const double>(grid), [&](double x) { zeros.push_back(x); });
    return zeros;
}

std::vector<double> steps(double from, double to, int count) {
    std::vector<double> grid;
    for (int i = 0; i <= count; ++i)
        grid.push_back(from + (to - from) * i / count);
    return grid;
}

TEST(ZeroBetween, IsExactToRounding) {
    const auto g = [](double x) { return std::cos(x) - x; };
    EXPECT_NEAR(zero_between<double>(g, 0, 1, g(0), g(1)), 0.73908513321516064166, 2e-16);  // the Dottie number
    const auto cube = [](double x) { return x * x * x - 2; };
    EXPECT_DOUBLE_EQ(zero_between<double>(cube, -3, 4, cube(-3), cube(4)), std::cbrt(2.0));
}

TEST(ZeroBetween, WorksInFiftyDigits) {
    const auto g = [](const Precise& x) { return Precise(x * x - 2); };
    const Precise root = zero_between<Precise>(g, Precise(1), Precise(2), g(Precise(1)), g(Precise(2)));
    EXPECT_LT(abs(root - sqrt(Precise(2))), Precise(1e-48));
}

TEST(ZeroBetween, EndsWhereTheZeroIsAtZero) {
    // No relative rounding is reached there: the search must stop all the same.
    int evaluations = 0;
    const auto g = [&](double x) {
        ++evaluations;
        return x > 0 ? 1.0 : -2.0;
    };
    EXPECT_NEAR(zero_between<double>(g, -1, 1.5, g(-1), g(1.5)), 0, 1e-30);
    EXPECT_LT(evaluations, 200);
}

TEST(ZeroBetween, FindsJumpsAndSteepZeros) {
    const auto steep = [](double x) { return std::tanh(1e9 * (x - 0.3)); };
    EXPECT_NEAR(zero_between<double>(steep, 0, 1, steep(0), steep(1)), 0.3, 1e-16);
    const auto flat = [](double x) { return std::pow(x - 0.3, 9); };
    EXPECT_NEAR(zero_between<double>(flat, 0, 1, flat(0), flat(1)), 0.3, 1e-15);
}

TEST(ZerosOnGrid, AreAllFoundInOrder) {
    const auto zeros = zeros_of([](double x) { return std::sin(x); }, steps(0.5, 10, 12));
    ASSERT_EQ(zeros.size(), 3u);
    for (std::size_t k = 0; k < 3; ++k)
        EXPECT_DOUBLE_EQ(zeros[k], static_cast<double>(k + 1) * std::numbers::pi);
}

TEST(ZerosOnGrid, AreReportedOnceWhereTheyFallOnPoints) {
    const auto g = [](double x) { return x * (x - 1) * (x - 3); };
    EXPECT_EQ(zeros_of(g, {0, 0.5, 1, 2, 3}), (std::vector<double>{0, 1, 3}));
    EXPECT_EQ(zeros_of(g, {0}), (std::vector<double>{0}));
    EXPECT_TRUE(zeros_of(g, {}).empty());
}

TEST(ZerosOnGrid, ComeInPairsWhereTheFunctionDipsBetweenPoints) {
    for (const double depth : {1e-1, 1e-3, 1e-6, 1e-10}) {
        const auto g = [&](double x) { return std::cosh(x - 0.37) - 1 - depth; };
        const auto zeros = zeros_of(g, steps(-4, 4, 7));
        ASSERT_EQ(zeros.size(), 2u) << depth;
        const double half = std::acosh(1 + depth);
        EXPECT_NEAR(zeros[0], 0.37 - half, 1e-6 * half) << depth;
        EXPECT_NEAR(zeros[1], 0.37 + half, 1e-6 * half) << depth;
    }
}

/// Four zeros of which two make a sign change that can be seen, and two do not.
TEST(ZerosOnGrid, ComeInPairsBesideOtherZeros) {
    int checked = 0;
    const auto check = [&](std::array<double, 4> all) {
        std::sort(all.begin(), all.end());
        const auto in_step_of = [&](double x) {
            return std::count_if(all.begin(), all.end(), [x](double y) { return std::floor(x) == std::floor(y); });
        };
        if (std::none_of(all.begin(), all.end(), [&](double x) { return in_step_of(x) % 2 == 1; })) return;
        const auto g = [&](double x) {
            return (x - all[0]) * (x - all[1]) * (x - all[2]) * (x - all[3]) * std::exp(0.2 * x);
        };
        ++checked;
        const auto zeros = zeros_of(g, steps(-5, 5, 10));
        ASSERT_EQ(zeros.size(), 4u) << all[0] << ' ' << all[1] << ' ' << all[2] << ' ' << all[3];
        for (std::size_t i = 0; i < 4; ++i)
            EXPECT_NEAR(zeros[i], all[i], 1e-10);
    };
    for (const double gap : {0.9, 0.3, 1e-2, 1e-4})
        for (const double centre : {0.02, 0.31, 0.5, 0.97})
            for (double first = -3; first < 3; first += 0.23)
                for (double second = first + 0.17; second < 3; second += 0.31)
                    check({centre - gap / 2, centre + gap / 2, first, second});
    EXPECT_GT(checked, 2000);
}

TEST(ZerosOnGrid, AreNotInventedWhereTheFunctionOnlyDips) {
    int evaluations = 0;
    const auto g = [&](double x) {
        ++evaluations;
        return std::cosh(x - 0.37) - 0.999;
    };
    EXPECT_TRUE(zeros_of(g, steps(-4, 4, 7)).empty());
    EXPECT_LT(evaluations, 20);
    EXPECT_TRUE(zeros_of([](double) { return 1.0; }, steps(-4, 4, 7)).empty());
}

TEST(ZerosOnGrid, AreNotSeenWhereTheFunctionIsNotFinite) {
    EXPECT_TRUE(zeros_of([](double x) { return 1 / x; }, {0, 1, 2}).empty());
    EXPECT_TRUE(zeros_of([](double x) { return -std::sqrt(1 - x * x); }, {-1.5, 0, 0.5, 1.5}).empty());
    EXPECT_EQ(zeros_of([](double x) { return 1 / x - 1; }, {0, 0.75, 2}).size(), 1u);
}

TEST(StationaryValue, HasTheDerivativesOfTheExtremeItself) {
    // f(p, q, z) = p z - q z^2 / 2 + p^2 q + z^3 / 8 - q z^3 / 16: stationary in z at a z that depends on p and q.
    const auto f = [](const auto& p, const auto& q, const auto& z) {
        return p * z - q * z * z * 0.5 + p * p * q + z * z * z / 8.0 - z * z * z * q / 16.0;
    };
    const auto slope = [](const auto& p, const auto& q, const auto& z) {
        return p - q * z + z * z * 0.375 - z * z * q * 0.1875;
    };
    const auto extreme = [&](const Point<2>& x) {
        Precise z(1);
        for (int k = 0; k < 12; ++k)
            z -= slope(x[0], x[1], z) / (-x[1] + z * 0.75 - z * x[1] * 0.375);
        return Precise(f(x[0], x[1], z));
    };
    const std::array<double, 2> at{0.9, 1.7};
    const auto exact = central_differences<2>(extreme, precise(at), Precise(1));

    double z = 1;
    for (int k = 0; k < 12; ++k)
        z -= slope(at[0], at[1], z) / (-at[1] + z * 0.75 - z * at[1] * 0.375);
    using Wide = SecondDual<double, 3>;
    const auto value = stationary_value(f(Wide::variable(at[0], 0), Wide::variable(at[1], 1), Wide::variable(z, 2)));
    EXPECT_NEAR(value.value, static_cast<double>(exact.value), 1e-15);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_NEAR(value.first[i], static_cast<double>(exact.gradient[i]), 1e-14);
        for (std::size_t j = 0; j < 2; ++j)
            EXPECT_NEAR(value.mixed(i, j), static_cast<double>(exact.hessian[i][j]), 1e-13);
    }
}

TEST(StationaryValue, OfWhatDoesNotChangeAlongTheMotionIsThatOfAnyPlace) {
    using Wide = SecondDual<double, 2>;
    const Wide p = Wide::variable(0.7, 0), z = Wide::variable(0.3, 1);
    for (const Wide& along : {Wide(z * 0.0), Wide(z * z * 1e-17)}) {  // nothing, and what rounding makes of nothing
        const auto value = stationary_value(Wide(p * p * p + along * p));
        EXPECT_NEAR(value.value, 0.343, 1e-15);
        EXPECT_NEAR(value.first[0], 1.47, 1e-15);
        EXPECT_NEAR(value.mixed(0, 0), 4.2, 1e-14);
    }
}

/// Four extremes of its ram's acceleration are within 0.3 of the place where its slotted arm is fast and 0.1 from where
/// its rod stands nearly square to the arm; two of them between signs of the jerk that a coarse grid saw alike.
/// Whatever is found, no fewer can there be than changes of sign of the jerk on a fine scan.
TEST(RamExtremes, CloseToTwoFastPlacesAreAllFound) {
    const Whitworth<double> m{1.0000000000000006e-05, 1.1337905825838847e-05, 1.0000000000000006e-05,
                              1.0101106493644107e-05, 0.33192437008862319};
    const double turn = 2 * std::numbers::pi;
    std::vector<double> scanned;
    bool before = ram_jerk(m, 0.0) > 0;
    for (int i = 1; i <= 4000; ++i) {
        const bool now = ram_jerk(m, turn * i / 4000) > 0;
        if (now != before) scanned.push_back(turn * i / 4000);
        before = now;
    }
    ASSERT_EQ(scanned.size(), 8u);
    const RamExtremes found = ram_acceleration_extremes(m, {true, 0, turn});
    ASSERT_EQ(found.count, 8u);
    for (std::size_t i = 0; i < 8; ++i) {
        EXPECT_LT(found.at[i], scanned[i]);
        EXPECT_GT(found.at[i], scanned[i] - turn / 4000);
    }
}

/// Near a ratio of 1 : 4 of crank to rod three extremes of the ram's acceleration are close together at its inner dead
/// centre, where the outer two part from the middle one: that is at pi, the slide being on the crank pivot.
TEST(RamExtremes, ThreeAtADeadCentreAreAllFound) {
    const SliderCrank<double> m{0.053751878222889647, 0.20366576019380325, 0};
    const RamExtremes found = ram_acceleration_extremes(m, {true, 0, 2 * std::numbers::pi});
    ASSERT_EQ(found.count, 4u);
    EXPECT_NEAR(found.at[0], 0, 1e-15);
    EXPECT_DOUBLE_EQ(found.at[2], std::numbers::pi);
    EXPECT_NEAR(found.at[1] + found.at[3], 2 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(found.at[3], 3.1801, 1e-4);
}

}  // namespace
}  // namespace mechwright::test
