// Four-bars among the links of six-bars: their coupler points are the guided points, and searches begin about them.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/mechanism/linkage/targets/guiding_part.h"
#include "synthesis/search/path/known_parts.h"
#include "synthesis/search/path/trials_about_parts.h"
#include "tests/mechanism/six_bar_with_point.h"

namespace mechwright {

namespace {

using namespace testing;

constexpr PartDimensions some_four_bar{100, 30, 90, 70, 35, 50, -12, 8, 0.7};

/// Where a four-bar's coupler point is in the drawing.
Vector<double> point_of_four_bar(const PartDimensions& d, bool open, double angle) {
    const FourBar<double> m{d[0], d[1], d[2], d[3]};
    const auto at =
        position(m, CouplerPoint<double>{d[4], d[5]}, pose(m, angle, open ? Assembly::open : Assembly::crossed));
    return placed(at, Placement<double>{{d[6], d[7]}, d[8]});
}

/// Puts a four-bar into a six-bar as one of its parts, with the other links as they are: the six-bar has to draw the
/// four-bar's curve, wherever it assembles.
void expect_drawn_by(const Problem& problem, const GuidingPart& part) {
    const LinkageModel& model = model_in(problem);
    const auto with = with_part(model, part, some_four_bar, all_free(problem), some_dimensions(problem));
    ASSERT_TRUE(with) << "it cannot be put in";
    constexpr double within = 1e-12 * 200;  // of the size of the curve and where it is
    int compared = 0;
    for (std::size_t assembly = 0; assembly < model.sides.size(); ++assembly)
        for (double angle = 0; angle < 6.28; angle += 0.1) {
            const bool open = model.sides[assembly][part.choice] == part.open;
            const auto at = drawn_point(problem, with->dimensions, assembly, angle + with->crank_angle);
            if (!at) continue;
            ++compared;
            const Vector<double> expected = point_of_four_bar(some_four_bar, open, angle);
            EXPECT_NEAR(at->x, expected.x, within);
            EXPECT_NEAR(at->y, expected.y, within);
        }
    EXPECT_GT(compared, 20);
}

/// The number of parts of a six-bar, after a look at each of them.
std::size_t parts_that_guide(const Problem& problem) {
    const std::vector<GuidingPart> parts = guiding_parts(model_in(problem));
    for (const GuidingPart& part : parts)
        expect_drawn_by(problem, part);
    return parts.size();
}

TEST(GuidingParts, OfSixBarsGuideTheirPointsAsFourBarsDo) {
    // The coupler itself, with P on E; and the dyad, with E on B and F on D where these are not on crank and frame.
    EXPECT_EQ(parts_that_guide(six_bar_with_point_on_rod("coupler", "rocker")), 2U);  // Watt's first kind
    EXPECT_EQ(parts_that_guide(six_bar_with_point_on_rod("coupler", "frame")), 2U);   // Stephenson's third
    EXPECT_EQ(parts_that_guide(six_bar_with_point_on_rod("crank", "rocker")), 1U);    // Stephenson's first
}

TEST(GuidingParts, HoldThePointThatIsOnTheirCoupler) {
    // P is on the coupler of the four-bar, which is a part as it is.
    for (const char* f_on : {"rocker", "frame"}) {
        const Problem problem = six_bar_with_point("coupler", f_on, "coupler");
        const std::vector<GuidingPart> parts = guiding_parts(model_in(problem));
        ASSERT_EQ(parts.size(), 1U);
        EXPECT_TRUE(parts.front().joined.empty());
        expect_drawn_by(problem, parts.front());
    }
}

TEST(GuidingParts, AreNoneWhereThePointIsOnNoCoupler) {
    // It goes round the rocker's pivot.
    EXPECT_TRUE(guiding_parts(model_in(six_bar_with_point("coupler", "frame", "rocker"))).empty());
}

TEST(GuidingParts, AreNoneOfStephensonsSecondKind) {
    // Its plate, its rods and the rocker are placed together.
    const ReadProblem read = parse_problem(R"(schema = 1
mechanism = "linkage"
[links]
frame  = { A = [0, 0], G = [5, 0] }
crank  = { A = [0, 0], B = [1, 0.3], C = [0.4, -0.8] }
upper  = { B = [0, 0], D = [3, 0] }
lower  = { C = [0, 0], E = [3.4, 0] }
plate  = { D = [0, 0], E = [0.7, -1.1], F = [1.6, 0.2], P = ["p-x", "p-y"] }
rocker = { G = [0, 0], F = [2.5, 0] }
[dimensions]
p-x = { min = -3, max = 3 }
p-y = { min = -3, max = 3 }
[drive]
link = "crank"
[sketch]
crank  = 0
points = { D = [3.9, 1], F = [5.4, 2.4] }
[path]
point = "P"
timing = "free"
points = [[0, 0], [1, 0], [2, 1]]
[objective]
minimize = "path-rms"
)",
                                           "six-bar.toml");
    ASSERT_TRUE(read.messages.empty()) << to_string(read.messages.front());
    EXPECT_TRUE(guiding_parts(model_in(read.problem)).empty());
}

TEST(GuidingParts, HaveTheRangesOfTheLinkage) {
    const Problem problem = six_bar_with_point_on_rod("coupler", "rocker");
    std::vector<double> least, greatest;
    for (const DimensionRange& range : problem.dimensions) {
        least.push_back(range.min);
        greatest.push_back(range.max);
    }
    const LinkageModel& model = model_in(problem);
    const PartRanges ranges = ranges_of_part(model, guiding_parts(model).front(), least, greatest);
    EXPECT_DOUBLE_EQ(ranges.least[1], 5);
    EXPECT_DOUBLE_EQ(ranges.greatest[1], 400);
    EXPECT_DOUBLE_EQ(ranges.greatest[2], 400);
    EXPECT_DOUBLE_EQ(ranges.least[3], 5);
}

TEST(GuidingParts, HaveCognatesOnTheSamePath) {
    const PartDimensions other = cognate_of_part(some_four_bar);
    for (double angle = 0; angle < 6.28; angle += 0.3) {
        const Vector<double> one = point_of_four_bar(some_four_bar, true, angle);
        const Vector<double> same = point_of_four_bar(other, false, angle);
        EXPECT_NEAR(same.x, one.x, 1e-10);
        EXPECT_NEAR(same.y, one.y, 1e-10);
    }
}

/// Points of a four-bar's curve, at crank angles from 0 on, as the path of a problem; each off by as much to either
/// side.
void set_path_of_four_bar(double off, Problem& problem) {
    PathTarget& path = *problem.path;
    path.points.clear();
    path.crank_angles.clear();
    path.prescribed_timing = true;
    for (int i = 0; i < 16; ++i) {
        const double angle = 0.35 * i;
        path.points.push_back(point_of_four_bar(some_four_bar, true, angle) +
                              Vector<double>{i % 2 == 0 ? off : -off, i % 3 == 0 ? off : -off});
        path.crank_angles.push_back(angle);
    }
    path.weights.assign(path.points.size(), 1);
    DimensionRange& start = problem.dimensions[problem.mechanism->point->roles.start];
    start.min = 0;
    start.max = 6.3;
}

RunOptions with_two_jobs() {
    RunOptions options;
    options.jobs = 2;
    return options;
}

constexpr auto no_deadline = std::chrono::steady_clock::time_point::max();

TEST(StartsAboutParts, AreTheBestFourBarsWhateverTheOtherLinksAre) {
    Problem problem = six_bar_with_point_on_rod("coupler", "frame");
    set_path_of_four_bar(0, problem);
    std::vector<Program> programs;
    for (const Variant& variant : variants(problem))
        programs.push_back(build_program(problem, variant));
    long evaluations = 0;
    const auto parts = known_parts(problem, programs, {}, no_deadline, 6000, evaluations);
    EXPECT_GT(evaluations, 0);
    double least = 1e30;
    for (std::size_t p = 0; p < programs.size(); ++p) {
        if (parts[p].empty()) continue;
        DrawCounts counts;
        PathResiduals rest;
        for (const Eigen::VectorXd& x : DrawnStarts(programs[p], 1, parts[p]).of_round(0, 2, 10, 400, counts))
            if (path_residuals(programs[p], x, false, rest)) least = std::min(least, rest.value.norm());
        EXPECT_EQ(counts.preferred, 0);
    }
    EXPECT_LT(least, 1e-6);
}

TEST(StartsAboutParts, LeadToDesignsAsGoodAsTheFourBarAlone) {
    for (const double off : {0.0, 1.0}) {
        Problem problem = six_bar_with_point_on_rod("coupler", off == 0 ? "rocker" : "frame");
        set_path_of_four_bar(off, problem);
        const RunOptions options = with_two_jobs();
        PathRounds rounds(problem, options, no_deadline);
        const std::vector<Trial> trials = trials_about_parts(rounds, 6000);
        ASSERT_FALSE(trials.empty());
        EXPECT_TRUE(rounds.assessed(trials.front()).feasible);
        EXPECT_LT(trials.front().outcome.objective, off == 0 ? 1e-12 : 16 * 2 * off * off);
        EXPECT_EQ(rounds.report.sources.drawn, 0);
        EXPECT_EQ(rounds.report.sources.four_bars, rounds.report.optimised);
        EXPECT_GT(rounds.report.optimised, 0);
    }
}

TEST(StartsAboutParts, LeaveTheRoundsWhatTheyAre) {
    Problem problem = six_bar_with_point_on_rod("coupler", "rocker");
    set_path_of_four_bar(1, problem);
    problem.solver.starts = 1;
    const RunOptions options = with_two_jobs();
    PathRounds alone(problem, options, no_deadline), after(problem, options, no_deadline);
    const long before = after.report.evaluations;
    EXPECT_FALSE(trials_about_parts(after, 4000).empty());
    EXPECT_GT(after.report.evaluations, before);
    EXPECT_LT(after.report.evaluations, before + 2 * 4000);
    const std::vector<Trial> one = alone.trials_of(0), other = after.trials_of(0);
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i)
        EXPECT_EQ(one[i].outcome.x, other[i].outcome.x);
    EXPECT_EQ(alone.report.sources.drawn, after.report.sources.drawn);
}

TEST(StartsAboutParts, AreNoneWhereThereIsNoPart) {
    Problem problem = six_bar_with_point("coupler", "frame", "rocker");
    set_path_of_four_bar(1, problem);
    const RunOptions options{};
    PathRounds rounds(problem, options, no_deadline);
    EXPECT_TRUE(trials_about_parts(rounds, 12000).empty());
    EXPECT_EQ(rounds.report.evaluations, 0);
}

}  // namespace

}  // namespace mechwright
