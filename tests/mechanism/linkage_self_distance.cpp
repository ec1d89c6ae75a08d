// How near the path of a point comes to itself: against closed forms, all chords of a fine scan and differences.

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "synthesis/solve/solve.h"
#include "tests/mechanism/kinds_with_rooms.h"

namespace mechwright::linkage_scans {

namespace {

std::string room_of(const std::string& point) { return "[[room]]\nname = \"way\"\nof = [\"" + point + "\"]\n"; }

double self_distance(const Json& document) { return value_in(document, "way.self-distance"); }

/// The pin of a crank of 10, over a turn or a part of one.
Json crank_pin(const std::string& range) {
    return analysed_room(
               "schema = 1\nmechanism = \"linkage\"\n[dimensions]\narm = 10\n[links]\nframe = { A = [0, 0] }\ncrank = "
               "{ A "
               "= [0, 0], B = [\"arm\", 0] }\n[drive]\nlink = \"crank\"\n" +
               (range.empty() ? "" : "[motion]\ncrank_range = " + range + "\n") + room_of("B"))
        .document;
}

/// An ellipse of half axes 10 and 30: the shorter axis is the shortest chord that stands square at both ends.
TEST(SelfDistance, OfAnEllipseIsItsShorterAxis) {
    const Json document =
        analysed_room(
            "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { O = [0, 0] }\nbar = { A = [0, 0], "
            "B = [10, 0], P = [15, 0] }\n[[slot]]\npin = \"A\"\nin = \"frame\"\npoint = "
            "\"O\"\ndirection = 0\n[[slot]]\npin = \"B\"\nin = \"frame\"\npoint = \"O\"\ndirection = "
            "90\n[drive]\nlink = \"bar\"\n[placement]\nscale = 2\ntilt = 40\n" +
            room_of("P"))
            .document;
    EXPECT_NEAR(self_distance(document), 20, 1e-12);
    expect_verified(document);
}

TEST(SelfDistance, OfACircleIsItsDiameter) {
    const Json document = crank_pin("");
    EXPECT_NEAR(self_distance(document), 20, 1e-12);
    expect_verified(document);
}

/// Of three quarters of a circle and more the ends are nearest; of less than half nothing comes back, and the ends are
/// all there is.
TEST(SelfDistance, OfAnArcIsThatOfItsEnds) {
    const Json open = crank_pin("[-150, 150]"), flat = crank_pin("[-40, 80]");
    EXPECT_NEAR(self_distance(open), 10, 1e-12);
    EXPECT_NEAR(self_distance(flat), 20 * std::sin(60 * one_degree), 1e-12);
    expect_verified(open);
    expect_verified(flat);
}

/// A four-bar whose coupler point goes round a figure of eight, and one whose rocker pin goes back the way it came.
TEST(SelfDistance, OfWhatCrossesOrRetracesItselfIsZero) {
    const std::string links =
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 2\ncoupler = 4\nrocker = 4\n"
        "point-along = 3\npoint-across = -1.5\n";
    const Json eight = analysed_room(links + room_of("P")).document,
               back = analysed_room(links + room_of("C")).document;
    EXPECT_NEAR(self_distance(eight), 0, 1e-12);
    EXPECT_NEAR(self_distance(back), 0, 1e-12);
}

/// The least of all chords between 3000 places that stand square at both: of those at which the sum of the places' ways
/// along it changes its sign both times.
double least_of_chords(const std::vector<Vector<double>>& places) {
    const std::size_t n = places.size();
    const auto along = [&](std::size_t i) { return places[(i + 1) % n] - places[(i + n - 1) % n]; };
    const auto changes = [](double a, double b, double c, double d) {
        return std::min({a, b, c, d}) <= 0 && std::max({a, b, c, d}) >= 0;
    };
    double least = 1e99;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = i + 3; j + 3 < n + i && j < n; ++j) {
            const auto square = [&](std::size_t a, std::size_t b, bool first) {
                a %= n;
                b %= n;
                return dot(places[a] - places[b], along(first ? a : b));
            };
            const auto both = [&](bool first) {
                return changes(square(i, j, first), square(i + 1, j, first), square(i, j + 1, first),
                               square(i + 1, j + 1, first));
            };
            if (!both(true) || !both(false)) continue;
            const Vector<double> chord = places[i] - places[j];
            least = std::min(least, std::hypot(chord.x, chord.y));
        }
    return least;
}

/// Coupler curves that come near to themselves without crossing.
TEST(SelfDistance, IsTheLeastOfAllChords) {
    for (const std::string point : {"point-along = 3\npoint-across = 2.5\n", "point-along = 1\npoint-across = 3\n",
                                    "point-along = -1\npoint-across = 1.5\n"}) {
        SCOPED_TRACE(point);
        const std::string text =
            "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1.5\ncoupler = 4\nrocker = 4.5\n" +
            point;
        const AnalysedRoom found = analysed_room(text + room_of("P"));
        std::vector<Vector<double>> path;
        for (const Places& pose : poses_of(found.design, 3000))
            path.push_back(pose.back());
        path.pop_back();  // where it began
        EXPECT_NEAR(self_distance(found.document), least_of_chords(path), 2e-2 * self_distance(found.document));
        expect_verified(found.document);
        expect_room_slopes(text + room_of("P"), {"way.self-distance"});
    }
}

/// A coupler point whose path keeps clear of itself by a given distance, in a box that is as small as that allows.
TEST(SelfDistance, CanBeRequired) {
    const ReadProblem read = parse_problem(
        "schema = 1\nmechanism = \"four-bar\"\n[dimensions]\nground = 4\ncrank = 1.5\ncoupler = 4\nrocker = "
        "4.5\npoint-along = { min = -3, max = 3 }\npoint-across = { min = 1, max = 3 }\n" +
            room_of("P") +
            "[[require]]\nquantity = \"way.self-distance\"\nmin = 1\n[objective]\nminimize = "
            "\"way.area\"\n[solver]\nstarts "
            "= 4\n",
        "p.toml");
    ASSERT_TRUE(read.ok()) << read.messages.front().text;
    const Result result = solve(read.problem, {});
    ASSERT_EQ(result.status, Status::solved);
    EXPECT_TRUE(result.verified());
}

TEST(SelfDistance, IsOfOnePoint) {
    const ReadProblem read = parse_problem(
        "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = { A = [0, 0] }\ncrank = { A = [0, 0], B = [10, 0] "
        "}\n[drive]\nlink = \"crank\"\n[[room]]\nname = \"way\"\nof = \"mechanism\"\n[[require]]\nquantity = "
        "\"way.self-distance\"\nmin = 1\n",
        "p.toml");
    ASSERT_FALSE(read.ok());
    EXPECT_NE(read.messages.front().text.find("of the path of one point that moves"), std::string::npos)
        << read.messages.front().text;
}

}  // namespace

}  // namespace mechwright::linkage_scans
