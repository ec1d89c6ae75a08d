// Cognates of linkages: the guided point follows the same path, point by point.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "synthesis/mechanism/linkage/targets/cognates.h"
#include "synthesis/search/path/cognate_starts.h"
#include "tests/mechanism/six_bar_with_point.h"

namespace mechwright {

namespace {

using namespace testing;

std::size_t assembly_with(const LinkageModel& model, const std::vector<std::int8_t>& sides) {
    return static_cast<std::size_t>(std::find(model.sides.begin(), model.sides.end(), sides) - model.sides.begin());
}

/// How many cognates a six-bar has; each has to pass the same points at the same inputs.
std::size_t cognates_on_same_path(const Problem& problem, const std::vector<double>& dimensions) {
    const LinkageModel& model = model_in(problem);
    std::size_t found = 0;
    for (std::size_t assembly = 0; assembly < model.sides.size(); ++assembly)
        for (const LinkageCognate& cognate : linkage_cognates(model, dimensions, assembly, all_free(problem), 0.4)) {
            ++found;
            const std::size_t other = assembly_with(model, cognate.sides);
            int compared = 0;
            for (double input = 0; input < 6.28; input += 0.1) {
                const auto one = drawn_point(problem, dimensions, assembly, input);
                if (!one) continue;
                const auto same = drawn_point(problem, cognate.dimensions, other, input + cognate.crank_angle);
                if (!same) {
                    ADD_FAILURE() << "no assembly at " << input;
                    continue;
                }
                ++compared;
                EXPECT_NEAR(same->x, one->x, 1e-9);
                EXPECT_NEAR(same->y, one->y, 1e-9);
            }
            EXPECT_GT(compared, 20);
        }
    return found;
}

TEST(LinkageCognates, OfWattsFirstKindPassTheSamePoints) {
    const Problem problem = six_bar_with_point_on_rod("coupler", "rocker");
    EXPECT_EQ(cognates_on_same_path(problem, some_dimensions(problem)), 4U);
}

TEST(LinkageCognates, OfStephensonsThirdKindPassTheSamePoints) {
    const Problem problem = six_bar_with_point_on_rod("coupler", "frame");
    EXPECT_EQ(cognates_on_same_path(problem, some_dimensions(problem)), 4U);
}

TEST(LinkageCognates, AreNoneOfStephensonsFirstKind) {
    const Problem problem = six_bar_with_point_on_rod("crank", "rocker");
    EXPECT_EQ(cognates_on_same_path(problem, some_dimensions(problem)), 0U);
}

TEST(LinkageCognates, AreNoneWhereADimensionThatIsGivenWouldChange) {
    const Problem problem = six_bar_with_point_on_rod("coupler", "rocker");
    std::vector<bool> free = all_free(problem);
    free[static_cast<std::size_t>(find_dimension(*problem.mechanism, "rod"))] = false;
    EXPECT_TRUE(linkage_cognates(model_in(problem), some_dimensions(problem), 0, free, 0.4).empty());
}

/// The points of a path that a six-bar follows exactly, at crank angles from 0.7 on.
void set_path_of(const std::vector<double>& dimensions, std::size_t assembly, Problem& problem) {
    PathTarget& path = *problem.path;
    path.points.clear();
    path.crank_angles.clear();
    path.prescribed_timing = true;
    for (int i = 0; i < 8; ++i) {
        const double angle = 0.1 * i;
        path.points.push_back(*drawn_point(problem, dimensions, assembly, 0.7 + angle));
        path.crank_angles.push_back(angle);
    }
    path.weights.assign(path.points.size(), 1);
}

TEST(LinkageCognates, AreDesignsOfTheSameProblem) {
    Problem problem = six_bar_with_point_on_rod("coupler", "rocker");
    std::vector<double> dimensions = some_dimensions(problem);
    set_path_of(dimensions, 0, problem);
    const std::size_t start = problem.mechanism->point->roles.start;
    dimensions[start] = 0.7;
    problem.dimensions[start].max = 6.3;
    std::vector<Program> programs;
    for (const Variant& variant : variants(problem))
        programs.push_back(build_program(problem, variant));
    Design design{dimensions, 0, {}};
    for (const double angle : problem.path->crank_angles)
        design.path_angles.push_back(0.7 + angle);
    const std::vector<PointOfProgram> cognates = cognates_of(programs, 0, point_of(programs[0], design));
    ASSERT_EQ(cognates.size(), 1U);
    const Program& other = programs[cognates[0].program];
    EXPECT_NE(other.variant.assembly, 0U);
    PathResiduals rest;
    ASSERT_TRUE(path_residuals(other, cognates[0].x, false, rest));
    EXPECT_LT(rest.value.norm(), 1e-10);
}

}  // namespace

}  // namespace mechwright
