// Boxes that linkages need over their motion, and regions that they keep in or out of: against closed forms, against
// all poses of a fine scan, and by differences.

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <numbers>
#include <sstream>
#include <string>
#include <vector>

#include "synthesis/document/document.h"
#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/problem/reader.h"
#include "synthesis/program/assess.h"
#include "synthesis/report/drawing/finished.h"
#include "tests/checked.h"
#include "tests/mechanism/linkage_texts.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;
using testing::expect_verified;
using testing::is_refused;
using PlacesOfRooms = std::vector<Vector<double>>;

constexpr double one_degree_of_room = std::numbers::pi / 180;

/// A crank-rocker with a coupler point.
const std::string rocking_room = testing::head + R"(
[dimensions]
ground = 5
crank = 2
coupler = 4.5
rocker = 4
along = 2.5
across = 3
[placement]
origin-x = 1
origin-y = -2
tilt = 20
[links]
frame = { A = [0, 0], D = ["ground", 0] }
crank = { A = [0, 0], B = ["crank", 0] }
coupler = { B = [0, 0], C = ["coupler", 0], P = ["along", "across"] }
rocker = { D = [0, 0], C = ["rocker", 0] }
[drive]
link = "crank"
)";

struct AnalysedRoom {
    Json document;
    FinishedDesign design;
};

AnalysedRoom analysed_room(const std::string& text) {
    const ReadProblem read = testing::read_without_fault(text);
    if (!read.ok()) return {};
    const Solution solution = evaluate_given(read.problem);
    return {analysis_document(read.problem, solution), finished_design(read.problem, solution.design)};
}

double value_in(const Json& document, const std::string& quantity) {
    EXPECT_TRUE(document["quantities"].contains(quantity)) << quantity;
    return document["quantities"].value(quantity, std::numeric_limits<double>::quiet_NaN());
}

/// Positions of all its points at many crank angles of the motion.
struct ScannedRoom {
    std::vector<std::vector<Vector<double>>> poses{};

    ScannedRoom(const FinishedDesign& design, const std::vector<std::string>& points, int steps) {
        for (int i = 0; i <= steps; ++i) {
            const double at =
                design.motion.from + (design.motion.to - design.motion.from) * i / static_cast<double>(steps);
            const MotionRow row(design, at);
            if (!row.assembled()) continue;
            poses.emplace_back();
            for (const std::string& point : points)
                poses.back().push_back(row.vector(point));
        }
    }
    double least(const std::function<double(const PlacesOfRooms&)>& of) const {
        double least = std::numeric_limits<double>::infinity();
        for (const PlacesOfRooms& pose : poses)
            least = std::min(least, of(pose));
        return least;
    }
};

double along_way(const Vector<double>& at, double degrees) {
    return at.x * std::cos(degrees * one_degree_of_room) + at.y * std::sin(degrees * one_degree_of_room);
}

/// The box of all points of a scan: width and height.
Vector<double> scanned_box(const ScannedRoom& scan, const std::vector<std::size_t>& points, double direction) {
    const auto side = [&](double degrees) {
        const auto least = [&](double sign) {
            return scan.least([&](const PlacesOfRooms& pose) {
                double one = std::numeric_limits<double>::infinity();
                for (const std::size_t p : points)
                    one = std::min(one, sign * along_way(pose[p], degrees));
                return one;
            });
        };
        return -(least(-1) + least(1));
    };
    return {side(direction), side(direction + 90)};
}

TEST(LinkageRooms, OfACrankPinIsTheSquareAboutItsCircle) {
    for (const double direction : {0., 30., -77.}) {
        const Json document = analysed_room(rocking_room + "[[room]]\nname = \"pin\"\nof = [\"B\"]\ndirection = " +
                                            std::to_string(direction) + "\n")
                                  .document;
        EXPECT_NEAR(value_in(document, "pin.width"), 4, 1e-14);
        EXPECT_NEAR(value_in(document, "pin.height"), 4, 1e-14);
        EXPECT_NEAR(value_in(document, "pin.area"), 16, 1e-13);
        expect_verified(document);
    }
}

