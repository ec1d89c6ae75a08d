// Boxes that linkages need over their motion: against closed forms, all poses of a fine scan and differences; and what
// is said of rooms and regions that are wrong.

#include <fmt/format.h>

#include <fstream>
#include <span>
#include <sstream>

#include "analysis/numbers/golden_section.h"
#include "analysis/numbers/resolved.h"
#include "synthesis/report/drawing/scene.h"
#include "tests/long_form.h"
#include "tests/mechanism/linkage_scans.h"

namespace mechwright::linkage_scans {

namespace {

/// The box of all points of a scan: width and height.
Vector<double> scanned_box(const ScannedRoom& scan, const std::vector<std::size_t>& points, double direction) {
    const auto side = [&](double degrees) {
        const auto least = [&](double sign) {
            return scan.least([&](const Places& pose) {
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
    EXPECT_NEAR(value_in(document, "bay.width"), 5 * std::cos(30 * one_degree), 1e-14);
    EXPECT_NEAR(value_in(document, "bay.height"), 5 * std::sin(30 * one_degree), 1e-14);
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

TEST(LinkageRooms, AreDrawnAsTheyAre) {
    const AnalysedRoom found = analysed_room(rocking_room + R"(
[[room]]
name = "all"
[[region]]
name = "post"
keep = "out"
circle = { centre = [20, 9], radius = 1 }
[[region]]
name = "wall"
keep = "in"
half-plane = { through = [0, 12], direction = 180 }
)");
    const Scene scene = scene_of(found.design, 1e-4);
    std::vector<Vector<double>> sizes;
    for (const Outline& outline : scene.fixed) {
        if (outline.layer != Layer::room) continue;
        Vector<double> low = outline.vertices.front().at, high = low;
        for (const ArcVertex& v : outline.vertices) {
            low = {std::min(low.x, v.at.x), std::min(low.y, v.at.y)};
            high = {std::max(high.x, v.at.x), std::max(high.y, v.at.y)};
        }
        sizes.push_back(high - low);
    }
    ASSERT_EQ(sizes.size(), 3u);
    EXPECT_NEAR(sizes[0].x, 2, 1e-12);
    EXPECT_GT(sizes[1].x, value_in(found.document, "all.width"));
    EXPECT_NEAR(sizes[1].y, 0, 1e-12);
    EXPECT_NEAR(sizes[2].x, value_in(found.document, "all.width"), 1e-12);
    EXPECT_NEAR(sizes[2].y, value_in(found.document, "all.height"), 1e-12);
    EXPECT_GE(scene.high.x, 21);  // all of it is in the picture
}

TEST(LinkageRooms, ThatAreStatedWrongAreRefused) {
    const Json document = analysed_room(rocking_room + "[[room]]\nname = \"all\"\n").document;
    expect_verified(document);
    expect_refused_if_off(document, {"all.width", "all.height", "all.area"});
    Json changed = document;
    changed["linkage"]["room"][0]["of"] = "pivots";
    EXPECT_TRUE(is_refused(changed));
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
    const double margin = ScannedRoom(found.design, {"B", "C", "P", "D"}, 20000).least([](const Places& pose) {
        return std::min(between_outlines({pose[0], pose[1], pose[2]}, {{9, 1}}),
                        between_outlines({pose[3], pose[1]}, {{9, 1}})) -
               0.5;
    });
    EXPECT_NEAR(value_in(found.document, "stop.margin"), margin, 1e-3);
    EXPECT_LE(value_in(found.document, "stop.margin"), margin + 1e-12);
    expect_verified(found.document);
}

std::string text_of_source(const std::string& file) {
    std::ifstream in(MECHWRIGHT_SOURCE_DIR "/" + file);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

std::string shipped_for_room(const std::string& name) { return text_of_source("problems/linkage/" + name + ".toml"); }

/// What the manual shows, of a linkage that has the links that it names.
/// A four-bar that moves between limits: the place of its coupler point by the circles about B and D.
struct OpenFourBar {
    double ground, crank, coupler, rocker, along, across;
    std::string side;

    Vector<double> point(double crank_angle) const {
        const Vector<double> b{crank * std::cos(crank_angle), crank * std::sin(crank_angle)};
        const Vector<double> way = Vector<double>{ground, 0} - b;
        const double far = std::hypot(way.x, way.y);
        const double before = (coupler * coupler - rocker * rocker + far * far) / (2 * far);
        const double beside = std::sqrt(std::max(0.0, coupler * coupler - before * before));
        const Vector<double> u = (1 / far) * way;
        const Vector<double> e = (1 / coupler) * (before * u + (side == "left" ? beside : -beside) * left_of(u));
        return b + along * e + across * left_of(e);
    }
    /// Its motion, whose limits are where coupler and rocker are in line.
    Stretch motion() const {
        const double reach = coupler + rocker;
        const double limit = std::acos((ground * ground + crank * crank - reach * reach) / (2 * ground * crank));
        return {-limit, limit, true, true};
    }
    /// The greatest of a sum over the motion, by golden sections between shares of a fine scan.
    template <class Of>
    double greatest(const Of& of) const {
        constexpr int steps = 4000;
        const auto at = [&](double share) { return of(point(motion().at(std::clamp(share, 0.0, 1.0)))); };
        int best = 0;
        for (int i = 0; i <= steps; ++i)
            if (at(i / double{steps}) > at(best / double{steps})) best = i;
        return at(greatest_between(at, (best - 1) / double{steps}, (best + 1) / double{steps}));
    }
    std::string problem() const {
        return fmt::format(
            "schema = 1\nmechanism = \"linkage\"\n[links]\nframe = {{ A = [0, 0], D = [{}, 0] }}\ncrank = {{ A = [0, "
            "0], "
            "B = [{}, 0] }}\ncoupler = {{ B = [0, 0], C = [{}, 0], P = [{}, {}] }}\nrocker = {{ D = [0, 0], C = [{}, "
            "0] "
            "}}\n[drive]\nlink = \"crank\"\n[assembly]\nC = {{ side = \"{}\", from = \"B\", to = \"D\" }}\n[[room]]\n"
            "name = \"path\"\nof = [\"P\"]\n",
            ground, crank, coupler, along, across, rocker, side);
    }
};

/// Next to a limit, nearer than samples are to each other, these paths turn back.
TEST(LinkageRooms, HaveTheirExtremesBesideLimits) {
    for (const OpenFourBar& bars :
         {OpenFourBar{3.6, 2.4, 2.6, 2.5, -1.7, 0.8, "right"}, OpenFourBar{2.5, 5.6, 2.2, 2.5, -1.5, 0.2, "left"}}) {
        SCOPED_TRACE(bars.problem());
        const Json document = analysed_room(bars.problem()).document;
        const auto side = [&](const Vector<double>& way) {
            return bars.greatest([&](const Vector<double>& at) { return dot(at, way); }) +
                   bars.greatest([&](const Vector<double>& at) { return -dot(at, way); });
        };
        EXPECT_NEAR(value_in(document, "path.width"), side({1, 0}), 1e-12);
        EXPECT_NEAR(value_in(document, "path.height"), side({0, 1}), 1e-12);
        expect_verified(document);
    }
}

TEST(LinkageRooms, AreReadAsTheManualSaysThem) {
    const std::string manual = text_of_source("problems/README.md"), fence = "```";
    const std::size_t from = manual.find("[[room]]\nname      = \"envelope\"");
    ASSERT_NE(from, std::string::npos);
    const AnalysedRoom found = analysed_room(rocking_room + manual.substr(from, manual.find(fence, from) - from));
    for (const char* quantity : {"envelope.width", "envelope.height", "envelope.area", "bay.margin", "strut.margin"})
        EXPECT_TRUE(std::isfinite(value_in(found.document, quantity))) << quantity;
    EXPECT_EQ(found.document["requirements"].size(), 2u);
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
    const Places fence{{200, -90}, {260, -90}, {260, -72}};
    const double margin = ScannedRoom(found.design, {"Q", "G", "B", "C"}, 40000).least([&](const Places& pose) {
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
        ScannedRoom(found.design, {"A", "B", "M", "C", "D", "T"}, 20000).least([](const Places& pose) {
            double least = 1e9;
            for (const Vector<double>& at : pose)
                least = std::min(least, along_way(at - Vector<double>{0, 1200}, 275));
            return least;
        });
    EXPECT_NEAR(value_in(found.document, "hall.margin"), margin, 1e-3);
}

/// With slots, gears, racks and several loops: in fifty digits boxes and margins are the same.
TEST(LinkageRooms, OfShippedLinkagesAreVerified) {
    const std::vector<const char*> names{"klann-leg",      "scotch-yoke", "cardan-gear",
                                         "crank-and-rack", "jansen-leg",  "arc-slot"};
    for (const char* name : std::span(names).first(static_cast<std::size_t>(cases_to_try(4, 6)))) {
        const Json document = analysed_room(shipped_for_room(name) + R"(
[[room]]
name = "all-of-it"
direction = 17
[[region]]
name = "disc-beside"
keep = "out"
circle = { centre = [3000, 2500], radius = 1 }
[[region]]
name = "box-beside"
keep = "out"
polygon = [[-2000, -2100], [-1900, -2500], [-2200, -2300]]
[[region]]
name = "ground"
keep = "in"
half-plane = { through = [0, -9000], direction = 3 }
)")
                                  .document;
        EXPECT_GT(value_in(document, "all-of-it.area"), 0) << name;
        EXPECT_GT(value_in(document, "box-beside.margin"), 0) << name;
        expect_verified(document);
    }
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
    expect_error(region + "keep = \"in\"\nlink = { name = \"rocker\" }\nof = [\"A\"]\n",
                 "[[region]] number 1 has a 'link', which parts can keep out of only");
    expect_error(region + "keep = \"out\"\nlink = { name = \"frame\" }\nof = [\"P\"]\n",
                 "'name' in [link]: 'frame' has no outline");
    const auto polygon = [&](const char* keep, const char* corners) {
        return region + "keep = \"" + keep + "\"\npolygon = " + corners + "\n";
    };
    expect_error(polygon("in", "[[0, 0], [1, 0]]"), "'polygon' in [[region]] number 1 needs three corners");
    expect_error(polygon("in", "[[0, 0], [0, 0], [1, 1]]"),
                 "'polygon' in [[region]] number 1 has the corner [0, 0] twice");
    expect_error(polygon("in", "[[0, 0], [1, 1], [2, 2]]"), "'polygon' in [[region]] number 1 has no area");
    expect_error(polygon("out", "[[0, 10], [-6, -8], [9.5, 3], [-9.5, 3], [6, -8]]"),
                 "'polygon' in [[region]] number 1 crosses itself");
}

}  // namespace

}  // namespace mechwright::linkage_scans
