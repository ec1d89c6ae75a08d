// Tolerances of finished designs.

#include "synthesis/study/tolerance.h"

#include <cmath>

#include "analysis/numbers/low_discrepancy.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/study/allocation.h"
#include "synthesis/study/iso_tolerances.h"
#include "tests/study/studies.h"

namespace mechwright::testing {
namespace {

/// ISO 286-1: values of its table, at the ends of steps too; millimetres.
TEST(IsoTolerance, IsThatOfTheTable) {
    EXPECT_EQ(iso_tolerance(7, 25), 0.021);
    EXPECT_EQ(iso_tolerance(7, 30), 0.021);
    EXPECT_EQ(iso_tolerance(7, 30.001), 0.025);
    EXPECT_EQ(iso_tolerance(6, 50), 0.016);
    EXPECT_EQ(iso_tolerance(8, 3), 0.014);
    EXPECT_EQ(iso_tolerance(11, 100), 0.220);
    EXPECT_EQ(iso_tolerance(5, 500), 0.027);
    EXPECT_EQ(iso_tolerance(7, 501), 0.070);
    EXPECT_DOUBLE_EQ(*iso_tolerance(13, 3150), 3.3);
    EXPECT_FALSE(iso_tolerance(7, 3151));
    EXPECT_FALSE(iso_tolerance(4, 25));
    EXPECT_FALSE(iso_tolerance(7, 0));
}

/// From grade 6 on a tolerance is that of the standard's unit i = 0.45 D^(1/3) + 0.001 D (micrometres), above 500 mm
/// I = 0.004 D + 2.1, times 10, 16,
/// 25, 40, 64, 100, 160, 250, D the geometric mean of the step; rounded to whole micrometres up to grade 11, from then
/// on ten times the rounded value of five grades below.
TEST(IsoTolerance, FollowsTheStandardsFormula) {
    const std::vector<double> ends{3,   6,   10,  18,  30,   50,   80,   120,  180,  250, 315,
                                   400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150};
    const std::vector<double> factors{10, 16, 25, 40, 64, 100, 160, 250};
    for (std::size_t grade = 0; grade < factors.size(); ++grade)
        for (std::size_t k = 1; k < ends.size(); ++k) {
            const double d = std::sqrt(ends[k] * ends[k - 1]);
            const double unit = d < 500 ? 0.45 * std::cbrt(d) + 0.001 * d : 0.004 * d + 2.1;
            const double formula = factors[grade] * unit;
            EXPECT_NEAR(*iso_tolerance(static_cast<int>(grade) + 6, ends[k]) * 1000, formula, 0.5 + 0.05 * formula);
        }
}

/// ISO 2768-1, table 1: limit deviations, of which the zone is twice as wide.
TEST(GeneralTolerance, IsThatOfTheTable) {
    EXPECT_EQ(general_tolerance(1, 30), 0.2);
    EXPECT_EQ(general_tolerance(2, 30.1), 0.6);
    EXPECT_EQ(general_tolerance(2, 400), 1.0);
    EXPECT_EQ(general_tolerance(3, 1500), 6.0);
    EXPECT_EQ(general_tolerance(4, 4000), 16.0);
    EXPECT_FALSE(general_tolerance(1, 2500));  // f ends at 2000 mm
    EXPECT_FALSE(general_tolerance(4, 2));     // v begins above 3 mm
    EXPECT_FALSE(general_tolerance(2, 0.4));
    EXPECT_FALSE(general_tolerance(5, 30));
    EXPECT_FALSE(general_tolerance(0, 30));
}

TolerancedDesign design_of(const PreparedStudy& study) {
    std::string why;
    auto design = toleranced_design(study, {}, why);
    if (!design) throw std::runtime_error(why);
    return *design;
}

/// Exact gradients against central differences.
TEST(Sensitivities, AreTheDerivatives) {
    const TemporaryFolder folder;
    const std::string path_file = folder.write("path.toml", R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 30
crank = 10
coupler = 28
rocker = 25
point-along = 12
point-across = 9
origin-x = 1
origin-y = 2
tilt = 20
crank-start = 15
[path]
points = [[10, 20], [5, 22], [0, 18]]
timing = "prescribed"
crank_angles = [0, 40, 80]
[study]
count = 10
[study.tolerance]
lengths = { normal = 0.01 }
)");
    for (const std::string& file : {shipped("crank-rocker-tolerances"), path_file}) {
        const PreparedStudy study = prepared(file);
        const TolerancedDesign design = design_of(study);
        const auto& dimensions = design.nominal.design.dimensions;
        int checked = 0;
        for (const std::string& name : study.columns.quantities) {
            const auto quantity = static_cast<std::size_t>(find_quantity(*design.problem.mechanism, name));
            const auto gradient = sensitivities(design.problem, quantity, design.nominal.design);
            if (!gradient) continue;
            ++checked;
            for (std::size_t i = 0; i < dimensions.size(); ++i) {
                if (!design.problem.dimensions[i].named) continue;
                const double h = 1e-5 * std::max(1.0, std::abs(dimensions[i]));
                const auto at = [&](double value) {
                    Design moved = design.nominal.design;
                    moved.dimensions[i] = value;
                    if (design.problem.path)
                        for (std::size_t k = 0; k < moved.path_angles.size(); ++k)
                            moved.path_angles[k] = moved.dimensions[design.problem.mechanism->point->roles.start] +
                                                   design.problem.path->crank_angles[k];
                    return *quantity_value(design.problem, quantity, moved);
                };
                const double difference = (at(dimensions[i] + h) - at(dimensions[i] - h)) / (2 * h);
                EXPECT_NEAR((*gradient)[i], difference, 1e-6 * std::max(1.0, std::abs(difference))) << name << ' ' << i;
            }
        }
        EXPECT_GE(checked, 9);
    }
}

/// Small deviations: samples and sensitivities must agree as far as so many samples can tell.
TEST(Tolerances, SpreadAsTheSensitivitiesPredict) {
    const TemporaryFolder folder;
    for (const std::string distribution : {"normal", "uniform"}) {
        const std::string file = folder.write(
            distribution + ".toml", changed(shipped("crank-rocker-tolerances"),
                                            {{"lengths = \"IT7\"", "lengths = { " + distribution + " = 0.001 }"}}));
        const std::filesystem::path data = folder / (distribution + ".sqlite");
        run_to_end(file, data);
        const PreparedStudy study = prepared(file);
        const ToleranceReport report = tolerance_report(study, design_of(study), data);
        EXPECT_EQ(report.samples, 20000u);
        EXPECT_EQ(report.assembled, 20000u);
        EXPECT_NEAR(report.standard_deviations[0], distribution == "normal" ? 0.001 : 0.001 / std::sqrt(3), 1e-15);
        int compared = 0;
        for (const QuantitySpread& s : report.quantities) {
            if (!s.first_order) continue;
            ++compared;
            EXPECT_NEAR(s.deviation, *s.first_order, 0.03 * *s.first_order) << s.quantity;
            EXPECT_NEAR(s.mean, s.nominal, 4 * s.deviation / std::sqrt(20000) + 1e-6 * std::abs(s.nominal))
                << s.quantity;
            EXPECT_LT(s.least, s.low);
            EXPECT_LT(s.low, s.high);
            EXPECT_LT(s.high, s.greatest);
        }
        EXPECT_GE(compared, 9);
    }
}

/// Pieces with all dimensions at the ends of their zones, each on the side that makes a quantity greater, or less.
TEST(Tolerances, AreWorstWithAllZonesAtTheirEnds) {
    const TemporaryFolder folder;
    const std::string file = folder.write(
        "a.toml", changed(shipped("crank-rocker-tolerances"),
                          {{"lengths = \"IT7\"", "lengths = { uniform = 0.001 }\ncrank = { normal = 0.0002 }"}}));
    const std::filesystem::path data = folder / "a.sqlite";
    run_to_end(file, data);
    const PreparedStudy study = prepared(file);
    const TolerancedDesign design = design_of(study);
    int compared = 0;
    for (const QuantitySpread& s : tolerance_report(study, design, data).quantities) {
        if (s.derivatives.empty()) continue;
        const auto quantity = static_cast<std::size_t>(find_quantity(*design.problem.mechanism, s.quantity));
        std::vector<double> ends;
        for (std::size_t i = 0; i < s.derivatives.size(); ++i)
            ends.push_back(std::copysign(study.study->deviations[i].uniform ? 0.001 : 0.0006, s.derivatives[i]));
        const auto value_at = [&](double side) {
            std::vector<Off> offs;
            for (const double end : ends)
                offs.push_back({side * end, 0});
            const Design piece = piece_of(design, *study.study, offs).solution.design;
            const double value = *quantity_value(design.problem, quantity, piece);
            return in_file_unit(value, design.problem.mechanism->quantities[quantity].unit, design.problem.units);
        };
        EXPECT_NEAR((value_at(1) - value_at(-1)) / 2, s.worst, 1e-3 * s.worst) << s.quantity;
        ++compared;
    }
    EXPECT_GE(compared, 9);
}

TEST(Tolerances, CountTheSamplesWithinLimits) {
    const TemporaryFolder folder;
    const std::filesystem::path data = folder / "study.sqlite";
    run_to_end(shipped("crank-rocker-tolerances"), data);
    const PreparedStudy study = prepared(shipped("crank-rocker-tolerances"));
    const ToleranceReport report = tolerance_report(study, design_of(study), data);
    ASSERT_TRUE(report.has_limits);
    // The limit lies (45.00822 - 44.99) deg below the mean of a nearly normal quantity.
    const auto worst = std::find_if(report.quantities.begin(), report.quantities.end(),
                                    [](const QuantitySpread& s) { return s.quantity == "transmission-angle-worst"; });
    const double share = 0.5 * std::erfc(-(worst->nominal - 44.99) / *worst->first_order / std::sqrt(2));
    EXPECT_NEAR(static_cast<double>(report.within_limits) / 20000, share, 4 * std::sqrt(share * (1 - share) / 20000));
}

/// With one limit the stationary point is times_i = c (weight_i / share_i)^(1 / (exponent + 2)), c such that the limit
/// is reached.
TEST(Allocation, OfOneLimitIsThatOfTheClosedForm) {
    const LimitShares shares{0.5, 2, 0.03, 7};
    const std::vector<double> weights{1, 2, 0.5, 3};
    for (const double exponent : {0.5, 1.0, 2.0}) {
        const std::vector<double> times = cheapest_tolerances({shares}, weights, exponent);
        std::vector<double> expected;
        double variance = 0;
        for (std::size_t i = 0; i < shares.size(); ++i) {
            expected.push_back(std::pow(weights[i] / shares[i], 1 / (exponent + 2)));
            variance += shares[i] * expected[i] * expected[i];
        }
        for (std::size_t i = 0; i < shares.size(); ++i)
            EXPECT_NEAR(times[i], expected[i] / std::sqrt(variance), 1e-11 * times[i]);
    }
}

/// The cost is convex: where no step that keeps the limits makes it less, none does.
TEST(Allocation, OfSeveralLimitsCannotBeBettered) {
    std::uint64_t number = 0;
    const auto random = [&number] { return std::ldexp(static_cast<double>(mixed(++number) >> 11), -53); };
    for (int trial = 0; trial < 40; ++trial) {
        const std::vector<double> weights{0.2 + random(), 0.2 + random(), 0.2 + random(), 0.2 + random()};
        std::vector<LimitShares> limits(1 + static_cast<std::size_t>(trial % 4));
        for (LimitShares& limit : limits)
            for (int i = 0; i < 4; ++i)
                limit.push_back(std::pow(10, 2 * random() - 1));
        const double exponent = 0.5 + 2 * random();
        const auto cost = [&](const std::vector<double>& times) {
            double sum = 0;
            for (std::size_t i = 0; i < times.size(); ++i)
                sum += weights[i] / std::pow(times[i], exponent);
            return sum;
        };
        const auto most_variance = [&](const std::vector<double>& times) {
            double most = 0;
            for (const LimitShares& limit : limits) {
                double variance = 0;
                for (std::size_t i = 0; i < times.size(); ++i)
                    variance += limit[i] * times[i] * times[i];
                most = std::max(most, variance);
            }
            return most;
        };
        const std::vector<double> times = cheapest_tolerances(limits, weights, exponent);
        EXPECT_NEAR(most_variance(times), 1, 1e-9);
        for (int step = 0; step < 400; ++step) {
            std::vector<double> other = times;
            for (double& one : other)
                one *= std::exp(std::pow(10, -4 * random()) * (random() - 0.5));
            const double scale = std::sqrt(most_variance(other));
            for (double& one : other)
                one /= scale;
            EXPECT_GT(cost(other), cost(times) * (1 - 1e-9));
        }
    }
}

TEST(Allocation, WidensWhatNoLimitReadsToTheEnd) {
    const std::vector<double> times = cheapest_tolerances({{4, 0}}, {1, 1}, 1);
    EXPECT_NEAR(times[0], 0.5, 1e-12);
    EXPECT_EQ(times[1], widest_times);
}

/// The study's own samples, drawn from other numbers, confirm the share; a sixth wider they miss it.
TEST(Allocation, KeepsTheShareOfPiecesWithinLimits) {
    const TemporaryFolder folder;
    const std::filesystem::path data = folder / "study.sqlite";
    const std::string file = shipped("crank-rocker-allocation");
    run_to_end(file, data);
    const PreparedStudy study = prepared(file);
    const TolerancedDesign design = design_of(study);
    const ToleranceReport report = tolerance_report(study, design, data);
    ASSERT_TRUE(report.allocated);
    EXPECT_GE(report.allocated->share, 0.9973);
    const double of_share = std::sqrt(0.9973 * 0.0027 / 20000);
    EXPECT_NEAR(static_cast<double>(report.within_limits) / 20000, 0.9973, 6 * of_share);
    EXPECT_GE(report.within_limits, 0.9973 * 20000);
    EXPECT_LT(report.allocated->cost, report.allocated->usual_cost);
    EXPECT_EQ(report.allocated->limits.back(), "time-ratio <= 1.1845");

    TolerancedDesign wider = design;
    for (double& size : wider.sizes)
        size *= 1.17;
    int within = 0;
    for (std::uint64_t number = 0; number < 20000; ++number) {
        const Solution piece = sample(wider, *study.study, number).solution;
        within += std::all_of(
            wider.problem.requirements.begin(), wider.problem.requirements.end(), [&](const Requirement& requirement) {
                const double value = *quantity_value(wider.problem, requirement.quantity, piece.design);
                return !(value < requirement.min) && !(value > requirement.max);
            });
    }
    EXPECT_LT(within / 20000.0, 0.9973 - 3 * of_share);
}

TEST(Allocation, SaysWhichLimitLeavesNoRoom) {
    const TemporaryFolder folder;
    const PreparedStudy study = prepared(
        folder.write("a.toml", changed(shipped("crank-rocker-allocation"), {{"max      = 1.1845", "max = 1.18"}})));
    std::string why;
    EXPECT_FALSE(toleranced_design(study, {}, why));
    EXPECT_NE(why.find("time-ratio <= 1.18: the design itself misses it"), std::string::npos) << why;
}

/// The first targets are met before the crank comes round, the last one after: pieces move over the same range.
TEST(Tolerances, OfARangeOfUseThatGoesPastAFullTurnAreSmall) {
    const TemporaryFolder folder;
    const PreparedStudy study = prepared(folder.write("use.toml", R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground = 100
crank = 40
coupler = 90
rocker = 80
point-along = 20
point-across = 5
assembly = "open"
[motion]
from = "first-target"
to = "last-target"
[path]
points = [[38.94831, 6.88977], [42.62152, 13.41512], [46.46387, 23.01128]]
[study]
count = 20
[study.tolerance]
lengths = { uniform = 0.001 }
)"));
    const TolerancedDesign design = design_of(study);
    const std::vector<double>& angles = design.nominal.design.path_angles;
    ASSERT_EQ(angles.size(), 3u);
    EXPECT_NEAR(angles[2] - angles[0], 25 * std::numbers::pi / 180, 1e-3);
    const auto index = static_cast<std::size_t>(find_quantity(*design.problem.mechanism, "transmission-angle-max"));
    const double nominal = quantity_value(design.problem, index, design.nominal.design).value();
    for (std::uint64_t number = 0; number < 20; ++number) {
        const Piece piece = sample(design, *study.study, number);
        for (std::size_t i = 0; i < angles.size(); ++i)
            EXPECT_NEAR(piece.solution.design.path_angles[i], angles[i], 1e-3) << i;
        EXPECT_NEAR(quantity_value(piece.problem, index, piece.solution.design).value(), nominal, 1e-4);
    }
}

TEST(Tolerances, NeedADesign) {
    const TemporaryFolder folder;
    const PreparedStudy study = prepared(
        folder.write("a.toml", changed(shipped("crank-rocker-tolerances"),
                                       {{"equal    = 60", "equal = 179.9"}, {"min      = 44.99", "min = 80"}})));
    std::string why;
    EXPECT_FALSE(toleranced_design(study, {}, why));
    EXPECT_NE(why.find("was not found"), std::string::npos);
}

}  // namespace
}  // namespace mechwright::testing
