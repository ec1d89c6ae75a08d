// Regions that parts of linkages keep in or out of over their motion: against closed forms, all poses of a fine scan
// and differences.

#include "tests/mechanism/linkage_scans.h"

namespace mechwright::linkage_scans {

namespace {

/// How far a point is beyond the line of the side beyond which it is farthest; of a polygon against the clock.
double beyond_sides(const Vector<double>& at, const Places& polygon) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector<double> side = polygon[(i + 1) % polygon.size()] - polygon[i];
        most = std::max(most, -cross(side, at - polygon[i]) / std::hypot(side.x, side.y));
    }
    return most;
}

const std::vector<std::string> points_of_regions{"A", "D", "B", "C", "P"};

void expect_margin(const AnalysedRoom& found, const std::string& region,
                   const std::function<double(const Places&)>& of_pose, double within = 1e-6) {
    const double scanned = ScannedRoom(found.design, points_of_regions, 40000).least(of_pose),
                 margin = value_in(found.document, region + ".margin");
    EXPECT_NEAR(margin, scanned, within) << region;
    EXPECT_LE(margin, scanned + 1e-13) << region;
}

TEST(LinkageRegions, InWhichPartsKeepAreThoseOfAScan) {
    const AnalysedRoom found = analysed_room(rocking_room + R"(
[[region]]
name = "bay"
keep = "in"
polygon = [[-3, -6], [-2, 9], [9, 6], [8, -5]]
[[region]]
name = "disc"
keep = "in"
of = ["coupler"]
circle = { centre = [2, 1], radius = 7 }
[[region]]
name = "wall"
keep = "in"
of = ["P", "C"]
half-plane = { through = [0, 8], direction = 170 }
[[region]]
name = "floor"
keep = "out"
half-plane = { through = [0, -4.5], direction = 180 }
)");
    const Places bay{{8, -5}, {9, 6}, {-2, 9}, {-3, -6}};
    expect_margin(found, "bay", [&](const Places& pose) {
        double least = 100;
        for (const Vector<double>& at : pose)
            least = std::min(least, -beyond_sides(at, bay));
        return least;
    });
    expect_margin(found, "disc", [](const Places& pose) {
        double least = 100;
        for (const std::size_t p : {2, 3, 4})
            least = std::min(least, 7 - std::hypot(pose[p].x - 2, pose[p].y - 1));
        return least;
    });
    expect_margin(found, "wall", [](const Places& pose) {
        double least = 100;
        for (const std::size_t p : {3, 4})
            least = std::min(least, along_way(pose[p] - Vector<double>{0, 8}, 260));
        return least;
    });
    expect_margin(found, "floor", [](const Places& pose) {
        double least = 100;
        for (const Vector<double>& at : pose)
            least = std::min(least, at.y + 4.5);
        return least;
    });
    expect_verified(found.document);
}

TEST(LinkageRegions, OutOfWhichPartsKeepAreThoseOfAScan) {
    const std::string text = rocking_room + R"(
[[region]]
name = "post"
keep = "out"
of = ["coupler"]
circle = { centre = [9, 9], radius = 1 }
[[region]]
name = "box"
keep = "out"
of = ["rocker"]
polygon = [[7.8, 2], [9, 2], [9, 3], [7.9, 3]]
[[region]]
name = "pole"
keep = "out"
of = ["P"]
polygon = [[-2, 4], [-3, 6], [-4, 4]]
[[region]]
name = "thorn"
keep = "out"
of = ["crank", "rocker", "coupler"]
polygon = [[0.9, 7], [0.6, 9], [1.5, 9]]
)";
    for (const char* motion : {"", "[motion]\ncrank_range = [20, 200]\n"}) {
        const AnalysedRoom found = analysed_room(text + motion);
        const auto plate = [](const Places& pose) { return Places{pose[2], pose[3], pose[4]}; };
        expect_margin(found, "post", [&](const Places& pose) { return between_outlines(plate(pose), {{9, 9}}) - 1; });
        expect_margin(found, "box", [&](const Places& pose) {
            return between_outlines({pose[1], pose[3]}, {{7.8, 2}, {9, 2}, {9, 3}, {7.9, 3}});
        });
        expect_margin(found, "pole", [&](const Places& pose) {
            return between_outlines({pose[4]}, {{-2, 4}, {-3, 6}, {-4, 4}});
        });
        const Places thorn{{0.9, 7}, {1.5, 9}, {0.6, 9}};
        expect_margin(found, "thorn", [&](const Places& pose) {
            return std::min({between_outlines({pose[0], pose[2]}, thorn), between_outlines({pose[1], pose[3]}, thorn),
                             between_outlines(plate(pose), thorn)});
        });
        expect_verified(found.document);
        for (const char* region : {"post", "box", "pole", "thorn"}) {
            Json changed = found.document;
            const std::string name = std::string(region) + ".margin";
            changed["quantities"][name] = value_in(changed, name) + 1e-6;
            EXPECT_TRUE(is_refused(changed)) << region;
        }
    }
}

