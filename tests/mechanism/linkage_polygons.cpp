// Regions that are polygons with inward corners: against all poses of a fine scan, and differences; and what is said of
// polygons whose sides meet.

#include "tests/mechanism/linkage_scans.h"

namespace mechwright::linkage_scans {

namespace {

const std::string polygons_of_linkage = rocking_room + R"(
[[region]]
name = "bay"
keep = "in"
polygon = [[-3, -6.3], [9, -6.3], [9, 9], [5.5, 9], [5.5, 12], [-3, 12]]
[[region]]
name = "hook"
keep = "out"
of = ["coupler"]
polygon = [[7.8, 7], [12, 7], [12, 8], [9, 8], [9, 12], [7.8, 12]]
[[region]]
name = "notch"
keep = "out"
of = ["rocker", "P"]
polygon = [[9, 14], [-6, 14], [-6, -3], [-5, -3], [-5, 11], [8, 11], [8, -3], [9, -3]]
)";

/// Outlines of crank, coupler and rocker in a pose, in the order A, D, B, C, P.
std::vector<Places> links_of(const Places& pose) {
    return {{pose[0], pose[2]}, {pose[2], pose[3], pose[4]}, {pose[1], pose[3]}};
}

double least_distance(const std::vector<Places>& parts, const Places& polygon) {
    double least = std::numeric_limits<double>::infinity();
    for (const Places& part : parts)
        least = std::min(least, between_outlines(part, polygon));
    return least;
}

TEST(LinkagePolygons, WithInwardCornersAreThoseOfAScan) {
    const Places bay{{-3, -6.3}, {9, -6.3}, {9, 9}, {5.5, 9}, {5.5, 12}, {-3, 12}},
        hook{{7.8, 7}, {12, 7}, {12, 8}, {9, 8}, {9, 12}, {7.8, 12}},
        notch{{9, 14}, {-6, 14}, {-6, -3}, {-5, -3}, {-5, 11}, {8, 11}, {8, -3}, {9, -3}};
    for (const char* motion : {"", "[motion]\ncrank_range = [20, 200]\n"}) {
        const AnalysedRoom found = analysed_room(polygons_of_linkage + motion);
        const ScannedRoom scan(found.design, {"A", "D", "B", "C", "P"}, 20000);
        const auto expect_least = [&](const char* name, const std::function<double(const Places&)>& of_pose) {
            const double margin = value_in(found.document, std::string(name) + ".margin"), least = scan.least(of_pose);
            EXPECT_GT(margin, 0) << name;
            EXPECT_NEAR(margin, least, 1e-6) << name;
            EXPECT_LE(margin, least + 1e-13) << name;
        };
        expect_least("bay", [&](const Places& pose) { return least_distance(links_of(pose), bay); });
        expect_least("hook", [&](const Places& pose) { return least_distance({links_of(pose)[1]}, hook); });
        expect_least("notch", [&](const Places& pose) {
            return least_distance({links_of(pose)[2], {pose[4]}}, notch);
        });
        expect_verified(found.document);
        for (const char* name : {"bay.margin", "hook.margin", "notch.margin"}) {
            Json changed = found.document;
            changed["quantities"][name] = value_in(changed, name) + 1e-6;
            EXPECT_TRUE(is_refused(changed)) << name;
        }
    }
}

TEST(LinkagePolygons, HaveExactDerivatives) {
    expect_room_slopes(polygons_of_linkage, {"bay.margin", "hook.margin", "notch.margin"});
}

/// All points of the rocker stay in an L whose inward corner it passes over: it is not in the L, as its points are.
TEST(LinkagePolygons, AreLeftBySidesBetweenTheirCorners) {
    const std::string l = "polygon = [[-3, -6], [9, -6], [9, 1.2], [5, 1.2], [5, 9], [-3, 9]]\n";
    const AnalysedRoom found = analysed_room(rocking_room + R"(
[[region]]
name = "link"
keep = "in"
of = ["rocker"]
)" + l + R"([[region]]
name = "points"
keep = "in"
of = ["D", "C"]
)" + l + R"([[region]]
name = "over"
keep = "out"
of = ["crank"]
polygon = [[2, -2.2], [2.4, -2.2], [2.4, -1.8], [2.3, -1.8], [2.2, -2], [2.1, -1.8], [2, -1.8]]
)");
    EXPECT_LT(value_in(found.document, "link.margin"), -0.01);
    EXPECT_GT(value_in(found.document, "points.margin"), 0.1);
    EXPECT_LT(value_in(found.document, "over.margin"), -0.05);
    EXPECT_GE(count_of_stated(found.document), 3u);
}

TEST(LinkagePolygons, WhoseSidesMeetAreRefused) {
    const auto error_of = [](const std::string& corners) {
        return testing::first_error(rocking_room + "[[region]]\nname = \"bay\"\nkeep = \"in\"\npolygon = " + corners +
                                    "\n");
    };
    const auto expect_said = [&](const std::string& corners, const std::string& said) {
        EXPECT_EQ(error_of(corners).substr(0, said.size()), said);
    };
    expect_said(
        "[[0, 0], [4, 4], [4, 0], [0, 2]]",
        "'polygon' in [[region]] number 1 crosses itself at [1.33333, 1.33333]: give its corners in their order "
        "around it");
    expect_said("[[0, 0], [4, 0], [4, 3], [2, 0], [0, 3]]",
                "'polygon' in [[region]] number 1 crosses itself at [2, 0]");
    expect_said("[[0, 0], [4, 0], [2, 0], [2, 3]]", "'polygon' in [[region]] number 1 crosses itself at [2, 0]");
}

}  // namespace

}  // namespace mechwright::linkage_scans
