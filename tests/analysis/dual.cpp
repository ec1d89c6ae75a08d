// First and second dual numbers against central differences in fifty digits: every operation of both.

#include "analysis/numbers/dual.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/second_dual.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

constexpr std::array<std::array<double, 2>, 4> points{{{0.7, 1.3}, {-1.9, 0.4}, {2.3, -0.8}, {-0.6, -1.7}}};

/// Two arguments that both depend on both variables, so that every mixed term counts.
template <class T>
T first_argument(const std::array<T, 2>& x) {
    return x[0] * x[0] * x[1] + x[0];
}

template <class T>
T second_argument(const std::array<T, 2>& x) {
    return x[1] * x[1] * x[1] - x[0] * x[1];
}

/// Checks f(a, b), given as a template, at all points: value, gradient, Hessian, each to a few roundings of its largest
/// entry; and that first and second dual numbers agree.
template <class Function>
void expect_exact_derivatives(const Function& f) {
    const auto of = [&](const auto& x) { return f(first_argument(x), second_argument(x)); };
    for (const auto& at : points) {
        const auto exact = central_differences<2>(of, precise(at), Precise(1));
        const auto dual = of(std::array{Dual<double, 2>::variable(at[0], 0), Dual<double, 2>::variable(at[1], 1)});
        const auto second =
            of(std::array{SecondDual<double, 2>::variable(at[0], 0), SecondDual<double, 2>::variable(at[1], 1)});
        const double value = static_cast<double>(exact.value);
        const double tolerance = 64 * std::numeric_limits<double>::epsilon();
        EXPECT_NEAR(dual.value, value, tolerance * std::abs(value));
        EXPECT_EQ(second.value, dual.value);
        double steepest = 0, bend = 0;
        for (std::size_t i = 0; i < 2; ++i) {
            steepest = std::max(steepest, static_cast<double>(abs(exact.gradient[i])));
            for (std::size_t j = 0; j < 2; ++j)
                bend = std::max(bend, static_cast<double>(abs(exact.hessian[i][j])));
        }
        for (std::size_t i = 0; i < 2; ++i) {
            EXPECT_NEAR(dual.partial[i], static_cast<double>(exact.gradient[i]), tolerance * steepest);
            EXPECT_NEAR(second.first[i], static_cast<double>(exact.gradient[i]), tolerance * steepest);
            for (std::size_t j = 0; j < 2; ++j)
                EXPECT_NEAR(second.mixed(i, j), static_cast<double>(exact.hessian[i][j]),
                            tolerance * std::max(bend, steepest));
        }
    }
}

TEST(DualNumbers, AddAndSubtract) {
    expect_exact_derivatives([](const auto& a, const auto& b) { return a + b; });
    expect_exact_derivatives([](const auto& a, const auto& b) { return a - b; });
    expect_exact_derivatives([](const auto& a, const auto& b) { return -a - (+b); });
}

TEST(DualNumbers, MultiplyByTheProductRule) {
    expect_exact_derivatives([](const auto& a, const auto& b) { return a * b; });
    expect_exact_derivatives([](const auto& a, const auto&) { return a * a; });
}

TEST(DualNumbers, DivideByTheQuotientRule) {
    expect_exact_derivatives([](const auto& a, const auto& b) { return a / b; });
    expect_exact_derivatives([](const auto& a, const auto& b) { return (a * b) / (a * a + b * b); });
}

TEST(DualNumbers, MixWithConstantsOnEitherSide) {
    expect_exact_derivatives([](const auto& a, const auto&) { return a + 2.5; });
    expect_exact_derivatives([](const auto& a, const auto&) { return 2.5 + a; });
    expect_exact_derivatives([](const auto& a, const auto&) { return a - 2.5; });
    expect_exact_derivatives([](const auto& a, const auto&) { return 2.5 - a; });
    expect_exact_derivatives([](const auto& a, const auto&) { return a * 2.5; });
    expect_exact_derivatives([](const auto& a, const auto&) { return 2.5 * a; });
    expect_exact_derivatives([](const auto& a, const auto&) { return a / 2.5; });
    expect_exact_derivatives([](const auto& a, const auto&) { return 2.5 / a; });
}

TEST(DualNumbers, UpdateInPlace) {
    expect_exact_derivatives([](auto a, const auto& b) { return a += b; });
    expect_exact_derivatives([](auto a, const auto& b) { return a -= b; });
    expect_exact_derivatives([](auto a, const auto& b) { return a *= b; });
    expect_exact_derivatives([](auto a, const auto& b) { return a /= b; });
}

