/// \file
/// Linkages of which many dyads may be closed on either side: 2^n assemblies, of which searches go on in sixteen.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <chrono>
#include <nlohmann/json.hpp>
#include <string>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/search/best_assemblies.h"
#include "synthesis/search/multistart.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

/// A crank that moves five rockers, each by a rod from the one before it; T is on the last. The sides are those that
/// are given, from the first dyad on.
std::string row_of_rockers(const std::string& dimensions, const std::string& side) {
    std::string text = "schema = 1\nmechanism = \"linkage\"\n" + dimensions + R"(
[links]
frame = { A = [0, 0], D1 = [100, 0], D2 = [190, 10], D3 = [280, -5], D4 = [370, 8], D5 = [460, 0] }
crank = { A = [0, 0], B = [30, 0] }
rod-1 = { B = [0, 0], C1 = ["rod", 0] }
rocker-1 = { D1 = [0, 0], C1 = [60, 0] }
rod-2 = { C1 = [0, 0], C2 = [85, 0] }
rocker-2 = { D2 = [0, 0], C2 = [65, 0] }
rod-3 = { C2 = [0, 0], C3 = [95, 0] }
rocker-3 = { D3 = [0, 0], C3 = [60, 0] }
rod-4 = { C3 = [0, 0], C4 = [88, 0] }
rocker-4 = { D4 = [0, 0], C4 = [70, 0] }
rod-5 = { C4 = [0, 0], C5 = ["last", 0] }
rocker-5 = { D5 = [0, 0], C5 = [66, 0], T = [40, 20] }
[drive]
link = "crank"
[assembly]
)";
    for (int k = 1; k <= 5; ++k)
        text += fmt::format("C{} = \"{}\"\n", k, side);
    return text;
}

const std::string given = "[dimensions]\nrod = 92\nlast = 93\n";
const std::string designed = "[dimensions]\nrod = 92\nlast = { min = 90, max = 96 }\n";

Result solved(const std::string& text) {
    const ReadProblem read = parse_problem(text, "row.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.ok() ? solve(read.problem, {}) : Result{};
}

TEST(ManySides, AreSearchedInTheBestSixteen) {
    const std::string wanted = "[signals]\nswing = { angle = \"rocker-5\" }\n";
    const ReadProblem read = parse_problem(row_of_rockers(given, "left") + wanted, "row.toml");
    ASSERT_TRUE(read.ok());
    const nlohmann::ordered_json document = analysis_document(read.problem, evaluate_given(read.problem));
    const double swing = document["quantities"]["swing.range"].get<double>();
    const std::string text = row_of_rockers(designed, "either") + wanted +
                             fmt::format(
                                 "[[require]]\nquantity = \"swing.range\"\nequal = {:.17g}\n"
                                 "[objective]\nminimize = \"swing.greatest\"\n[solver]\nstarts = 1\n",
                                 swing);
    const Multistart result =
        multistart(parse_problem(text, "row.toml").problem, slsqp, {}, std::chrono::steady_clock::time_point::max());
    EXPECT_EQ(result.report.starts, static_cast<int>(most_assemblies_searched));
    EXPECT_GT(result.report.drawn, result.report.optimised);
    ASSERT_FALSE(result.optima.empty());
    EXPECT_TRUE(result.optima.front().feasible);
    EXPECT_LE(result.optima.front().objective, document["quantities"]["swing.greatest"].get<double>() * (1 + 1e-9));
}

TEST(ManySides, APathThatOneOfThemMeetsIsFound) {
    std::string signals = "[signals]\nx = { x = \"T\" }\ny = { y = \"T\" }\n";
    std::string asked, points, angles;
    for (int angle = 10; angle < 360; angle += 25)
        asked += fmt::format(
            "[[require]]\nquantity = \"x.at({0})\"\nmin = -9e9\n[[require]]\nquantity = \"y.at({0})\"\nmin = -9e9\n",
            angle);
    const ReadProblem read = parse_problem(row_of_rockers(given, "left") + signals + asked, "row.toml");
    ASSERT_TRUE(read.ok());
    const nlohmann::ordered_json document = analysis_document(read.problem, evaluate_given(read.problem));
    for (int angle = 10; angle < 360; angle += 25) {
        const auto value = [&](const char* of) {
            return document["quantities"][fmt::format("{}.at({})", of, angle)].get<double>();
        };
        points += fmt::format("[{:.17g}, {:.17g}], ", value("x"), value("y"));
        angles += fmt::format("{}, ", angle);
    }
    const Result result =
        solved(row_of_rockers(designed, "either") +
               fmt::format("[path]\npoint = \"T\"\ntiming = \"prescribed\"\npoints = [{}]\ncrank_angles = [{}]\n"
                           "[objective]\nminimize = \"path-rms\"\n",
                           points, angles));
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_NEAR(result.best->objective, 0, 1e-9);
}

TEST(ManySides, FewAssembliesAreAllSearched) {
    const ReadProblem read = parse_problem(row_of_rockers(designed, "either"), "row.toml");
    ASSERT_TRUE(read.ok());
    std::vector<Program> programs;
    for (std::size_t assembly = 0; assembly < 5; ++assembly)
        for (const int direction : {1, -1})
            programs.push_back(build_program(read.problem, {0, assembly, direction, {}}));
    std::vector<AssemblyMerit> merits{{0, 3.0}, {3, 1.0}, {1, 2.0}, {3, 0.5}, {2, 2.0}};
    EXPECT_EQ(in_best_assemblies(programs, merits).size(), programs.size());
    EXPECT_EQ(in_best_assemblies(programs, {}, 2).size(), programs.size());
    // The second and the fourth assembly, in both directions each; the third is as good as the second, and comes later.
    EXPECT_EQ(in_best_assemblies(programs, merits, 2), (std::vector<std::size_t>{2, 3, 6, 7}));
}

}  // namespace

}  // namespace mechwright
