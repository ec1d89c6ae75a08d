// Linkages that guide a point or a body: against the built-in four-bar, differences and known optima.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <string>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/program.h"
#include "synthesis/solve/solve.h"
#include "tests/checked.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_near;
using testing::expect_slopes;
using testing::expect_verified;
using testing::first_error;
using testing::four_bar_links;
using testing::free_four_bar;
using testing::head;
using testing::is_refused;
using testing::read_without_fault;

const std::string with_poses = R"(
[poses]
point = "P"
link = "coupler"
body-angle = { min = 0, max = 360 }
poses = [[0, 0, 0], [1, 2, 10], [2, 3, 20]]
)";

/// Room for what a pose misses, with all derivatives by ten dimensions and the crank angle.
struct Room {
    std::array<std::array<double, 11>, 4> gradient{};
    std::array<std::array<double, 66>, 4> hessian{};

    PoseMiss miss() {
        PoseMiss made{};
        made.place = {{}, 0, gradient[0], gradient[1], hessian[0], hessian[1]};
        made.turn = {{}, 0, gradient[2], gradient[3], hessian[2], hessian[3]};
        return made;
    }
};

}  // namespace

TEST(LinkageTargets, MissesOfAFourBarAreThoseOfTheBuiltInKind) {
    const ReadProblem read = read_without_fault(free_four_bar + with_poses);
    ASSERT_TRUE(read.ok());
    const Mechanism& own = *read.problem.mechanism;
    const auto built_in = find_mechanism("four-bar");
    // ground, crank, coupler, rocker, along, across, origin, tilt and the body's angle: the built-in kind's order.
    ASSERT_EQ(own.body->reads.size(), 10u);
    ASSERT_EQ(built_in->body->reads.size(), 10u);
    std::mt19937_64 random(7);
    const auto between = [&](double low, double high) { return std::uniform_real_distribution<>(low, high)(random); };
    int compared = 0;
    for (int i = 0; i < 200; ++i) {
        std::array<double, 10> d{between(1, 10), between(0.5, 10), between(1, 10), between(1, 10), between(-5, 5),
                                 between(-5, 5), between(-9, 9),   between(-9, 9), between(0, 6),  between(0, 6)};
        const double angle = between(-3, 9);
        const Vector<double> target{between(-5, 5), between(-5, 5)}, facing{std::cos(1.0), std::sin(1.0)};
        for (std::size_t assembly = 0; assembly < 2; ++assembly) {
            Room room, known;
            PoseMiss miss = room.miss(), expected = known.miss();
            own.body->miss(own.form(assembly), d, angle, target, facing, miss);
            built_in->body->miss(built_in->form(assembly), d, angle, target, facing, expected);
            // Beside a toggle derivatives lose the digits that the root of the margin has not.
            if (expected.place.margin < 0.05) {
                EXPECT_EQ(miss.place.margin < 0, expected.place.margin < 0);
                continue;
            }
            ++compared;
            EXPECT_NEAR(miss.place.miss.x, expected.place.miss.x, 1e-13);
            EXPECT_NEAR(miss.place.miss.y, expected.place.miss.y, 1e-13);
            EXPECT_NEAR(miss.turn.miss.x, expected.turn.miss.x, 1e-13);
            EXPECT_NEAR(miss.turn.miss.y, expected.turn.miss.y, 1e-13);
            for (std::size_t c = 0; c < 4; ++c) {
                expect_near(room.gradient[c], known.gradient[c], 1e-10, "slope");
                expect_near(room.hessian[c], known.hessian[c], 1e-8, "curvature");
            }
            // The point and the direction in fifty digits, by the equations of all joints.
            const std::vector<Digits50> precise(d.begin(), d.end() - 1);
            const Vector<Digits50> at = own.point->point(own.form(assembly), precise, angle);
            EXPECT_NEAR((target.x - at.x).convert_to<double>(), miss.place.miss.x, 1e-12);
            EXPECT_NEAR((target.y - at.y).convert_to<double>(), miss.place.miss.y, 1e-12);
            const double direction = own.body->direction(own.form(assembly), precise, angle).convert_to<double>();
            EXPECT_NEAR(facing.x - std::cos(direction + d[9]), miss.turn.miss.x, 1e-12);
        }
    }
    EXPECT_GT(compared, 100);
}

