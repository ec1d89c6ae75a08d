// Poses in first-order dual numbers: what follows from the turns of the links against what the formulas give in dual
// numbers themselves, and the value's bits.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

#include "analysis/four_bar.h"
#include "analysis/slider_crank.h"

namespace mechwright::testing {

namespace {

/// Random lengths between 0.5 and 2.5 as the first variables, a crank angle as the last.
template <std::size_t N>
std::array<Dual<double, N>, N> random_variables(std::mt19937& random) {
    std::uniform_real_distribution<double> length(0.5, 2.5), angle(-3.1, 3.1);
    std::array<Dual<double, N>, N> x;
    for (std::size_t i = 0; i < N; ++i)
        x[i] = Dual<double, N>::variable(i + 1 < N ? length(random) : angle(random), i);
    return x;
}

/// The same value, and derivatives that differ by rounding, which a toggle close by makes greater.
template <std::size_t N>
void expect_same(const Dual<double, N>& a, const Dual<double, N>& b, double sine) {
    EXPECT_EQ(a.value, b.value);
    for (std::size_t i = 0; i < N; ++i)
        EXPECT_NEAR(a.partial[i], b.partial[i], 2e-14 * (1 + 1 / std::abs(sine) + std::abs(b.partial[i])));
}

template <std::size_t N>
void expect_same(const Vector<Dual<double, N>>& a, const Vector<Dual<double, N>>& b, double sine) {
    expect_same(a.x, b.x, sine);
    expect_same(a.y, b.y, sine);
}

TEST(PoseInDuals, OfAFourBarIsThatOfTheFormulas) {
    std::mt19937 random(5);
    int assembled = 0;
    for (int k = 0; k < 2000; ++k) {
        const auto x = random_variables<5>(random);
        const FourBar<Dual<double, 5>> m{x[0], x[1], x[2], x[3]};
        const auto half = half_turn(x[4]);
        for (const Assembly assembly : {Assembly::open, Assembly::crossed}) {
            const auto p = pose(m, half, assembly);
            const auto q = detail::pose_by_formulas(m, half, assembly);
            if (!q.assembled()) continue;
            ++assembled;
            const double sine = q.transmission_sine.value;
            expect_same(p.crank, q.crank, sine);
            expect_same(p.coupler, q.coupler, sine);
            expect_same(p.rocker, q.rocker, sine);
            expect_same(p.transmission_sine, q.transmission_sine, sine);
            expect_same(p.transmission_cosine, q.transmission_cosine, sine);
            expect_same(p.margins.diagonal, q.margins.diagonal, sine);
            expect_same(p.margins.stretch, q.margins.stretch, sine);
            expect_same(p.margins.fold, q.margins.fold, sine);
        }
    }
    EXPECT_GT(assembled, 1000);
}

TEST(PoseInDuals, OfASliderCrankIsThatOfTheFormulas) {
    std::mt19937 random(5);
    int assembled = 0;
    for (int k = 0; k < 2000; ++k) {
        const auto x = random_variables<4>(random);
        const SliderCrank<Dual<double, 4>> m{x[0], x[1], x[2] - 1.5};
        const Vector<Dual<double, 4>> crank{cos(x[3]), sin(x[3])};
        const auto p = pose(m, crank);
        const auto q = detail::pose_by_formulas(m, crank);
        if (!q.assembled()) continue;
        ++assembled;
        const double sine = q.rod.x.value;
        expect_same(p.crank, q.crank, sine);
        expect_same(p.rod, q.rod, sine);
        expect_same(p.position, q.position, sine);
        expect_same(p.left, q.left, sine);
        expect_same(p.right, q.right, sine);
    }
    EXPECT_GT(assembled, 1000);
}

}  // namespace

}  // namespace mechwright::testing
