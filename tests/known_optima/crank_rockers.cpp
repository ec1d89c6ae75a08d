// The classical transmission-angle problem: given swing and time ratio. The rows are the optima of the cubic in
// (coupler/crank)^2, confirmed for their source by brute force over the family; each row is the better of its two
// directions of the crank. Every method has to find them.

#include <fmt/format.h>

#include <algorithm>
#include <numbers>
#include <random>

#include "analysis/four_bar.h"
#include "analysis/four_bar/best_crank_rocker.h"
#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::Solved;
using testing::solved;

struct Row {
    double forward_stroke;  ///< deg
    double swing;           ///< deg
    double transmission;    ///< deg, to the digits of the source; 0: the source has only the other direction
};

// Forward strokes phi and 360 - phi are one problem: (160, 40) and (200, 40) and so on.
constexpr Row rows[] = {{200, 40, 42.80781}, {190, 60, 45.00822}, {195, 50, 44.29757},
                        {210, 30, 36.07124}, {220, 20, 0},        {220, 70, 26.33125}};

std::string problem_of(const Row& row, const std::string& more = "") {
    return fmt::format(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100.0
crank = {{ min = 1, max = 200 }}
coupler = {{ min = 1, max = 500 }}
rocker = {{ min = 1, max = 500 }}
[[require]]
quantity = "swing"
equal = {}
[[require]]
quantity = "time-ratio"
equal = {}
{})",
                       row.swing, row.forward_stroke / (360 - row.forward_stroke),
                       more.empty() ? "[objective]\nmaximize = \"transmission-angle-worst\"\n" : more);
}

/// The best least transmission angle by a scan over the family with plain trigonometry: an oracle of its own.
double scanned_optimum(double swing, double stroke) {
    double best = 0;
    for (int k = 1; k < 400000; ++k) {
        const double lambda = 1 + k * 2e-5;
        const double kappa = (stroke - swing) / 2;
        const double d = std::pow(lambda * std::cos(kappa), 2) + std::pow(std::sin(kappa), 2);
        const double crank = std::sin(swing / 2) / std::sqrt(d);
        const double coupler = lambda * crank;
        const double rocker =
            std::sqrt((std::pow(lambda * std::cos(stroke / 2), 2) + std::pow(std::sin(stroke / 2), 2)) / d);
        const double low = (coupler * coupler + rocker * rocker - (1 - crank) * (1 - crank)) / (2 * coupler * rocker);
        const double high = (coupler * coupler + rocker * rocker - (1 + crank) * (1 + crank)) / (2 * coupler * rocker);
        if (std::abs(low) > 1 || std::abs(high) > 1 || crank > 1 || crank > rocker) continue;
        // Only members that really swing as asked: rocker angles at both limits by the law of cosines.
        const auto at_rocker = [&](double third) {
            return std::acos((1 + rocker * rocker - third * third) / (2 * rocker));
        };
        if (std::abs(at_rocker(coupler + crank) - at_rocker(coupler - crank) - swing) > 1e-9) continue;
        best = std::max(best, std::min(std::acos(low), std::numbers::pi - std::acos(high)));
    }
    return best / degree;
}

class CrankRockers : public ::testing::TestWithParam<std::string> {};

TEST_P(CrankRockers, HaveTheBestTransmissionAngleOfBothDirections) {
    for (const Row& row : rows) {
        const Solved s = solved(problem_of(row), GetParam());
        SCOPED_TRACE(fmt::format("stroke {} swing {}", row.forward_stroke, row.swing));
        ASSERT_EQ(s.result.status, Status::solved);
        const double reached = s.value("transmission-angle-worst") / degree;
        if (row.transmission > 0) {
            EXPECT_NEAR(reached, row.transmission, 5.1e-6);
        }
        const double scan = std::max(scanned_optimum(row.swing * degree, row.forward_stroke * degree),
                                     scanned_optimum(row.swing * degree, (360 - row.forward_stroke) * degree));
        EXPECT_NEAR(reached, scan, 1e-7);
        EXPECT_NEAR(s.value("swing") / (row.swing * degree), 1, 1e-12);
        EXPECT_NEAR(s.value("time-ratio") / (row.forward_stroke / (360 - row.forward_stroke)), 1, 1e-12);
    }
}

INSTANTIATE_TEST_SUITE_P(EveryMethod, CrankRockers, ::testing::Values("closed-form", "slsqp", "ipopt"),
                         [](const auto& method) {
                             return method.param == "closed-form" ? "closed_form" : method.param;
                         });