/// Quantities over an input range whose ends are arguments.
TEST(LinkageTargets, QuantitiesKnowThatEndsOfTheMotionMove) {
    const std::string signals = R"(
[signals]
swing = { angle = "rocker" }
height = { y = "P" }
[[require]]
quantity = "height.mean"
min = -100
)";
    for (const double range : {1.3, -1.3}) {
        const std::vector<double> arguments{7, 2, 6, 5, 2, 1, 0.3, -0.4, 0.5, 0.9, range};
        for (const auto& [followed, target] :
             {std::pair(Followed::nothing, "[path]\npoint = \"P\"\npoints = [[0, 0], [1, 2], [2, 3]]\n"),
              {Followed::line, "[line]\npoint = \"P\"\nstart = 0\nrange = 90\n"},
              {Followed::arc, "[arc]\npoint = \"P\"\nstart = 0\nrange = 90\n"}}) {
            const ReadProblem read = read_without_fault(free_four_bar + signals + target);
            ASSERT_TRUE(read.ok());
            const Mechanism& m = *read.problem.mechanism;
            Motion motion;
            motion.followed = followed;
            for (const Quantity& quantity : m.input->quantities)
                expect_slopes(m, quantity, motion, arguments);
            expect_slopes(m, m.input->margin, motion, arguments);
            std::vector<double> with_shape = arguments;
            const auto& shape = followed == Followed::line ? m.line : m.arc;
            for (const double number : {0.4, 1.2, 2.5})
                if (shape && with_shape.size() < arguments.size() + shape->numbers.size()) with_shape.push_back(number);
            for (const Quantity& quantity : shape ? shape->quantities : std::vector<Quantity>{})
                expect_slopes(m, quantity, motion, with_shape);
        }
    }
}

namespace {

/// A Stephenson six-bar of which some dimensions are to be found.
std::string six_bar(const std::string& found, const std::string& target) {
    return head + "[dimensions]\n" + found + R"(
[links]
frame   = { A = [0, 0], D = [100, 0], F = [160, 120] }
crank   = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = [110, 0], P = [55, 60] }
rocker  = { D = [0, 0], C = [80, 0] }
rod     = { P = [0, 0], E = ["rod", 0], T = ["tip", 10] }
output  = { F = [0, 0], E = [100, 0] }
[drive]
link = "crank"
[assembly]
C = "left"
E = "left"
[path]
point = "T"
)" + target;
}

Json solved(const std::string& text) {
    const ReadProblem read = read_without_fault(text);
    return read.ok() ? document(read.problem, solve(read.problem, {})) : Json();
}

/// T's places with the crank 40, the rod 120 and the tip 150 long at crank angles 20, 60, ... 180 deg: by the law of
/// cosines for C and E, in Python.
const std::string timed_points = R"(
points = [[106.884913, 233.349826], [124.895599, 240.154498], [117.4034, 231.700178], [98.383879, 210.687572],
          [83.587153, 180.227431]]
timing = "prescribed"
crank_angles = [20, 60, 100, 140, 180]
crank-start = { min = -20, max = 20 }
)";

}  // namespace

/// Places written with six digits: the six-bar that made them is found again, to these.
TEST(LinkageTargets, ASixBarIsFoundByTheTimedPointsThatItMade) {
    const std::string target =
        timed_points + "[objective]\nminimize = \"path-rms\"\n[solver]\nmethod = \"slsqp\"\nstarts = 2\n";
    const Json found =
        solved(six_bar("crank = { min = 30, max = 50 }\nrod = { min = 90, max = 150 }\n"
                       "tip = { min = 120, max = 180 }\n",
                       target));
    EXPECT_EQ(found["status"], "solved");
    EXPECT_LT(found["objective"]["value"].get<double>(), 1e-6);
    EXPECT_NEAR(found["design"]["crank"].get<double>(), 40, 1e-5);
    EXPECT_NEAR(found["design"]["rod"].get<double>(), 120, 1e-5);
    EXPECT_NEAR(found["design"]["crank-start"].get<double>(), 0, 1e-5);
    expect_verified(found);
    Json changed = found;
    changed["path"]["reached"][2][0] = changed["path"]["reached"][2][0].get<double>() + 1e-4;
    EXPECT_TRUE(is_refused(changed));
    changed = found;
    changed["linkage"]["path"]["point"] = "P";
    EXPECT_TRUE(is_refused(changed));
    changed = found;
    changed["design"]["crank-start"] = 0.01;
    EXPECT_TRUE(is_refused(changed));
}

