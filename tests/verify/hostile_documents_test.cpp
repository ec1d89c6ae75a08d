#include <gtest/gtest.h>

#include "tests/long_form.h"
#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;

Json good() {
    Json json = document({.links = {4, 1, 3, 3.5},
                          .assembly = "open",
                          .placement = {1.5, 2, 10, -5, 30, 15},
                          .required = {"swing"},
                          .maximized = "transmission-angle-worst",
                          .crank_range = {}});
    add_path(json, {15, 75, 135, 195}, 0.25, true);
    return json;
}

/// One failed check that says why, with this in it.
void expect_refused(const Json& json, const std::string& why) {
    const auto checks = verify(json);
    ASSERT_EQ(checks.size(), 1u) << told(checks);
    EXPECT_EQ(checks[0].name, "the document can be understood");
    EXPECT_FALSE(checks[0].passed);
    EXPECT_NE(checks[0].detail.find(why), std::string::npos) << checks[0].detail;
}

TEST(HostileDocument, TheGoodOneItIsMadeFromPasses) { EXPECT_TRUE(failures(good()).empty()) << told(verify(good())); }

TEST(HostileDocument, IsRefusedIfItIsNoDocumentAtAll) {
    for (const Json& json : {Json(), Json(1), Json("text"), Json::array({1, 2}), Json(true)})
        expect_refused(json, "not a JSON object");
    expect_refused(Json::object(), "schema is missing");
}

TEST(HostileDocument, IsRefusedIfSomethingIsMissing) {
    for (const char* member : {"schema", "problem", "dimensions", "design"}) {
        Json json = good();
        json.erase(member);
        expect_refused(json, member);
    }
    for (const char* member : {"ground", "crank", "coupler", "rocker"}) {
        Json json = good();
        json["design"].erase(member);
        expect_refused(json, std::string("design.") + member + " is missing");
    }
    Json json = good();
    json["requirements"][0].erase("quantity");
    expect_refused(json, "requirements[0].quantity is missing");
    json = good();
    json["requirements"][0].erase("equal");
    expect_refused(json, "requires nothing");
}

TEST(HostileDocument, IsRefusedIfANameIsUnknown) {
    Json json = good();
    json["problem"]["mechanism"] = "five-bar";
    expect_refused(json, "'five-bar'");
    json = good();
    json["requirements"][0]["quantity"] = "swang";
    expect_refused(json, "'swang'");
    json = good();
    json["design"]["assembly"] = "ajar";
    expect_refused(json, "'ajar'");
    json = good();
    json["design"]["krank"] = 1;
    expect_refused(json, "'krank'");
    json = good();
    json["dimensions"]["krank"] = 1;
    expect_refused(json, "'krank'");
    json = good();
    json["quantities"]["krank"] = 1;
    expect_refused(json, "'krank'");
    json = good();
    json["units"]["angle"] = "gon";
    expect_refused(json, "units.angle");
    json = good();
    json["path"]["timing"] = "whenever";
    expect_refused(json, "path.timing");
    json = good();
    json["objective"]["sense"] = "sideways";
    expect_refused(json, "objective.sense");
}

TEST(HostileDocument, NeverThrowsWhateverItsMembersAre) {
    Json json = good();
    json["quantities"] = {{"swing", json["quantities"]["swing"]}, {"link-ratio", json["quantities"]["link-ratio"]}};
    EXPECT_GT(verified_with_members_replaced(json), cases_to_try(150, 500));
    EXPECT_TRUE(failures(json).empty());
}

TEST(HostileDocument, IsRefusedIfANumberIsNone) {
    for (const Json& other : {Json(), Json("4"), Json(true), Json::array(), Json::object()}) {
        Json json = good();
        json["design"]["crank"] = other;
        expect_refused(json, "design.crank");
        json = good();
        json["requirements"][0]["value"] = other;
        expect_refused(json, "requirements[0].value");
        json = good();
        json["path"]["distances"][1] = other;
        expect_refused(json, "path.distances[1]");
        json = good();
        json["tolerance"] = other;
        expect_refused(json, "tolerance");
    }
    Json json = good();
    json["design"]["crank"] = std::numeric_limits<double>::infinity();
    expect_refused(json, "design.crank is not a finite number");
}

TEST(HostileDocument, IsRefusedIfANumberIsAbsurd) {
    Json json = good();
    json["path"]["crank_angles"][0] = 1e308;
    expect_refused(json, "path.crank_angles[0]");
    json = good();
    json["design"]["tilt"] = -1e300;
    expect_refused(json, "design.tilt");
    json = good();
    json["crank_range"] = {10, 10};
    expect_refused(json, "crank_range");
    json = good();
    json["crank_range"] = {10, 20, 30};
    expect_refused(json, "crank_range");
    for (const double tolerance : {0.0, -1e-9, 1.0, 1e308}) {
        json = good();
        json["tolerance"] = tolerance;
        expect_refused(json, "tolerance");
    }
    json = good();
    json["path"]["weights"] = {1, -1, 1, 1};
    expect_refused(json, "path.weights");
}

TEST(HostileDocument, FailsIfItsLengthsAreAbsurd) {
    for (const double length : {1e308, 1e-320, -1.0, 0.0}) {
        Json json = good();
        json["design"]["crank"] = length;
        EXPECT_FALSE(failures(json).empty()) << length;
        for (const char* name : {"ground", "crank", "coupler", "rocker"})
            json["design"][name] = length;
        EXPECT_FALSE(failures(json).empty()) << length;
    }
}

TEST(HostileDocument, FailsIfItsListsDifferInLength) {
    Json json = good();
    json["path"]["crank_angles"].push_back(200);
    EXPECT_EQ(failures(json), std::vector<std::string>{"says for every point of the path where it is met"});
    json = good();
    json["path"]["prescribed_angles"].push_back(200);
    expect_refused(json, "path.prescribed_angles");
    json = good();
    json["path"]["weights"] = {1, 1};
    expect_refused(json, "path.weights");
    json = good();
    json["path"]["points"][2] = {1, 2, 3};
    expect_refused(json, "path.points[2]");
    json = good();
    json["path"]["points"] = Json::array();
    expect_refused(json, "path.points is empty");
}

TEST(HostileDocument, IsRefusedIfItHasMorePointsOrRequirementsThanMakeSense) {
    Json json = good();
    json["path"]["points"] = std::vector<std::array<double, 2>>(1000000, {1, 2});
    expect_refused(json, "1000000 entries");
    json = good();
    json["requirements"] = Json(std::vector<Json>(100000, json["requirements"][0]));
    expect_refused(json, "100000 entries");
}

TEST(HostileDocument, IsQuotedShortlyInMessages) {
    Json json = good();
    json["problem"]["mechanism"] = std::string(1000000, 'x');
    const auto checks = verify(json);
    ASSERT_EQ(checks.size(), 1u);
    EXPECT_LT(checks[0].detail.size(), 500u);
    json["problem"]["mechanism"] = "four\x1b[31m\n-bar";
    EXPECT_EQ(verify(json)[0].detail.find('\x1b'), std::string::npos);
}

}  // namespace

}  // namespace mechwright