TEST(LinkageRooms, OfPivotsDoNotDependOnTheMotion) {
    const Json document =
        analysed_room(rocking_room + "[[room]]\nname = \"bay\"\nof = \"pivots\"\ndirection = -10\n").document;
    EXPECT_NEAR(value_in(document, "bay.width"), 5 * std::cos(30 * one_degree_of_room), 1e-14);
    EXPECT_NEAR(value_in(document, "bay.height"), 5 * std::sin(30 * one_degree_of_room), 1e-14);
    expect_verified(document);
}

TEST(LinkageRooms, AreThoseOfAScanOfAllPoses) {
    const std::vector<std::string> points{"A", "D", "B", "C", "P"};
    for (const double direction : {0., 37.}) {
        const std::string at = "direction = " + std::to_string(direction) + "\n";
        for (const char* motion : {"", "[motion]\ncrank_range = [-35, 110]\n"}) {
            const AnalysedRoom found = analysed_room(rocking_room + motion + "[[room]]\nname = \"all\"\n" + at +
                                                     "[[room]]\nname = \"plate\"\nof = [\"coupler\"]\n" + at +
                                                     "[[room]]\nname = \"two\"\nof = [\"P\", \"rocker\"]\n" + at);
            const ScannedRoom scan(found.design, points, 20000);
            const auto expect_box = [&](const std::string& room, const std::vector<std::size_t>& of) {
                const Vector<double> box = scanned_box(scan, of, direction);
                const double width = value_in(found.document, room + ".width"),
                             height = value_in(found.document, room + ".height");
                EXPECT_NEAR(width, box.x, 1e-6);
                EXPECT_NEAR(height, box.y, 1e-6);
                EXPECT_GE(width, box.x - 1e-13);
                EXPECT_GE(height, box.y - 1e-13);
                EXPECT_NEAR(value_in(found.document, room + ".area"), width * height, 1e-12);
            };
            expect_box("all", {0, 1, 2, 3, 4});
            expect_box("plate", {2, 3, 4});
            expect_box("two", {1, 3, 4});
            expect_verified(found.document);
        }
    }
}

TEST(LinkageRooms, ThatAreStatedWrongAreRefused) {
    const Json document = analysed_room(rocking_room + "[[room]]\nname = \"all\"\n").document;
    expect_verified(document);
    for (const char* quantity : {"all.width", "all.height", "all.area"}) {
        Json changed = document;
        changed["quantities"][quantity] = value_in(document, quantity) * (1 + 1e-7);
        EXPECT_TRUE(is_refused(changed)) << quantity;
    }
    Json changed = document;
    changed["linkage"]["room"][0]["of"] = "pivots";
    EXPECT_TRUE(is_refused(changed));
}

/// A segment from a to b keeps from a place by so much.
double from_segment(const Vector<double>& at, const Vector<double>& a, const Vector<double>& b) {
    const Vector<double> side = b - a, way = at - a;
    const double along = std::clamp(dot(side, way) / dot(side, side), 0.0, 1.0);
    const Vector<double> from = way - along * side;
    return std::hypot(from.x, from.y);
}

/// The least distance of two outlines that do not overlap.
double between_outlines(const PlacesOfRooms& a, const PlacesOfRooms& b) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [one, other] : {std::pair(&a, &b), {&b, &a}})
        for (const Vector<double>& at : *one)
            for (std::size_t i = 0; i < other->size(); ++i) {
                const Vector<double>&from = (*other)[i], &to = (*other)[(i + 1) % other->size()];
                const bool point = other->size() == 1;
                least = std::min(least, point ? std::hypot(at.x - from.x, at.y - from.y) : from_segment(at, from, to));
            }
    return least;
}

/// How far a point is beyond the line of the side beyond which it is farthest; of a polygon against the clock.
double beyond_sides(const Vector<double>& at, const PlacesOfRooms& polygon) {
    double most = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vector<double> side = polygon[(i + 1) % polygon.size()] - polygon[i];
        most = std::max(most, -cross(side, at - polygon[i]) / std::hypot(side.x, side.y));
    }
    return most;
}

