// Larger groups in problem files: which assembly is meant, what is measured on its branch, documents that are verified
// by the joints' equations. Angles of platforms are those of the reference (triad_circuits.py, 40 digits).

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/solve/solve.h"
#include "tests/checked.h"
#include "tests/long_form.h"
#include "tests/triad.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::is_refused;

/// A plate on two legs and on a rod of a crank; `rest` says the assembly and what is asked.
std::string plate_file(const std::string& crank_pivot, const std::string& crank, const std::string& left,
                       const std::string& rest) {
    return "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0], B = [2.5, 0], O = " + crank_pivot +
           " }\ncrank = { O = [0, 0], C = [" + crank + ", 0] }\nleft = { A = [0, 0], P = [" + left +
           ", 0] }\nplatform = { P = [0, 0], Q = [2, 0], R = [1, -1.5] }\nright = { B = [0, 0], Q = [2, 0] }\n"
           "rod = { C = [0, 0], R = [2.5, 0] }\n[drive]\nlink = \"crank\"\n[signals]\n"
           "turn = { angle = \"platform\", near = 180 }\n" +
           rest;
}

std::string index_of_plate(int index) {
    return "[assembly]\nplatform = { group = \"left+platform+right+rod\", index = " + std::to_string(index) + " }\n";
}

/// Reference 5.8: B has six circuits that go round, A two of four that come to turning points.
std::string case_b(const std::string& rest) { return plate_file("[1.2, 2]", "0.6", "2", rest); }
std::string case_a(const std::string& rest) { return plate_file("[1.5, 2]", "0.5", "1.5", rest); }

std::string asked(const std::string& quantity) { return "[[require]]\nquantity = \"" + quantity + "\"\nmin = -1e9\n"; }

