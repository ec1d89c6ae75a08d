// Velocities and accelerations at one instant, and extreme velocity ratios.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/four_bar.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/solve/solve.h"
#include "tests/degree.h"

namespace mechwright {
namespace {

Problem four_bar_problem(const std::string& ground, const std::string& rest) {
    const ReadProblem read =
        parse_problem("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = " + ground +
                          "\ncrank = { min = 0, max = 100000 }\ncoupler = { min = 0, max = 100000 }\n"
                          "rocker = { min = 0, max = 100000 }\nassembly = \"either\"\n" +
                          rest,
                      "p.toml");
    EXPECT_TRUE(read.ok()) << (read.messages.empty() ? "" : read.messages.front().text);
    return read.problem;
}

std::string instant(const std::array<double, 3>& velocity, const std::array<double, 3>& acceleration) {
    return fmt::format(
        "[instant]\nvelocity = {{ crank = {}, coupler = {}, rocker = {} }}\nacceleration = {{ crank = {}, coupler = "
        "{}, "
        "rocker = {} }}\n",
        velocity[0], velocity[1], velocity[2], acceleration[0], acceleration[1], acceleration[2]);
}

struct InstantOfTextbook {
    std::array<double, 3> velocity, acceleration;
    double crank, coupler, rocker, ground;
};

/// Theory of Machines, chapter 9: example 9-1, exercises 9-1 and 9-2, each digit as computed from the data.
TEST(Instants, OfTheTextbookGiveItsLinkages) {
    const std::vector<InstantOfTextbook> cases{
        {{6, 1, 3}, {0, 10, 5}, 25.709920, 61.773781, 67.082039, 30.413813},
        {{6, 1, 4}, {0, 8, 4}, 30.463092, 53.665631, 56.603887, 30.265492},
        {{-3, 1, 3}, {0, 10, 6}, 24.738634, 56.920998, 32.310989, 60},
    };
    for (const InstantOfTextbook& c : cases) {
        const Result result =
            solve(four_bar_problem(fmt::format("{}", c.ground), instant(c.velocity, c.acceleration)), {});
        ASSERT_EQ(result.status, Status::solved);
        EXPECT_TRUE(result.search.complete());
        const auto& d = result.best->design.dimensions;
        // The ground link is given to eight digits.
        EXPECT_NEAR(d[1], c.crank, 2e-6);
        EXPECT_NEAR(d[2], c.coupler, 2e-6);
        EXPECT_NEAR(d[3], c.rocker, 2e-6);
    }
}

/// Velocities and accelerations of random linkages give those linkages.
TEST(Instants, OfRandomLinkagesGiveThem) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> between(0, 1);
    RunOptions with_defects;
    with_defects.all = true;
    for (int k = 0; k < 200;) {
        const FourBar<double> m{1, 0.2 + between(random), 0.2 + 2 * between(random), 0.2 + 2 * between(random)};
        const double angle = 6.28 * between(random);
        const Assembly assembly = k % 2 == 0 ? Assembly::open : Assembly::crossed;
        const auto p = pose(m, angle, assembly);
        if (!(p.margins.stretch > 1e-2 && p.margins.fold > 1e-2)) continue;
        ++k;
        const double speed = 4 * between(random) - 2.5, rate = 3 * between(random);
        const auto v = velocity(m, p, speed);
        const auto a = acceleration(m, p, v, rate);
        const Result result =
            solve(four_bar_problem("1", instant({speed, v.coupler, v.rocker}, {rate, a.coupler, a.rocker})), {});
        ASSERT_EQ(result.status, Status::solved)
            << k << ' ' << (result.excluded.empty() ? result.note : result.excluded.front().defect);
        const auto& d = result.best->design.dimensions;
        EXPECT_NEAR(d[1], m.crank, 1e-7) << k;
        EXPECT_NEAR(d[2], m.coupler, 1e-7) << k;
        EXPECT_NEAR(d[3], m.rocker, 1e-7) << k;
        EXPECT_NEAR(std::remainder(d[9] - angle, 360 * degree), 0, 1e-7) << k;
        EXPECT_EQ(result.best->design.assembly, assembly == Assembly::open ? 0u : 1u);
    }
}

/// With fewer rates than dimensions the search takes its place, and both agree where both apply.
TEST(Instants, AreRequirementsForEveryMethod) {
    const std::string asked = instant({-3, 1, 3}, {0, 10, 6});
    for (const char* method : {"slsqp", "ipopt"}) {
        Problem problem = four_bar_problem("{ min = 10, max = 100 }", asked);
        problem.solver.method = method;
        const Result result = solve(problem, {});
        ASSERT_EQ(result.status, Status::solved) << method;
        const auto& d = result.best->design.dimensions;
        EXPECT_NEAR(d[1] / d[0], 24.738634 / 60, 1e-7);
        EXPECT_NEAR(d[2] / d[0], 56.920998 / 60, 1e-7);
    }
    const Problem part =
        four_bar_problem("100",
                         "[instant]\nvelocity = { crank = 1, rocker = 0.3 }\nacceleration = { rocker = 0 }\n"
                         "[objective]\nmaximize = \"transmission-angle-worst\"\n");
    EXPECT_NE(why_not_applicable("exact", part), "");
    const Result result = solve(part, {});
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verified());
}