/// A bar that turns about A: it sweeps over a place, and how deep it is in a polygon follows from its direction alone.
TEST(LinkageRegions, AreLeftByTheShortestWayWherePartsOverlap) {
    const std::string text = rocking_room + R"(
[[region]]
name = "point"
keep = "out"
of = ["B"]
polygon = [[2.9, -2.2], [3.1, -2.2], [3.1, -1.8], [2.9, -1.8]]
[[region]]
name = "disc"
keep = "out"
of = ["crank"]
circle = { centre = [2, -2], radius = 0.3 }
[[region]]
name = "bar"
keep = "out"
of = ["crank"]
polygon = [[2, -2.1], [2.4, -2.1], [2.4, -1.9], [2, -1.9]]
)";
    const AnalysedRoom found = analysed_room(text);
    // The crank's circle of radius 2 about (1, -2) passes (3, -2), the middle of the square: 0.1 from its long sides,
    // and deeper below them nowhere, for it is narrower than that.
    const double margin = value_in(found.document, "point.margin");
    const Places square{{2.9, -2.2}, {3.1, -2.2}, {3.1, -1.8}, {2.9, -1.8}};
    expect_margin(found, "point", [&](const Places& pose) { return beyond_sides(pose[2], square); });
    EXPECT_NEAR(margin, -0.1, 1e-12);
    EXPECT_NEAR(value_in(found.document, "disc.margin"), -0.3, 1e-12);
    const Places bar{{2, -2.1}, {2.4, -2.1}, {2.4, -1.9}, {2, -1.9}};
    expect_margin(
        found, "bar",
        [&](const Places& pose) {
            double most = -100, least = 100, greatest = -100;
            const Vector<double> side = pose[2] - pose[0];
            for (const Vector<double>& corner : bar) {
                least = std::min(least, cross(side, corner - pose[0]) / 2);
                greatest = std::max(greatest, cross(side, corner - pose[0]) / 2);
            }
            most = std::max(least, -greatest);
            for (std::size_t i = 0; i < 4; ++i) {
                const Vector<double> edge = bar[(i + 1) % 4] - bar[i];
                double nearest = 100;
                for (const std::size_t p : {0, 2})
                    nearest = std::min(nearest, -cross(edge, pose[p] - bar[i]) / std::hypot(edge.x, edge.y));
                most = std::max(most, nearest);
            }
            return most < 0 ? most : between_outlines({pose[0], pose[2]}, bar);
        },
        1e-4);  // least where two sides are as deep, not flat
    EXPECT_NEAR(value_in(found.document, "bar.margin"), -0.1, 1e-12);
    // They do not keep out; but their margins are as they are stated.
    EXPECT_GE(count_of_stated(found.document), 4u);
}