const std::vector<std::string> points_of_regions{"A", "D", "B", "C", "P"};

void expect_margin(const AnalysedRoom& found, const std::string& region,
                   const std::function<double(const PlacesOfRooms&)>& of_pose, double within = 1e-6) {
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
    const PlacesOfRooms bay{{8, -5}, {9, 6}, {-2, 9}, {-3, -6}};
    expect_margin(found, "bay", [&](const PlacesOfRooms& pose) {
        double least = 100;
        for (const Vector<double>& at : pose)
            least = std::min(least, -beyond_sides(at, bay));
        return least;
    });
    expect_margin(found, "disc", [](const PlacesOfRooms& pose) {
        double least = 100;
        for (const std::size_t p : {2, 3, 4})
            least = std::min(least, 7 - std::hypot(pose[p].x - 2, pose[p].y - 1));
        return least;
    });
    expect_margin(found, "wall", [](const PlacesOfRooms& pose) {
        double least = 100;
        for (const std::size_t p : {3, 4})
            least = std::min(least, along_way(pose[p] - Vector<double>{0, 8}, 260));
        return least;
    });
    expect_margin(found, "floor", [](const PlacesOfRooms& pose) {
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
        const auto plate = [](const PlacesOfRooms& pose) { return PlacesOfRooms{pose[2], pose[3], pose[4]}; };
        expect_margin(found, "post", [&](const PlacesOfRooms& pose) {
            return between_outlines(plate(pose), {{9, 9}}) - 1;
        });
        expect_margin(found, "box", [&](const PlacesOfRooms& pose) {
            return between_outlines({pose[1], pose[3]}, {{7.8, 2}, {9, 2}, {9, 3}, {7.9, 3}});
        });
        expect_margin(found, "pole", [&](const PlacesOfRooms& pose) {
            return between_outlines({pose[4]}, {{-2, 4}, {-3, 6}, {-4, 4}});
        });
        const PlacesOfRooms thorn{{0.9, 7}, {1.5, 9}, {0.6, 9}};
        expect_margin(found, "thorn", [&](const PlacesOfRooms& pose) {
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
    const PlacesOfRooms square{{2.9, -2.2}, {3.1, -2.2}, {3.1, -1.8}, {2.9, -1.8}};
    expect_margin(found, "point", [&](const PlacesOfRooms& pose) { return beyond_sides(pose[2], square); });
    EXPECT_NEAR(margin, -0.1, 1e-12);
    EXPECT_NEAR(value_in(found.document, "disc.margin"), -0.3, 1e-12);
    const PlacesOfRooms bar{{2, -2.1}, {2.4, -2.1}, {2.4, -1.9}, {2, -1.9}};
    expect_margin(
        found, "bar",
        [&](const PlacesOfRooms& pose) {
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
    std::size_t stated = 0;
    for (const Check& check : verify(found.document))
        if (check.name.ends_with("stated")) {
            EXPECT_TRUE(check.passed) << check.name << ": " << check.detail;
            ++stated;
        }
    EXPECT_GE(stated, 4u);
}

/// Derivatives of quantities by differences with two steps, so that what is left of these is 1e-9.
void expect_room_slopes(const std::string& text, const std::vector<std::string>& names) {
    const ReadProblem read = testing::read_without_fault(text);
    ASSERT_TRUE(read.ok());
    const Mechanism& m = *read.problem.mechanism;
    std::vector<double> arguments;
    for (const DimensionRange& range : read.problem.dimensions)
        arguments.push_back(range.start.value_or(range.min));
    const Solution solution = evaluate_given(read.problem);
    Motion motion = finished_design(read.problem, solution.design).motion;
    for (const std::string& name : names) {
        const Quantity& quantity = m.quantities[static_cast<std::size_t>(find_quantity(m, name))];
        motion.model = m.model.data();
        motion.of = quantity.of.data();
        const std::size_t n = arguments.size(), count = quantity.components(motion);
        std::vector<double> value(count), gradient(count * n), moved(count);
        quantity.measure(motion, arguments, {value, gradient, {}});
        for (std::size_t i = 0; i < n; ++i) {
            const double here = arguments[i];
            const auto at = [&](double h) {
                arguments[i] = here + h;
                quantity.measure(motion, arguments, {moved, {}, {}});
                arguments[i] = here;
                return moved[0];
            };
            constexpr double h = 2e-3;
            const double once = (at(h) - at(-h)) / (2 * h), twice = (at(2 * h) - at(-2 * h)) / (4 * h),
                         thrice = (at(3 * h) - at(-3 * h)) / (6 * h);
            EXPECT_NEAR(gradient[i], 1.5 * once - 0.6 * twice + 0.1 * thrice, 1e-9)
                << name << " by " << m.dimensions[i].name;
        }
        testing::expect_slopes(m, quantity, motion, arguments);
    }
}

TEST(LinkageRooms, HaveExactDerivatives) {
    expect_room_slopes(rocking_room + R"(
[[room]]
name = "all"
direction = 12
[[room]]
name = "plate"
of = ["coupler"]
)",
                       {"all.width", "all.height", "all.area", "plate.width", "plate.area"});
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

/// The box of the points of a design against a scan, to what steps leave.
void expect_scanned_box(const AnalysedRoom& found, const std::string& room, const std::vector<std::string>& points,
                        double direction, double size) {
    std::vector<std::size_t> all;
    for (std::size_t i = 0; i < points.size(); ++i)
        all.push_back(i);
    const Vector<double> box = scanned_box(ScannedRoom(found.design, points, 20000), all, direction);
    EXPECT_NEAR(value_in(found.document, room + ".width"), box.x, 1e-6 * size);
    EXPECT_NEAR(value_in(found.document, room + ".height"), box.y, 1e-6 * size);
    EXPECT_GE(value_in(found.document, room + ".width"), box.x - 1e-12 * size);
    EXPECT_GE(value_in(found.document, room + ".height"), box.y - 1e-12 * size);
}

/// A crank that swings between two limits of its dyad.
TEST(LinkageRooms, OfMotionsThatEndAtLimitsAreThoseOfAScan) {
    const AnalysedRoom found = analysed_room(testing::head + R"(
[links]
frame   = { A = [0, 0], D = [5, -0.1] }
crank   = { A = [0, 0], B = [3.5, 0] }
coupler = { B = [0, 0], C = [2.8, 0], P = [-1.7, -0.5] }
rocker  = { D = [0, 0], C = [2.9, 0] }
[drive]
link = "crank"
[[room]]
name = "all"
direction = 50
[[room]]
name = "end"
of = ["C"]
[[region]]
name = "stop"
keep = "out"
of = ["rocker", "coupler"]
circle = { centre = [9, 1], radius = 0.5 }
)");
    ASSERT_LT(found.design.motion.to - found.design.motion.from, 6);
    expect_scanned_box(found, "all", {"A", "D", "B", "C", "P"}, 50, 5);
    // The ends themselves are hardly in the scan: there the pin goes like the root of the way.
    const Vector<double> end = scanned_box(ScannedRoom(found.design, {"C"}, 20000), {0}, 0);
    EXPECT_NEAR(value_in(found.document, "end.width"), end.x, 1e-3);
    EXPECT_NEAR(value_in(found.document, "end.height"), end.y, 1e-3);
    const double margin = ScannedRoom(found.design, {"B", "C", "P", "D"}, 20000).least([](const PlacesOfRooms& pose) {
        return std::min(between_outlines({pose[0], pose[1], pose[2]}, {{9, 1}}),
                        between_outlines({pose[3], pose[1]}, {{9, 1}})) -
               0.5;
    });
    EXPECT_NEAR(value_in(found.document, "stop.margin"), margin, 1e-3);
    EXPECT_LE(value_in(found.document, "stop.margin"), margin + 1e-12);
    expect_verified(found.document);
}

std::string shipped_for_room(const std::string& name) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/problems/linkage/" + name + ".toml");
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string with_given(std::string text, const std::string& line, const std::string& given) {
    const std::size_t at = text.find(line);
    EXPECT_NE(at, std::string::npos) << line;
    return text.replace(at, text.find('\n', at) - at, given);
}

/// Its quill dwells, rises and dwells again: extremes are at breaks, too.
TEST(LinkageRooms, KnowDrivesThatDwell) {
    std::string text = shipped_for_room("pick-and-place");
    text = text.substr(0, text.find("[[require]]"));
    text = with_given(with_given(text, "crank = {", "crank = 60"), "rod   = {", "rod = 250");
    const AnalysedRoom found = analysed_room(text + R"(
[[room]]
name = "quill"
of = ["quill"]
direction = 10
[[region]]
name = "fence"
keep = "out"
of = ["quill", "rod"]
polygon = [[200, -90], [260, -90], [260, -72]]
)");
    expect_scanned_box(found, "quill", {"Q", "G"}, 10, 300);
    const PlacesOfRooms fence{{200, -90}, {260, -90}, {260, -72}};
    const double margin = ScannedRoom(found.design, {"Q", "G", "B", "C"}, 40000).least([&](const PlacesOfRooms& pose) {
        return std::min(between_outlines({pose[0], pose[1]}, fence), between_outlines({pose[2], pose[3]}, fence));
    });
    EXPECT_NEAR(value_in(found.document, "fence.margin"), margin, 1e-4);
    EXPECT_LE(value_in(found.document, "fence.margin"), margin + 1e-10);
    expect_verified(found.document);
}

TEST(LinkageRooms, OfWhatASlideDrivesAreThoseOfAScan) {
    const AnalysedRoom found = analysed_room(shipped_for_room("scissors-ram") + R"(
[[room]]
name = "lift"
[[region]]
name = "hall"
keep = "in"
half-plane = { through = [0, 1200], direction = 185 }
)");
    expect_scanned_box(found, "lift", {"A", "B", "M", "C", "D", "T"}, 0, 1000);
    expect_verified(found.document);
    const double margin =
        ScannedRoom(found.design, {"A", "B", "M", "C", "D", "T"}, 20000).least([](const PlacesOfRooms& pose) {
            double least = 1e9;
            for (const Vector<double>& at : pose)
                least = std::min(least, along_way(at - Vector<double>{0, 1200}, 275));
            return least;
        });
    EXPECT_NEAR(value_in(found.document, "hall.margin"), margin, 1e-3);
}

/// Over a stretch whose ends are designed; beside it there are quantities over the whole motion.
TEST(LinkageRooms, HaveExactDerivativesOverARangeOfUse) {
    const ReadProblem read = testing::read_without_fault(testing::free_four_bar + R"(
[motion]
from = "first-target"
to = "last-target"
[poses]
point = "P"
link = "coupler"
poses = [[4, 4, 10], [3, 4.5, 20], [2, 4.4, 35]]
[[room]]
name = "all"
direction = 20
[[room]]
name = "plate"
of = ["coupler"]
[[region]]
name = "bay"
keep = "in"
of = ["coupler", "A", "D"]
polygon = [[-9, -9], [12, -8], [11, 12], [-8, 13]]
[[region]]
name = "post"
keep = "out"
of = ["coupler", "crank"]
circle = { centre = [-4, 8], radius = 0.5 }
)");
    ASSERT_TRUE(read.ok());
    const Mechanism& m = *read.problem.mechanism;
    EXPECT_GE(find_quantity(m, "post.margin.whole"), 0);
    EXPECT_GE(find_quantity(m, "all.area.whole"), 0);
    std::size_t seen = 0;
    for (const Quantity& quantity : m.input->quantities) {
        if (!quantity.name.starts_with("all.") && !quantity.name.starts_with("plate.") &&
            !quantity.name.ends_with(".margin"))
            continue;
        if (quantity.name == "full-turn-margin") continue;
        ++seen;
        // ground, crank, coupler, rocker, along, across, origin, tilt; start and range
        std::vector<double> arguments{5, 2, 4.5, 4, 2.5, 3, 1, -2, 0.3};
        arguments.resize(quantity.reads.size(), 0.1);
        for (const double range : {1.3, -0.8}) {
            std::vector<double> all = arguments;
            all.insert(all.end(), {0.4, range});
            Motion motion;
            motion.is_range_of_use = true;
            testing::expect_slopes(m, quantity, motion, all);
        }
    }
    EXPECT_EQ(seen, 8u);
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

TEST(LinkageRooms, SayWhatIsWrong) {
    const auto error = [](const std::string& part) { return testing::first_error(rocking_room + part); };
    const auto expect_error = [&](const std::string& part, const std::string& begins) {
        EXPECT_EQ(error(part).substr(0, begins.size()), begins) << error(part);
    };
    const std::string room = "[[room]]\nname = \"all\"\n", region = "[[region]]\nname = \"panel\"\n";
    expect_error("[[room]]\n", "'name' in [[room]] number 1 is missing");
    expect_error("[[room]]\nname = \"a b\"\n", "name 'a b' is no name");
    expect_error(room + room, "'all' is the name of another room or region");
    expect_error("[[room]]\nname = \"link-ratio\"\n", "'link-ratio' cannot be the name of a room or a region");
    expect_error(room + "of = [\"rokcer\"]\n",
                 "'of' in [[room]] number 1: there is no link and no point 'rokcer'; did you mean 'rocker'?");
    expect_error(room + "of = []\n", "'of' in [[room]] number 1 is empty");
    expect_error(room + "of = 3\n", "'of' in [[room]] number 1 must be");
    expect_error(room + "[signals]\nall = { x = \"P\" }\n", "'all' cannot be the name of a signal");
    expect_error(room + "[[require]]\nquantity = \"all.depth\"\nmax = 3\n",
                 "'quantity' in [[require]] number 1: 'all.depth' is no quantity of a room");
    expect_error(region + "keep = \"in\"\n", "[[region]] number 1 needs exactly one of polygon, circle, half-plane");
    expect_error(region + "circle = { centre = [0, 0], radius = 1 }\n", "'keep' in [[region]] number 1 is missing");
    expect_error(region + "keep = \"in\"\ncircle = { centre = [0, 0], radius = 0 }\n",
                 "'radius' in [circle] must be greater than 0");
    expect_error(region + "keep = \"in\"\ncircle = { radius = 1 }\n", "'centre' in [circle] is missing");
    expect_error(region + "keep = \"in\"\nhalf-plane = { through = [0, 0] }\n",
                 "'direction' in [half-plane] is missing");
    expect_error(region + "keep = \"in\"\nmargin = -1\ncircle = { centre = [0, 0], radius = 1 }\n",
                 "'margin' in [[region]] number 1 must be 0 or more");
    const auto polygon = [&](const char* keep, const char* corners) {
        return region + "keep = \"" + keep + "\"\npolygon = " + corners + "\n";
    };
    expect_error(polygon("in", "[[0, 0], [1, 0]]"), "'polygon' in [[region]] number 1 needs three corners");
    expect_error(polygon("in", "[[0, 0], [0, 0], [1, 1]]"),
                 "'polygon' in [[region]] number 1 has the corner [0, 0] twice");
    expect_error(polygon("in", "[[0, 0], [1, 1], [2, 2]]"), "'polygon' in [[region]] number 1 has no area");
    expect_error(polygon("in", "[[0, 0], [4, 0], [1, 1], [0, 4]]"),
                 "'polygon' in [[region]] number 1 is not convex at [1, 1]: keep in the convex polygon about it");
    expect_error(polygon("out", "[[0, 0], [0, 4], [1, 1], [4, 0]]"),
                 "'polygon' in [[region]] number 1 is not convex at [1, 1]: write it as several convex polygons");
    expect_error(polygon("out", "[[0, 10], [-6, -8], [9.5, 3], [-9.5, 3], [6, -8]]"),
                 "'polygon' in [[region]] number 1 crosses itself");
}

}  // namespace

}  // namespace mechwright
