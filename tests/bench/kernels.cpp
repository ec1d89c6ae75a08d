// What the report of the benchmarks rests on: counted operations, instructions, bounds, digits.

#include <gtest/gtest.h>

#include <cmath>

#include "synthesis/bench/digits.h"
#include "synthesis/bench/instructions.h"
#include "synthesis/bench/kernels/costs.h"
#include "synthesis/bench/kernels/measured_kernel.h"

namespace mechwright::bench {
namespace {

TEST(CountedNumber, CountsWhatAResultDependsOn) {
    const auto [mix, chain] = mix_of([] {
        const Counted a = Counted::variable(3), b = Counted::variable(4);
        const Counted c = sqrt(a * a + b * b) / (a - b);
        EXPECT_EQ(c.value, -5);
        EXPECT_EQ(atan2(sin(a), cos(a)).value, std::atan2(std::sin(3.0), std::cos(3.0)));  // is not asked for
        return Vector<Counted>{c, atan2(a, cos(b))};
    });
    EXPECT_EQ(mix.sums_and_products, 4);
    EXPECT_EQ(mix.quotients, 1);
    EXPECT_EQ(mix.roots, 1);
    EXPECT_EQ(mix.sines, 1);
    EXPECT_EQ(mix.angles, 1);
    // The longest chain: cosine, angle.
    EXPECT_EQ(chain.sines, 1);
    EXPECT_EQ(chain.angles, 1);
    EXPECT_EQ(chain.sums_and_products + chain.quotients + chain.roots, 0);
}

TEST(CountedNumber, CountsEachOperationOnceAndConstantsNot) {
    const auto [mix, chain] = mix_of([] {
        const Counted a = Counted::variable(3);
        const Counted twice = Counted(2) * Counted(3) * a;
        return Vector<Counted>{twice + sqrt(a), -(Counted(6) * a - sqrt(a))};
    });
    EXPECT_EQ(mix.sums_and_products, 3);
    EXPECT_EQ(mix.roots, 1);
    EXPECT_EQ(mix.quotients + mix.sines + mix.angles, 0);
    EXPECT_EQ(chain.roots, 1);
    EXPECT_EQ(chain.sums_and_products, 1);
}

// A pose takes the root of the diagonal and that of the area, one sine and one cosine, and no arc tangent.
TEST(CountedNumber, GoesThroughTheFormulasOfAFourBar) {
    const auto in = CouplerPointKernel::usual().front();
    Vector<Counted> counted;
    const CallMix mix = mix_of(
        [&] { return counted = CouplerPointKernel::ours<0>(kernel_detail::counted(in.x), Counted::variable(in.at)); });
    EXPECT_EQ(mix.all.roots, 2);
    EXPECT_EQ(mix.all.sines, 2);
    EXPECT_EQ(mix.all.angles, 0);
    EXPECT_GT(mix.all.sums_and_products, 40);
    EXPECT_LT(mix.chain.sums_and_products, mix.all.sums_and_products);
    const Vector<double> plain = CouplerPointKernel::ours<0>(in.x, in.at);
    EXPECT_EQ(counted.x.value, plain.x);
    EXPECT_EQ(counted.y.value, plain.y);
}

// A loop of so many additions takes at least one instruction for each more of them, and the same count each time.
TEST(Instructions, AreCountedOneByOne) {
    const auto sums = [](int count) {
        return [count] {
            volatile double sum = 0;
            for (int i = 0; i < count; ++i)
                sum = sum + 1;
        };
    };
    const auto few = instructions_of(sums(100)), many = instructions_of(sums(300));
    if (!few) GTEST_SKIP() << "this system does not let a process be traced";
    EXPECT_GE(*many - *few, 200);
    EXPECT_EQ(instructions_of(sums(300)), many);
    EXPECT_EQ((*many - *few) % 200, 0);
}

TEST(LeastTime, IsThatOfTheBusierUnitsAndTheCalls) {
    const OperationCosts costs{1, 5, 7, 20, 30};
    EXPECT_EQ(least_seconds({10, 1, 0, 0, 0}, costs), 10);
    EXPECT_EQ(least_seconds({10, 1, 1, 0, 0}, costs), 12);
    EXPECT_EQ(least_seconds({10, 1, 1, 2, 1}, costs), 12 + 20 + 30);
    EXPECT_EQ(chain_seconds({10, 1, 1, 1, 1}, costs), 10 + 5 + 7 + 20 + 30);
}

TEST(LeastTime, CostsAreThoseOfAProcessor) {
    const OperationCosts costs = scalar_costs();
    for (const double seconds :
         {costs.sum_or_product, costs.quotient, costs.root, costs.sine_and_cosine, costs.angle}) {
        EXPECT_GT(seconds, 1e-11);
        EXPECT_LT(seconds, 1e-5);
    }
    EXPECT_GT(costs.quotient, costs.sum_or_product);
}

/// Ours and the textbook's are formulas for the same motion, for every kernel.
template <class Kernel>
struct Kernels : ::testing::Test {};
using All = ::testing::Types<CouplerPointKernel, SliderCrankKernel, CrankShaperKernel, RollerKernel>;
TYPED_TEST_SUITE(Kernels, All, );

template <class Kernel, int order>
void expect_same(const typename Kernel::Input& in) {
    const Vector<double> ours = Kernel::template ours<order>(in.x, in.at);
    const Vector<double> textbook = Kernel::template textbook<order>(in.x, in.at);
    const double size = std::hypot(ours.x, ours.y) + 1e-3;
    EXPECT_NEAR(ours.x, textbook.x, 1e-7 * size) << order;
    EXPECT_NEAR(ours.y, textbook.y, 1e-7 * size) << order;
}

TYPED_TEST(Kernels, AreTheTextbooksMotion) {
    for (const auto& in : TypeParam::usual()) {
        expect_same<TypeParam, 0>(in);
        expect_same<TypeParam, 1>(in);
        expect_same<TypeParam, 2>(in);
    }
}

// Every order is the derivative of the one before, by differences in fifty digits.
template <class Kernel, int order>
void expect_derivative(const typename Kernel::Input& in) {
    const auto at = [&](const Digits50& angle) {
        std::array<Digits50, Kernel::size> x;
        std::copy(in.x.begin(), in.x.end(), x.begin());
        return Kernel::template ours<order - 1>(x, angle);
    };
    const Digits50 h = 1e-12;
    const auto up = at(in.at + h), down = at(in.at - h);
    const Vector<double> rate{static_cast<double>(Digits50((up.x - down.x) / (2 * h))),
                              static_cast<double>(Digits50((up.y - down.y) / (2 * h)))};
    const Vector<double> ours = Kernel::template ours<order>(in.x, in.at);
    const double size = std::hypot(rate.x, rate.y) + 1e-3;
    EXPECT_NEAR(ours.x, rate.x, 1e-11 * size) << order;
    EXPECT_NEAR(ours.y, rate.y, 1e-11 * size) << order;
}

TYPED_TEST(Kernels, OrdersAreDerivatives) {
    if (std::is_same_v<TypeParam, RollerKernel>) GTEST_SKIP() << "each order of a cam has a meaning of its own";
    for (const auto& in : TypeParam::usual()) {
        expect_derivative<TypeParam, 1>(in);
        expect_derivative<TypeParam, 2>(in);
    }
}

}  // namespace
}  // namespace mechwright::bench
