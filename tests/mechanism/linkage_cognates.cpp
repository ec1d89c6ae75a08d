// Cognates of linkages: the guided point follows the same path, point by point.

#include <gtest/gtest.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "synthesis/mechanism/linkage/targets/cognates.h"
#include "synthesis/problem/reader.h"
#include "synthesis/search/path/cognate_starts.h"

namespace mechwright {

namespace {

/// Six-bars with P on the rod E-G, whose other end G-F hangs on the rocker (Watt's first kind), on the frame
/// (Stephenson's third) or between crank and rocker (Stephenson's first), in frames of their links as nobody chooses
/// them.
Problem six_bar_with_point_on_rod(const std::string& e_on, const std::string& f_on) {
    const auto on = [](const std::string& own, const std::string& link, const char* pin) {
        return own == link ? std::string(", ") + pin : std::string();
    };
    const char* e = R"(E = ["e-x", "e-y"])";
    const char* f = R"(F = { length = "f", angle = "f-angle" })";
    std::string text = "schema = 1\nmechanism = \"linkage\"\n[dimensions]\n";
    for (const char* name : {"ground", "crank", "coupler", "rocker", "rod", "last", "f"})
        text += std::string(name) + " = { min = 5, max = 400 }\n";
    for (const char* name : {"e-x", "e-y", "p-x", "p-y"})
        text += std::string(name) + " = { min = -400, max = 400 }\n";
    text += R"(f-angle = { min = -180, max = 180 }
[placement]
origin-x = { min = -400, max = 400 }
origin-y = { min = -400, max = 400 }
tilt = { min = -180, max = 180 }
[links]
)";
    text += "frame = { A = [3, -2], D = [\"ground\", -2]" + on(f_on, "frame", f) + " }\n";
    text += "crank = { A = [0, 0], B = { length = \"crank\", angle = -35 }" + on(e_on, "crank", e) + " }\n";
    text += "coupler = { B = [0, 0], C = [0, \"coupler\"]" + on(e_on, "coupler", e) + " }\n";
    text += "rocker = { D = [0, 0], C = [\"rocker\", 0]" + on(f_on, "rocker", f) + " }\n";
    text += R"(rod = { E = [0, 0], G = ["rod", 0], P = ["p-x", "p-y"] }
last = { F = [0, 0], G = ["last", 0] }
[drive]
link = "crank"
[assembly]
C = { side = "either", from = "B", to = "D" }
G = { side = "either", from = "F", to = "E" }
[path]
point = "P"
timing = "free"
points = [[0, 0], [1, 0], [2, 1]]
[objective]
minimize = "path-rms"
)";
    ReadProblem read = parse_problem(text, "six-bar.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return std::move(read.problem);
}

const LinkageModel& model_in(const Problem& problem) { return linkage_of(problem.mechanism->model.data()); }

/// Those of a six-bar that assembles over a wide range; others are 0.
std::vector<double> some_dimensions(const Problem& problem) {
    std::vector<double> all;
    const std::vector<std::pair<std::string, double>> known{
        {"ground", 100}, {"crank", 30},     {"coupler", 90}, {"rocker", 70},  {"rod", 95},
        {"last", 100},   {"f", 60},         {"e-x", 35},     {"e-y", 50},     {"p-x", 40},
        {"p-y", -25},    {"f-angle", -1.2}, {"origin-x", 5}, {"origin-y", 7}, {"tilt", 0.3}};
    for (const Dimension& dimension : problem.mechanism->dimensions) {
        const auto at = std::find_if(known.begin(), known.end(),
                                     [&](const auto& one) { return dimension.name.ends_with(one.first); });
        all.push_back(at == known.end() ? 0 : at->second);
    }
    return all;
}

std::vector<bool> all_free(const Problem& problem) {
    return std::vector<bool>(problem.mechanism->dimensions.size(), true);
}

/// The guided point in the drawing; nothing where the linkage does not assemble.
std::optional<Vector<double>> drawn_point(const Problem& problem, const std::vector<double>& dimensions,
                                          std::size_t assembly, double input) {
    PathMiss miss{};
    miss_of_point(*problem.mechanism, problem.mechanism->form(assembly), dimensions, input, {0, 0}, miss);
    if (!(miss.margin >= 0)) return {};
    return Vector<double>{-miss.miss.x, -miss.miss.y};
}

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
