// The designs that a result has beside its own: alternatives, cognates among them, what is set aside, and fronts; and
// designs that stand close to a singular position.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "analysis/four_bar/cognates.h"
#include "synthesis/document/document.h"
#include "synthesis/mechanism/four_bar/cognates.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/program/standing/singular.h"
#include "synthesis/report/text/summary.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/asked.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

Problem problem_of(const std::string& text) {
    const ReadProblem read = parse_problem("schema = 1\n" + text, "given.toml");
    for (const Message& m : read.messages)
        EXPECT_TRUE(m.warning) << to_string(m);
    return read.problem;
}

std::vector<double> dimensions_of(const PathLinkage<double>& m) {
    return {m.links.ground, m.links.crank,        m.links.coupler,      m.links.rocker,  m.point.along,
            m.point.across, m.placement.origin.x, m.placement.origin.y, m.placement.tilt};
}

TEST(Cognates, AreKnownByTheirDimensions) {
    const PathLinkage<double> m{{50, 20, 45, 40}, {25, 30}, {{3, -4}, 0.4}, Assembly::open};
    const auto [one, other] = cognates(m);
    const auto own = dimensions_of(m);
    EXPECT_TRUE(four_bar::are_cognates(own, dimensions_of(one)));
    EXPECT_TRUE(four_bar::are_cognates(dimensions_of(other), own));
    EXPECT_TRUE(four_bar::are_cognates(dimensions_of(one), dimensions_of(other)));
    EXPECT_FALSE(four_bar::are_cognates(own, own));
    auto moved = dimensions_of(one);
    moved[4] *= 1.001;
    EXPECT_FALSE(four_bar::are_cognates(own, moved));
}

constexpr const char* timed_path =
    "mechanism = \"four-bar\"\n[path]\ntiming = \"prescribed\"\nclosed = false\n"
    "points = [[2.68, 4.98], [2.71, 5.04], [2.84, 5.10], [2.94, 5.17], [3.19, 5.30], [3.54, 5.42], [3.93, 5.43], "
    "[4.46, 5.25], [4.96, 4.64]]\n"
    "crank_angles = [0, 17.7, 35.4, 53.1, 70.7, 88.4, 106.1, 123.8, 141.5]\n[dimensions]\n"
    "ground = { min = 0.1, max = 50.0 }\ncrank = { min = 0.1, max = 50.0 }\ncoupler = { min = 0.1, max = 50.0 }\n"
    "rocker = { min = 0.1, max = 50.0 }\npoint-along = { min = -50.0, max = 50.0 }\n"
    "point-across = { min = -50.0, max = 50.0 }\norigin-x = { min = -50.0, max = 50.0 }\n"
    "origin-y = { min = -50.0, max = 50.0 }\ntilt = { min = 0.0, max = 360.0 }\n"
    "crank-start = { min = 0.0, max = 360.0 }\nassembly = \"either\"\n[objective]\nminimize = \"path-max\"\n"
    "[solver]\nstarts = 16\n";

TEST(Alternatives, AreVerifiedOrSetAsideByName) {
    const Problem problem = problem_of(timed_path);
    const Result result = solve(problem, {});
    ASSERT_TRUE(result.best);
    for (const VerifiedDesign& d : result.alternatives) {
        EXPECT_TRUE(all_passed(d.verification));
        EXPECT_FALSE(result.verified() && preferred(problem, d.solution, *result.best));
    }
    for (const ExcludedDesign& e : result.excluded)
        EXPECT_FALSE(e.defect.empty());
    const Json json = document(problem, result);
    EXPECT_EQ(json["alternatives"].size(), result.alternatives.size() + result.excluded.size());
    for (const Json& one : json["alternatives"])
        EXPECT_NE(one.contains("verification"), one.contains("defect"));
}

TEST(Alternatives, ThatAreBetterAndNoUseAreSaidToBe) {
    const Problem problem = problem_of(timed_path);
    Result result;
    result.status = Status::solved;
    result.best = Solution{};
    result.best->design = {std::vector<double>(problem.mechanism->dimensions.size(), 1.0), 0, {}};
    result.best->objective = 0.0311285;
    result.best->feasible = true;
    result.verification = {{"all", true, ""}};
    result.excluded.push_back({*result.best, "stays on one branch: it does not"});
    result.excluded.front().solution.objective = 0.0293838;
    const std::string text = summary(problem, result, {});
    EXPECT_NE(text.find("Set aside"), std::string::npos) << text;
    EXPECT_NE(text.find("better"), std::string::npos) << text;
    EXPECT_NE(text.find("0.02938"), std::string::npos) << text;
    EXPECT_NE(text.find("one branch"), std::string::npos) << text;
}

