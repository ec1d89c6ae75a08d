// Fewer places than say which four-bar it is: the best of the family that passes them.

#include "synthesis/exact/place_family.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "analysis/four_bar.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/quantity_value.h"
#include "tests/degree.h"
#include "tests/exact/all_solutions.h"
#include "tests/long_form.h"

namespace mechwright {
namespace {

const std::string ranges = free_four_bar(100);

ReadProblem through(const std::string& dimensions, const std::string& targets, const std::string& objective) {
    return parse_problem("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + dimensions + targets +
                             "\n[objective]\nminimize = \"" + objective +
                             "\"\n[solver]\nmethod = \"exact\"\nstarts = 4\n",
                         "p.toml");
}

struct MadePlaces {
    FourBar<double> links;
    std::string targets;  ///< the section of them
};

/// Places of a random crank-rocker over part of a turn, the first of them poses.
MadePlaces random_places(std::mt19937_64& random, std::size_t poses, std::size_t points) {
    std::uniform_real_distribution<double> between(0, 1);
    FourBar<double> links;
    do
        links = {1, 0.1 + 0.3 * between(random), 0.5 + between(random), 0.5 + between(random)};
    while (classify(links).kind != FourBarClass::crank_rocker);
    const CouplerPoint<double> point{between(random), between(random) - 0.5};
    const double from = 6.28 * between(random), span = 2 + 3 * between(random);
    const std::size_t count = poses + points;
    std::string list;
    for (std::size_t i = 0; i < count; ++i) {
        const auto p = pose(links, from + span * static_cast<double>(i) / static_cast<double>(count), Assembly::open);
        const Vector<double> at = position(links, point, p);
        list += fmt::format("[{:.17g}, {:.17g}", at.x, at.y);
        if (i < poses) list += fmt::format(", {:.17g}", std::atan2(p.coupler.y, p.coupler.x) / degree);
        list += "], ";
    }
    if (poses > 0) return {links, "[poses]\nposes = [" + list + "]"};
    return {links, "[path]\npoints = [" + list + "]\ntiming = \"free\""};
}

struct Places {
    std::size_t poses, points, free;
};

class PlaceFamily : public ::testing::TestWithParam<Places> {};

// Eight points leave one number, each point less one more; so does each direction less.
INSTANTIATE_TEST_SUITE_P(Of, PlaceFamily,
                         ::testing::Values(Places{0, 8, 1}, Places{0, 6, 3}, Places{0, 5, 4}, Places{0, 3, 6},
                                           Places{2, 5, 1}, Places{3, 2, 2}, Places{1, 3, 5}),
                         [](const auto& tested) {
                             return fmt::format("{}Poses{}Points", tested.param.poses, tested.param.points);
                         });

/// The linkage that made the places is a member: the most compact one that is found is no larger.
TEST_P(PlaceFamily, HasAMemberNoLargerThanTheLinkageThatMadeThePlaces) {
    std::mt19937_64 random(17);
    const auto& [poses, points, free] = GetParam();
    if (points == 8 && !in_long_form()) GTEST_SKIP() << "of the long form";
    for (int k = 0; k < cases_to_try(1, 5); ++k) {
        const MadePlaces made = random_places(random, poses, points);
        const std::string body = poses > 0 ? "body-angle = { min = 0, max = 360 }\n" : "";
        const ReadProblem read = through(ranges + body, made.targets, "total-length");
        ASSERT_TRUE(read.ok()) << read.messages.front().text;
        EXPECT_EQ(free_directions(read.problem), free);
        const Result result = all_solutions(read.problem);
        ASSERT_EQ(result.status, Status::solved);
        EXPECT_TRUE(result.verified());
        EXPECT_FALSE(result.search.complete());
        EXPECT_FALSE(result.search.solutions);
        EXPECT_LT(path_values(read.problem, result.best->design)->greatest, 1e-9);
        const double total = made.links.ground + made.links.crank + made.links.coupler + made.links.rocker;
        EXPECT_LT(result.best->objective, total * (1 + 1e-6));
    }
}

/// The same optimum as by least squares from many starts, which the shipped file states.
TEST(PlaceFamily, OfSixPointsHasTheSmallestLinkageOfAnotherMethod) {
    ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/path/six-points-compact.toml");
    ASSERT_TRUE(read.ok());
    read.problem.solver.method = "exact";
    read.problem.solver.starts = 2;
    const Result result = all_solutions(read.problem);
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_EQ(result.search.free_numbers, 3u);
    const int length = find_quantity(*read.problem.mechanism, "total-length");
    EXPECT_NEAR(*quantity_value(read.problem, static_cast<std::size_t>(length), result.best->design), 356.83013, 1e-4);
}

TEST(PlaceFamily, IsNotSearchedForWhatIsGivenBesides) {
    std::mt19937_64 random(19);
    std::string dimensions = ranges;
    dimensions.replace(dimensions.find("{ min = 0, max = 100 }"), 22, "1");
    const ReadProblem read = through(dimensions, random_places(random, 0, 7).targets, "total-length");
    ASSERT_TRUE(read.ok());
    const std::string why = why_not_applicable("exact", read.problem);
    EXPECT_NE(why.find("'ground' has one value besides"), std::string::npos) << why;
}

}  // namespace
}  // namespace mechwright
