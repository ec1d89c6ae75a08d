#include "synthesis/report/csv/motion_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/math/constants/constants.hpp>
#include <charconv>
#include <cmath>
#include <locale>
#include <sstream>

#include "analysis/quick_return.h"
#include "tests/report/examples.h"

namespace mechwright {
namespace {

using namespace testing;

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);)
        lines.push_back(line);
    return lines;
}

std::vector<std::string> fields_of(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, ',');)
        fields.push_back(field);
    return fields;
}

TEST(MotionTable, HasUnitsInItsHeaderAndARowForEachStep) {
    const Problem problem = problem_of(path_text);
    const auto lines = lines_of(motion_table(problem, path_solution().design, 360));
    ASSERT_EQ(lines.size(), 362u);
    EXPECT_EQ(lines[0] + "\n", motion_header(problem));
    EXPECT_EQ(fields_of(lines[0])[0], "crank-angle [deg]");
    EXPECT_NE(lines[0].find("point-x [mm]"), std::string::npos);
    for (int i = 0; i <= 360; ++i) {
        const auto fields = fields_of(lines[static_cast<std::size_t>(i) + 1]);
        ASSERT_EQ(fields.size(), fields_of(lines[0]).size());
        EXPECT_EQ(fields[0], std::to_string(i));
    }
}

TEST(MotionTable, NumbersReadBackAsTheSame) {
    const Problem problem = problem_of(path_text);
    const Design design = path_solution().design;
    const auto fields = fields_of(lines_of(motion_table(problem, design, 4))[2]);
    std::vector<double> row(problem.mechanism->table.columns.size());
    ASSERT_TRUE(problem.mechanism->table.row(Motion{}, design.dimensions, 90 * 3.141592653589793 / 180, row));
    for (std::size_t c = 0; c < row.size(); ++c) {
        if (problem.mechanism->table.units[c] == Unit::angle) continue;
        double number = 0;
        std::from_chars(fields[c].data(), fields[c].data() + fields[c].size(), number);
        EXPECT_EQ(number, row[c]) << problem.mechanism->table.columns[c];
    }
}

// With the crank on the line of ground coupler and rocker turn alike: crank / (ground + crank), or -crank / (ground -
// crank). Next to a change point the rounding of 180 and 360 deg to radians would cost half of the digits.
TEST(MotionTable, KeepsItsDigitsNextToAChangePoint) {
    constexpr std::size_t coupler_velocity = 4, rocker_velocity = 5;
    const Mechanism& mechanism = *find_mechanism("four-bar");
    std::vector<double> dimensions(mechanism.dimensions.size(), 0.0), row(mechanism.table.columns.size());
    for (const double more : {1e-6, 1e-10, 1e-15}) {
        std::copy_n(std::array{3.0, 1.0, 3.0, 1 + more}.begin(), 4, dimensions.begin());
        for (const auto& [angle, velocity] : {std::pair{180.0, 0.25}, {360.0, -0.5}, {540.0, 0.25}, {-180.0, 0.25}}) {
            ASSERT_TRUE(mechanism.table.row(Motion{}, dimensions, angle * 3.141592653589793 / 180, row));
            EXPECT_NEAR(row[coupler_velocity], velocity, 1e-14) << more << ' ' << angle;
            EXPECT_NEAR(row[rocker_velocity], velocity, 1e-14) << more << ' ' << angle;
        }
    }
    // At the dead position of a rod that just passes it, at 90 deg, the ram is as fast as the crank pin.
    constexpr std::size_t ram_velocity = 6;
    const Mechanism& slider_crank = *find_mechanism("slider-crank");
    std::vector<double> lengths(slider_crank.dimensions.size(), 0.0), of_ram(slider_crank.table.columns.size());
    std::copy_n(std::array{1.0, 1 + 1e-15}.begin(), 2, lengths.begin());
    for (const double angle : {90.0, 270.0}) {
        ASSERT_TRUE(slider_crank.table.row(Motion{}, lengths, angle * 3.141592653589793 / 180, of_ram));
        EXPECT_NEAR(std::abs(of_ram[ram_velocity]), 1, 1e-14) << angle;
    }
}

/// The row of a mechanism, its first dimensions given, at a crank angle in degrees.
std::vector<double> row_of(const std::string& name, std::vector<double> dimensions, double degrees) {
    const Mechanism& mechanism = *find_mechanism(name);
    dimensions.resize(mechanism.dimensions.size());
    std::vector<double> row(mechanism.table.columns.size());
    EXPECT_TRUE(mechanism.table.row(Motion{}, dimensions, degrees * 3.141592653589793 / 180, row)) << name;
    return row;
}

/// A crank angle in fifty digits, moved a little to the side from which the limit at a change point is taken.
Digits50 beside(double degrees) {
    const Digits50 angle = boost::math::constants::pi<Digits50>() * degrees / 180;
    return degrees > 0 ? angle - 1e-20 : angle + 1e-20;
}

