// Interval arithmetic: results of random operations in fifty digits lie in the intervals.

#include "analysis/numbers/interval.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/mpfr.hpp>
#include <random>

namespace mechwright {

namespace {

using Precise = boost::multiprecision::mpfr_float_50;

struct Drawn {
    Interval interval;
    double point;  ///< in it
};

Drawn drawn(std::mt19937_64& random, double size) {
    std::uniform_real_distribution<double> place(-size, size), width(-12, 0), share(0, 1);
    const double low = place(random), high = low + size * std::pow(10, width(random));
    return {{low, high}, std::clamp(low + share(random) * (high - low), low, high)};
}

bool holds(const Interval& interval, const Precise& x) {
    return Precise(interval.low) <= x && x <= Precise(interval.high);
}

TEST(Interval, HoldsEveryResultOfItsOperations) {
    std::mt19937_64 random(1);
    for (int i = 0; i < 100000; ++i) {
        const double size = std::pow(10, static_cast<double>(i % 7) - 3);
        const Drawn a = drawn(random, size), b = drawn(random, size);
        const Precise x = a.point, y = b.point;
        EXPECT_TRUE(holds(a.interval + b.interval, x + y));
        EXPECT_TRUE(holds(a.interval - b.interval, x - y));
        EXPECT_TRUE(holds(-a.interval, -x));
        EXPECT_TRUE(holds(a.interval * b.interval, x * y));
        if (y != 0) {
            EXPECT_TRUE(holds(a.interval / b.interval, x / y));
        }
        EXPECT_TRUE(holds(square(a.interval), x * x));
        if (x >= 0) {
            EXPECT_TRUE(holds(sqrt(a.interval), sqrt(x)));
        }
        EXPECT_TRUE(holds(cos(a.interval), cos(x)));
        EXPECT_TRUE(holds(sin(a.interval), sin(x)));
        if (abs(x) <= 1) {
            EXPECT_TRUE(holds(acos(a.interval), acos(x)));
        }
    }
}

TEST(Interval, IsHardlyWiderThanItMustBe) {
    const Interval third = Interval(1) / Interval(3);
    EXPECT_LT(third.high - third.low, 1e-15);
    const Interval top = cos(Interval(-0.1, 0.2));
    EXPECT_EQ(top.high, 1);
    EXPECT_NEAR(top.low, std::cos(0.2), 1e-14);
    const Interval round = sin(Interval(0, 7));
    EXPECT_EQ(round.low, -1);
    EXPECT_EQ(round.high, 1);
    EXPECT_EQ(square(Interval(-2, 1)).low, 0);
}

TEST(Interval, DividedByOneThatHoldsZeroIsTheWholeLine) {
    EXPECT_EQ((Interval(1) / Interval(-1, 1)).high, std::numeric_limits<double>::infinity());
    EXPECT_EQ((Interval(1) / Interval(0, 1)).low, -std::numeric_limits<double>::infinity());
}

}  // namespace

}  // namespace mechwright
