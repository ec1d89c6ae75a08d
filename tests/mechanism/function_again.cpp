// The mean error of a function generator, measured again: as exact as the expression allows, and no more work than
// that.

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "synthesis/target/function/formulas_again.h"

namespace mechwright {
namespace {

std::size_t calls = 0;

constexpr double ripple = 1e-6, waves = 20;

/// Generates the root of its input but for a ripple, in as many digits as it is asked for.
struct RippledRoot {
    static constexpr std::size_t scales = 0;
    RippledRoot(const Motion&, std::span<const Digits50>) {}

    template <class T>
    T error(const T& input, const T& asked) const {
        using std::sin, std::sqrt;
        ++calls;
        return sqrt(input) + T(ripple) * sin(T(waves) * input) - asked;
    }
};

// What is asked for is known in doubles: of an error of a millionth of the output's range ten digits are left, and a
// rule that wants eleven would halve its intervals without end.
TEST(FunctionRmsAgain, StopsAtTheNoiseOfTheExpression) {
    FunctionTarget root;
    root.expression = "sqrt(x)";
    root.from = 1;
    root.to = 3;
    ASSERT_EQ(complete(root), "");
    Motion motion;
    motion.function = &root;
    const std::array<Digits50, 4> scales{1, 2, 1, sqrt(Digits50(3)) - 1};
    calls = 0;
    const double measured = function_rms_again<RippledRoot>(motion, scales).convert_to<double>();
    // The mean of sin^2(20 x) over [1, 3].
    const double mean = 0.5 - (std::sin(6 * waves) - std::sin(2 * waves)) / (4 * waves * 2);
    EXPECT_NEAR(measured, ripple * std::sqrt(mean), 1e-9 * ripple);
    EXPECT_LT(calls, 20000u);
}

}  // namespace
}  // namespace mechwright
