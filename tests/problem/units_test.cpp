#include "synthesis/problem/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace mechwright {
namespace {

const Units degrees{true, "mm"};
const Units radians{false, "in"};

TEST(Units, EveryWholeAndHalfDegreeComesOutAsItWasWritten) {
    for (int halves = -1440; halves <= 1440; ++halves) {
        const double written = 0.5 * halves;
        EXPECT_EQ(in_file_unit(from_file_unit(written, Unit::angle, degrees), Unit::angle, degrees), written);
    }
}

TEST(Units, DecimalDegreesComeOutAsTheyWereWritten) {
    for (const double written : {0.1, 0.3, 12.345678, 59.9999, 1e-6, 123.456789012345, -77.7, 1e-300})
        EXPECT_EQ(in_file_unit(from_file_unit(written, Unit::angle, degrees), Unit::angle, degrees), written);
}

TEST(Units, AnglesReadBackAsTheSameRadians) {
    double angle = 1e-3;
    for (int i = 0; i < 2000; ++i) {
        angle = std::fmod(angle * 1.618033988749895 + 0.1, 2 * std::numbers::pi);
        const double again = from_file_unit(in_file_unit(angle, Unit::angle, degrees), Unit::angle, degrees);
        EXPECT_NEAR(again, angle, 2.3e-16 * angle);
    }
}

TEST(Units, OnlyAnglesInDegreesAreConverted) {
    EXPECT_EQ(in_file_unit(1.25, Unit::length, degrees), 1.25);
    EXPECT_EQ(in_file_unit(1.25, Unit::area, degrees), 1.25);
    EXPECT_EQ(in_file_unit(1.25, Unit::none, degrees), 1.25);
    EXPECT_EQ(in_file_unit(1.25, Unit::angle, radians), 1.25);
    EXPECT_EQ(from_file_unit(1.25, Unit::angle, radians), 1.25);
}

TEST(Units, NumbersThatAreNotFiniteStaySo) {
    EXPECT_TRUE(std::isnan(in_file_unit(std::nan(""), Unit::angle, degrees)));
    EXPECT_TRUE(std::isinf(in_file_unit(INFINITY, Unit::angle, degrees)));
}

TEST(Units, Labels) {
    EXPECT_EQ(unit_label(Unit::angle, degrees), "deg");
    EXPECT_EQ(unit_label(Unit::angle, radians), "rad");
    EXPECT_EQ(unit_label(Unit::length, radians), "in");
    EXPECT_EQ(unit_label(Unit::area, degrees), "mm^2");
    EXPECT_EQ(unit_label(Unit::curvature, degrees), "1/mm");
    EXPECT_EQ(unit_label(Unit::none, degrees), "");
}

TEST(Units, ALabelCannotCommandTheTerminal) {
    const std::string label = unit_label(Unit::length, Units{true, "m\x1b[2J"});
    EXPECT_EQ(label.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace mechwright
