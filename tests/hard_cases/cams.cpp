// Cams at their limits: a roller as large as the pitch curve's radius, a pitch curve that turns hollow, joints with
// dwells, a prime circle a hair from its least size. Values stay finite and on the right side.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

std::string cam_text(const std::string& follower, const std::string& law, const std::string& dimensions) {
    return "schema = 1\nmechanism = \"cam\"\n[cam]\nfollower = \"" + follower +
           "\"\n[[segment]]\nkind = \"rise\"\nangle = 60\nlift = 20\nlaw = \"" + law +
           "\"\n[[segment]]\nkind = \"dwell\"\nangle = 30\n[[segment]]\nkind = \"return\"\nangle = 120\nlift = 20\nlaw "
           "= "
           "\"cycloidal\"\n[[segment]]\nkind = \"dwell\"\nangle = 150\n[dimensions]\n" +
           dimensions;
}

struct Cam {
    Problem problem;
    Design design;

    explicit Cam(const std::string& text) : problem(parse_problem(text, "hard.toml").problem) {
        design = evaluate_given(problem).design;
    }
    double value(std::string_view quantity) const {
        const int index = find_quantity(*problem.mechanism, quantity);
        return quantity_value(problem, static_cast<std::size_t>(index), design).value();
    }
    Cam with(std::string_view dimension, double length) const {
        Cam changed = *this;
        changed.design.dimensions[static_cast<std::size_t>(find_dimension(*problem.mechanism, dimension))] = length;
        return changed;
    }
};

}  // namespace

TEST(HardCams, UndercutBeginsWhereTheRollerIsAsLargeAsTheRadius) {
    const Cam knife(cam_text("knife", "cycloidal", "prime-radius = 40\n"));
    const double radius = knife.value("pitch-radius-min");
    const Cam roller(cam_text("roller", "cycloidal", "prime-radius = 40\nroller-radius = 1\n"));
    EXPECT_NEAR(roller.with("roller-radius", radius).value("undercut-margin"), 0, 1e-15);
    for (int k = 10; k <= 45; k += 5) {
        const double hair = std::ldexp(1, -k);
        EXPECT_NEAR(roller.with("roller-radius", radius * (1 - hair)).value("undercut-margin"), hair, 4e-16);
        EXPECT_NEAR(roller.with("roller-radius", radius * (1 + hair)).value("undercut-margin"), -hair, 4e-16);
        EXPECT_NEAR(roller.with("roller-radius", radius * (1 - hair)).value("profile-radius-min"), radius * hair,
                    1e-14 * radius);
    }
}

// The prime radius at which the pitch curve first turns hollow, by bisection of the motion table's radius.
TEST(HardCams, APitchCurveMayTurnHollow) {
    const Cam cams(cam_text("roller", "cycloidal", "prime-radius = 40\nroller-radius = 5\n"));
    for (double size = 20; size < 4000; size *= 1.01) {
        const Cam one = cams.with("prime-radius", size);
        for (const char* quantity :
             {"pitch-radius-min", "profile-radius-min", "undercut-margin", "pressure-angle-max", "cam-size"})
            EXPECT_TRUE(std::isfinite(one.value(quantity))) << quantity << " at " << size;
        EXPECT_LT(one.value("undercut-margin"), 1);
        EXPECT_LT(one.value("pitch-radius-min"), size + 20 + 1e-9);
    }
}

TEST(HardCams, APrimeCircleAHairFromTheLimitIsOnTheRightSide) {
    // Closed form of the in-line cycloidal rise under 30 deg.
    const double t = 2 * std::numbers::pi * std::sqrt(3.0) / (std::numbers::pi / 3);
    const double least = 20 / std::numbers::pi * (t - std::atan(t)), limit = std::numbers::pi / 6;
    const Cam cams(cam_text("knife", "cycloidal", "prime-radius = 40\n"));
    EXPECT_NEAR(cams.with("prime-radius", least).value("pressure-angle-rise"), limit,
                4e-16);  // the size itself is rounded
    for (int k = 10; k <= 48; k += 2) {
        const double hair = std::ldexp(1, -k);
        EXPECT_LT(cams.with("prime-radius", least * (1 + hair)).value("pressure-angle-rise"), limit) << k;
        EXPECT_GT(cams.with("prime-radius", least * (1 - hair)).value("pressure-angle-rise"), limit) << k;
    }
}

TEST(HardCams, DwellsJoinWithoutATrace) {
    for (const char* law :
         {"cycloidal", "modified-sine", "modified-trapezoid", "3-4-5", "4-5-6-7", "modified-constant-velocity"}) {
        const Cam one(cam_text("roller", law, "prime-radius = 60\nroller-radius = 5\n"));
        EXPECT_NEAR(one.value("velocity-jump"), 0, 1e-13) << law;
        EXPECT_NEAR(one.value("acceleration-jump"), 0, 1e-12) << law;
    }
    const Cam harmonic(cam_text("roller", "harmonic", "prime-radius = 60\nroller-radius = 5\n"));
    EXPECT_NEAR(harmonic.value("acceleration-jump"),
                std::pow(std::numbers::pi, 2) / 2 * 20 / std::pow(std::numbers::pi / 3, 2), 1e-12);
}

TEST(HardCams, SizesFromTinyToHugeAreTheSameCam) {
    const Cam one(cam_text("roller", "modified-sine", "prime-radius = 40\noffset = 4\nroller-radius = 5\n"));
    for (const int k : {-40, -20, 20, 40}) {
        Cam scaled = one;
        const auto& kinds = scaled.problem.mechanism->dimensions;
        for (std::size_t i = 0; i < kinds.size(); ++i)
            if (scales(kinds[i].kind)) scaled.design.dimensions[i] = std::ldexp(scaled.design.dimensions[i], k);
        for (const char* quantity : {"pressure-angle-rise", "pressure-angle-return", "undercut-margin"})
            EXPECT_EQ(scaled.value(quantity), one.value(quantity)) << quantity;
        EXPECT_EQ(scaled.value("pitch-radius-min"), std::ldexp(one.value("pitch-radius-min"), k));
        EXPECT_EQ(scaled.value("cam-size"), std::ldexp(one.value("cam-size"), k));
    }
}

// Under a flat face the cam comes to a cusp where base radius + s + s'' is zero.
TEST(HardCams, AFlatFaceMakesACuspAtZeroRadius) {
    const Cam cams(cam_text("flat", "cycloidal", "base-radius = 40\n"));
    const double cusp = 40 - cams.value("profile-radius-min");
    EXPECT_NEAR(cams.with("base-radius", cusp).value("profile-radius-min"), 0, 1e-13);
    EXPECT_LT(cams.with("base-radius", cusp * (1 - 1e-12)).value("undercut-margin"), 0);
    EXPECT_GT(cams.with("base-radius", cusp * (1 + 1e-12)).value("undercut-margin"), 0);
}

}  // namespace mechwright
