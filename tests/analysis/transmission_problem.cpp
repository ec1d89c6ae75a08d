// The classical transmission-angle problem: the crank-rocker of given swing psi and crank rotation phi of the forward
// stroke whose worst transmission angle is best. Closed form and numbers were derived and checked by brute force for
// this project; with ground 1, lambda = coupler / crank, Q = lambda^2, t = tan(phi/2), v = tan((phi - psi)/2) the
// optimum solves (1 + t^2) Q^3 + t^2 v^2 (Q^2 - 2 Q - t^2) = 0.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "analysis/four_bar.h"
#include "analysis/numbers/extremes.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {
namespace {

struct Row {
    double phi, psi, lambda, crank, coupler, rocker, worst;  // degrees; ground 1
};

constexpr Row table[]{
    {160, 40, 2.023432, 0.256819, 0.519656, 0.785139, 31.85420},
    {200, 40, 2.468007, 0.318449, 0.785935, 1.000000, 42.80781},
    {170, 60, 2.449273, 0.307461, 0.753056, 0.626488, 37.37052},
    {190, 60, 2.727403, 0.340997, 0.930038, 0.698474, 45.00822},
    {165, 50, 2.181918, 0.292632, 0.638500, 0.714266, 34.35098},
    {195, 50, 2.555008, 0.345081, 0.881686, 0.854118, 44.29757},
    {150, 30, 1.758224, 0.209734, 0.368760, 0.865254, 24.90286},
    {210, 30, 2.205381, 0.258819, 0.570794, 1.121971, 36.07124},
    {140, 20, 1.593467, 0.147564, 0.235138, 0.923120, 19.40423},
    {220, 70, 1.829172, 0.533209, 0.975332, 1.049450, 26.33125},
};

FourBar<double> linkage(const Row& row, double lambda) {
    const double phi = row.phi * degree, psi = row.psi * degree, kappa = (phi - psi) / 2;
    const double d = std::pow(lambda * std::cos(kappa), 2) + std::pow(std::sin(kappa), 2);
    const double crank = std::sin(psi / 2) / std::sqrt(d);
    return {1, crank, lambda * crank, std::hypot(lambda * std::cos(phi / 2), std::sin(phi / 2)) / std::sqrt(d)};
}

double best_lambda(const Row& row) {
    const double t = std::tan(row.phi * degree / 2), v = std::tan((row.phi - row.psi) * degree / 2);
    const auto g = [&](double q) { return (1 + t * t) * q * q * q + t * t * v * v * (q * q - 2 * q - t * t); };
    return std::sqrt(zero_between<double>(g, 1, 100, g(1), g(100)));
}

double worst_transmission(const FourBar<double>& m) {
    const auto ends = transmission_extremes_of_full_turn();
    const double least = transmission_angle(m, ends.at[0]), greatest = transmission_angle(m, ends.at[1]);
    return std::min(least, std::numbers::pi - greatest);
}

TEST(TransmissionProblem, HasTheTabulatedLinks) {
    for (const Row& row : table) {
        const double lambda = best_lambda(row);
        const FourBar<double> m = linkage(row, lambda);
        EXPECT_NEAR(lambda, row.lambda, 5.1e-7);
        EXPECT_NEAR(m.crank, row.crank, 5.1e-7);
        EXPECT_NEAR(m.coupler, row.coupler, 5.1e-7);
        EXPECT_NEAR(m.rocker, row.rocker, 5.1e-7);
    }
}

TEST(TransmissionProblem, HasTheSwingAndTheTimeRatioAskedFor) {
    for (const Row& row : table) {
        const FourBar<double> m = linkage(row, best_lambda(row));
        EXPECT_EQ(classify(m).kind, FourBarClass::crank_rocker);
        EXPECT_NEAR(swing(m) / degree, row.psi, 1e-12);
        EXPECT_NEAR(180 + stroke_excess(m) / degree, row.phi, 1e-11);
        const double ratio = (std::numbers::pi + stroke_excess(m)) / (std::numbers::pi - stroke_excess(m));
        EXPECT_NEAR(ratio, row.phi / (360 - row.phi), 1e-13);
        // The tabulated links have six digits, and so have their swing and stroke.
        const FourBar<double> printed{1, row.crank, row.coupler, row.rocker};
        EXPECT_NEAR(swing(printed) / degree, row.psi, 1e-3);
        EXPECT_NEAR(180 + stroke_excess(printed) / degree, row.phi, 1e-3);
    }
}

TEST(TransmissionProblem, HasTheTabulatedTransmissionAngle) {
    for (const Row& row : table) {
        const double best = best_lambda(row);
        EXPECT_NEAR(worst_transmission(linkage(row, best)) / degree, row.worst, 5.1e-6);
        // It is the best of its family.
        for (const double step : {1e-3, -1e-3})
            EXPECT_LT(worst_transmission(linkage(row, best + step)), worst_transmission(linkage(row, best)));
    }
}

}  // namespace
}  // namespace mechwright::test
