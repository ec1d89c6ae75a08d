// Documents of exact designs: what only they state is checked as well.

#include <gtest/gtest.h>

#include <algorithm>

#include "synthesis/document/document.h"
#include "synthesis/problem/reader.h"
#include "synthesis/solve/solve.h"
#include "synthesis/verify/verify.h"

namespace mechwright {
namespace {

using Json = nlohmann::ordered_json;

Json solved_document(const std::string& file) {
    const ReadProblem read = read_problem(MECHWRIGHT_SOURCE_DIR "/problems/exact/" + file);
    EXPECT_TRUE(read.ok());
    const Result result = solve(read.problem, {});
    EXPECT_EQ(result.status, Status::solved) << file;
    return document(read.problem, result);
}

std::vector<std::string> failures(const Json& document) {
    std::vector<std::string> names;
    for (const Check& check : verify(document))
        if (!check.passed) names.push_back(check.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(VerifyExact, MeetsTheAccuracyPointsOfAFunction) {
    Json json = solved_document("power-three-points.toml");
    EXPECT_EQ(failures(json), Names{});
    const std::vector<Check> checks = verify(json);
    EXPECT_TRUE(std::any_of(checks.begin(), checks.end(),
                            [](const Check& c) { return c.name == "meets the function at the accuracy points"; }));
    json["function"]["accuracy_points"][1] = 2.6;
    EXPECT_EQ(failures(json), (Names{"meets the function at the accuracy points", "asks for what its problem does"}));
    json["function"]["accuracy_points"] = "all";
    EXPECT_EQ(failures(json), Names{"the document can be understood"});
}

TEST(VerifyExact, LooksAtTheDirectionOfPosesAlone) {
    Json json = solved_document("three-poses-four-points.toml");
    EXPECT_EQ(failures(json), Names{});
    EXPECT_TRUE(json["poses"]["directions"][1].is_null());
    json["poses"]["directions"][1] = 3.0;  // asked for, and not met
    const Names failed = failures(json);
    EXPECT_NE(std::find(failed.begin(), failed.end(), "distances from the target are as stated"), failed.end());
    json["poses"]["directions"][1] = "any";
    EXPECT_EQ(failures(json), Names{"the document can be understood"});
}

TEST(VerifyExact, MeasuresAnInstantAgain) {
    Json json = solved_document("velocities-of-an-instant.toml");
    EXPECT_EQ(failures(json), Names{});
    json["design"]["crank-start"] = json["design"]["crank-start"].get<double>() + 0.1;
    const Names failed = failures(json);
    EXPECT_NE(std::find(failed.begin(), failed.end(), "instant-rocker-velocity equals 0.5"), failed.end());
    // Without the statement that an instant is asked for its quantities have no value.
    json = solved_document("velocities-of-an-instant.toml");
    json.erase("instant");
    EXPECT_FALSE(failures(json).empty());
}

/// A count that is whole in itself, and not that of all solutions that there are.
TEST(VerifyExact, KnowsHowManySolutionsThereAre) {
    const Json whole = solved_document("slider-crank-four-poses-one-point.toml");
    EXPECT_EQ(failures(whole), Names{});
    EXPECT_EQ(whole["search"]["solutions"]["tracked"], 6);
    Json one_less = whole;
    for (const char* count : {"tracked", "distinct"})
        one_less["search"]["solutions"][count] = 5;
    EXPECT_EQ(failures(one_less), Names{"that no design is better is shown"});
}

}  // namespace
}  // namespace mechwright