/// The bin of problems/poses/tipper.toml on a four-bar that is described by its links, from near the known optimum,
/// 4.22912 mm, with a transmission angle at its limit over the motion.
TEST(LinkageTargets, TheTippersOptimumIsThatOfTheBuiltInKind) {
    const Json found = solved(head + R"(
[dimensions]
ground = { min = 10, max = 2000, start = 1040 }
crank = { min = 10, max = 2000, start = 520 }
coupler = { min = 10, max = 2000, start = 560 }
rocker = { min = 10, max = 2000, start = 1020 }
along = { min = -2000, max = 2000, start = -10 }
across = { min = -2000, max = 2000, start = -50 }
[placement]
origin-x = { min = -2000, max = 2000, start = 460 }
origin-y = { min = -2000, max = 2000, start = -60 }
tilt = { min = 0, max = 360, start = 56 }
)" + four_bar_links + R"(
[motion]
crank_range = [0, 360]
[poses]
point = "P"
link = "coupler"
body-angle = { min = 0, max = 360, start = 278 }
timing = "prescribed"
crank_angles = [114.26, 100.79, 83.72, 65.58, 46.65, 28.26, 12.61, -0.08]
crank-start = { min = -10, max = 10 }
poses = [[0, 0, 0], [40, 120, 5], [120, 260, 12], [240, 380, 25], [390, 460, 45], [540, 490, 70], [660, 470, 95],
         [740, 420, 115]]
length = 200
[[require]]
quantity = "transmission-angle-worst"
min = 20
[objective]
minimize = "pose-rms"
[solver]
method = "slsqp"
starts = 1
)");
    EXPECT_EQ(found["status"], "solved");
    // Prescribed angles, rounded to a hundredth of a degree, can be met a little worse than free ones.
    EXPECT_NEAR(found["objective"]["value"].get<double>(), 4.22912, 1e-4);
    EXPECT_GT(found["objective"]["value"].get<double>(), 4.229119);
    expect_verified(found);
}

/// The lambda linkage over half a turn, of which the coupler is as long as the rocker and half as long as its whole
/// bar: ground 2.21525, half the band 1.8712205e-3 (problems/line/hoekens-180.toml).
TEST(LinkageTargets, TheLambdaLinkagesOptimumIsThatOfTheBuiltInKind) {
    const Json found = solved(head + R"(
[dimensions]
ground = { min = 1, max = 10 }
coupler = { min = 1, max = 10 }
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = [1, 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["2 coupler", 0] }
rocker = { D = [0, 0], C = ["coupler", 0] }
[drive]
link = "crank"
[line]
point = "P"
start = 90
range = 180
full_turn = true
[objective]
minimize = "line-deviation"
[solver]
starts = 4
)");
    EXPECT_EQ(found["status"], "solved");
    EXPECT_NEAR(found["objective"]["value"].get<double>(), 1.8712205e-3, 1e-10);
    EXPECT_NEAR(found["design"]["ground"].get<double>(), 2.21525, 1e-5);
    EXPECT_NEAR(found["quantities"]["line-length"].get<double>(), 4.19321, 1e-5);
    expect_verified(found);
    Json changed = found;
    changed["design"]["line-offset"] = changed["design"]["line-offset"].get<double>() + 1e-5;
    EXPECT_TRUE(is_refused(changed));
}

TEST(LinkageTargets, WrongOnesAreSaidWithARemedy) {
    const auto error = [](const std::string& target) { return first_error(free_four_bar + target); };
    const std::string points = "points = [[0, 0], [1, 2], [2, 3]]\n";
    EXPECT_EQ(error("[path]\n" + points),
              "'point' in [path] is missing: name the point that is guided, like point = \"P\"");
    EXPECT_NE(error("[path]\npoint = \"Q\"\n" + points).find("'Q'"), std::string::npos);
    EXPECT_EQ(error("[path]\npoint = \"D\"\n" + points),
              "'D' is a point of the frame, which does not move: name one that does");
    EXPECT_EQ(error("[path]\npoint = \"P\"\nlink = \"rocker\"\n" + points),
              "'P' is no point of the link 'rocker': name one of that link, or another link");
    EXPECT_NE(error("[poses]\npoint = \"P\"\nposes = [[0, 0, 0], [1, 2, 3]]\n").find("'link' in [poses]"),
              std::string::npos);
    EXPECT_NE(error("[path]\npoint = \"P\"\n" + points + with_poses).find("'name' in [path] is missing"),
              std::string::npos);
    EXPECT_NE(error("[line]\nstart = 0\nrange = 90\n").find("'point' in [line] is missing"), std::string::npos);
    EXPECT_NE(error("[path]\npoint = \"P\"\ncrank-strat = 3\n" + points).find("crank-start"), std::string::npos);
    EXPECT_NE(error("[[path]]\npoint = \"P\"\n" + points + "[[path]]\npoint = \"C\"\n" + points), "");
    EXPECT_NE(error("[objective]\nminimize = \"path-rms\"\n"), "");
}

}  // namespace mechwright
