#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/verify/documents.h"

namespace mechwright {

namespace {

using namespace test;
using Names = std::vector<std::string>;

/// A linkage with a coupler point, placed in the drawing.
Json path_linkage(const FourBar<double>& links, const std::string& assembly = "open") {
    return document({.links = links,
                     .assembly = assembly,
                     .placement = {1.5, 2, 10, -5, 30, 15},
                     .required = {},
                     .maximized = "",
                     .crank_range = {}});
}

const FourBar<double> turning{4, 1, 3, 3.5};
const FourBar<double> swinging{4, 3, 2, 2.5};  // assembles from -78.6 deg to 78.6 deg

TEST(VerifyPath, PassesRightPaths) {
    for (const char* assembly : {"open", "crossed"}) {
        Json free = path_linkage(turning, assembly);
        add_path(free, {10, 50, 90, 170, 300}, 0.25, false);
        EXPECT_EQ(failures(free), Names{}) << told(verify(free));
        Json backwards = path_linkage(turning, assembly);
        add_path(backwards, {10, -50, -90, 200, 20}, 0, false);
        EXPECT_EQ(failures(backwards), Names{}) << told(verify(backwards));
        Json timed = path_linkage(turning, assembly);
        add_path(timed, {15, 75, 135, 195}, 0.25, true);
        EXPECT_EQ(failures(timed), Names{}) << told(verify(timed));
        Json single = path_linkage(turning, assembly);
        add_path(single, {40}, 0.25, false);
        EXPECT_EQ(failures(single), Names{}) << told(verify(single));
        Json closed = path_linkage(turning, assembly);
        add_path(closed, {15, 105, 195, 285, 375}, 0, false);
        closed["path"]["points"][4] = closed["path"]["points"][0];
        EXPECT_EQ(failures(closed), Names{}) << told(verify(closed));
    }
}

TEST(VerifyPath, MeasuresPathQuantitiesWithWeights) {
    Json json = path_linkage(turning);
    add_path(json, {10, 50, 90, 170}, 0.5, false);
    json["path"]["weights"] = {1, 2, 3, 2};
    json["objective"] = {{"quantity", "path-sse"}, {"sense", "minimize"}, {"value", 2.0}};
    json["requirements"] = Json::array({{{"quantity", "path-rms"}, {"value", 0.5}, {"max", 0.5}},
                                        {{"quantity", "path-max"}, {"value", 0.5}, {"max", 1}}});
    EXPECT_EQ(failures(json), Names{}) << told(verify(json));
    json["objective"]["value"] = 1.0;
    json["requirements"][1]["max"] = 0.49;
    EXPECT_EQ(failures(json), (Names{"path-max is at most 0.49 mm", "the objective is as stated"}));
}

TEST(VerifyPath, FailsPathPointsThatAreNotMetInOrder) {
    const std::string order = "meets the points in order within one turn of the crank";
    const std::string sweep = "stays assembled on one branch along the path";
    for (const std::vector<double>& angles :
         {std::vector<double>{10, 90, 50, 170}, {10, 50, 50, 90}, {10, 130, 250, 370, 490}, {10, 130, 250, 370}}) {
        Json json = path_linkage(turning);
        add_path(json, angles, 0.25, false);
        // Nothing is wrong but the order: neighbouring points may coincide here, the last is not the first.
        json["path"]["points"].back()[0] = json["path"]["points"].back()[0].get<double>() + 0.25;
        json["path"]["distances"].back() = 0.5;
        EXPECT_EQ(failures(json), (Names{order, sweep})) << told(verify(json));
    }
}

TEST(VerifyPath, FailsPrescribedCrankAnglesThatAreNotMet) {
    Json json = path_linkage(turning);
    add_path(json, {15, 75, 135, 195}, 0.25, true);
    json["path"]["prescribed_angles"][2] = json["path"]["prescribed_angles"][2].get<double>() + 1e-6;
    EXPECT_EQ(failures(json), Names{"meets the points at the prescribed crank angles"});
}

TEST(VerifyPath, FailsFalsifiedDistancesAndPoints) {
    Json json = path_linkage(turning);
    add_path(json, {10, 50, 90, 170}, 0.25, false);
    json["path"]["distances"][2] = 0.2499999;
    EXPECT_EQ(failures(json), Names{"distances from the target are as stated"});
    json["path"]["distances"][2] = 0.25;
    json["path"]["reached"][1][0] = json["path"]["reached"][1][0].get<double>() + 1e-6;
    EXPECT_EQ(failures(json), Names{"reaches the points that are stated"});
}

/// A path in any order whose points lie on the curve at some crank angles, said to be nearest at others.
Json path_in_any_order(const std::vector<double>& met_at, const std::vector<double>& stated_at) {
    Json json = path_linkage(turning);
    add_path(json, met_at, 0, false);
    const Json points = json["path"]["reached"];
    add_path(json, stated_at, 0, false);
    Json& path = json["path"];
    path["timing"] = "none";
    path["points"] = points;
    for (std::size_t i = 0; i < points.size(); ++i)
        path["distances"][i] = std::hypot(points[i][0].get<double>() - path["reached"][i][0].get<double>(),
                                          points[i][1].get<double>() - path["reached"][i][1].get<double>());
    return json;
}

/// Crank angles between whole and half degrees, where no sample of the curve is.
TEST(VerifyPath, FailsPlacesThatAreNotTheNearest) {
    const Json right = path_in_any_order({40.25, 359.75, 130.2}, {40.25, 359.75, 130.2});
    EXPECT_EQ(failures(right), Names{}) << told(verify(right));
    for (const std::vector<double>& stated :
         {std::vector<double>{40.1, 359.75, 130.2}, {40.25, 359.9, 130.2}, {40.25, 359.75, 130.201}}) {
        const Json wrong = path_in_any_order({40.25, 359.75, 130.2}, stated);
        EXPECT_EQ(failures(wrong), Names{"every point counts by the nearest point of the curve"})
            << told(verify(wrong));
    }
}

TEST(VerifyPath, FailsTheRightPathOnTheOtherBranch) {
    Json json = path_linkage(turning);
    add_path(json, {10, 50, 90, 170}, 0.25, false);
    json.erase("quantities");
    json["design"]["assembly"] = "crossed";
    EXPECT_EQ(failures(json), (Names{"reaches the points that are stated", "distances from the target are as stated"}));
}

TEST(VerifyPath, HoldsAPathToTheRangeInWhichASwingingCrankAssembles) {
    Json inside = path_linkage(swinging);
    add_path(inside, {60, 20, -10, -70}, 0.25, false);
    EXPECT_EQ(failures(inside), Names{}) << told(verify(inside));
    Json timed = path_linkage(swinging);
    add_path(timed, {-40, 60, 15}, 0.25, true);
    EXPECT_EQ(failures(timed), Names{}) << told(verify(timed));
    // All four are met, but only over 180 deg, where the linkage comes apart.
    Json across = path_linkage(swinging);
    add_path(across, {10, 70, -70, -10}, 0.25, false);
    EXPECT_EQ(failures(across), Names{"stays assembled on one branch along the path"}) << told(verify(across));
    Json beyond = path_linkage(swinging);
    add_path(beyond, {60, 20, -10, -120}, 0.25, false);
    const Names failed = failures(beyond);
    EXPECT_NE(std::find(failed.begin(), failed.end(), "reaches the points that are stated"), failed.end());
    EXPECT_NE(std::find(failed.begin(), failed.end(), "stays assembled on one branch along the path"), failed.end());
}

TEST(VerifyPath, FailsAPathThatDoesNotSayWhereItsPointsAreMet) {
    Json json = path_linkage(turning);
    add_path(json, {10, 50, 90, 170}, 0.25, false);
    for (const char* member : {"reached", "crank_angles", "distances"}) {
        Json without = json;
        without["path"].erase(member);
        EXPECT_EQ(failures(without), Names{"says for every point of the path where it is met"}) << member;
    }
}

}  // namespace

}  // namespace mechwright
