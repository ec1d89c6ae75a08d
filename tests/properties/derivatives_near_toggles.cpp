// Gradients and Hessians close to toggles and change points, margins of 1e-2 to 1e-6 of the longest link. There they
// depend strongly on the dimensions, so that even an exact method answers only for dimensions within their rounding.
// The conditioning is measured: how much the exact derivatives change, over the change, when all variables change by
// 1e-10 of themselves. Allowed is 16 times the rounding of that, and of the largest entry.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "tests/properties/measures.h"

namespace mechwright::test {
namespace {

constexpr int near_toggles = 1000;
constexpr double allowed = 16 * std::numeric_limits<double>::epsilon();

/// A linkage with one to three small margins, its crank near the ground line or anywhere.
Sample near_change_point(Random& random, bool crank_rocker_only) {
    const auto margin = [&] { return random.coin() ? random.log_between(1e-6, 1e-2) : random.log_between(0.05, 2); };
    const double p = margin(), q = margin(), s = margin(), shortest = random.log_between(0.1, 1);
    const auto m =
        crank_rocker_only || random.coin() ? crank_rocker(shortest, p, q, s) : double_crank(shortest, p, q, s);
    const double near = random.log_between(1e-3, 3) * (random.coin() ? 1 : -1);
    const double angle = random.coin() ? near : std::numbers::pi + near;
    const double size = longest_of(m);
    return {{m.ground, m.crank, m.coupler, m.rocker, angle, size * random.between(-1, 2), size * random.between(-1, 2)},
            size,
            random.assembly()};
}

/// A linkage that turns only between toggles, its crank 1e-6 to 1e-2 of a radian from one.
Sample near_toggle(Random& random) {
    while (true) {
        const auto length = [&] { return random.log_between(0.3, 3); };
        const FourBar<double> m{length(), length(), length(), length()};
        const auto range = assembled_range(m);
        if (range.full_turn || range.to - range.from < 0.1) continue;
        const double before = random.log_between(1e-6, 1e-2);
        const double angle = random.coin() ? range.to - before : range.from + before;
        const double size = longest_of(m);
        return {
            {m.ground, m.crank, m.coupler, m.rocker, angle, size * random.between(-1, 2), size * random.between(-1, 2)},
            size,
            random.assembly()};
    }
}

/// How far, over the size, the nearest toggle is: the least margin at this angle or on the ground line.
double distance_to_toggle(const Sample& sample) {
    double least = 1;
    for (const auto& half : {half_turn(sample.x[4]), HalfTurn<double>{1, 0}, HalfTurn<double>{0, 1}}) {
        const auto margins = assembly_margins(sample.links(), half);
        least = std::min({least, std::abs(margins.stretch), std::abs(margins.fold)});
    }
    return least / sample.size;
}

/// Largest ratio of an error to what its conditioning allows.
template <class Measure>
Errors compare_conditioned(const Measure& measure, const Sample& sample, Random& random) {
    constexpr std::size_t n = Measure::variables;
    const auto f = evaluated(measure, sample);
    const Largest largest(f);
    const auto u = random_direction<n>(random);
    const AlongDual<n> along(f, u);
    const double step = 1e-9 * std::max(distance_to_toggle(sample), 1e-7);
    const Along exact = differences_along<n>(in_steps(measure, sample), Point<n>{}, u, step);
    constexpr double change = 1e-10;
    double gradient_condition = 0, hessian_condition = 0;
    for (int trial = 0; trial < 3; ++trial) {
        Point<n> at{};
        for (std::size_t i = 0; i < n; ++i)
            at[i] = change * (random.coin() ? 1 : -1) * sample.x[i] / sample.unit(i);
        const Along moved = differences_along<n>(in_steps(measure, sample), at, u, step);
        gradient_condition =
            std::max(gradient_condition, std::abs(static_cast<double>(moved.first - exact.first)) / change);
        hessian_condition =
            std::max(hessian_condition, std::abs(static_cast<double>(moved.second - exact.second)) / change);
    }
    Errors errors;
    errors.add(std::abs(static_cast<double>(exact.first - along.first)) / (largest.gradient + gradient_condition),
               std::abs(static_cast<double>(exact.second - along.second)) / (largest.hessian + hessian_condition));
    return errors;
}

template <class SampleOf, class MeasureOf>
void expect_well_rounded(std::uint64_t seed, const SampleOf& sample_of, const MeasureOf& measure_of) {
    Random random(seed);
    Errors worst;
    for (int i = 0; i < near_toggles; ++i) {
        const Sample sample = sample_of(random);
        const Errors errors = compare_conditioned(measure_of(sample), sample, random);
        worst.add(errors.gradient, errors.hessian);
    }
    EXPECT_LE(worst.gradient, allowed);
    EXPECT_LE(worst.hessian, allowed);
}

/// Largest errors without regard to conditioning.
template <class MeasureOf>
Errors plain_errors(std::uint64_t seed, bool crank_rocker_only, const MeasureOf& measure_of) {
    Random random(seed);
    Errors worst;
    for (int i = 0; i < near_toggles; ++i) {
        const Sample sample = near_change_point(random, crank_rocker_only);
        const auto measure = measure_of(sample);
        constexpr std::size_t n = decltype(measure)::variables;
        const auto f = evaluated(measure, sample);
        const Largest largest(f);
        const auto u = random_direction<n>(random);
        const AlongDual<n> along(f, u);
        const double step = 1e-9 * std::max(distance_to_toggle(sample), 1e-7);
        const Along exact = differences_along<n>(in_steps(measure, sample), Point<n>{}, u, step);
        worst.add(std::abs(static_cast<double>(exact.first - along.first)) / largest.gradient,
                  std::abs(static_cast<double>(exact.second - along.second)) / largest.hessian);
    }
    return worst;
}

Sample any_near_change_point(Random& random) { return near_change_point(random, false); }
Sample crank_rocker_near_change_point(Random& random) { return near_change_point(random, true); }

TEST(DerivativesNearToggles, OfTheSwingAreAsExactAsTheirConditioning) {
    expect_well_rounded(41, crank_rocker_near_change_point, [](const Sample&) { return SwingMeasure{}; });
}

TEST(DerivativesNearToggles, OfTheStrokeExcessAreAsExactAsTheirConditioning) {
    expect_well_rounded(42, crank_rocker_near_change_point, [](const Sample&) { return StrokeExcessMeasure{}; });
}

TEST(DerivativesNearToggles, OfTheTransmissionAnglesAreAsExactAsTheirConditioning) {
    expect_well_rounded(43, any_near_change_point, [](const Sample&) { return TransmissionMeasure{false}; });
    expect_well_rounded(44, any_near_change_point, [](const Sample&) { return TransmissionMeasure{true}; });
}

TEST(DerivativesNearToggles, OfTheVelocityRatioAreAsExactAsTheirConditioning) {
    const auto measure = [](const Sample& s) { return VelocityRatioMeasure{s.assembly}; };
    expect_well_rounded(45, any_near_change_point, measure);
    expect_well_rounded(46, near_toggle, measure);
}

TEST(DerivativesNearToggles, OfTheCouplerPointAreAsExactAsTheirConditioning) {
    const auto measure = [](const Sample& s) { return PositionMeasure{s.assembly, s.x[0] > s.x[1]}; };
    expect_well_rounded(47, any_near_change_point, measure);
    expect_well_rounded(48, near_toggle, measure);
}

// Swing and transmission angles come from margins that are exact to their last digit: near change points they keep
// their digits although the conditioning is bad.
TEST(DerivativesNearToggles, OfSwingAndTransmissionKeepTheirDigitsNearChangePoints) {
    for (const Errors& errors : {plain_errors(51, true, [](const Sample&) { return SwingMeasure{}; }),
                                 plain_errors(52, false, [](const Sample&) { return TransmissionMeasure{false}; }),
                                 plain_errors(53, false, [](const Sample&) { return TransmissionMeasure{true}; })}) {
        EXPECT_LE(errors.gradient, 1e-14);
        EXPECT_LE(errors.hessian, 1e-14);
    }
}

}  // namespace
}  // namespace mechwright::test
