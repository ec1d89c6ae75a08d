// Tasks of engineers amid what is in the way: the best design of each is found by two methods.

#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tests/degree.h"
#include "tests/known_optima/solved.h"

namespace mechwright {

namespace {

using testing::shipped;
using testing::Solved;
using testing::solved;

using Values = std::vector<std::pair<const char*, double>>;

struct ObstacleTask {
    const char* folder;
    const char* file;
    double optimum;
    Values near;            ///< a design near the best one
    Values given{};         ///< what is not found again, since a local search is not sure to
    bool quick_by_ipopt{};  ///< else Ipopt is tried in the long form alone

    friend std::ostream& operator<<(std::ostream& out, const ObstacleTask& task) { return out << task.file; }
};

const std::vector<ObstacleTask> obstacle_tasks{
    {"linkage",
     "garage-door.toml",
     785.427076,
     {{"a-x", -500}, {"a-y", 1192}, {"arm", 1193}, {"pin", 162}, {"across", -101}}},
    {"linkage",
     "walking-leg-clearance.toml",
     66.31638472,
     {{"rod", 37.3}, {"lower", 57.9}, {"upper", 80}, {"leg", 60}, {"origin-y", 165.5}},
     {{"f-along", -73.159734962},
      {"f-across", -100},
      {"l-x", -39.844979712},
      {"l-y", -47.051413112},
      {"u-x", -93.692596612},
      {"u-y", 78.772635322},
      {"k-x", 32.512839285},
      {"k-y", -40.742034453}}},
    {"path",
     "pick-and-place-between-walls.toml",
     66.571940574,
     {{"ground", 300},
      {"crank", 83},
      {"coupler", 215},
      {"rocker", 176},
      {"point-along", -45.5},
      {"point-across", 69.5},
      {"origin-x", 128},
      {"origin-y", 92.3},
      {"tilt", 95.4}}},
    {"linkage", "film-claw.toml", 0.049202425, {}, {}, true},
    {"four-bar", "pumping-unit.toml", 1.053481585, {{"ground", 5.4}, {"crank", 0.7}, {"coupler", 5.3}}, {}, true},
    {"function",
     "steering-turning-circle.toml",
     0.403624949,
     {{"crank", 140}, {"coupler", 1118}, {"input-start", 257}},
     {},
     true},
};

class Obstacles : public ::testing::TestWithParam<ObstacleTask> {};

TEST_P(Obstacles, LeaveTheBestDesignThatTwoMethodsFind) {
    const ObstacleTask& task = GetParam();
    for (const char* method : {"slsqp", "ipopt"}) {
        if (method == std::string_view("ipopt") && !task.quick_by_ipopt && !in_long_form()) continue;
        SCOPED_TRACE(method);
        ReadProblem read = parse_problem(shipped(task.file, task.folder), task.file);
        ASSERT_TRUE(read.messages.empty());
        const auto dimension = [&](const char* name) -> DimensionRange& {
            return read.problem.dimensions[static_cast<std::size_t>(find_dimension(*read.problem.mechanism, name))];
        };
        for (const auto& [name, value] : task.near)
            dimension(name).start = value;
        for (const auto& [name, value] : task.given)
            dimension(name).min = dimension(name).max = value;
        read.problem.solver.method = method;
        read.problem.solver.starts = 1;
        read.problem.solver.time_limit = 600;
        const Result result = solve(read.problem, {});
        ASSERT_EQ(result.status, Status::solved);
        EXPECT_TRUE(result.verified());
        EXPECT_NEAR(result.best->objective, task.optimum, 1e-7 * task.optimum);
    }
}

INSTANTIATE_TEST_SUITE_P(Of, Obstacles, ::testing::ValuesIn(obstacle_tasks), [](const auto& task) {
    std::string name;
    for (const char c : std::string_view(task.param.file).substr(0, std::string_view(task.param.file).find('.')))
        if (c != '-') name += c;
    return name;
});

/// The claw draws the film on by a frame, in the holes and out of them, by a scan of the law of cosines.
TEST(Obstacles, TheClawIsStraightOverTheStrokeAndBesideItAfterwards) {
    const Solved s = solved(shipped("film-claw.toml", "linkage"), "slsqp", 1, 2, 1);
    ASSERT_EQ(s.result.status, Status::solved);
    const double ground = s.dimension("ground"), lead = s.dimension("lead"), crank = s.dimension("crank"),
                 coupler = s.dimension("coupler"), rocker = s.dimension("rocker");
    const auto range = [&](bool down, double degrees) {
        constexpr int steps = 100000;
        double least = 1e300, greatest = -1e300;
        for (int i = 0; i <= steps; ++i) {
            const double angle = degrees * degree * i / steps;
            const double x = ground * std::cos(lead) - crank * std::cos(angle),
                         y = ground * std::sin(lead) - crank * std::sin(angle), d = std::hypot(x, y);
            const double turn = std::atan2(y, x) +
                                std::acos((d * d + coupler * coupler - rocker * rocker) / (2 * d * coupler)) +
                                s.dimension("turn");
            const double along = s.dimension("along"), across = s.dimension("across"),
                         drawn = angle + s.dimension("turn");
            const double at = down ? crank * std::sin(drawn) + along * std::sin(turn) + across * std::cos(turn)
                                   : crank * std::cos(drawn) + along * std::cos(turn) - across * std::sin(turn);
            least = std::min(least, at);
            greatest = std::max(greatest, at);
        }
        return greatest - least;
    };
    EXPECT_NEAR(range(true, 150), 7.605, 1e-7);
    EXPECT_NEAR(range(false, 150) / 2, s.result.best->objective, 1e-8);
    EXPECT_NEAR(range(false, 360), 2.5, 1e-7);
    EXPECT_LT(range(true, 360), 8.5);
}

/// The blade sweeps a part of a ring that lies on the screen, so that the widest swing leaves least: that of the
/// built-in kind, with pivots as far from each other and a lever as long.
TEST(Obstacles, AScreenIsWipedByTheWidestSwing) {
    const Solved wiper = solved(shipped("wiper-on-screen.toml", "linkage"), "slsqp", 1, 2, 1);
    ASSERT_EQ(wiper.result.status, Status::solved);
    EXPECT_TRUE(wiper.result.verified());
    const Solved swing = solved(R"(schema = 1
mechanism = "four-bar"
[dimensions]
ground  = { min = 80, max = 310.48349392520047 }
crank   = { min = 20, max = 80 }
coupler = { min = 80, max = 400 }
rocker  = 60
[[require]]
quantity = "transmission-angle-worst"
min = 40
[objective]
maximize = "swing"
[solver]
starts = 8
)",
                                "ipopt");
    ASSERT_EQ(swing.result.status, Status::solved);
    const double ring = (550.0 * 550 - 170.0 * 170) / 2, screen = 500 * (1120.0 + 880) / 2;
    EXPECT_NEAR(wiper.result.best->objective, screen - ring * swing.value("swing"), 1e-7 * screen);
}

}  // namespace

}  // namespace mechwright
