// Dyads through poses: against the geometry that they are made from, and against what is known of their number.

#include "synthesis/exact/poses/dyads.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "synthesis/exact/poses/certified_dyad.h"

namespace mechwright {
namespace {

using Number = std::complex<double>;
using Four = std::array<Displacement, 4>;

Number place_of(const Dyad& dyad, const Displacement& d) { return d.shift + dyad.moving * d.turn; }

/// The greatest difference of the link's length in the displaced poses from that in the first, relative.
double stretch(const Dyad& dyad, std::span<const Displacement> displacements) {
    const double length = std::abs(dyad.moving - dyad.fixed);
    double worst = 0;
    for (const Displacement& d : displacements)
        worst = std::max(worst, std::abs(std::abs(place_of(dyad, d) - dyad.fixed) - length));
    return worst / (1 + length);
}

class RandomPoses {
public:
    explicit RandomPoses(unsigned seed) : random_(seed) {}
    Number point() { return {normal_(random_), normal_(random_)}; }
    Displacement displacement() { return {point(), std::polar(1.0, 3 * normal_(random_))}; }
    Four four() { return {displacement(), displacement(), displacement(), displacement()}; }

private:
    std::mt19937_64 random_;
    std::normal_distribution<double> normal_;
};

TEST(Dyads, ThroughFivePosesAreFourOverTheComplexNumbers) {
    RandomPoses random(3);
    std::array<int, 5> reals{};
    for (int k = 0; k < 1000; ++k) {
        const Four poses = random.four();
        const DyadSolutions found = dyads_through(poses);
        ASSERT_TRUE(found.isolated);
        ASSERT_EQ(found.dyads.size(), 4u) << k;
        std::size_t real = 0;
        for (const ComplexDyad& dyad : found.dyads) {
            for (const Displacement& d : poses)
                EXPECT_LE(residual(dyad, d), 1e-12);
            const auto built = real_dyad(dyad);
            if (!built) continue;
            ++real;
            EXPECT_LT(stretch(*built, poses), 1e-9);
        }
        ++reals[real];
    }
    EXPECT_EQ(reals[1] + reals[3], 0);
    EXPECT_GT(reals[0], 0);
    EXPECT_GT(reals[2], 0);
    EXPECT_GT(reals[4], 0);
}

/// A dyad whose five poses are made by turning its link and the body as they like.
TEST(Dyads, IncludeTheOneThatThePosesAreMadeFrom) {
    RandomPoses random(5);
    for (int k = 0; k < 300; ++k) {
        const Dyad made{random.point(), random.point()};
        Four poses;
        for (Displacement& d : poses) {
            const Number turn = random.displacement().turn, link = random.displacement().turn;
            const Number pin = made.fixed + (made.moving - made.fixed) * link;
            d = {pin - made.moving * turn, turn};
        }
        bool found = false;
        for (const ComplexDyad& dyad : dyads_through(poses).dyads)
            if (const auto real = real_dyad(dyad))
                found = found || std::abs(real->fixed - made.fixed) + std::abs(real->moving - made.moving) < 1e-6;
        EXPECT_TRUE(found) << k;
    }
}

TEST(Dyads, OfThreePosesFollowFromEitherPivot) {
    RandomPoses random(7);
    for (int k = 0; k < 100; ++k) {
        const std::array<Displacement, 2> poses{random.displacement(), random.displacement()};
        const auto dyad = dyad_with_fixed_pivot(random.point(), poses);
        ASSERT_TRUE(dyad);
        EXPECT_LT(stretch(*dyad, poses), 1e-9);
        const Number fixed = random.point();
        const auto line = moving_pivots_of(fixed, poses[0]);
        ASSERT_TRUE(line);
        for (const double along : {-1.0, 0.0, 2.0})
            EXPECT_LT(stretch({fixed, line->point + along * line->direction}, std::span(poses).first(1)), 1e-10);
    }
}

TEST(Dyads, OfFourPosesHaveTheirFixedPivotsOnAnyLine) {
    RandomPoses random(9);
    int real = 0;
    for (int k = 0; k < 100; ++k) {
        const std::array<Displacement, 3> poses{random.displacement(), random.displacement(), random.displacement()};
        DyadConditions conditions;
        for (Eigen::Index i = 0; i < 3; ++i)
            conditions.row(i) = condition_of(poses[static_cast<std::size_t>(i)]);
        const Number point = random.point(), direction = random.displacement().turn;
        conditions.row(3) = fixed_pivot_on_line(point, direction);
        for (const ComplexDyad& dyad : dyads_meeting(conditions).dyads) {
            const auto built = real_dyad(dyad);
            if (!built) continue;
            ++real;
            EXPECT_LT(stretch(*built, poses), 1e-8);
            EXPECT_NEAR((std::conj(direction) * (built->fixed - point)).imag(), 0, 1e-8 * (1 + std::abs(built->fixed)));
        }
    }
    EXPECT_GE(real, 100);  // a cubic curve meets every line
}

/// Ball's point: its places in four poses lie on a line. Its mirror image in the inverse motion: a line of the body
/// that passes through one point.
TEST(Dyads, OfSlidersAreFoundInFourPosesOrFewer) {
    RandomPoses random(11);
    for (std::size_t count = 1; count <= 3; ++count)
        for (int k = 0; k < 100; ++k) {
            std::vector<Displacement> poses;
            for (std::size_t i = 0; i < count; ++i)
                poses.push_back(random.displacement());
            const std::array<double, 2> numbers{0.01 * k, 0.3 + 0.005 * k};
            const auto slider = slider_through(poses, std::span(numbers).first(numbers_of_slider(count + 1)));
            ASSERT_TRUE(slider);
            for (const Displacement& d : poses) {
                const Number moved = d.shift + slider->moving * d.turn - slider->moving;
                EXPECT_NEAR((std::conj(slider->normal) * moved).real(), 0, 1e-9 * (1 + std::abs(slider->moving)));
            }
        }
}

/// A rod whose end slides on a line: the slider is that end, wherever the crank is.
TEST(Dyads, OfASliderCrankHaveItsSlider) {
    const double crank = 1, rod = 3, offset = 0.4;
    const auto pose_at = [&](double angle) {
        const Number pin = std::polar(crank, angle);
        const double across = offset - pin.imag();
        const Number end(pin.real() + std::sqrt(rod * rod - across * across), offset);
        return std::pair{pin, (end - pin) / rod};
    };
    const auto [first_pin, first_rod] = pose_at(0.3);
    std::array<Displacement, 3> poses;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [pin, direction] = pose_at(1.0 + 1.4 * static_cast<double>(i));
        poses[i] = {pin - first_pin, direction / first_rod};
    }
    const auto slider = slider_through(poses, {});
    ASSERT_TRUE(slider);
    EXPECT_NEAR(std::abs(slider->moving - rod * first_rod), 0, 1e-10);
    EXPECT_NEAR(std::abs(slider->normal.real()), 0, 1e-10);
}

/// Repeated poses, translations, turns about one point, poses in a row: an account, and no crash.
TEST(Dyads, OfSpecialPosesComeToAnEnd) {
    RandomPoses random(13);
    const Displacement one = random.displacement(), two = random.displacement(), three = random.displacement();
    const Displacement none{0, 1};
    const auto turn = [](double angle) { return Displacement{0, std::polar(1.0, angle)}; };
    const auto shift = [](double x, double y) { return Displacement{{x, y}, 1}; };
    const std::vector<Four> special{
        {one, one, two, three},
        {one, two, three, none},
        {none, none, none, none},
        {turn(0.5), turn(1), turn(1.5), turn(2)},
        {shift(1, 0), shift(2, 0), shift(3, 0), shift(4, 0)},
        {shift(1, 0), shift(2, 1), shift(3, 3), shift(4, 7)},
        {Displacement{1, std::polar(1.0, 0.2)}, Displacement{2, std::polar(1.0, 0.4)},
         Displacement{-1, std::polar(1.0, -0.2)}, Displacement{-2, std::polar(1.0, -0.4)}},
        {Displacement{{1e-9, 0}, std::polar(1.0, 1e-9)}, one, two, three},
    };
    for (const Four& poses : special) {
        const DyadSolutions found = dyads_through(poses);
        EXPECT_LE(found.dyads.size(), 4u);
        EXPECT_EQ(found.dyads.size() + found.at_infinity + found.singular, found.isolated ? 4u : 0u);
        for (const ComplexDyad& dyad : found.dyads)
            for (const Displacement& d : poses)
                EXPECT_LE(residual(dyad, d), 1e-8);
    }
    EXPECT_FALSE(dyads_through(special[0]).isolated);
    EXPECT_FALSE(dyads_through(special[2]).isolated);
}

ExactDisplacement exactly(const Displacement& d) {
    const Digits50 angle = std::arg(d.turn);
    return {{d.shift.real(), d.shift.imag()}, {cos(angle), sin(angle)}};
}

/// The certificate holds a solution to fifty digits; what is no solution has none.
TEST(CertifiedDyads, AreProvenAndOthersAreNot) {
    RandomPoses random(17);
    int certificates = 0;
    for (int k = 0; k < 50; ++k) {
        const Four poses = random.four();
        std::array<ExactCondition, 4> conditions;
        for (std::size_t i = 0; i < 4; ++i)
            conditions[i] = exact_condition(exactly(poses[i]));
        for (const ComplexDyad& dyad : dyads_through(poses).dyads) {
            const auto real = real_dyad(dyad);
            if (!real) continue;
            const auto proof = certified(*real, conditions);
            ASSERT_TRUE(proof);
            ++certificates;
            EXPECT_LT(std::abs(proof->dyad.fixed - real->fixed), 1e-9 * (1 + std::abs(real->fixed)));
            for (const Displacement& d : poses) {
                const ExactDisplacement e = exactly(d);
                const auto& x = proof->moving;
                const Vector<Digits50> pin{e.shift.x + x.x * e.turn.x - x.y * e.turn.y,
                                           e.shift.y + x.x * e.turn.y + x.y * e.turn.x};
                const Vector<Digits50> now = pin - proof->fixed, first = x - proof->fixed;
                EXPECT_LT(abs(dot(now, now) - dot(first, first)), 1e-35 * (1 + dot(first, first)));
            }
        }
        // Five conditions of which one is met twice leave a family: nothing there is alone.
        conditions[3] = conditions[2];
        EXPECT_FALSE(certified({random.point(), random.point()}, conditions));
    }
    EXPECT_GT(certificates, 50);
}

}  // namespace
}  // namespace mechwright