TEST(Alternatives, ThatAreBetterAreNotBelieved) {
    const Problem problem = problem_of(timed_path);
    Json json = document(problem, solve(problem, {}));
    if (json["status"] != "solved") return;
    Json better = json["alternatives"].empty() ? Json{{"design", json["design"]}} : json["alternatives"][0];
    better["objective"] = json["objective"]["value"].get<double>() / 2;
    better.erase("defect");
    json["alternatives"].push_back(better);
    const auto failed = failures(json);
    EXPECT_TRUE(std::find(failed.begin(), failed.end(), fmt::format("alternative {}", json["alternatives"].size())) !=
                failed.end());
}

TEST(Front, HoldsNoDesignThatAnotherIsAsGoodAsWithinTheTolerance) {
    const Problem problem = problem_of(
        "mechanism = \"four-bar\"\n[dimensions]\nground = { min = 20.0, max = 200.0 }\n"
        "crank = { min = 5.0, max = 90.0 }\ncoupler = { min = 20.0, max = 300.0 }\n"
        "rocker = { min = 20.0, max = 300.0 }\n[[require]]\nquantity = \"swing\"\nequal = 63.13451816217547\n"
        "[[require]]\nquantity = \"time-ratio\"\nmin = 1.114566192846492\nmax = 1.4\n[[objective]]\n"
        "maximize = \"time-ratio\"\n[[objective]]\nmaximize = \"transmission-angle-worst\"\n[solver]\npareto = 5\n"
        "starts = 12\n");
    const Result result = solve(problem, {});
    ASSERT_GE(result.front.size(), 4u);
    const auto value = [&](std::size_t i, std::size_t term) {
        return quantity_value(problem, problem.objective->terms[term].quantity, result.front[i].solution.design)
            .value();
    };
    EXPECT_NEAR(value(0, 0), 1.4, 1e-8);
    EXPECT_NEAR(value(0, 1) * 180 / std::numbers::pi, 31.9602, 1e-3);
    for (std::size_t i = 1; i < result.front.size(); ++i) {
        EXPECT_LT(value(i, 0), value(i - 1, 0) * (1 - 1e-9)) << i;
        EXPECT_GT(value(i, 1), value(i - 1, 1) * (1 + 1e-9)) << i;
    }
    Json json = document(problem, result);
    EXPECT_TRUE(failures(json).empty()) << told(verify(json));
    json["front"].push_back(json["front"][0]);
    json["front"].back()["objective"]["terms"][1]["value"] = 7.46;
    const auto failed = failures(json);
    EXPECT_TRUE(std::find(failed.begin(), failed.end(), "no design of the front is dominated") != failed.end());
}

Json given(double rocker) {
    const Problem problem = problem_of(fmt::format(
        "mechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = 30\ncoupler = 80\nrocker = {}\n", rocker));
    return analysis_document(problem, evaluate_given(problem));
}

TEST(Singular, PositionsAreWarnedOfByTheRule) {
    EXPECT_FALSE(given(60).contains("warnings"));
    EXPECT_FALSE(given(50.02).contains("warnings"));  // 2e-4 of the longest link
    const Json close = given(50.00003);
    ASSERT_TRUE(close.contains("warnings"));
    EXPECT_NEAR(close["warnings"][0]["margin"].get<double>(), 3e-5, 1e-12);
    EXPECT_NEAR(close["warnings"][0]["relative"].get<double>(), 3e-7, 1e-14);
    EXPECT_TRUE(failures(close).empty()) << told(verify(close));
    Json silent = close;
    silent.erase("warnings");
    EXPECT_FALSE(failures(silent).empty());
}

TEST(Asked, IsWhatTheProblemAsksFor) {
    const Problem problem = problem_of(
        "mechanism = \"four-bar\"\n[dimensions]\nground = 100\ncrank = { min = 5, max = 90 }\n"
        "coupler = { min = 20, max = 300 }\nrocker = { min = 20, max = 300 }\n[[require]]\nquantity = \"swing\"\n"
        "equal = 60\n[[require]]\nquantity = \"time-ratio\"\nequal = 1.1\n[objective]\n"
        "maximize = \"transmission-angle-worst\"\n");
    const Json json = document(problem, solve(problem, {}));
    EXPECT_EQ(asked_otherwise(json, problem), "");
    Problem other = problem;
    other.requirements[1].equal = 1.2;
    EXPECT_NE(asked_otherwise(json, other).find("requirements[1].equal"), std::string::npos);
    other = problem;
    other.requirements.pop_back();
    EXPECT_NE(asked_otherwise(json, other), "");
    other = problem;
    other.dimensions[1].max = 80;
    EXPECT_NE(asked_otherwise(json, other).find("dimensions.crank.max"), std::string::npos);
    other = problem;
    other.crank_range = Vector<double>{0.5, 1};
    EXPECT_NE(asked_otherwise(json, other).find("crank_range"), std::string::npos);
}

}  // namespace

}  // namespace mechwright
