// Truncated Taylor series against closed forms and differences in fifty digits.

#include "analysis/numbers/series.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "analysis/geometry/half_angle.h"
#include "analysis/numbers/dual.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

using Series4 = Series<double, 4>;

/// A formula with every operation that the analysis uses.
template <class T>
T everything(const T& x) {
    using std::abs, std::atan2, std::cos, std::sin, std::sqrt;
    const T s = sin(x), c = cos(x);
    const T d = hypotenuse(T(T(2) + c), T(T(0.3) * s));
    const T root = root_or_zero(T(d * (T(4) - d)));
    return atan2(root, T(s - c)) / (T(1) + abs(s)) - select(d > c, T(sqrt(d)), d) * T(0.5);
}

TEST(Series, HasTheDerivativesOfElementaryFunctions) {
    const double x = 0.7;
    const Series4 v = Series4::variable(x);
    const auto expect = [](const Series4& s, const std::array<double, 5>& exact) {
        for (std::size_t k = 0; k <= 4; ++k)
            EXPECT_NEAR(s.derivative(k), exact[k], 4e-15 * (1 + std::abs(exact[k]))) << k;
    };
    expect(sin(v), {std::sin(x), std::cos(x), -std::sin(x), -std::cos(x), std::sin(x)});
    expect(cos(v), {std::cos(x), -std::sin(x), -std::cos(x), std::sin(x), std::cos(x)});
    expect(Series4(1) / v, {1 / x, -1 / (x * x), 2 / (x * x * x), -6 / std::pow(x, 4), 24 / std::pow(x, 5)});
    expect(sqrt(v), {std::sqrt(x), 0.5 * std::pow(x, -0.5), -0.25 * std::pow(x, -1.5), 0.375 * std::pow(x, -2.5),
                     -0.9375 * std::pow(x, -3.5)});
    // hypot(x, 1) = h: x / h, 1 / h^3, -3 x / h^5, (12 x^2 - 3) / h^7
    const double h = std::hypot(x, 1);
    expect(hypot(v, Series4(1)),
           {h, x / h, std::pow(h, -3), -3 * x * std::pow(h, -5), (12 * x * x - 3) * std::pow(h, -7)});
    expect(atan2(sin(v), cos(v)), {x, 1, 0, 0, 0});
    expect(atan2(sin(v), -cos(v)), {std::numbers::pi - x, -1, 0, 0, 0});
    expect(abs(-v), {x, 1, 0, 0, 0});
    expect(slope_of(v * v * v), {3 * x * x, 6 * x, 6, 0, 0});
    // A variable that grows by 3 while the true one grows by 1.
    expect(sin(Series4::variable(x, 3)),
           {std::sin(x), 3 * std::cos(x), -9 * std::sin(x), -27 * std::cos(x), 81 * std::sin(x)});
}

TEST(Series, HasTheDerivativesThatFiftyDigitsDifferencesHave) {
    for (const double x : {-2.5, -0.4, 0.3, 1.1, 2.9}) {
        const Series<double, 6> s = everything(Series<double, 6>::variable(x));
        const Series<Precise, 6> exact = everything(Series<Precise, 6>::variable(Precise(x)));
        EXPECT_EQ(value_of(s), s.c[0]);
        const Precise h("1e-6");
        std::array<Precise, 9> f;
        for (int i = 0; i < 9; ++i)
            f[static_cast<std::size_t>(i)] = everything(Precise(x + (i - 4) * h));
        // Central differences of order h^8, h^8, h^6, h^6 (Fornberg's weights).
        const auto difference = [&](std::array<int, 9> weights, int denominator, int order) {
            Precise sum(0);
            for (std::size_t i = 0; i < 9; ++i)
                sum += weights[i] * f[i];
            return Precise(sum / (denominator * pow(h, order)));
        };
        const std::array<Precise, 5> differences{
            f[4], difference({3, -32, 168, -672, 0, 672, -168, 32, -3}, 840, 1),
            difference({-9, 128, -1008, 8064, -14350, 8064, -1008, 128, -9}, 5040, 2),
            difference({-7, 72, -338, 488, 0, -488, 338, -72, 7}, 240, 3),
            difference({7, -96, 676, -1952, 2730, -1952, 676, -96, 7}, 240, 4)};
        for (std::size_t k = 0; k <= 4; ++k) {
            EXPECT_LT(abs(exact.derivative(k) - differences[k]), Precise("1e-24") * (1 + abs(differences[k]))) << k;
            EXPECT_NEAR(s.derivative(k), static_cast<double>(differences[k]),
                        1e-13 * (1 + std::abs(static_cast<double>(differences[k]))))
                << k;
        }
    }
}

TEST(Series, CarriesPartialDerivatives) {
    // f(p, x) = sqrt(p + sin(p x)): d/dp of the derivatives by x, against fifty digits.
    using Partial = Dual<double, 1>;
    const auto f = []<class T>(const T& p, const T& x) {
        using std::sin, std::sqrt;
        return T(sqrt(T(p + sin(T(p * x)))));
    };
    const double p = 1.3, x = 0.4;
    using Both = Series<Partial, 3>;
    const Both s = f(Both(Partial::variable(p, 0)), Both::variable(Partial(x)));
    using Exact = Series<Precise, 3>;
    const Precise h("1e-20");
    const Exact up = f(Exact(Precise(p) + h), Exact::variable(Precise(x)));
    const Exact down = f(Exact(Precise(p) - h), Exact::variable(Precise(x)));
    for (std::size_t k = 0; k <= 3; ++k)
        EXPECT_NEAR(s.derivative(k).partial[0], static_cast<double>((up.derivative(k) - down.derivative(k)) / (2 * h)),
                    2e-14)
            << k;
    EXPECT_EQ(value_of(s), s.c[0].value);
}

TEST(Series, HasNoDerivativesWhereThereAreNone) {
    const Series4 zero = Series4::variable(0.0);
    for (const Series4& s : {root_or_zero(zero), hypot(zero, Series4(0)), atan2(zero, Series4(0))})
        for (const double c : s.c)
            EXPECT_EQ(c, 0);
    EXPECT_EQ(root_or_zero(Series4::variable(-1.0)).c[1], 0);
}

}  // namespace
}  // namespace mechwright::test