Json document_of(const std::string& text) {
    const ReadProblem read = parse_problem(text, "larger.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.ok() ? analysis_document(read.problem, evaluate_given(read.problem)) : Json();
}

std::string refusal(const std::string& text) {
    const ReadProblem read = parse_problem(text, "larger.toml");
    std::string all;
    for (const Message& message : read.messages)
        all += to_string(message) + "\n";
    EXPECT_FALSE(read.ok());
    return all;
}

bool is_among(double value, const std::vector<double>& all) {
    return std::any_of(all.begin(), all.end(), [value](double one) { return std::abs(value - one) < 1e-10; });
}

TEST(LargerProblems, EachIndexIsACircuitOfItsOwn) {
    const std::vector<double> at_start{19.217130135104067, 66.368777948591608, 102.34461344566289,
                                       244.98243845302464, 250.37454847053023, 351.31815899383071},
        half_round{8.002213795986366,  113.06285560842495, 117.07236593899778,
                   258.00575050944216, 298.33922497031405, 339.18149928007581};
    const auto folded = [](double angle) { return angle - 360 * std::floor(angle / 360); };
    std::vector<double> starts;
    for (int index = 1; index <= 6; ++index) {
        const Json document = document_of(case_b(index_of_plate(index) + asked("turn.at(0)") + asked("turn.at(180)")));
        const Json& quantities = document["quantities"];
        starts.push_back(folded(quantities["turn.at(0)"].get<double>()));
        EXPECT_TRUE(is_among(starts.back(), at_start)) << starts.back();
        EXPECT_TRUE(is_among(folded(quantities["turn.at(180)"].get<double>()), half_round));
        EXPECT_EQ(document["design"]["assembly"]["left+platform+right+rod"]["index"], index);
        if (index == 3) expect_verified(document);
    }
    std::sort(starts.begin(), starts.end());
    EXPECT_EQ(std::unique(starts.begin(), starts.end(), [](double a, double b) { return b - a < 1e-9; }), starts.end());
}

TEST(LargerProblems, ALimitedMotionEndsAtItsTurningPoints) {
    // At 150 degrees four assemblies, of which two go to and fro between these crank angles.
    int limited = 0;
    for (int index = 1; index <= 4; ++index) {
        const std::string text =
            case_a("[motion]\nat = 150\n" + index_of_plate(index) + asked("turn.least") + asked("turn.greatest"));
        const ReadProblem read = parse_problem(text, "larger.toml");
        ASSERT_TRUE(read.ok());
        std::vector<double> dimensions;
        for (const DimensionRange& range : read.problem.dimensions)
            dimensions.push_back(range.min);
        const Mechanism& mechanism = *read.problem.mechanism;
        const Motion motion = mechanism.motion({mechanism.model.data(), 0}, dimensions, nullptr);
        if (motion.full_turn) continue;
        ++limited;
        EXPECT_NEAR(motion.from * 180 / std::numbers::pi, 43.75894663936723, 1e-10);
        EXPECT_NEAR(motion.to * 180 / std::numbers::pi, 224.8118250556021, 1e-10);
        const Json document = document_of(text);
        const double least = document["quantities"]["turn.least"].get<double>(),
                     greatest = document["quantities"]["turn.greatest"].get<double>();
        EXPECT_LE(least, 45.56343253017661 + 1e-8);
        EXPECT_GE(greatest, 52.32960980464734 - 1e-8);
        if (limited == 1 || in_long_form()) expect_verified(document);
    }
    EXPECT_EQ(limited, 2);
}

TEST(LargerProblems, ASketchMeansTheNearestAssembly) {
    const std::string sketch = "[sketch]\ncrank = 0\npoints = { P = [1.7, 1], Q = [3.6, 1.6] }\n";
    const Json document = document_of(case_b(sketch + asked("turn.at(0)")));
    EXPECT_NEAR(document["quantities"]["turn.at(0)"].get<double>(), 19.217130135104067, 1e-10);
    Json other = document;
    Json& index = other["design"]["assembly"]["left+platform+right+rod"]["index"];
    index = index.get<int>() % 6 + 1;
    EXPECT_TRUE(is_refused(other));
}

TEST(LargerProblems, DimensionsAreFoundAlongTheBranchOfTheSketch) {
    std::string text = case_b(
        "[sketch]\ncrank = 0\npoints = { P = [1.7, 1], Q = [3.6, 1.6] }\n"
        "[dimensions]\nrod = { min = 2.3, max = 2.62, start = 2.5 }\n"
        "[[require]]\nquantity = \"turn.range\"\nequal = 24\n[solver]\nstarts = 2\n");
    text.replace(text.find("R = [2.5, 0]"), 12, "R = [\"rod\", 0]");
    const ReadProblem read = parse_problem(text, "larger.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    ASSERT_TRUE(read.ok());
    const Json document = ::mechwright::document(read.problem, solve(read.problem, {}));
    EXPECT_EQ(document["status"], "solved");
    EXPECT_NEAR(document["quantities"]["turn.range"].get<double>(), 24, 1e-6);
    expect_verified(document);
}

TEST(LargerProblems, WrongInputIsToldWithItsRemedy) {
    const auto expect_in = [](const std::string& text, const std::vector<std::string>& parts) {
        const std::string said = refusal(text);
        for (const std::string& part : parts)
            EXPECT_NE(said.find(part), std::string::npos) << part << " is not in\n" << said;
    };
    expect_in(case_b(""), {"close in 6 ways", "crank angle 0", "index = 1", "[sketch]"});
    expect_in(case_b(index_of_plate(7)), {"close in 6 ways", "the index must be one of them"});
    expect_in(case_b("[assembly]\nplatform = { group = \"left+rod\", index = 1 }\n"),
              {"the group of this link is \"left+platform+right+rod\""});
    expect_in(case_b("[assembly]\nplatform = \"left\"\n"), {"is of a group of links", "index = 1"});
    expect_in(plate_file("[1.2, 20]", "0.6", "2", ""), {"do not close at any input", "are missing at the crank angle"});
}

TEST(LargerProblems, EitherTriesAll) {
    const ReadProblem read = parse_problem(case_b("[assembly]\nplatform = \"either\"\n"), "larger.toml");
    ASSERT_TRUE(read.ok());
    EXPECT_EQ(read.problem.assemblies.size(), 6U);
}

}  // namespace

}  // namespace mechwright