/// What the closed form says of all linkages of a swing and a stroke, against linkages that know nothing of their
/// families: none is better than the bound, none stands where a family is said to be empty, and none beats an optimum.
TEST(CrankRockers, OfRandomLinksKeepToTheBoundsOfTheirFamilies) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> length(0.02, 3);
    int linkages = 0;
    double closest = 1;
    for (int k = 0; k < 400000; ++k) {
        const FourBar<double> m{1, length(random), length(random), length(random)};
        const auto margins = crank_rocker_margins(m);
        if (std::min({margins.ground_longest, margins.coupler_longest, margins.rocker_longest}) < 1e-3) continue;
        ++linkages;
        const double least = transmission_angle(m, HalfTurn<double>{1, 0});
        const double greatest = transmission_angle(m, HalfTurn<double>{0, 1});
        const double worst = std::min(least, std::numbers::pi - greatest);
        const double stroke = std::numbers::pi + stroke_excess(m);
        const double bound = transmission_bound_of_crank_rockers(swing(m), stroke);
        ASSERT_GE(bound, worst - 1e-9) << m.crank << ' ' << m.coupler << ' ' << m.rocker;
        closest = std::min(closest, bound - worst);
        const auto best = best_transmission_crank_rocker(swing(m), stroke);
        ASSERT_TRUE(best) << m.crank << ' ' << m.coupler << ' ' << m.rocker;
        const double of_best = std::min(transmission_angle(*best, HalfTurn<double>{1, 0}),
                                        std::numbers::pi - transmission_angle(*best, HalfTurn<double>{0, 1}));
        ASSERT_GE(of_best, worst - 1e-9) << m.crank << ' ' << m.coupler << ' ' << m.rocker;
    }
    EXPECT_GT(linkages, 10000);
    EXPECT_LT(closest, 1e-3);
    EXPECT_EQ(transmission_bound_of_crank_rockers(100 * degree, 139 * degree), 0);
    EXPECT_GT(transmission_bound_of_crank_rockers(100 * degree, 141 * degree), 0);
    // A family just before it is empty has nothing but bad linkages.
    EXPECT_LT(transmission_bound_of_crank_rockers(100 * degree, 140.000001 * degree), 0.1 * degree);
}

TEST(CrankRockers, MethodsAgreeToNineDigits) {
    for (const Row& row : rows) {
        const double exact = solved(problem_of(row), "closed-form").value("transmission-angle-worst");
        EXPECT_NEAR(solved(problem_of(row), "slsqp").value("transmission-angle-worst") / exact, 1, 1e-9);
        EXPECT_NEAR(solved(problem_of(row), "ipopt").value("transmission-angle-worst") / exact, 1, 1e-9);
    }
}

TEST(CrankRockers, ClosedFormSaysWhyItsAnswerIsComplete) {
    const Solved s = solved(problem_of(rows[1]));
    EXPECT_TRUE(s.result.search.complete());
    EXPECT_FALSE(s.result.search.proof->argument.empty());
}

/// The best that can be had for 60 deg and 1.4 is 32.631949 deg; every method says so, one with proof.
TEST(CrankRockers, UnreachableTransmissionAngleIsInfeasibleWithTheBestThatCanBeHad) {
    const std::string text =
        problem_of({210, 60, 0}, "[[require]]\nquantity = \"transmission-angle-worst\"\nmin = 40\n");
    for (const std::string method : {"auto", "slsqp", "ipopt"}) {
        const Solved s = solved(text, method);
        EXPECT_EQ(s.result.status, Status::infeasible) << method;
        EXPECT_NEAR(s.value("transmission-angle-worst") / degree, 32.631949, 5.1e-7) << method;
        EXPECT_NEAR(s.value("swing") / degree, 60, 1e-8) << method;
        EXPECT_EQ(s.result.search.complete(), method == "auto");
    }
}

/// Where a range cuts the optimum off, the closed form leaves the problem to a search, which ends on the limit.
TEST(CrankRockers, RangesThatExcludeTheOptimumAreRespected) {
    std::string text = problem_of(rows[1]);
    text.replace(text.find("max = 500"), 9, "max =  80");
    const Solved s = solved(text);
    EXPECT_EQ(s.result.status, Status::solved);
    EXPECT_EQ(s.result.search.method, "slsqp");
    EXPECT_FALSE(s.result.search.complete());
    EXPECT_NEAR(s.dimension("coupler"), 80, 1e-9);
    EXPECT_LT(s.value("transmission-angle-worst") / degree, 45.00822);
}

TEST(CrankRockers, ScaleOfTheProblemChangesNothingElse) {
    std::string text = problem_of(rows[0]);
    const Solved one = solved(text, "slsqp");
    for (const auto& [from, to] : {std::pair<std::string, std::string>{"ground = 100.0", "ground = 102400.0"},
                                   {"min = 1, max = 200", "min = 1024, max = 204800"},
                                   {"min = 1, max = 500", "min = 1024, max = 512000"},
                                   {"min = 1, max = 500", "min = 1024, max = 512000"}})
        text.replace(text.find(from), from.size(), to);
    const Solved other = solved(text, "slsqp");
    for (const char* name : {"crank", "coupler", "rocker"})
        EXPECT_EQ(one.dimension(name) * 1024, other.dimension(name)) << name;
}

}  // namespace

}  // namespace mechwright
