// Where bodies are drawn: against the analysis, and against each other.

#include "synthesis/report/drawing/scene.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <regex>
#include <set>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/report/drawing/svg.h"
#include "tests/drawing/designs.h"

namespace mechwright::testing {
namespace {

double distance(const Vector<double>& a, const Vector<double>& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// The bodies of a scene at a crank angle.
struct Pose {
    std::vector<BodyPlace> places;
    const Scene& scene;

    Pose(const FinishedDesign& design, const Scene& of, double angle) : places(of.bodies.size()), scene(of) {
        EXPECT_TRUE(place_bodies(design, angle, design.motion.assembly, places));
    }
    std::size_t index(const std::string& body) const {
        for (std::size_t b = 0; b < scene.bodies.size(); ++b)
            if (scene.bodies[b].name == body) return b;
        ADD_FAILURE() << "no " << body;
        return 0;
    }
    Vector<double> pin(const std::string& body, std::size_t number) const {
        const std::size_t b = index(body);
        return in_drawing(places[b], scene.bodies[b].pins[number]);
    }
};

constexpr double fineness = 1e-5;

/// Pins of two bodies that the mechanism joins: body, pin, body, pin.
struct Joint {
    const char* first;
    std::size_t first_pin;
    const char* second;
    std::size_t second_pin;
};

void expect_joined(const FinishedDesign& design, const std::vector<Joint>& joints) {
    const Scene scene = scene_of(design, fineness);
    for (const double angle : even_angles(design, 37)) {
        const Pose pose(design, scene, angle);
        for (const Joint& joint : joints)
            EXPECT_LE(distance(pose.pin(joint.first, joint.first_pin), pose.pin(joint.second, joint.second_pin)),
                      1e-13 * scene.extent())
                << joint.first << " and " << joint.second << " at " << angle;
        for (const Vector<double>& pivot : scene.pivots) {
            double nearest = scene.extent();
            for (std::size_t b = 0; b < scene.bodies.size(); ++b)
                for (const Vector<double>& pin : scene.bodies[b].pins)
                    nearest = std::min(nearest, distance(in_drawing(pose.places[b], pin), pivot));
            EXPECT_LE(nearest, 1e-13 * scene.extent());
        }
        for (const BodyPlace& place : pose.places)
            EXPECT_NEAR(std::hypot(place.turn.x, place.turn.y), 1, 1e-14);
    }
}

/// A mechanism that is added has to be drawn, and tested here.
TEST(Scene, IsTestedForEveryMechanism) {
    std::set<std::string> drawn;
    for (const std::string& text : {four_bar_text("open"), slider_crank_text, crank_shaper_text, whitworth_text,
                                    drag_link_text, roller_text("translating", "ccw")}) {
        const FinishedDesign design = given(text);
        EXPECT_GE(scene_of(design, fineness).bodies.size(), 2u);
        drawn.insert(design.mechanism->name);
    }
    for (const auto& mechanism : mechanisms())
        EXPECT_TRUE(drawn.contains(mechanism->name)) << mechanism->name;
}

TEST(Scene, JoinsTheLinksOfAFourBar) {
    for (const char* assembly : {"open", "crossed"})
        expect_joined(given(four_bar_text(assembly)), {{"crank", 1, "coupler", 0}, {"coupler", 1, "rocker", 1}});
}

TEST(Scene, JoinsTheLinksOfRamDrives) {
    const std::vector<Joint> end{{"rod", 1, "ram", 0}};
    expect_joined(given(slider_crank_text), {{"crank", 1, "rod", 0}, {"rod", 1, "ram", 0}});
    expect_joined(given(crank_shaper_text), {{"crank", 1, "block", 0}, {"lever", 1, "rod", 0}, {"rod", 1, "ram", 0}});
    expect_joined(given(whitworth_text), {{"crank", 1, "block", 0}, {"arm", 1, "rod", 0}, {"rod", 1, "ram", 0}});
    expect_joined(
        given(drag_link_text),
        {{"crank", 1, "coupler", 0}, {"coupler", 1, "follower", 1}, {"follower", 2, "rod", 0}, {"rod", 1, "ram", 0}});
}

TEST(Scene, HasTheRamWhereTheAnalysisHasIt) {
    for (const std::string& text : {slider_crank_text, crank_shaper_text, whitworth_text, drag_link_text}) {
        const FinishedDesign design = given(text);
        const Scene scene = scene_of(design, fineness);
        const bool turned_round = design.mechanism->name == "crank-shaper";
        for (const double angle : even_angles(design, 12)) {
            const Pose pose(design, scene, angle);
            const double along = dot(pose.pin("ram", 0), Vector<double>{turned_round ? -1.0 : 1.0, 0});
            EXPECT_NEAR(along, MotionRow(design, angle)["ram-position"], 1e-13 * scene.extent()) << text;
        }
    }
}

TEST(Scene, SlidesTheBlockInTheSlot) {
    for (const std::string& text : {crank_shaper_text, whitworth_text}) {
        const FinishedDesign design = given(text);
        const Scene scene = scene_of(design, fineness);
        for (const double angle : even_angles(design, 12)) {
            const Pose pose(design, scene, angle);
            const BodyPlace& arm = pose.places[pose.index("block") + 1];
            const Vector<double> reach = pose.pin("block", 0) - arm.at;
            EXPECT_NEAR(cross(arm.turn, reach), 0, 1e-12 * scene.extent());
            EXPECT_NEAR(dot(arm.turn, reach), MotionRow(design, angle)["block-position"], 1e-12 * scene.extent());
        }
    }
}

TEST(Scene, GuidesThePointAlongThePathInFiftyDigits) {
    const FinishedDesign design = given(four_bar_text("open"));
    const Scene scene = scene_of(design, fineness);
    const std::vector<Digits50> dimensions(design.dimensions.begin(), design.dimensions.end());
    for (const double angle : even_angles(design, 24)) {
        const auto exact = design.mechanism->point->point(design.mechanism->form(0), dimensions, Digits50(angle));
        const Vector<double> drawn = guided_point(design, scene, angle).value();
        EXPECT_LE(distance(drawn, {exact.x.convert_to<double>(), exact.y.convert_to<double>()}), 1e-12);
    }
}

TEST(Scene, DrawsThePathWithinItsFineness) {
    const FinishedDesign design = given(four_bar_text("open"));
    const Scene scene = scene_of(design, fineness);
    const auto path = std::find_if(scene.fixed.begin(), scene.fixed.end(),
                                   [](const Outline& outline) { return outline.layer == Layer::path; });
    ASSERT_NE(path, scene.fixed.end());
    const std::vector<ArcVertex>& v = path->vertices;
    // Every point of the curve lies near one of the arcs: near its chord's ends as well.
    for (const double angle : even_angles(design, 1000)) {
        const Vector<double> p = *guided_point(design, scene, angle);
        double least = scene.extent();
        for (std::size_t i = 0; i < v.size(); ++i) {
            const Vector<double>& end = v[(i + 1) % v.size()].at;
            const double chord = distance(v[i].at, end);
            if (distance(v[i].at, p) + distance(p, end) > 1.5 * chord) continue;
            least = std::min(least, distance_from_arc(v[i], end, p));
        }
        EXPECT_LE(least, fineness * scene.extent());
    }
}

/// The roller touches the profile: its centre is a roller radius from the nearest point of it, and on the pitch curve.
TEST(Scene, KeepsTheFollowerOnTheCam) {
    for (const std::string& text : {roller_text("translating", "ccw"), roller_text("translating", "cw"),
                                    roller_text("oscillating", "ccw"), roller_text("oscillating", "cw")}) {
        const FinishedDesign design = given(text);
        const Scene scene = scene_of(design, fineness);
        for (const double angle : even_angles(design, 16)) {
            const Pose pose(design, scene, angle);
            const Body& follower = scene.bodies[1];
            const Vector<double> centre = in_drawing(pose.places[1], follower.pins.back());
            double least = scene.extent();
            constexpr int samples = 7200;
            for (int i = 0; i < samples; ++i) {
                const Vector<double> profile = MotionRow(design, 2 * std::numbers::pi * i / samples).vector("profile");
                least = std::min(least, distance(in_drawing(pose.places[0], profile), centre));
            }
            EXPECT_NEAR(least, design["roller-radius"], 2e-3) << text << angle;
            if (design.mechanism->meaning.find("translating") != std::string_view::npos)
                EXPECT_NEAR(std::abs(centre.x), std::abs(design["offset"]), 1e-12);
            else
                EXPECT_NEAR(distance(centre, {design["pivot-distance"], 0}), design["arm-length"], 1e-12);
        }
    }
}

/// No point of the profile stands out through a flat face, and one touches it.
TEST(Scene, KeepsAFlatFaceOnTheCam) {
    for (const std::string& text : {flat_text("translating", "ccw"), flat_text("translating", "cw"),
                                    flat_text("oscillating", "ccw"), flat_text("oscillating", "cw")}) {
        const FinishedDesign design = given(text);
        const Scene scene = scene_of(design, fineness);
        for (const double angle : even_angles(design, 16)) {
            const Pose pose(design, scene, angle);
            const Outline& face = scene.bodies[1].outlines[0];
            const Vector<double> from = in_drawing(pose.places[1], face.vertices[0].at);
            const Vector<double> to = in_drawing(pose.places[1], face.vertices[1].at);
            const Vector<double> along = (1 / distance(from, to)) * (to - from);
            // The cam's centre is on the inner side.
            const double inner = cross(along, -from) > 0 ? 1 : -1;
            double least = scene.extent(), place = 0;
            constexpr int samples = 3600;
            for (int i = 0; i < samples; ++i) {
                const Vector<double> p =
                    in_drawing(pose.places[0], MotionRow(design, 2 * std::numbers::pi * i / samples).vector("profile"));
                if (const double away = inner * cross(along, p - from); away < least) {
                    least = away;
                    place = dot(along, p - from);
                }
            }
            EXPECT_NEAR(least, 0, 1e-3) << text << angle;
            EXPECT_GE(place, 0);
            EXPECT_LE(place, distance(from, to));
        }
    }
}

TEST(Scene, LeavesNothingOutsideOfThePicture) {
    for (const std::string& text :
         {four_bar_text("open"), slider_crank_text, crank_shaper_text, whitworth_text, drag_link_text,
          roller_text("oscillating", "ccw"), flat_text("translating", "cw")}) {
        const FinishedDesign design = given(text);
        const Scene scene = scene_of(design, fineness);
        const SvgView view = view_of(scene, 640, 520);
        for (const double angle : even_angles(design, 36)) {
            const Pose pose(design, scene, angle);
            for (std::size_t b = 0; b < scene.bodies.size(); ++b)
                for (const Vector<double>& pin : scene.bodies[b].pins) {
                    const Vector<double> at = view.pixels(in_drawing(pose.places[b], pin));
                    EXPECT_TRUE(at.x >= 0 && at.x <= view.width && at.y >= 0 && at.y <= view.height);
                }
        }
    }
}

TEST(Scene, ShowsTheLimitPositionsOfTheSwing) {
    const FinishedDesign design = given(four_bar_text("open"));
    const std::vector<double> limits = limit_angles(design);
    ASSERT_EQ(limits.size(), 2u);
    // Between its limits the rocker swings by as much as between the extremes of its angle.
    double least = 1e9, greatest = -1e9;
    for (const double angle : even_angles(design, 100'000)) {
        const double rocker = MotionRow(design, angle)["rocker-angle"];
        least = std::min(least, rocker);
        greatest = std::max(greatest, rocker);
    }
    const double at_limits =
        std::abs(MotionRow(design, limits[0])["rocker-angle"] - MotionRow(design, limits[1])["rocker-angle"]);
    EXPECT_NEAR(at_limits, greatest - least, 1e-8);
}

TEST(Svg, HasAScaleAndTheNamesOfLinks) {
    const FinishedDesign design = given(four_bar_text("open"));
    SvgPicture picture;
    const std::string svg = svg_picture(design, picture);
    for (const char* name : {">crank 34<", ">coupler 93<", ">rocker 70<"})
        EXPECT_NE(svg.find(name), std::string::npos) << name;
    std::smatch bar;
    ASSERT_TRUE(std::regex_search(svg, bar, std::regex(R"(M20 [0-9.]+H([0-9.]+)M.*>([0-9.]+) mm<)")));
    const double scale = view_of(scene_of(design, fineness), 640, 640).scale;
    EXPECT_NEAR(std::stod(bar[1]) - 20, scale * std::stod(bar[2]), 0.02);
    // A small one has no room for names.
    picture.width = 320;
    EXPECT_EQ(svg_picture(design, picture).find(">crank 34<"), std::string::npos);
}

/// Also those of borders on the right of a small drawing.
TEST(Svg, HasTheNamesOfRegionsInThePicture) {
    for (const int direction : {0, 90, 180, 270}) {
        const FinishedDesign design =
            given(four_bar_text("open") + fmt::format("[[region]]\nname = \"wall-beside-the-machine\"\nkeep = \"in\"\n"
                                                      "of = [\"coupler\"]\nhalf-plane = {{ through = [70, 40], "
                                                      "direction = {} }}\n",
                                                      direction));
        SvgPicture picture;
        picture.width = 320;
        const std::string svg = svg_picture(design, picture);
        std::smatch name;
        ASSERT_TRUE(std::regex_search(
            svg, name, std::regex(R"re(data-x="([0-9.]+)"[^>]* x="(-?[0-9.]+)" y="-7">wall-beside-the-machine<)re")))
            << direction;
        const double begins = std::stod(name[1]) + std::stod(name[2]);
        EXPECT_GE(begins, 0) << direction;
        EXPECT_LE(begins + 0.6 * 13 * 23, 320) << direction;
    }
}

TEST(Svg, EscapesMarkup) {
    EXPECT_EQ(escaped("<b>\"a\" & 'b'</b>\x01"), "&lt;b&gt;&quot;a&quot; &amp; &#39;b&#39;&lt;/b&gt;");
}

}  // namespace
}  // namespace mechwright::testing