TEST(Instants, ThatMakeNoSenseAreNamed) {
    const auto fault = [](const std::string& section) {
        const ReadProblem read = parse_problem(
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 1\ncrank = 1\ncoupler = 1\nrocker = 1\n" +
                section,
            "p.toml");
        return read.messages.empty() ? std::string() : read.messages.front().text;
    };
    EXPECT_NE(fault("[instant]\nvelocity = { rocker = 1 }\n").find("that of the crank not 0"), std::string::npos);
    EXPECT_NE(fault("[instant]\nvelocity = { crank = 0, rocker = 1 }\n").find("not 0"), std::string::npos);
    EXPECT_NE(fault("[instant]\nvelocity = { crank = 1 }\n").find("coupler or of the rocker"), std::string::npos);
    EXPECT_NE(
        fault("[instant]\nvelocity = { crank = 1, rocker = 1 }\nacceleration = { coupler = 1 }\n").find("same link"),
        std::string::npos);
    EXPECT_NE(fault("[instant]\nvelocity = { crank = 1, rockr = 1 }\n").find("rocker"), std::string::npos);
    EXPECT_NE(fault("[[require]]\nquantity = \"instant-rocker-velocity\"\nequal = 1\n").find("[instant]"),
              std::string::npos);
}

/// Theory of Machines, example 9-3: greatest velocity ratio 0.619 on a ground link of 16 with a crank of at least 4.
/// Its solutions have angles and distances of their own choice; this one is its (20 deg, 60).
TEST(ExtremeVelocityRatios, OfTheTextbookIsOneOfTheFamily) {
    const FourBar<double> m{16, 9.433079, 10.565507, 16.260150};
    EXPECT_NEAR(velocity_ratio(m, 129.523341 * degree, Assembly::open), 0.619, 1e-6);
    EXPECT_NEAR(velocity_ratio_slope(m, 129.523341 * degree, Assembly::open), 0, 1e-6);
    for (const char* objective : {"maximize = \"transmission-angle-worst\"", "minimize = \"link-ratio\""}) {
        Problem problem =
            four_bar_problem("16", std::string("[[require]]\nquantity = \"velocity-ratio-max\"\nequal = 0.619\n"
                                               "[objective]\n") +
                                       objective + "\n[solver]\nmethod = \"exact\"\n");
        problem.dimensions[1].min = 4;
        const Result result = solve(problem, {});
        ASSERT_EQ(result.status, Status::solved);
        EXPECT_TRUE(result.verified());
        problem.solver.method = "slsqp";
        const Result other = solve(problem, {});
        ASSERT_EQ(other.status, Status::solved);
        EXPECT_NEAR(result.best->objective, other.best->objective, 1e-4 * std::abs(other.best->objective)) << objective;
    }
}

/// Extremes of either sign and sense; a ratio of 2.2 is that of problems/four-bar/drag-link-velocity-ratio.toml.
TEST(ExtremeVelocityRatios, AreMetExactly) {
    for (const auto& [quantity, ratio] :
         {std::pair{"velocity-ratio-max", 2.2}, std::pair{"velocity-ratio-max", 0.4},
          std::pair{"velocity-ratio-min", -0.7}, std::pair{"velocity-ratio-min", 0.45}}) {
        const Problem problem =
            four_bar_problem("30", fmt::format("[[require]]\nquantity = \"{}\"\nequal = {}\n[objective]\nmaximize = "
                                               "\"transmission-angle-worst\"\n[solver]\nmethod = \"exact\"\n",
                                               quantity, ratio));
        const Result result = solve(problem, {});
        ASSERT_EQ(result.status, Status::solved) << quantity << ratio;
        EXPECT_TRUE(result.verified());
        // A scan of the motion by the analysis comes to the same extreme.
        const auto& d = result.best->design.dimensions;
        const FourBar<double> m{d[0], d[1], d[2], d[3]};
        const Assembly assembly = result.best->design.assembly == 0 ? Assembly::open : Assembly::crossed;
        double least = 1e300, greatest = -1e300;
        for (int i = 0; i < 100000; ++i) {
            const double r = velocity_ratio(m, 2e-5 * 3.14159265358979 * i, assembly);
            least = std::min(least, r);
            greatest = std::max(greatest, r);
        }
        ASSERT_TRUE(motion_of(problem, result.best->design).full_turn);
        EXPECT_NEAR(std::string(quantity) == "velocity-ratio-max" ? greatest : least, ratio, 1e-6);
    }
    EXPECT_NE(why_not_applicable("exact",
                                 four_bar_problem("30", "[[require]]\nquantity = \"velocity-ratio-max\"\nequal = 1\n")),
              "");
}

}  // namespace
}  // namespace mechwright
