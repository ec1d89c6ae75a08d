// The nine-point problem: its equations, its start system, and what is known of its solutions.

#include <gtest/gtest.h>

#include <complex>
#include <random>
#include <span>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/exact/homotopy/guidance_linkages.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "tests/exact/all_solutions.h"
#include "tests/long_form.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::homotopy {
namespace {

using Number = std::complex<double>;
using Points = std::array<Complex<double>, 9>;

const GuidanceSystem nine_points{};
constexpr std::size_t nine_point_triplets = 1442;

GuidanceTarget target_of(const Points& points) {
    std::vector<GuidedPlace> places;
    for (const Complex<double>& point : points)
        places.push_back({point, {}});
    return guidance_target(places);
}

/// Wampler, Morgan and Sommese 1992, Problem 3: 1442 triplets, of which 64 are real (their paper and the README of
/// TOMS algorithm 921).
const Points problem_3{{{0.25, 0},
                        {0.52, 0.10},
                        {0.80, 0.70},
                        {1.20, 1.00},
                        {1.40, 1.30},
                        {1.10, 1.48},
                        {0.70, 1.40},
                        {0.20, 1.00},
                        {0.02, 0.40}}};

std::size_t count_real(const GuidanceSolutions& found) {
    return static_cast<std::size_t>(std::count_if(found.solutions.begin(), found.solutions.end(), is_real));
}

TEST(NinePoints, AreMetByEveryMemberOfAnOrbit) {
    const StartSystem& start = start_system(nine_points);
    for (std::size_t k = 0; k < start.solutions.size(); k += 97) {
        const OrbitKey key = orbit_of(nine_points, start.solutions[k]);
        for (GuidanceValues member : orbit_members(nine_points, start.solutions[k])) {
            const GuidanceValues before = member;
            EXPECT_LT(refine(nine_points, member, start.parameters), 1e-13);
            for (std::size_t i = 0; i < member.size(); ++i)
                EXPECT_LT(norm(member[i] - before[i]), 1e-18 * (1 + norm(member[i])) * 1e4);
            EXPECT_TRUE(is_same(orbit_of(nine_points, member), key));
        }
    }
}

/// From nothing: the count is that of the literature, for three seeds.
TEST(StartSystem, IsMadeByMonodromy) {
    for (int seed = 11; seed < 11 + cases_to_try(1, 3); ++seed) {
        const StartSystem start =
            make_start_system(nine_points, static_cast<std::uint64_t>(seed), 2, 60, nine_point_triplets, {});
        ASSERT_EQ(start.solutions.size(), nine_point_triplets) << seed;
        const ReadStart read = parse_start_system(to_text(start, static_cast<std::uint64_t>(seed)));
        ASSERT_TRUE(read.start) << read.fault;
        const auto found = solve_guidance(*read.start, target_of(problem_3).parameters, 2);
        EXPECT_EQ(found.solutions.size(), nine_point_triplets);
        EXPECT_EQ(count_real(found), 64u);
    }
}

/// But for the last digits of the mathematical library, of which the random numbers are made.
TEST(StartSystem, ThatComesWithTheProgramIsTheOneItMakes) {
    const StartSystem made = make_start_system(nine_points, 1, 2, 60, nine_point_triplets, {});
    const StartSystem& shipped = start_system(nine_points);
    for (std::size_t i = 0; i < made.parameters.size(); ++i)
        EXPECT_LE(norm(made.parameters[i] - shipped.parameters[i]), 1e-24 * norm(shipped.parameters[i]));
    SeenOrbits seen;
    for (std::size_t i = 0; i < shipped.solutions.size(); ++i)
        EXPECT_FALSE(seen.find_or_keep(orbit_of(nine_points, shipped.solutions[i]), i));
    ASSERT_EQ(made.solutions.size(), shipped.solutions.size());
    for (const GuidanceValues& solution : made.solutions)
        EXPECT_TRUE(seen.find_or_keep(orbit_of(nine_points, solution), 0));
}

TEST(StartSystem, ThatIsDamagedIsNamed) {
    const std::string text = to_text(start_system(nine_points), 1);
    const auto fault = [](const std::string& damaged) { return parse_start_system(damaged).fault; };
    EXPECT_EQ(fault(text), "");
    EXPECT_NE(fault("").find("another version"), std::string::npos);
    EXPECT_NE(fault("// mechwright start system: nine-point, version 2\n").find("another version"), std::string::npos);
    EXPECT_NE(fault(text.substr(0, text.size() / 2)).find("damaged"), std::string::npos);
    std::string changed = text;
    changed[text.size() / 2] = 'x';
    EXPECT_NE(fault(changed).find("damaged"), std::string::npos);
    // A digit in the middle of a solution, and a solution in the place of another.
    const std::size_t line = text.rfind('\n', text.size() - 2);
    changed = text;
    char& digit = changed[changed.find_first_of("123456789", line)];
    digit = digit == '9' ? '8' : static_cast<char>(digit + 1);
    EXPECT_NE(fault(changed).find("solution 1442 is none"), std::string::npos) << fault(changed);
    const std::size_t before = text.rfind('\n', line - 1);
    EXPECT_NE(fault(text.substr(0, line + 1) + text.substr(before + 1, line - before)).find("are the same"),
              std::string::npos);
}

TEST(NinePointPaths, AreTheSameForAnyInstructionSetAndNumberOfThreads) {
    const StartSystem& start = start_system(nine_points);
    const std::vector<GuidanceValues> some(start.solutions.begin(), start.solutions.begin() + 100);
    const GuidanceParameters target = target_of(problem_3).parameters;
    const auto baseline = track(nine_points, some, start.parameters, target, {}, 1, {}, InstructionSet::baseline);
    for (const InstructionSet set : {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512}) {
        if (!is_available(set)) continue;
        for (const int jobs : {1, 2, 7}) {
            const auto paths = track(nine_points, some, start.parameters, target, {}, jobs, {}, set);
            for (std::size_t i = 0; i < some.size(); ++i)
                for (std::size_t k = 0; k < paths[i].point.size(); ++k) {
                    ASSERT_EQ(paths[i].point[k].re, baseline[i].point[k].re);
                    ASSERT_EQ(paths[i].point[k].im, baseline[i].point[k].im);
                }
        }
    }
}

TEST(NinePoints, OfProblem3Have64RealTriplets) {
    const GuidanceTarget target = target_of(problem_3);
    const GuidanceSolutions found = solve_guidance(start_system(nine_points), target.parameters, 2);
    EXPECT_EQ(found.solutions.size(), 1442u);
    EXPECT_TRUE(found.complete());
    EXPECT_EQ(count_real(found), 64u);
    int linkages = 0;
    for (const GuidanceValues& solution : found.solutions) {
        if (!is_real(solution)) continue;
        const auto members = orbit_members(nine_points, solution);
        for (std::size_t k = 0; k < members.size(); ++k) {
            const auto linkage = linkage_of(members[k], target);
            ASSERT_TRUE(linkage);
            linkages += k % 2 == 0;
            if (!linkage->one_assembly) continue;
            // The analysis, which knows nothing of the equations, passes the points.
            for (std::size_t j = 0; j < 9; ++j) {
                const auto& [links, point, placement, assembly] = linkage->linkage;
                const auto reached =
                    placed(position(links, point, pose(links, linkage->crank_angles[j], assembly)), placement);
                EXPECT_NEAR(reached.x, problem_3[j].re, 1e-7);
                EXPECT_NEAR(reached.y, problem_3[j].im, 1e-7);
            }
        }
    }
    EXPECT_EQ(linkages, 192);
}

/// Nine points of a known linkage: it must be among the solutions, and every path accounted for.
TEST(NinePoints, OfRandomFourBarsHaveThatFourBarAmongTheirSolutions) {
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> between(0, 1);
    int done = 0;
    while (done < cases_to_try(4, 12)) {
        const FourBar<double> m{1, 0.2 + between(random), 0.2 + 2 * between(random), 0.2 + 2 * between(random)};
        const CouplerPoint<double> point{2 * between(random) - 0.5, 2 * between(random) - 1};
        Points points;
        const double from = 6.28 * between(random), span = 1 + 5 * between(random);
        bool assembles = true;
        for (std::size_t j = 0; j < 9; ++j) {
            const auto p = pose(m, from + span * static_cast<double>(j) / 9, Assembly::open);
            assembles = assembles && p.margins.stretch > 1e-3 && p.margins.fold > 1e-3;
            const auto at = position(m, point, p);
            points[j] = {at.x, at.y};
        }
        if (!assembles) continue;
        ++done;
        const GuidanceTarget target = target_of(points);
        const GuidanceSolutions found = solve_guidance(start_system(nine_points), target.parameters, 2);
        EXPECT_TRUE(found.complete()) << done;
        bool generated = false;
        for (const GuidanceValues& solution : found.solutions) {
            if (!is_real(solution)) continue;
            for (const GuidanceValues& member : orbit_members(nine_points, solution)) {
                const auto linkage = linkage_of(member, target);
                if (!linkage) continue;
                const FourBar<double>& links = linkage->linkage.links;
                generated = generated || (std::abs(links.ground - m.ground) + std::abs(links.crank - m.crank) +
                                              std::abs(links.coupler - m.coupler) + std::abs(links.rocker - m.rocker) <
                                          1e-5);
            }
        }
        EXPECT_TRUE(generated) << done;
    }
}

/// Points that lie on curves of their own: whole families meet them, or none does. The account has to be true.
TEST(NinePoints, ThatAreSpecialComeToAnEnd) {
    Points line, circle, ellipse, twice = problem_3, symmetric;
    for (std::size_t j = 0; j < 9; ++j) {
        const auto t = static_cast<double>(j);
        line[j] = {t, 0};
        circle[j] = {std::cos(0.5 * t), std::sin(0.5 * t)};
        ellipse[j] = {2 * std::cos(0.6 * t), std::sin(0.6 * t)};
        symmetric[j] = {t - 4, (t - 4) * (t - 4) * (t - 4)};
    }
    twice[5] = twice[1];
    const std::vector<Points> special{circle, twice, line, ellipse, symmetric};
    for (const Points& points : std::span(special).first(static_cast<std::size_t>(cases_to_try(2, 5)))) {
        const GuidanceSolutions found = solve_guidance(start_system(nine_points), target_of(points).parameters, 2);
        EXPECT_EQ(found.solutions.size() + found.at_infinity + found.singular + found.lost, 1442u);
        EXPECT_EQ(found.complete(), found.lost == 0);
        SeenOrbits seen;
        for (std::size_t i = 0; i < found.solutions.size(); ++i)
            EXPECT_FALSE(seen.find_or_keep(orbit_of(nine_points, found.solutions[i]), i));
    }
}

Problem nine_point_problem(const std::string& points) {
    const ReadProblem read = parse_problem(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + free_four_bar(100) + "[path]\npoints = " + points + R"(
[objective]
minimize = "total-length"
[solver]
method = "exact"
)",
        "p.toml");
    EXPECT_TRUE(read.ok());
    return read.problem;
}

