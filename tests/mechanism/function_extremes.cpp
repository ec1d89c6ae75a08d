// The extremes of a structural error along its range.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "synthesis/target/function/formulas.h"

namespace mechwright {

namespace {

/// A generator whose error has the slope (share - x0) (share - x1).
struct TwoExtremes {
    static constexpr std::size_t reads = 2;
    template <class T>
    static T error(const std::array<T, 2>& x, std::size_t, const T& share, const T&) {
        return share * (share * share / 3.0 - (x[0] + x[1]) / 2.0 * share + x[0] * x[1]);
    }
};

void expect_extremes(double first, double second) {
    const auto found = error_extremes<TwoExtremes>(nullptr, {first, second}, 0);
    ASSERT_EQ(found.size(), 4u) << first << " " << second;
    const double expected[] = {0, first, second, 1};
    for (std::size_t i = 0; i < found.size(); ++i) {
        EXPECT_NEAR(found[i].share, expected[i], 1e-12);
        EXPECT_EQ(found[i].stationary, i == 1 || i == 2);
    }
}

TEST(FunctionExtremes, AreFoundFarApart) { expect_extremes(0.21, 0.77); }

TEST(FunctionExtremes, AreFoundCloserThanASampleToTheNext) {
    expect_extremes(0.502, 0.505);
    expect_extremes(0.5039, 0.5040);
}

TEST(FunctionExtremes, AtAnEndAreThatEnd) {
    const auto found = error_extremes<TwoExtremes>(nullptr, {0, 0.4}, 0);
    ASSERT_EQ(found.size(), 3u);
    EXPECT_EQ(found[0].share, 0);
    EXPECT_NEAR(found[1].share, 0.4, 1e-12);
    EXPECT_EQ(found[2].share, 1);
}

/// A generator that is off by an angle that grows to x0 + x1 in the middle of the range, from x0 at its ends.
struct Bulge {
    static constexpr std::size_t reads = 2;
    static constexpr bool wraps = true;
    template <class T>
    static T error(const std::array<T, 2>& x, std::size_t, const T& share, const T&) {
        using std::atan2, std::cos, std::sin;
        const T angle = x[0] + 4.0 * x[1] * share * (1.0 - share);
        return atan2(T(sin(angle)), T(cos(angle)));
    }
};

/// Half a turn is reached at the share s with 4 growth s (1 - s) = pi - at_ends, and once more at 1 - s.
void expect_half_turn(double at_ends, double growth) {
    const double s = 0.5 - std::sqrt(0.25 - (std::numbers::pi - at_ends) / (4 * growth));
    std::vector<double> half_turns;
    for (const ErrorExtreme& e : error_extremes<Bulge>(nullptr, {at_ends, growth}, 0))
        if (!e.stationary && std::abs(std::abs(e.error) - std::numbers::pi) < 1e-12) half_turns.push_back(e.share);
    ASSERT_GE(half_turns.size(), 2u);
    EXPECT_NEAR(*std::min_element(half_turns.begin(), half_turns.end()), s, 1e-12);
    EXPECT_NEAR(*std::max_element(half_turns.begin(), half_turns.end()), 1 - s, 1e-12);
}

TEST(FunctionExtremes, AreHalfATurnWhereTheErrorJumps) {
    expect_half_turn(2.5, 1.5);
    expect_half_turn(0.5, 5.0);
}

TEST(FunctionExtremes, AreHalfATurnWhereTheErrorJumpsAndComesBackWithinOneStep) {
    expect_half_turn(3.0, std::numbers::pi - 3.0 + 1e-6);
    expect_half_turn(2.0, std::numbers::pi - 2.0 + 1e-7);
}

TEST(FunctionExtremes, OfAnAngleBelowHalfATurnAreAsOfAnyOther) {
    EXPECT_EQ(error_extremes<Bulge>(nullptr, {1.0, 2.0}, 0).size(), 3u);
}

}  // namespace

}  // namespace mechwright
