// Tolerances of finished designs.

#include "synthesis/study/tolerance.h"

#include <cmath>

#include "synthesis/program/quantity_value.h"
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
