// Gradients and Hessians by second dual numbers against fifty-digit central differences, away from toggles: margins of
// at least 0.05 of the longest link, sines of the transmission angle of at least 0.1. Along one random direction for
// 10 000 linkages, which all entries of gradient and Hessian enter, and entry by entry for the first of them.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/properties/measures.h"

namespace mechwright::test {
namespace {

constexpr int linkages = 10000, entry_by_entry = 200;
constexpr double tolerance = 1e-12;

/// Sizes over six decades. `crank_rocker_only`: for measures that other linkages do not have.
Sample regular_sample(Random& random, bool crank_rocker_only) {
    while (true) {
        const double scale = random.log_between(1e-3, 1e3);
        const double p = scale * random.log_between(0.05, 4), q = scale * random.log_between(0.05, 4),
                     s = scale * random.log_between(0.05, 4);
        const FourBar<double> m =
            crank_rocker_only || random.coin() ? crank_rocker(scale, p, q, s) : double_crank(scale, p, q, s);
        const double size = longest_of(m);
        const Assembly assembly = random.assembly();
        const double angle = random.angle();
        const auto regular = [&](const HalfTurn<double>& half) {
            return std::abs(pose(m, half, assembly).transmission_sine) >= 0.1;
        };
        if (std::min({p, q, s}) < 0.05 * size || !regular({1, 0}) || !regular({0, 1}) || !regular(half_turn(angle)))
            continue;
        return {
            {m.ground, m.crank, m.coupler, m.rocker, angle, size * random.between(-1, 2), size * random.between(-1, 2)},
            size,
            assembly};
    }
}

template <class MeasureOf>
void expect_exact(std::uint64_t seed, bool crank_rocker_only, const MeasureOf& measure_of) {
    Random random(seed);
    Errors errors;
    for (int i = 0; i < linkages; ++i) {
        const Sample sample = regular_sample(random, crank_rocker_only);
        compare_along(measure_of(sample), sample, random, errors);
        if (i < entry_by_entry) compare_entries(measure_of(sample), sample, errors);
    }
    EXPECT_LE(errors.gradient, tolerance);
    EXPECT_LE(errors.hessian, tolerance);
}

TEST(Derivatives, OfTheSwingAreExact) {
    expect_exact(31, true, [](const Sample&) { return SwingMeasure{}; });
}

TEST(Derivatives, OfTheStrokeExcessAreExact) {
    expect_exact(32, true, [](const Sample&) { return StrokeExcessMeasure{}; });
}

TEST(Derivatives, OfTheTimeRatioAreExact) {
    expect_exact(33, true, [](const Sample&) { return TimeRatioMeasure{}; });
}

TEST(Derivatives, OfTheLeastTransmissionAngleAreExact) {
    expect_exact(34, false, [](const Sample&) { return TransmissionMeasure{false}; });
}

TEST(Derivatives, OfTheGreatestTransmissionAngleAreExact) {
    expect_exact(35, false, [](const Sample&) { return TransmissionMeasure{true}; });
}

TEST(Derivatives, OfTheVelocityRatioAreExact) {
    expect_exact(36, false, [](const Sample& s) { return VelocityRatioMeasure{s.assembly}; });
}

TEST(Derivatives, OfTheCouplerPointAcrossTheDrawingAreExact) {
    expect_exact(37, false, [](const Sample& s) { return PositionMeasure{s.assembly, false}; });
}

TEST(Derivatives, OfTheCouplerPointUpTheDrawingAreExact) {
    expect_exact(38, false, [](const Sample& s) { return PositionMeasure{s.assembly, true}; });
}

}  // namespace
}  // namespace mechwright::test
