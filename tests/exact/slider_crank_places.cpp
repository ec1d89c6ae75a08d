// Slider-cranks through points, and through poses among them.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "analysis/slider_crank.h"
#include "synthesis/exact/exact.h"
#include "synthesis/exact/homotopy/guidance_linkages.h"
#include "synthesis/exact/place_family.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "tests/degree.h"
#include "tests/exact/all_solutions.h"
#include "tests/long_form.h"

namespace mechwright {
namespace {

struct MadeRod {
    SliderCrank<double> links;
    CouplerPoint<double> point;
    Placement<double> placement;
    double start = 0;     ///< the crank angle at the first place
    std::string targets;  ///< the section of them
};

/// Places of a random slider-crank whose crank turns fully, over part of a turn, the first of them poses; at given
/// crank angles if that is asked for.
MadeRod random_rod(std::mt19937_64& random, std::size_t poses, std::size_t points, bool timed = false) {
    std::uniform_real_distribution<double> between(0, 1);
    MadeRod made{{1, 2 + 2 * between(random), between(random) - 0.5},
                 {3 * between(random), 0.3 + between(random)},
                 {{between(random), between(random)}, 6 * between(random) - 3},
                 6.28 * between(random),
                 {}};
    const double from = made.start, span = 3 + 2 * between(random);
    const std::size_t count = poses + points;
    std::string list, angles;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = from + span * static_cast<double>(i) / static_cast<double>(count);
        const auto p = pose(made.links, angle);
        const Vector<double> at = placed(position(made.links, made.point, p), made.placement);
        list += fmt::format("[{:.17g}, {:.17g}", at.x, at.y);
        if (i < poses) list += fmt::format(", {:.17g}", (std::atan2(p.rod.y, p.rod.x) + made.placement.tilt) / degree);
        list += "], ";
        angles += fmt::format("{:.17g}, ", (angle - from) / degree);
    }
    made.targets = poses > 0 ? "[poses]\nposes = [" + list + "]" : "[path]\npoints = [" + list + "]";
    made.targets += timed ? "\ntiming = \"prescribed\"\ncrank_angles = [" + angles + "]" : "\ntiming = \"free\"";
    return made;
}

ReadProblem slider_crank_through(const std::string& more, const std::string& targets, const std::string& objective) {
    std::string text = "schema = 1\nmechanism = \"slider-crank\"\n[dimensions]\n";
    for (const char* length : {"crank", "rod"})
        text += fmt::format("{} = {{ min = 0, max = 100 }}\n", length);
    for (const char* coordinate : {"offset", "point-along", "point-across", "origin-x", "origin-y"})
        text += fmt::format("{} = {{ min = -100, max = 100 }}\n", coordinate);
    text += "tilt = { min = -180, max = 180 }\n" + more + targets + "\n[objective]\n" + objective +
            "\n[solver]\nmethod = \"exact\"\nstarts = 2\n";
    return parse_problem(text, "p.toml");
}

const std::string best_transmission = "maximize = \"transmission-angle-worst\"";

double off(const MadeRod& made, const Design& design) {
    const auto& d = design.dimensions;
    return std::abs(d[0] - made.links.crank) + std::abs(d[1] - made.links.rod) + std::abs(d[2] - made.links.offset);
}

/// As exactly as the longest of the links lets rounding do it.
void expect_met(const Problem& problem, const Design& design) {
    const double longest = std::max({1.0, design.dimensions[0], design.dimensions[1]});
    EXPECT_LT(path_values(problem, design)->greatest, 1e-9 * longest);
}

struct SliderPlaces {
    std::size_t poses, points;
};

class SliderCrankPlaces : public ::testing::TestWithParam<SliderPlaces> {};

INSTANTIATE_TEST_SUITE_P(Of, SliderCrankPlaces,
                         ::testing::Values(SliderPlaces{0, 8}, SliderPlaces{1, 7}, SliderPlaces{2, 5},
                                           SliderPlaces{3, 3}, SliderPlaces{4, 1}),
                         [](const auto& tested) {
                             return fmt::format("{}Poses{}Points", tested.param.poses, tested.param.points);
                         });

TEST_P(SliderCrankPlaces, AreMetByTheSliderCrankThatMadeThemAmongAll) {
    const auto [poses, points] = GetParam();
    std::mt19937_64 random(61 + poses);
    for (int k = 0; k < cases_to_try(1, 10); ++k) {
        const MadeRod made = random_rod(random, poses, points);
        const std::string body = poses > 0 ? "body-angle = { min = -180, max = 180 }\n" : "";
        const ReadProblem read = slider_crank_through(body, made.targets, best_transmission);
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        const Result result = all_solutions(read.problem);
        ASSERT_EQ(result.status, Status::solved);
        EXPECT_TRUE(result.verified());
        EXPECT_TRUE(result.search.complete());
        ASSERT_TRUE(result.search.solutions);
        const homotopy::GuidanceSystem system{std::max<std::size_t>(poses, 1), homotopy::SecondDyad::ram};
        EXPECT_EQ(result.search.solutions->distinct, homotopy::orbits_of(system));
        EXPECT_EQ(result.search.solutions->certified, result.search.solutions->real);
        double nearest = off(made, result.best->design);
        for (const auto& other : result.alternatives)
            nearest = std::min(nearest, off(made, other.solution.design));
        EXPECT_LT(nearest, 1e-6);
        expect_met(read.problem, result.best->design);
    }
}

/// Of points alone the cognate passes them too: it has the same crank pivot, and the point's distance from the crank
/// pin as its crank.
TEST(SliderCrankPlaces, AreMetByTheCognate) {
    using S = homotopy::GuidanceSystem;
    const S eight_points{1, homotopy::SecondDyad::ram};
    const homotopy::StartSystem& start = homotopy::start_system(eight_points);
    for (std::size_t k = 0; k < start.solutions.size(); k += 31) {
        const auto members = homotopy::orbit_members(eight_points, start.solutions[k]);
        ASSERT_EQ(members.size(), 2u);
        homotopy::GuidanceValues cognate = members[1];
        EXPECT_LT(homotopy::refine(eight_points, cognate, start.parameters), 1e-13);
        for (std::size_t i = 0; i < cognate.size(); ++i)
            EXPECT_LT(norm(cognate[i] - members[1][i]), 1e-20 * (1 + norm(cognate[i])));
        EXPECT_TRUE(is_same(orbit_of(eight_points, cognate), orbit_of(eight_points, start.solutions[k])));
        EXPECT_GT(norm(cognate[S::x] - members[0][S::x]), 1e-6);
    }
}

struct FewPlaces {
    std::size_t poses, points, free;
};

class SliderCrankFamily : public ::testing::TestWithParam<FewPlaces> {};

INSTANTIATE_TEST_SUITE_P(Of, SliderCrankFamily,
                         ::testing::Values(FewPlaces{0, 7, 1}, FewPlaces{0, 5, 3}, FewPlaces{0, 4, 4},
                                           FewPlaces{2, 3, 2}, FewPlaces{1, 2, 5}),
                         [](const auto& tested) {
                             return fmt::format("{}Poses{}Points", tested.param.poses, tested.param.points);
                         });

/// The linkage that made the places is a member: the most compact one that is found is no larger.
TEST_P(SliderCrankFamily, HasAMemberNoLargerThanTheSliderCrankThatMadeThePlaces) {
    std::mt19937_64 random(67);
    const auto& [poses, points, free] = GetParam();
    if (!(points == 4 && poses == 0) && !in_long_form()) GTEST_SKIP() << "of the long form";
    for (int k = 0; k < cases_to_try(1, 5); ++k) {
        const MadeRod made = random_rod(random, poses, points);
        const std::string body = poses > 0 ? "body-angle = { min = -180, max = 180 }\n" : "";
        const ReadProblem read = slider_crank_through(body, made.targets, "minimize = \"total-length\"");
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        EXPECT_EQ(free_directions(read.problem), free);
        const Result result = all_solutions(read.problem);
        ASSERT_EQ(result.status, Status::solved);
        EXPECT_TRUE(result.verified());
        EXPECT_FALSE(result.search.complete());
        expect_met(read.problem, result.best->design);
        EXPECT_LT(result.best->objective, (made.links.crank + made.links.rod) * (1 + 1e-6));
    }
}

/// Four points leave one number beside the crank's start, fewer more.
TEST(SliderCrankTimedPoints, AreMetByMembersOfAFamily) {
    std::mt19937_64 random(71);
    const std::vector<std::size_t> counts =
        in_long_form() ? std::vector<std::size_t>{4, 3, 2} : std::vector<std::size_t>{4};
    for (const std::size_t count : counts) {
        const MadeRod made = random_rod(random, 0, count, true);
        const ReadProblem read =
            slider_crank_through("crank-start = { min = 0, max = 360 }\n", made.targets, "minimize = \"total-length\"");
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        const Result result = all_solutions(read.problem);
        ASSERT_EQ(result.status, Status::solved) << count;
        EXPECT_TRUE(result.verified());
        EXPECT_FALSE(result.search.complete());
        expect_met(read.problem, result.best->design);
        EXPECT_LT(result.best->objective, (made.links.crank + made.links.rod) * (1 + 1e-6)) << count;
    }
}

/// Where the start and the direction of the slide are given, four points say the rest: the slider-crank that made them
/// is found.
TEST(SliderCrankTimedPoints, SayAllWithTheDirectionsThatAreGiven) {
    std::mt19937_64 random(73);
    const MadeRod made = random_rod(random, 0, 4, true);
    ReadProblem read = slider_crank_through("crank-start = { min = 0, max = 360 }\n", made.targets, best_transmission);
    ASSERT_TRUE(read.ok());
    const PathRoles& roles = read.problem.mechanism->point->roles;
    for (const auto& [at, value] : {std::pair{roles.tilt, made.placement.tilt}, {roles.start, made.start}})
        read.problem.dimensions[at].min = read.problem.dimensions[at].max = value;
    const Result result = all_solutions(read.problem);
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verified());
    double nearest = off(made, result.best->design);
    for (const auto& other : result.alternatives)
        nearest = std::min(nearest, off(made, other.solution.design));
    EXPECT_LT(nearest, 1e-6);
}

TEST(SliderCrankPlaces, ThatAreTooManyAreCounted) {
    std::mt19937_64 random(79);
    const auto why = [&](std::size_t poses, std::size_t points, bool timed) {
        const std::string more = std::string(poses > 0 ? "body-angle = { min = -180, max = 180 }\n" : "") +
                                 (timed ? "crank-start = { min = 0, max = 360 }\n" : "");
        const ReadProblem read =
            slider_crank_through(more, random_rod(random, poses, points, timed).targets, best_transmission);
        EXPECT_TRUE(read.ok());
        return why_not_exact(read.problem);
    };
    EXPECT_NE(why(0, 9, false).find("up to eight points, and there are 9"), std::string::npos);
    EXPECT_NE(why(4, 2, false).find("there are 4 poses and 2 points"), std::string::npos);
    EXPECT_NE(why(5, 0, false).find("up to four poses, and there are 5"), std::string::npos);
    EXPECT_NE(why(0, 5, true).find("up to four points at given crank angles, and there are 5"), std::string::npos);
}

}  // namespace
}  // namespace mechwright