TEST(LinkageRegions, HaveExactDerivatives) {
    expect_room_slopes(rocking_room + R"(
[[region]]
name = "bay"
keep = "in"
polygon = [[-3, -6], [-2, 9], [9, 6], [8, -5]]
[[region]]
name = "disc"
keep = "in"
of = ["coupler"]
circle = { centre = [2, 1], radius = 7 }
[[region]]
name = "post"
keep = "out"
of = ["coupler"]
circle = { centre = [9, 9], radius = 1 }
[[region]]
name = "box"
keep = "out"
of = ["rocker"]
polygon = [[7.8, 2], [9, 2], [9, 3], [7.9, 3]]
[[region]]
name = "bar"
keep = "out"
of = ["rocker"]
polygon = [[4, 2.1], [6, 2.2], [6.1, 3], [4.1, 3]]
[[region]]
name = "thin"
keep = "out"
of = ["crank"]
polygon = [[2, -2.12], [2.4, -2.1], [2.41, -1.9], [2, -1.9]]
)",
                       {"bay.margin", "disc.margin", "post.margin", "box.margin", "bar.margin", "thin.margin"});
}

/// Two cranks geared to each other, beside each other, and a floating bar.
const std::string geared_cranks = testing::head + R"(
[dimensions]
ground = 5
first = 2
second = 2.4
left = 6
right = 6.2
[links]
frame = { A = [0, 0], E = ["ground", 0] }
first = { A = [0, 0], B = ["first", 0], F = [-0.7, 0.4] }
second = { E = [0, 0], D = ["second", 0] }
left = { B = [0, 0], P = ["left", 0] }
right = { D = [0, 0], P = ["right", 0] }
[[gear]]
links = ["first", "second"]
ratio = -1
phase = 200
[drive]
link = "first"
[[region]]
name = "cranks"
keep = "out"
of = ["first"]
link = { name = "second", width = 0.2 }
[[region]]
name = "sides"
keep = "out"
of = ["first", "E"]
link = { name = "left" }
)";

TEST(LinkageRegions, ThatMoveAreThoseOfAScan) {
    std::string text = geared_cranks;
    text = text.substr(0, text.find("[[region]]\nname = \"sides\""));
    const AnalysedRoom found = analysed_room(text + R"(
[[region]]
name = "sides"
keep = "out"
of = ["first"]
link = { name = "right", width = 0.5 }
)");
    const std::vector<std::string> points{"A", "B", "F", "E", "D", "P"};
    const ScannedRoom scan(found.design, points, 40000);
    const auto first = [](const Places& pose) { return Places{pose[0], pose[1], pose[2]}; };
    const double cranks = scan.least([&](const Places&pose) {
        return between_outlines(first(pose), {pose[3], pose[4]}) - 0.1;
    }),
                 sides = scan.least([&](const Places&pose) {
                     return between_outlines(first(pose), {pose[4], pose[5]}) - 0.25;
                 });
    EXPECT_NEAR(value_in(found.document, "cranks.margin"), cranks, 1e-4);
    EXPECT_NEAR(value_in(found.document, "sides.margin"), sides, 1e-4);
    for (const Check& check : verify(found.document))
        if (check.name.ends_with("stated")) {
            EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
        }
    expect_room_slopes(text, {"cranks.margin"});
    EXPECT_EQ(testing::first_error(geared_cranks).substr(0, 60),
              std::string("'name' in [link]: 'left' has the point 'B' in common with what").substr(0, 60));
}

TEST(LinkageRegions, AreRequirements) {
    const std::string text = rocking_room + R"(
[[region]]
name = "disc"
keep = "in"
of = ["crank"]
circle = { centre = [1, -2], radius = 3 }
margin = )";
    const ReadProblem near = testing::read_without_fault(text + "0.9"), far = testing::read_without_fault(text + "1.1");
    ASSERT_EQ(near.problem.requirements.size(), 1u);
    EXPECT_TRUE(evaluate_given(near.problem).feasible);
    EXPECT_FALSE(evaluate_given(far.problem).feasible);
    const Json document = analysis_document(near.problem, evaluate_given(near.problem));
    EXPECT_EQ(document["requirements"][0]["quantity"], "disc.margin");
    EXPECT_NEAR(document["requirements"][0]["min"].get<double>(), 0.9, 0);
    EXPECT_NEAR(value_in(document, "disc.margin"), 1, 1e-14);
}

}  // namespace

}  // namespace mechwright::linkage_scans