TEST(ExactMethod, SinglesOutTheUsableLinkageOfProblem3) {
    const Problem problem = nine_point_problem(
        "[[0.25, 0], [0.52, 0.10], [0.80, 0.70], [1.20, 1.00], [1.40, 1.30], [1.10, 1.48], [0.70, 1.40], [0.20, "
        "1.00], "
        "[0.02, 0.40]]");
    RunOptions options;
    options.jobs = 2;
    options.all = true;
    const Result result = solve(problem, options);
    EXPECT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.search.complete());
    ASSERT_TRUE(result.search.solutions);
    EXPECT_EQ(result.search.solutions->real, 64u);
    // One triplet, of which two cognates with a crank can be driven.
    EXPECT_EQ(result.search.solutions->defect_free, 2u);
    EXPECT_EQ(result.alternatives.size(), 1u);
    EXPECT_EQ(result.excluded.size(), 64u * 6 - 2);
    EXPECT_NEAR(result.best->objective, 2.6374391, 1e-6);
    for (std::size_t i = 0; i < result.excluded.size(); ++i)
        EXPECT_FALSE(result.excluded[i].defect.empty());
    options.all = false;
    EXPECT_TRUE(solve(problem, options).excluded.empty());
}

TEST(ExactMethod, SaysWhyItDoesNotApply) {
    const std::string nine = "[[0,0],[1,0],[2,1],[3,1],[4,2],[5,1],[6,0],[5,-1],[3,-2]]";
    EXPECT_EQ(why_not_applicable("exact", nine_point_problem(nine)), "");
    const std::string ten = why_not_applicable(
        "exact", nine_point_problem("[[0,0],[1,0],[2,1],[3,1],[4,2],[5,1],[6,0],[5,-1],[3,-2],[1,-2]]"));
    EXPECT_NE(ten.find("there are 10"), std::string::npos);
    EXPECT_NE(ten.find("least-squares"), std::string::npos);
    const std::string twice =
        why_not_applicable("exact", nine_point_problem("[[0,0],[1,0],[2,1],[0,0],[4,2],[5,1],[6,0],[5,-1],[3,-2]]"));
    EXPECT_NE(twice.find("points 1 and 4 are the same"), std::string::npos);
}

}  // namespace
}  // namespace mechwright::homotopy
