// Guided points and bodies have gradients by the implicit function theorem: against those of dual numbers, and the
// value's bits.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "synthesis/mechanism/four_bar/coupler_path.h"
#include "synthesis/mechanism/slider_crank/rod_path.h"

namespace mechwright::testing {

namespace {

constexpr Vector<double> target{1.2, -0.3};
constexpr Vector<double> facing{0.6, 0.8};

/// Random arguments of a formula: dimensions and crank angle.
template <std::size_t N>
std::array<double, N> random_arguments(std::mt19937& random) {
    std::uniform_real_distribution<double> any(0.5, 2.5);
    std::array<double, N> x;
    for (double& v : x)
        v = any(random);
    return x;
}

template <std::size_t N>
void expect_same(const PathMiss& miss, const Vector<Dual<double, N>>& by_duals) {
    EXPECT_EQ(miss.miss.x, by_duals.x.value);
    EXPECT_EQ(miss.miss.y, by_duals.y.value);
    for (std::size_t i = 0; i < N; ++i) {
        EXPECT_NEAR(miss.gradient_x[i], by_duals.x.partial[i], 1e-12 * (1 + std::abs(by_duals.x.partial[i])));
        EXPECT_NEAR(miss.gradient_y[i], by_duals.y.partial[i], 1e-12 * (1 + std::abs(by_duals.y.partial[i])));
    }
}

/// Where the gradient is to be written, with something in it that must not stay.
template <std::size_t N>
struct Written {
    std::array<double, N> x, y;

    Written() {
        x.fill(7);
        y.fill(7);
    }
    PathMiss place() {
        PathMiss miss{};
        miss.gradient_x = x;
        miss.gradient_y = y;
        return miss;
    }
};

/// At random arguments, and in both assemblies in turn, compare(assembly, arguments) says whether there was a gradient
/// to compare.
template <class Formula, class Compare>
void expect_at_many_places(const Compare& compare) {
    std::mt19937 random(3);
    int compared = 0;
    for (std::size_t k = 0; k < 1000; ++k)
        compared += compare(k % 2, random_arguments<Formula::reads + 1>(random));
    EXPECT_GT(compared, 200);
}

template <class Formula>
void expect_gradients_of_points() {
    constexpr std::size_t n = Formula::reads + 1;
    expect_at_many_places<Formula>([](std::size_t assembly, const std::array<double, n>& x) {
        const auto by_duals = Formula::miss(assembly, seeded<Dual<double, n>, n>(x), target);
        Written<n> gradient;
        PathMiss miss = gradient.place();
        if (!(by_duals.margin > 1e-3) || !Formula::miss_and_gradient(assembly, x, target, miss)) return false;
        EXPECT_EQ(miss.margin, by_duals.margin);
        expect_same(miss, by_duals.miss);
        return true;
    });
}

template <class Formula>
void expect_gradients_of_bodies() {
    constexpr std::size_t n = Formula::reads + 1;
    expect_at_many_places<Formula>([](std::size_t assembly, const std::array<double, n>& x) {
        const auto by_duals = Formula::miss(assembly, seeded<Dual<double, n>, n>(x), target, facing);
        Written<n> place, turn;
        PoseMiss miss{place.place(), turn.place()};
        if (!(by_duals.place.margin > 1e-3) || !Formula::miss_and_gradient(assembly, x, target, facing, miss))
            return false;
        EXPECT_EQ(miss.place.margin, by_duals.place.margin);
        expect_same(miss.place, by_duals.place.miss);
        expect_same(miss.turn, by_duals.turn);
        return true;
    });
}

TEST(GuidedGradients, OfPointsAreThoseOfDualNumbers) {
    expect_gradients_of_points<four_bar::CouplerPath>();
    expect_gradients_of_points<quick_return::RodPath>();
}

TEST(GuidedGradients, OfBodiesAreThoseOfDualNumbers) {
    expect_gradients_of_bodies<four_bar::CouplerPose>();
    expect_gradients_of_bodies<quick_return::RodPose>();
}

}  // namespace

}  // namespace mechwright::testing
