#include "synthesis/document/document.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "synthesis/program/proof.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/json_text.h"
#include "tests/report/examples.h"

namespace mechwright {
namespace {

using Json = nlohmann::ordered_json;
using namespace testing;

std::vector<std::string> names_of(const Json& object) {
    std::vector<std::string> names;
    for (const auto& [name, value] : object.items())
        names.push_back(name);
    return names;
}

Json crank_rocker_document() {
    return document(problem_of(crank_rocker_text), result_of(Status::solved, crank_rocker_solution()));
}

std::size_t quantity_named(const Problem& problem, std::string_view name) {
    const int index = find_quantity(*problem.mechanism, name);
    EXPECT_GE(index, 0) << name;
    return static_cast<std::size_t>(index);
}

TEST(Document, HasItsMembersInTheirOrder) {
    EXPECT_EQ(names_of(crank_rocker_document()),
              (std::vector<std::string>{"schema", "problem", "program", "units", "status", "tolerance", "dimensions",
                                        "design", "objective", "requirements", "quantities", "verification",
                                        "alternatives", "search"}));
    Problem problem = problem_of(path_text);
    problem.crank_range = {0.5, 2.5};
    Result result = result_of(Status::limit, path_solution());
    result.note = "stopped";
    EXPECT_EQ(names_of(document(problem, result)),
              (std::vector<std::string>{"schema", "problem", "program", "units", "status", "note", "tolerance",
                                        "dimensions", "crank_range", "design", "quantities", "path", "verification",
                                        "alternatives", "search"}));
}

TEST(Document, SaysWhichProblemAndProgram) {
    const Json json = crank_rocker_document();
    EXPECT_EQ(json["schema"], 1);
    EXPECT_EQ(json["problem"]["file"], "example.toml");
    EXPECT_EQ(json["problem"]["sha256"].get<std::string>().size(), 64u);
    EXPECT_EQ(json["problem"]["title"], "Crank-rocker of 60 deg swing");
    EXPECT_EQ(json["problem"]["mechanism"], "four-bar");
    EXPECT_EQ(names_of(json["program"]["libraries"]), (std::vector<std::string>{"ipopt", "nlopt", "eigen"}));
    for (const auto& [name, version] : json["program"]["libraries"].items())
        EXPECT_NE(version.get<std::string>().find('.'), std::string::npos) << name;
    EXPECT_EQ(json["units"], (Json{{"angle", "deg"}, {"length", "mm"}}));
}

TEST(Document, RepeatsWhatWasGivenInTheFilesUnits) {
    const Json json = crank_rocker_document();
    EXPECT_EQ(json["dimensions"], (Json{{"ground", 100.0},
                                        {"crank", {{"min", 5.0}, {"max", 60.0}}},
                                        {"coupler", {{"min", 20.0}, {"max", 300.0}}},
                                        {"rocker", {{"min", 20.0}, {"max", 81.8}}},
                                        {"tilt", 30.0}}));
    EXPECT_EQ(json["design"], (Json{{"ground", 100.0},
                                    {"crank", 40.0},
                                    {"coupler", 92.4},
                                    {"rocker", 81.8},
                                    {"tilt", 30.0},
                                    {"assembly", "open"},
                                    {"kind", "crank-rocker"}}));
}

TEST(Document, OptionalDimensionsAppearIfNamedOrNotZero) {
    Solution solution = crank_rocker_solution();
    solution.design.dimensions[6] = 2.5;
    const Json json = document(problem_of(crank_rocker_text), result_of(Status::solved, solution));
    EXPECT_EQ(json["design"]["origin-x"], 2.5);
    EXPECT_FALSE(json["design"].contains("origin-y"));
}

TEST(Document, RequirementsHaveValueViolationAndWhetherTheyAreActive) {
    const Json json = crank_rocker_document();
    const Json& swing = json["requirements"][0];
    EXPECT_EQ(names_of(swing), (std::vector<std::string>{"quantity", "value", "equal", "violation", "active"}));
    EXPECT_NEAR(swing["value"], 61.413062, 1e-6);
    EXPECT_EQ(swing["equal"], 60.0);
    EXPECT_NEAR(swing["violation"], 1.413062 / 60, 1e-8);
    EXPECT_EQ(swing["active"], true);
    const Json& angle = json["requirements"][1];
    EXPECT_EQ(names_of(angle), (std::vector<std::string>{"quantity", "value", "min", "max", "violation", "active"}));
    EXPECT_EQ(angle["violation"], 0.0);
    EXPECT_EQ(angle["active"], false);
}

TEST(Document, AnInequalityAtItsLimitIsActive) {
    Problem problem = problem_of(crank_rocker_text);
    const Solution solution = crank_rocker_solution();
    const auto angle = quantity_value(problem, problem.requirements[1].quantity, solution.design);
    ASSERT_TRUE(angle);
    for (const auto& [limit, active] : {std::pair{*angle * (1 - 1e-7), true}, {*angle * (1 - 1e-5), false}}) {
        problem.requirements[1].min = limit;
        const Json json = document(problem, result_of(Status::solved, solution));
        EXPECT_EQ(json["requirements"][1]["active"], active);
        EXPECT_EQ(json["requirements"][1]["violation"], 0.0);
    }
}

TEST(Document, ObjectivesOfOneAndOfSeveralTerms) {
    Problem problem = problem_of(crank_rocker_text);
    EXPECT_EQ(crank_rocker_document()["objective"],
              (Json{{"quantity", "transmission-angle-worst"}, {"sense", "maximize"}, {"value", 39.7103}}));
    problem.objective = Objective{
        {{quantity_named(problem, "total-length"), false, 2}, {quantity_named(problem, "link-ratio"), true, 1}}, false};
    const Json json = document(problem, result_of(Status::solved, crank_rocker_solution()))["objective"];
    EXPECT_EQ(names_of(json), (std::vector<std::string>{"terms", "reduce", "value"}));
    EXPECT_EQ(json["reduce"], "sum");
    EXPECT_EQ(json["terms"][0]["sense"], "minimize");
    EXPECT_EQ(json["terms"][0]["weight"], 2.0);
    EXPECT_NEAR(json["terms"][0]["value"], 314.2, 1e-9);
    EXPECT_EQ(json["terms"][1]["quantity"], "link-ratio");
    EXPECT_EQ(json["terms"][1]["value"], 2.5);
    problem.objective->worst = true;
    EXPECT_EQ(document(problem, result_of(Status::solved, crank_rocker_solution()))["objective"]["reduce"], "max");
}

TEST(Document, QuantitiesAreThoseThatAreDefined) {
    const Json json = crank_rocker_document()["quantities"];
    EXPECT_TRUE(json.contains("time-ratio"));
    EXPECT_FALSE(json.contains("path-rms"));
    Solution double_rocker = crank_rocker_solution();
    double_rocker.design.dimensions = {100, 80, 40, 90, 0, 0, 0, 0, 0};
    const Json of_double_rocker =
        document(problem_of(crank_rocker_text), result_of(Status::solved, double_rocker))["quantities"];
    EXPECT_FALSE(of_double_rocker.contains("time-ratio"));
    EXPECT_TRUE(of_double_rocker.contains("total-length"));
}

TEST(Document, ADesignThatDoesNotAssembleHasNoQuantities) {
    Solution apart = crank_rocker_solution();
    apart.design.dimensions = {100, 10, 20, 30, 0, 0, 0, 0, 0};
    const Problem problem = problem_of(crank_rocker_text);
    const Json json = document(problem, result_of(Status::infeasible, apart));
    EXPECT_TRUE(json["quantities"].empty());
    EXPECT_FALSE(json["requirements"][0].contains("value"));
    EXPECT_FALSE(json["requirements"][0].contains("violation"));
}

TEST(Document, PathMeasuresFollowFromTheDistances) {
    const Problem problem = problem_of(path_text);
    const Json json = document(problem, result_of(Status::solved, path_solution()));
    const Json& path = json["path"];
    EXPECT_EQ(names_of(path), (std::vector<std::string>{"points", "timing", "closed", "weights", "reached",
                                                        "crank_angles", "distances"}));
    double sum = 0;
    double greatest = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double dx = path["points"][i][0].get<double>() - path["reached"][i][0].get<double>();
        const double dy = path["points"][i][1].get<double>() - path["reached"][i][1].get<double>();
        const double distance = path["distances"][i];
        EXPECT_NEAR(distance, std::hypot(dx, dy), 1e-12);
        sum += static_cast<double>(i + 1) * distance * distance;
        greatest = std::max(greatest, distance);
    }
    EXPECT_NEAR(json["quantities"]["path-sse"], sum, 1e-9);
    EXPECT_NEAR(json["quantities"]["path-rms"], std::sqrt(sum / 6), 1e-12);
    EXPECT_EQ(json["quantities"]["path-max"], greatest);
    EXPECT_NEAR(path["crank_angles"][0], 0.5 * 180 / 3.141592653589793, 1e-12);
}

TEST(Document, PathsWithTimingNameTheirAnglesAndPlainWeightsAreLeftOut) {
    Problem problem = problem_of(path_text);
    problem.path->prescribed_timing = true;
    problem.path->crank_angles = {0, 3.141592653589793 / 6, 1};
    problem.path->weights = {1, 1, 1};
    const Json path = document(problem, result_of(Status::solved, path_solution()))["path"];
    EXPECT_EQ(path["timing"], "prescribed");
    EXPECT_EQ(path["prescribed_angles"][1], 30.0);
    EXPECT_FALSE(path.contains("weights"));
}

TEST(Document, WithoutADesignItSaysWhatWasAsked) {
    Result result = result_of(Status::infeasible, path_solution());
    result.best.reset();
    result.verification.clear();
    const Json json = document(problem_of(path_text), result);
    EXPECT_EQ(json["status"], "infeasible");
    EXPECT_EQ(json["path"]["points"].size(), 3u);
    for (const char* name : {"design", "objective", "requirements", "quantities", "verification"})
        EXPECT_FALSE(json.contains(name)) << name;
}

TEST(Document, AlternativesHaveDesignObjectiveAndPathAngles) {
    Result result = result_of(Status::solved, path_solution());
    result.alternatives = {{path_solution(), {}}, {path_solution(), {}}};
    result.alternatives[1].solution.objective = std::nan("");
    const Json json = document(problem_of(path_text), result)["alternatives"];
    ASSERT_EQ(json.size(), 2u);
    EXPECT_EQ(names_of(json[0]), (std::vector<std::string>{"design", "objective", "path_angles", "distances"}));
    EXPECT_EQ(names_of(json[1]), (std::vector<std::string>{"design", "path_angles", "distances"}));
}

TEST(Document, NumbersThatAreNotFiniteAreNeverWritten) {
    const double infinity = std::numeric_limits<double>::infinity();
    for (const double bad : {std::nan(""), infinity, -infinity}) {
        Solution solution = path_solution();
        solution.objective = bad;
        solution.design.path_angles = {0.5, bad, 1};
        Result result = result_of(Status::limit, solution);
        result.alternatives = {{solution, {}}};
        result.search.missed_chance = bad;
        result.search.seconds = bad;
        Problem problem = problem_of(path_text);
        problem.objective = Objective{{{quantity_named(problem, "path-rms"), false, 1}}, false};
        const std::string text = json_text(document(problem, result));
        EXPECT_EQ(text.find("null"), std::string::npos) << text;
        EXPECT_EQ(text.find("nan"), std::string::npos);
        EXPECT_EQ(text.find("inf"), std::string::npos);
    }
}

TEST(Document, StatusesHaveTheirNames) {
    for (const auto& [status, name] : {std::pair{Status::solved, "solved"},
                                       {Status::infeasible, "infeasible"},
                                       {Status::limit, "limit"},
                                       {Status::unverified, "unverified"},
                                       {Status::interrupted, "interrupted"}})
        EXPECT_EQ(name_of(status), name);
}

TEST(Document, SearchSaysHowThoroughItWas) {
    Problem problem = problem_of(path_text);
    problem.solver.seed = 7;
    Result result = result_of(Status::solved, path_solution());
    result.search.drawn = 9;
    result.search.optimised = 5;
    result.search.sources = {.preferred = 1, .drawn = 2, .four_bars = 2, .nearby = 0};
    EXPECT_EQ(names_of(document(problem, result)["search"]),
              (std::vector<std::string>{"method", "complete", "drawn", "assembled", "optimised", "sources", "starts",
                                        "local_optima", "hits", "missed_chance", "evaluations", "seed", "seconds"}));
    EXPECT_EQ(document(problem, result)["search"]["sources"],
              Json::parse(R"({"preferred":1,"drawn":2,"four_bars":2})"));
    result.search.proof = proof_by("every solution of a cubic", CountCertificate{});
    const Json search = document(problem, result)["search"];
    EXPECT_EQ(search["argument"], "every solution of a cubic");
    EXPECT_EQ(search["certificate"]["kind"], "count");
    EXPECT_EQ(search["seed"], 7);
}

TEST(AnalysisDocument, LeavesOutWhatOnlyASearchHas) {
    const Json json = analysis_document(problem_of(path_text), path_solution());
    EXPECT_EQ(names_of(json), (std::vector<std::string>{"schema", "problem", "program", "units", "tolerance",
                                                        "dimensions", "design", "quantities", "path"}));
}

}  // namespace
}  // namespace mechwright
