// The extremes of a structural error along its range.

#include <gtest/gtest.h>

#include "synthesis/mechanism/function_formulas.h"

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

}  // namespace

}  // namespace mechwright
