// Searches beside ours: descriptors of curves, the error that all are measured by, and that they go towards the best.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/numbers/scalar.h"
#include "synthesis/bench/curves/best_known.h"
#include "synthesis/bench/curves/descriptors.h"
#include "synthesis/bench/curves/peer_methods.h"
#include "synthesis/bench/curves/whole_curve_error.h"
#include "synthesis/program/assess.h"

namespace mechwright::bench {
namespace {

using Complex = std::complex<double>;

/// Three harmonics at even steps.
std::vector<Vector<double>> closed_curve(std::mt19937& random, std::size_t points) {
    std::normal_distribution<double> normal;
    std::array<Complex, 3> forward, backward;
    for (std::size_t k = 0; k < forward.size(); ++k) {
        forward[k] = Complex(normal(random), normal(random)) / std::pow(2.0, k);
        backward[k] = Complex(normal(random), normal(random)) / std::pow(2.0, k + 1);
    }
    std::vector<Vector<double>> curve;
    for (std::size_t i = 0; i < points; ++i) {
        Complex z = 0;
        for (std::size_t k = 0; k < forward.size(); ++k) {
            const double angle = 2 * pi<double>() * static_cast<double>((k + 1) * i) / static_cast<double>(points);
            z += forward[k] * std::polar(1.0, angle) + backward[k] * std::polar(1.0, -angle);
        }
        curve.push_back({z.real(), z.imag()});
    }
    return curve;
}

TEST(Descriptors, AreThoseOfTheCurveWhereverItLiesAndBegins) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 50; ++trial) {
        const std::vector<Vector<double>> curve = closed_curve(random, 60);
        const Complex factor(normal(random), normal(random)), shift(normal(random), normal(random));
        std::vector<Vector<double>> other;
        const std::size_t start = random() % curve.size();
        const bool reversed = random() % 2 == 1;
        for (std::size_t i = 0; i < curve.size(); ++i) {
            const std::size_t n = reversed ? start + curve.size() - i : start + i;
            const Vector<double>& p = curve[n % curve.size()];
            const Complex z = shift + factor * Complex(p.x, p.y);
            other.push_back({z.real(), z.imag()});
        }
        const Difference d = difference(descriptors_of(other, 12), descriptors_of(curve, 12));
        EXPECT_LT(d.distance, 1e-12);
        EXPECT_LT(std::abs(d.factor - factor), 1e-12 * std::abs(factor));
        EXPECT_LT(std::abs(d.shift - shift), 1e-12 * (1 + std::abs(shift) + std::abs(factor)));
    }
}

TEST(Descriptors, ComeCloseToTheCurveWithTheirNumber) {
    std::mt19937 random(3);
    const std::vector<Vector<double>> curve = closed_curve(random, 200);
    const auto missed = [&](int harmonics) {
        const Descriptors d = descriptors_of(curve, harmonics);
        double worst = 0;
        for (const Vector<double>& p : curve) {
            double nearest = 1e300;
            for (int i = 0; i < 4000; ++i) {
                Complex z = 0;
                for (std::size_t k = 0; k < d.forward.size(); ++k) {
                    const double angle = 2 * pi<double>() * static_cast<double>(k + 1) * i / 4000;
                    z += d.forward[k] * std::polar(1.0, angle) + d.backward[k] * std::polar(1.0, -angle);
                }
                nearest = std::min(nearest, std::abs(d.middle + d.factor * z - Complex(p.x, p.y)));
            }
            worst = std::max(worst, nearest);
        }
        return worst;
    };
    const double coarse = missed(2), fine = missed(20);
    EXPECT_GT(coarse, 0.02);
    EXPECT_LT(fine, 0.1 * coarse);
    EXPECT_LE(harmonics_of(curve, 40, 1e-4), 20);
}

TEST(CurvePeers, MeasureBestKnownDesignsAsTheyAreStated) {
    CurveWork work;
    int measured = 0, as_stated = 0;
    for (const Shape& shape : shapes())
        for (const BestKnown& known : best_known()) {
            if (known.shape != shape.name || !shape.requirement.empty()) continue;
            const WholeCurveError error = whole_curve_error(shape);
            CurveArguments a{};
            for (std::size_t i = 0; i < known.dimensions.size(); ++i)
                a[i] = i == 8 ? known.dimensions[i] * pi<double>() / 180 : known.dimensions[i] / error.unit();
            FittedCurve design{a, known.assembly == "open" ? std::size_t{0} : std::size_t{1}};
            ASSERT_TRUE(descend(error.curve, design, 1, 0, work)) << shape.name;
            double rms = std::sqrt(design.sum / error.curve.weight) * error.unit();
            // The end of a motion itself is nearer than where it is sure where the point is, which is what counts.
            EXPECT_GT(rms, (1 - 0.02) * known.rms) << shape.name;
            if (const std::size_t kind = program_of(*error.programs, a, design.assembly); kind < error.programs->size())
                rms = assess(*error.problem, design_at((*error.programs)[kind], point_with((*error.programs)[kind], a)))
                          .objective;
            // They are written with ten digits; next to a change point that is few, on whichever side of the margin.
            EXPECT_GT(rms, (1 - 1e-3) * known.rms) << shape.name;
            as_stated += std::abs(rms - known.rms) <= 1e-4 * known.rms + 2e-6 ? 1 : 0;
            ++measured;
        }
    EXPECT_GT(measured, 40);
    // A corner of a great curve may lie within one chord.
    EXPECT_GE(as_stated, measured - 2);
}

TEST(CurvePeers, GoTowardsTheBestKnownAndNotBeyondIt) {
    const std::vector<Shape> all = shapes();
    const auto egg = std::find_if(all.begin(), all.end(), [](const Shape& s) { return s.name == "egg"; });
    ASSERT_NE(egg, all.end());
    const auto known =
        std::find_if(best_known().begin(), best_known().end(), [](const BestKnown& k) { return k.shape == "egg"; });
    ASSERT_NE(known, best_known().end());
    int searched = 0;
    for (const PeerMethod& method : peer_methods()) {
        if (method.name == "default" || method.name == "SLSQP, multistart") continue;
        const PeerRun run = method.run(*egg, 1, 20000), again = method.run(*egg, 1, 20000);
        EXPECT_EQ(run.rms, again.rms) << method.name;
        EXPECT_LT(run.rms, 3) << method.name;  // mm, of a shape of 20 mm
        EXPECT_GT(run.rms, (1 - 1e-6) * known->rms) << method.name;
        EXPECT_GT(run.evaluations, 10000) << method.name;
        ++searched;
    }
    EXPECT_EQ(searched, 3);
}

}  // namespace
}  // namespace mechwright::bench