void expect_limits(const std::vector<double>& row, std::size_t column, const std::vector<Digits50>& limits) {
    for (const Digits50& limit : limits) {
        EXPECT_NEAR(row[column], limit.convert_to<double>(), 1e-14) << "column " << column;
        ++column;
    }
}

TEST(MotionTable, HasTheLimitsOfVelocitiesAndAccelerationsAtAChangePoint) {
    // In one line at 180 deg, at both, at 0 deg.
    const std::vector<std::pair<std::vector<double>, std::vector<double>>> linkages{
        {{4, 2, 3, 3}, {180, -180, 540}}, {{3, 1, 3, 1}, {180, 0, 360}}, {{4, 1, 5, 2}, {0, 360}}};
    for (const auto& [d, angles] : linkages) {
        for (const double angle : angles) {
            SCOPED_TRACE(angle);
            const FourBar<Digits50> m{d[0], d[1], d[2], d[3]};
            const auto p = pose(m, half_turn(beside(angle)), Assembly::open);
            const auto v = velocity(m, p);
            const auto a = acceleration(m, p, v);
            expect_limits(row_of("four-bar", d, angle), 4, {v.coupler, v.rocker, a.coupler, a.rocker});
            const DragLink<Digits50> drag{m, 2, 0.5, 7, 0.25, 0.5, Assembly::open};
            std::vector<double> dimensions = d;
            dimensions.insert(dimensions.end(), {2, 0.5, 7, 0.25, 0.5});
            const auto q = pose(drag, half_turn(beside(angle)));
            const auto w = velocity(drag, q);
            const auto b = acceleration(drag, q, w);
            const auto row = row_of("drag-link", dimensions, angle);
            expect_limits(row, 7, {b.input.rocker, w.output.rod, b.output.rod});
            expect_limits(row, 11, {w.output.ram, b.output.ram});
        }
    }
    for (const double angle : {90, 270, -90}) {
        const SliderCrank<Digits50> m{2, 2, 0};
        const auto p = pose(m, beside(angle));
        const auto v = velocity(m, p);
        const auto a = acceleration(m, p, v);
        const auto row = row_of("slider-crank", {2, 2, 0}, angle);
        expect_limits(row, 3, {v.rod, a.rod});
        expect_limits(row, 6, {v.ram, a.ram});
    }
}

TEST(MotionTable, CoversALimitedRangeFromEndToEnd) {
    Problem problem = problem_of(path_text);
    problem.crank_range = {0.5235987755982988, 2.0943951023931953};
    const auto lines = lines_of(motion_table(problem, path_solution().design, 9));
    ASSERT_EQ(lines.size(), 11u);
    for (std::size_t i = 1; i < lines.size(); ++i)
        EXPECT_EQ(fields_of(lines[i])[0], std::to_string(20 + 10 * i));
}

TEST(MotionTable, ADoubleRockerStaysWithinItsAssembledRange) {
    Design design = path_solution().design;
    design.dimensions = {100, 80, 40, 90, 0, 0, 0, 0, 0, 0};
    const auto lines = lines_of(motion_table(problem_of(path_text), design, 100));
    EXPECT_GE(lines.size(), 100u);  // rounding may take the two ends
    EXPECT_LE(lines.size(), 102u);
    for (const std::string& line : lines)
        EXPECT_EQ(line.find("nan"), std::string::npos) << line;
}

TEST(MotionTable, WithoutMotionOnlyTheHeader) {
    Design apart = path_solution().design;
    apart.dimensions = {100, 10, 20, 30, 0, 0, 0, 0, 0, 0};
    const Problem problem = problem_of(path_text);
    EXPECT_EQ(motion_table(problem, apart, 360), motion_header(problem));
}

TEST(MotionTable, RadiansAndOddUnitsAreNamed) {
    Problem problem = problem_of(path_text);
    problem.units = {false, "a,\"b\""};
    const std::string header = motion_header(problem);
    EXPECT_EQ(header.find("deg"), std::string::npos);
    EXPECT_NE(header.find("crank-angle [rad]"), std::string::npos);
    EXPECT_NE(header.find("\"point-x [a,\"\"b\"\"]\""), std::string::npos) << header;
}

/// A locale that writes 1.234,5.
struct CommaNumbers : std::numpunct<char> {
    char do_decimal_point() const override { return ','; }
    std::string do_grouping() const override { return "\3"; }
};

TEST(MotionTable, IsTheSameInEveryLocale) {
    const Problem problem = problem_of(path_text);
    const std::string plain = motion_table(problem, path_solution().design, 7);
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new CommaNumbers));
    const std::string again = motion_table(problem, path_solution().design, 7);
    std::locale::global(before);
    EXPECT_EQ(again, plain);
}

}  // namespace
}  // namespace mechwright
