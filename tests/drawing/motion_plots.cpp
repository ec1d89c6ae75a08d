// The curves that plots show, against the motion table and known errors.

#include "synthesis/report/drawing/motion_plots.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/drawing/motion_row.h"
#include "tests/drawing/designs.h"

namespace mechwright::testing {
namespace {

const MotionPlot& plot(const MotionPlots& plots, const std::string& title) {
    const auto found =
        std::find_if(plots.plots.begin(), plots.plots.end(), [&](const auto& one) { return one.title == title; });
    EXPECT_NE(found, plots.plots.end()) << title;
    return *found;
}

/// A shipped problem, solved: its design and document.
struct Solved {
    FinishedDesign design;
    nlohmann::ordered_json document;

    explicit Solved(const std::string& name) {
        const ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/" + name);
        const Result result = solve(read.problem, {});
        document = mechwright::document(read.problem, result);
        design = finished_design(read.problem, result.best->design);
    }
};

TEST(MotionPlots, ShowTheErrorOfAFunctionBetweenItsExtremes) {
    const Solved solved("function/power.toml");
    const MotionPlots plots = motion_plots(solved.design, solved.document, 360);
    const MotionPlot& error = plot(plots, "error of the function");
    EXPECT_EQ(error.unit, "deg");
    const std::vector<double>& values = error.curves[0].values;
    // Chebyshev's alternation: the ends of the range are extremes of opposite signs, and none is greater.
    const double greatest = solved.document["objective"]["value"];
    EXPECT_NEAR(values.front(), -greatest, 1e-7);
    EXPECT_NEAR(values.back(), greatest, 1e-7);
    for (const double value : values)
        EXPECT_LE(std::abs(value), greatest + 1e-7);
    ASSERT_EQ(error.levels.size(), 2u);
    EXPECT_EQ(error.levels[0].value, greatest);
    EXPECT_EQ(error.levels[1].value, -greatest);
}

TEST(MotionPlots, ShowTheDistanceFromALine) {
    const Solved solved("line/lambda-120.toml");
    const MotionPlots plots = motion_plots(solved.design, solved.document, 720);
    const std::vector<double>& values = plot(plots, "distance from the line").curves[0].values;
    double greatest = 0;
    for (const double value : values)
        if (std::isfinite(value)) greatest = std::max(greatest, std::abs(value));
    const double deviation = solved.document["quantities"]["line-deviation"];
    EXPECT_NEAR(greatest, deviation, 1e-3 * deviation);
    EXPECT_LE(greatest, deviation * (1 + 1e-9));
    // The motion is the range over which the line is to be followed.
    EXPECT_TRUE(std::isfinite(values.front()) && std::isfinite(values.back()));
    EXPECT_NEAR(plots.angles.back() - plots.angles.front(), 120, 1e-9);
}

TEST(MotionPlots, HaveTheValuesOfTheTableInTheUnitsOfTheFile) {
    const FinishedDesign design = given(drag_link_text);
    const MotionPlots plots = motion_plots(design, {}, 90);
    const MotionPlot& velocity = plot(plots, "velocity");
    const std::vector<double> angles = even_angles(design, 90);
    for (const MotionCurve& curve : velocity.curves)
        for (std::size_t i = 0; i < angles.size(); i += 7)
            EXPECT_EQ(curve.values[i], MotionRow(design, angles[i])[curve.name]);
    for (std::size_t i = 0; i < angles.size(); ++i)
        EXPECT_NEAR(plots.angles[i], 4.0 * static_cast<double>(i), 1e-12);
}

TEST(MotionPlots, DoNotJumpWhereAnglesPassHalfATurn) {
    const FinishedDesign design = given(drag_link_text);
    const MotionPlots plots = motion_plots(design, {}, 360);
    for (const MotionPlot& one : plots.plots) {
        if (one.title != "position" || one.unit != "deg") continue;
        for (const MotionCurve& curve : one.curves)
            for (std::size_t i = 1; i < curve.values.size(); ++i)
                EXPECT_LT(std::abs(curve.values[i] - curve.values[i - 1]), 20) << curve.name;
    }
}

TEST(MotionPlots, DrawLimitsWhereTheyHold) {
    const Solved solved("cam/roller-offset.toml");
    const MotionPlots plots = motion_plots(solved.design, solved.document, 360);
    const MotionPlot& pressure = plot(plots, "pressure angle");
    ASSERT_EQ(pressure.levels.size(), 2u);
    EXPECT_EQ(pressure.levels[0].value, 30);
    EXPECT_EQ(pressure.levels[1].value, -45);
    const auto [least, greatest] =
        std::minmax_element(pressure.curves[0].values.begin(), pressure.curves[0].values.end());
    EXPECT_NEAR(*greatest, 30, 0.05);
    EXPECT_NEAR(*least, -45, 0.05);
}

TEST(MotionPlots, DrawLimitsOfQuantitiesThatThereAre) {
    const auto all = mechanisms();
    for (const std::string_view name : quantities_with_levels())
        EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const auto& m) { return find_quantity(*m, name) >= 0; }))
            << name;
}

}  // namespace
}  // namespace mechwright::testing