TEST(DualNumbers, TakeSquareRoots) {
    expect_exact_derivatives([](const auto& a, const auto& b) {
        using std::sqrt;
        return sqrt(a * a + b * b * b * b + 0.25);
    });
}

TEST(DualNumbers, TakeSinesAndCosines) {
    expect_exact_derivatives([](const auto& a, const auto& b) {
        using std::cos, std::sin;
        return sin(a) * cos(b);
    });
    expect_exact_derivatives([](const auto& a, const auto&) {
        using std::cos;
        return cos(a);
    });
}

TEST(DualNumbers, TakeAbsoluteValues) {
    expect_exact_derivatives([](const auto& a, const auto& b) {
        using std::abs;
        return abs(a) + abs(b) * b;
    });
}

TEST(DualNumbers, TakeHypotenuses) {
    expect_exact_derivatives([](const auto& a, const auto& b) {
        using std::hypot;
        return hypot(a, b);
    });
}

TEST(DualNumbers, TakeDirectionAngles) {
    expect_exact_derivatives([](const auto& a, const auto& b) {
        using std::atan2;
        return atan2(a, b);
    });
}

TEST(DualNumbers, TakeDifferencesOfSums) {
    expect_exact_derivatives([](const auto& a, const auto& b) { return sum_difference(a, a * b, b, b * b); });
}

TEST(DualNumbers, CompareByValueAlone) {
    const auto x = Dual<double, 1>::variable(2, 0);
    const Dual<double, 1> constant(2);
    EXPECT_TRUE(x == constant);
    EXPECT_TRUE(x <= constant && x >= constant);
    EXPECT_FALSE(x < constant || x > constant);
    const auto y = SecondDual<double, 1>::variable(3, 0);
    const SecondDual<double, 1> three(3);
    EXPECT_TRUE(y == three && y <= three && y >= three);
    EXPECT_FALSE(y < three || y > three);
    EXPECT_EQ(value_of(x), 2);
    EXPECT_EQ(value_of(y), 3);
}

TEST(DualNumbers, KeepTheCompensatedValueOfADifferenceOfSums) {
    // 1 + 2^-60 - 1 - 2^-61: the plain sum gives zero.
    const double tiny = std::ldexp(1.0, -60);
    const std::array<double, 4> x{1.0, tiny, 1.0, tiny / 2};
    EXPECT_EQ(sum_difference(x[0], x[1], x[2], x[3]), tiny / 2);
    EXPECT_EQ(sum_difference(Dual<double, 1>(x[0]), {x[1]}, {x[2]}, {x[3]}).value, tiny / 2);
    EXPECT_EQ(sum_difference(SecondDual<double, 1>(x[0]), {x[1]}, {x[2]}, {x[3]}).value, tiny / 2);
}

/// Where a derivative does not exist every partial is zero, never infinite or NaN.
TEST(DualNumbers, HaveZeroPartialsWhereADerivativeDoesNotExist) {
    const auto x = Dual<double, 1>::variable(0, 0);
    EXPECT_EQ(sqrt(x).partial[0], 0);
    EXPECT_EQ(hypot(x, x).partial[0], 0);
    EXPECT_EQ(atan2(x, x).partial[0], 0);
    EXPECT_EQ(abs(x).value, 0);
    const auto y = SecondDual<double, 1>::variable(0, 0);
    for (const auto& f : {sqrt(y), hypot(y, y), atan2(y, y)}) {
        EXPECT_EQ(f.value, 0);
        EXPECT_EQ(f.first[0], 0);
        EXPECT_EQ(f.second[0], 0);
    }
}

TEST(DualNumbers, StaySmoothWhereOnlyOneArgumentIsZero) {
    const auto x = SecondDual<double, 2>::variable(0, 0);
    const auto y = SecondDual<double, 2>::variable(2, 1);
    const auto h = hypot(x, y);  // h_xx = 1 / 2, all else as for y alone
    EXPECT_EQ(h.first[0], 0);
    EXPECT_EQ(h.first[1], 1);
    EXPECT_EQ(h.mixed(0, 0), 0.5);
    EXPECT_EQ(h.mixed(1, 0), 0);
    EXPECT_EQ(h.mixed(1, 1), 0);
    const auto angle = atan2(x, y);
    EXPECT_EQ(angle.first[0], 0.5);
    EXPECT_EQ(angle.mixed(0, 1), -0.25);
}

}  // namespace
}  // namespace mechwright::test
