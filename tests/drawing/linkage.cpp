// Where the bodies of linkages are drawn: joints, slides and wheels against each other; and their table of the motion.

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/mechanism/drawing/outlines.h"
#include "synthesis/report/drawing/dxf.h"
#include "synthesis/report/drawing/linkage_sheets.h"
#include "synthesis/report/drawing/motion_plots.h"
#include "synthesis/report/drawing/sketch.h"
#include "synthesis/report/drawing/svg.h"
#include "tests/drawing/linkages.h"
#include "tests/report/temporary_folder.h"

namespace mechwright::testing::drawn_linkages {
namespace {

constexpr double fineness = 1e-3, pi = std::numbers::pi;

double apart(const Vector<double>& a, const Vector<double>& b) { return std::hypot(a.x - b.x, a.y - b.y); }

std::vector<LinkageModel> all_linkages() {
    std::vector<LinkageModel> models;
    for (const char* name : {"geared-five-bar", "jansen-leg", "parallelogram", "peaucellier", "scotch-yoke"})
        models.push_back(shipped_linkage_model(name));
    for (const std::string& text : {planetary_text, rack_text, sliding_text, driven_slide_text, circular_text})
        models.push_back(linkage_model(text));
    // Elsewhere in the drawing, and larger.
    models.push_back(models[1]);
    models.back().placement = {{{7, {}}, {-3, {}}, {0.4, {}}}};
    models.back().scale = {2.5, {}};
    models.push_back(linkage_model(sliding_text));
    models.back().placement = {{{7, {}}, {-3, {}}, {0.4, {}}}};
    models.back().scale = {0.3, {}};
    return models;
}

/// A linkage with its scene, and where its links are; the frame, too.
struct Drawn {
    FinishedDesign design;
    const LinkageModel& model;
    Scene scene;
    LinkagePlacement placement;
    std::vector<BodyPlace> places;

    explicit Drawn(LinkageModel of) : Drawn(design_of(std::move(of))) {}
    explicit Drawn(FinishedDesign of)
        : design(std::move(of)),
          model(mechwright::linkage_of(design.motion.model)),
          scene(scene_of(design, fineness)),
          placement(placement_of(model, {})),
          places(scene.bodies.size()) {}

    bool place(double angle) { return place_bodies(design, angle, 0, places); }
    const Body& body(std::size_t link) const { return scene.bodies[body_of(driven_link(model), link)]; }
    BodyPlace link(std::size_t link) const {
        return link == 0 ? placement.frame : places[body_of(driven_link(model), link)];
    }
    double number(linkage::Number n) const { return model.numbers[n].constant; }
    /// A place of a link, from its own numbers.
    Vector<double> own(const linkage::Coordinates& at) const {
        const double a = number(at.first), b = number(at.second);
        return placement.scale * (at.polar ? Vector<double>{a * std::cos(b), a * std::sin(b)} : Vector<double>{a, b});
    }
    Vector<double> at(std::size_t of, const Vector<double>& point) const { return in_drawing(link(of), point); }
    double turn(std::size_t of) const { return std::atan2(link(of).turn.y, link(of).turn.x); }
};

TEST(LinkageDrawing, JoinsTheLinksInEveryPosition) {
    int joints = 0;
    for (LinkageModel& model : all_linkages()) {
        Drawn drawn(std::move(model));
        for (const double angle : even_angles(drawn.design, 37)) {
            ASSERT_TRUE(drawn.place(angle)) << drawn.model.links[1] << angle;
            for (const linkage::Pin& pin : drawn.model.structure.pins)
                for (const linkage::Point& point : pin.points) {
                    EXPECT_LE(apart(drawn.at(point.link, drawn.own(point.at)),
                                    drawn.at(pin.points[0].link, drawn.own(pin.points[0].at))),
                              1e-12 * drawn.scene.extent());
                    ++joints;
                }
            for (const BodyPlace& place : drawn.places)
                EXPECT_NEAR(std::hypot(place.turn.x, place.turn.y), 1, 1e-14);
        }
    }
    EXPECT_GT(joints, 3000);
}

/// Every pin of every body lies on one of another body, or on a pivot; where there are no slots.
TEST(LinkageDrawing, HasAPinOfAnotherBodyAtEveryPin) {
    for (LinkageModel& model : all_linkages()) {
        Drawn drawn(std::move(model));
        if (!drawn.model.structure.slots.empty() || !drawn.model.structure.circular.empty()) continue;
        for (const double angle : even_angles(drawn.design, 7)) {
            drawn.place(angle);
            for (std::size_t b = 0; b < drawn.places.size(); ++b)
                for (const Vector<double>& pin : drawn.scene.bodies[b].pins) {
                    const Vector<double> at = in_drawing(drawn.places[b], pin);
                    double nearest = drawn.scene.extent();
                    for (const Vector<double>& pivot : drawn.scene.pivots)
                        nearest = std::min(nearest, apart(at, pivot));
                    for (std::size_t other = 0; other < drawn.places.size(); ++other)
                        for (const Vector<double>& there : drawn.scene.bodies[other].pins)
                            if (other != b)
                                nearest = std::min(nearest, apart(at, in_drawing(drawn.places[other], there)));
                    EXPECT_LE(nearest, 1e-12 * drawn.scene.extent()) << drawn.scene.bodies[b].name;
                }
        }
    }
}

TEST(LinkageDrawing, KeepsSlidesAndPinsOnTheirGuides) {
    int kept = 0;
    for (LinkageModel& model : all_linkages()) {
        Drawn drawn(std::move(model));
        const linkage::Structure& s = drawn.model.structure;
        // The line of a slide or slot by two of its places.
        const auto off_line = [&](const linkage::Line& line, const Vector<double>& at) {
            const Vector<double> from = drawn.own(line.through);
            const Vector<double> to =
                line.by_angle ? from + drawn.placement.scale * Vector<double>{std::cos(drawn.number(line.angle)),
                                                                              std::sin(drawn.number(line.angle))}
                              : drawn.own(line.towards);
            const Vector<double> a = drawn.at(line.on, from), b = drawn.at(line.on, to);
            return cross(b - a, at - a) / apart(a, b);
        };
        for (const double angle : even_angles(drawn.design, 37)) {
            ASSERT_TRUE(drawn.place(angle));
            const double most = 1e-12 * drawn.scene.extent();
            for (const linkage::Slide& slide : s.slides) {
                EXPECT_NEAR(off_line(slide.line, drawn.link(slide.link).at),
                            drawn.placement.scale * drawn.number(slide.offset), most);
                EXPECT_NEAR(std::remainder(
                                drawn.turn(slide.link) - drawn.turn(slide.line.on) - drawn.number(slide.angle), 2 * pi),
                            0, 1e-13);
                ++kept;
            }
            for (const linkage::Slot& slot : s.slots) {
                const linkage::Point& pin = s.pins[slot.pin].points[0];
                EXPECT_NEAR(off_line(slot.line, drawn.at(pin.link, drawn.own(pin.at))), 0, most);
                ++kept;
            }
            // What bodies say of their guides, too.
            const auto check = [&](const Body& body, const BodyPlace& place) {
                for (const Guide& guide : body.guides)
                    for (const Vector<double>& point : guide.points) {
                        const Vector<double> a = in_drawing(place, guide.from), b = in_drawing(place, guide.to);
                        const Vector<double> at =
                            guide.body == the_ground ? point : in_drawing(drawn.places[guide.body], point);
                        EXPECT_NEAR(cross(b - a, at - a) / apart(a, b), 0, most);
                        const double share = dot(b - a, at - a) / dot(b - a, b - a);
                        EXPECT_TRUE(share >= 0 && share <= 1) << share;
                        ++kept;
                    }
            };
            check(drawn.scene.ground, {});
            for (std::size_t b = 0; b < drawn.places.size(); ++b)
                check(drawn.scene.bodies[b], drawn.places[b]);
        }
    }
    EXPECT_GT(kept, 500);
}

/// The circle of a body with this centre, in its frame: how large it is.
double circle_at(const std::vector<Outline>& outlines, const Vector<double>& centre, double nearest_to) {
    double radius = 0;
    for (const Outline& outline : outlines)
        if (const auto found = outlines::radius_of(outline))
            if (apart(0.5 * (outline.vertices[0].at + outline.vertices[2].at), centre) < 1e-9 &&
                std::abs(*found - nearest_to) < std::abs(radius - nearest_to))
                radius = *found;
    return radius;
}

/// Circles that touch in every position, and turn without slip: arcs that pass the place where they touch are equal.
void expect_rolling(Drawn& drawn, const linkage::Gear& gear, double first_radius, double second_radius) {
    const auto centre = [&](std::size_t link) {
        for (const linkage::Pin& pin : drawn.model.structure.pins)
            if (is_on(pin, link) && is_on(pin, gear.carrier)) return drawn.own(coordinates_on(pin, link));
        ADD_FAILURE();
        return Vector<double>{};
    };
    const auto circles = [&](std::size_t link) -> const std::vector<Outline>& {
        return link == 0 ? drawn.scene.fixed : drawn.body(link).outlines;
    };
    EXPECT_NEAR(circle_at(circles(gear.first), centre(gear.first), first_radius), first_radius, 1e-12);
    EXPECT_NEAR(circle_at(circles(gear.second), centre(gear.second), second_radius), second_radius, 1e-12);
    const bool inside = drawn.number(gear.ratio) > 0;
    double before[2]{};
    bool begun = false;
    for (const double angle : even_angles(drawn.design, 720)) {
        ASSERT_TRUE(drawn.place(angle));
        const double d = apart(drawn.at(gear.first, centre(gear.first)), drawn.at(gear.second, centre(gear.second)));
        EXPECT_NEAR(d, inside ? std::abs(first_radius - second_radius) : first_radius + second_radius, 1e-11);
        const double turns[2]{drawn.turn(gear.first) - drawn.turn(gear.carrier),
                              drawn.turn(gear.second) - drawn.turn(gear.carrier)};
        if (begun) {
            EXPECT_NEAR(first_radius * std::remainder(turns[0] - before[0], 2 * pi),
                        (inside ? 1 : -1) * second_radius * std::remainder(turns[1] - before[1], 2 * pi), 1e-11);
        }
        begun = true;
        std::copy(turns, turns + 2, before);
    }
}

TEST(LinkageDrawing, RollsPitchCirclesOnEachOther) {
    Drawn five_bar(shipped_linkage_model("geared-five-bar"));
    expect_rolling(five_bar, five_bar.model.structure.gears[0], 2, 1);
    // Sun 20, planet 10, ring 40: closed forms of the distance 30 and the ratios.
    Drawn planetary(linkage_model(planetary_text));
    expect_rolling(planetary, planetary.model.structure.gears[0], 20, 10);
    expect_rolling(planetary, planetary.model.structure.gears[1], 10, 40);
}

TEST(LinkageDrawing, RollsAWheelOnItsRack) {
    Drawn drawn(linkage_model(rack_text));
    const Outline* line = nullptr;
    for (const Outline& outline : drawn.body(2).outlines)
        if (outline.layer == Layer::pitch) line = &outline;
    ASSERT_NE(line, nullptr);
    ASSERT_EQ(line->vertices.size(), 2u);
    std::optional<double> before;
    for (const double angle : even_angles(drawn.design, 720)) {
        ASSERT_TRUE(drawn.place(angle));
        const Vector<double> a = drawn.at(2, line->vertices[0].at), b = drawn.at(2, line->vertices[1].at);
        const Vector<double> centre = drawn.at(1, {}), along = (1 / apart(a, b)) * (b - a);
        EXPECT_NEAR(std::abs(cross(along, centre - a)), 4, 1e-12);
        const double reach = dot(along, centre - a);
        EXPECT_TRUE(reach >= 0 && reach <= apart(a, b));
        // The place of contact goes along the rack as far as the rim turns past it.
        const double side = cross(along, centre - a) > 0 ? 1 : -1, rolled = -side * 4 * angle - reach;
        if (before) {
            EXPECT_NEAR(rolled - *before, 0, 1e-11);
        }
        before = rolled;
    }
}

/// The belt is not read here: a belt looks like a gear to everything else.
TEST(LinkageDrawing, LaysBeltsRoundTheirWheels) {
    for (const double ratio : {1.0, 2.0, -0.5}) {
        LinkageModel model = shipped_linkage_model("geared-five-bar");
        model.structure.gears[0].belt = true;
        model.numbers[model.structure.gears[0].ratio].constant = ratio;
        Drawn drawn(std::move(model));
        const double second = 3 * 0.6 / (1 + std::abs(ratio)), first = std::abs(ratio) * second;
        int tangents = 0;
        for (const Outline& outline : drawn.scene.fixed)
            if (outline.layer == Layer::pitch && !outline.closed) {
                const Vector<double> a = outline.vertices[0].at, b = outline.vertices[1].at;
                EXPECT_NEAR(apart(a, {0, 0}), first, 1e-12);
                EXPECT_NEAR(apart(b, {3, 0}), second, 1e-12);
                EXPECT_NEAR(dot(b - a, a), 0, 1e-12);
                EXPECT_NEAR(dot(b - a, b - Vector<double>{3, 0}), 0, 1e-12);
                EXPECT_EQ(a.y * b.y > 0, ratio > 0);  // crossed: from one side to the other
                ++tangents;
            }
        EXPECT_EQ(tangents, 2);
    }
}

TEST(LinkageDrawing, HasBarsPlatesBlocksAndSlots) {
    const Drawn jansen(shipped_linkage_model("jansen-leg"));
    EXPECT_EQ(jansen.scene.bodies[0].name, "crank");
    EXPECT_EQ(jansen.scene.bodies[0].outlines[0].vertices.size(), 2u);
    EXPECT_EQ(jansen.body(7).name, "foot");
    EXPECT_EQ(jansen.body(7).outlines[0].vertices.size(), 3u);
    EXPECT_TRUE(jansen.body(7).outlines[0].closed);
    EXPECT_EQ(jansen.body(7).points.size(), 1u);
    EXPECT_EQ(jansen.scene.pivots.size(), 2u);
    std::multiset<std::string> names;
    for (const Label& label : jansen.scene.ground.labels)
        names.insert(label.text);
    for (const Body& body : jansen.scene.bodies)
        for (const Label& label : body.labels)
            names.insert(label.text);
    EXPECT_EQ(names, (std::multiset<std::string>{jansen.model.pins.begin(), jansen.model.pins.end()}));

    const Drawn yoke(shipped_linkage_model("scotch-yoke"));
    EXPECT_EQ(std::count_if(yoke.body(2).outlines.begin(), yoke.body(2).outlines.end(),
                            [](const Outline& o) { return o.layer == Layer::block; }),
              1);
    // The pin goes 20 to either side; the slot ends there.
    const auto slot = std::find_if(yoke.body(2).outlines.begin(), yoke.body(2).outlines.end(),
                                   [](const Outline& o) { return o.closed && o.vertices[1].bulge == 1; });
    ASSERT_NE(slot, yoke.body(2).outlines.end());
    for (const ArcVertex& v : slot->vertices)
        EXPECT_NEAR(std::abs(v.at.y), 20, 1e-9);
    EXPECT_TRUE(std::any_of(yoke.scene.fixed.begin(), yoke.scene.fixed.end(),
                            [](const Outline& o) { return o.layer == Layer::ground; }));

    // A third crank that fits is a bar with two pins, not a slot.
    const Drawn parallelogram(design_of(shipped_linkage_model("parallelogram")));
    EXPECT_EQ(parallelogram.body(4).pins.size(), 2u);
    EXPECT_EQ(parallelogram.body(4).outlines.size(), 1u);
    EXPECT_NEAR(apart(parallelogram.body(4).pins[0], parallelogram.body(4).pins[1]), 40, 1e-9);
    EXPECT_EQ(parallelogram.scene.pivots.size(), 3u);
}

TEST(LinkageDrawing, ShowsTheEndsOfAMotionThatIsNoFullTurn) {
    Drawn drawn(shipped_linkage_model("peaucellier"));
    ASSERT_FALSE(drawn.design.motion.full_turn);
    const std::vector<double> limits = limit_angles(drawn.design);
    ASSERT_EQ(limits.size(), 2u);
    for (const double limit : limits)
        EXPECT_TRUE(drawn.place(limit));
    EXPECT_FALSE(drawn.place(limits[1] + 0.01));
    EXPECT_TRUE(limit_angles(Drawn(shipped_linkage_model("jansen-leg")).design).empty());
}

TEST(LinkageDrawing, LeavesNothingOutsideOfThePicture) {
    for (LinkageModel& model : all_linkages()) {
        Drawn drawn(std::move(model));
        const SvgView view = view_of(drawn.scene, 640, 520);
        for (const double angle : even_angles(drawn.design, 36)) {
            drawn.place(angle);
            for (std::size_t b = 0; b < drawn.places.size(); ++b)
                for (const Vector<double>& pin : drawn.scene.bodies[b].pins) {
                    const Vector<double> at = view.pixels(in_drawing(drawn.places[b], pin));
                    EXPECT_TRUE(at.x >= 0 && at.x <= view.width && at.y >= 0 && at.y <= view.height);
                }
        }
        EXPECT_NE(svg_picture(drawn.design, {.title = "drawn", .below = {}}).find("class=\"name\""), std::string::npos);
        EXPECT_NE(sketch_of(drawn.design, drawn.scene, drawn.design.motion.from).find("allowRedundant=1"),
                  std::string::npos);
    }
}

TEST(LinkageDrawing, HasGearsAsCirclesForCad) {
    const Drawn drawn(linkage_model(planetary_text));
    const std::string dxf = dxf_of(drawn.design, drawn.scene, 0.3);
    // Sun, planet twice (of both gears) and ring.
    std::size_t circles = 0;
    for (std::size_t at = 0; (at = dxf.find("CIRCLE\n  8\nPITCH", at)) != std::string::npos; ++at)
        ++circles;
    EXPECT_EQ(circles, 4u);
    const std::string sketch = sketch_of(drawn.design, drawn.scene, 0.3);
    std::size_t requests = 0;
    for (std::size_t at = 0; (at = sketch.find("Request.type=400\n", at)) != std::string::npos; ++at)
        ++requests;
    EXPECT_EQ(requests, 4u);
}

/// Whatever is missing in a file: what could be read is drawn, with a name at every point.
TEST(LinkageSkeleton, DrawsWhatCouldBeRead) {
    int drawn = 0;
    for (const char* name : {"geared-five-bar", "jansen-leg", "parallelogram", "scotch-yoke", "crank-and-rack"}) {
        const std::string text = content_of(shipped_linkage_file(name));
        for (std::size_t from = 0, to = 0; from < text.size(); from = to + 1) {
            to = std::min(text.find('\n', from), text.size() - 1);
            const Linkage l = parse_linkage(text.substr(0, from) + text.substr(to + 1), "torn.toml").linkage;
            if (!has_skeleton(l)) continue;
            const std::string picture = skeleton_picture(l, 640);
            for (const std::string& link : l.links)
                EXPECT_NE(picture.find(">" + link + "<"), std::string::npos) << link;
            for (const std::string& pin : l.pins)
                EXPECT_NE(picture.find(">" + pin + "<"), std::string::npos) << pin;
            EXPECT_EQ(picture.find("nan"), std::string::npos);
            ++drawn;
        }
    }
    EXPECT_GT(drawn, 40);
}

TEST(LinkageTable, HasAnglesPointsAndDisplacements) {
    const FinishedDesign jansen = design_of(shipped_linkage_model("jansen-leg"));
    const auto& columns = jansen.mechanism->table.columns;
    EXPECT_EQ(columns.size(), jansen.mechanism->table.units.size());
    EXPECT_EQ(columns.size(), 1 + 6 + 2 * 8u);  // the crank's own angle is the input
    EXPECT_EQ(columns.front(), "crank-angle");
    const MotionRow row(jansen, pi / 2);
    ASSERT_TRUE(row.assembled());
    EXPECT_NEAR(row["T-x"], 30.3109, 5e-5);  // of `mechwright structure`
    EXPECT_NEAR(row["T-y"], -82.5894, 5e-5);
    const Vector<double> foot = row.vector("U") - row.vector("W");
    EXPECT_NEAR(row["foot-angle"], std::atan2(foot.y, foot.x), 1e-14);

    const FinishedDesign yoke = design_of(shipped_linkage_model("scotch-yoke"));
    for (const double angle : even_angles(yoke, 24)) {
        const MotionRow at(yoke, angle);
        EXPECT_NEAR(at["ram-displacement"], 20 * std::cos(angle), 1e-13);
        EXPECT_EQ(at["crank-angle"], angle);
        EXPECT_EQ(at["yoke-angle"], 0);
    }

    LinkageModel moved = shipped_linkage_model("scotch-yoke");
    moved.placement = {{{7, {}}, {-3, {}}, {0.4, {}}}};
    moved.scale = {2.5, {}};
    const FinishedDesign larger = design_of(std::move(moved));
    const MotionRow at(larger, 1.1);
    EXPECT_NEAR(at["ram-displacement"], 50 * std::cos(1.1), 1e-13);
    EXPECT_NEAR(at["B-x"], 7 + 50 * std::cos(1.5), 1e-13);
    EXPECT_NEAR(at["B-y"], -3 + 50 * std::sin(1.5), 1e-13);
}

TEST(LinkageTable, CountsADrivenSlideInLengths) {
    FinishedDesign design = design_of(linkage_model(driven_slide_text));
    EXPECT_EQ(design.mechanism->table.columns.front(), "displacement");
    EXPECT_EQ(input_unit(design), Unit::length);
    const std::vector<double> inputs = even_angles(design, 10);
    EXPECT_NEAR(inputs[5], 0.5 * (design.motion.from + design.motion.to), 1e-12);
    for (const double input : inputs) {
        const MotionRow row(design, input);
        ASSERT_TRUE(row.assembled());
        EXPECT_NEAR(row["piston-displacement"], input, 1e-12);
        EXPECT_NEAR(row["P-x"], input, 1e-12);
    }
    const MotionPlots plots = motion_plots(design, {}, 10);
    EXPECT_EQ(plots.angle_name, "displacement");
    EXPECT_EQ(plots.angle_unit, design.units.length);
    EXPECT_NEAR(plots.angles.back(), design.motion.to, 1e-12);
}

TEST(LinkageTable, KeepsTheInputApartFromAnotherCrank) {
    LinkageModel model = shipped_linkage_model("geared-five-bar");
    model.links[2] = "crank";
    EXPECT_EQ(linkage_table(model).columns[0], "input-angle");
    model.links[2] = "second";
    model.links[1] = "crank";
    EXPECT_EQ(linkage_table(model).columns[0], "crank-angle");
    EXPECT_EQ(linkage_table(model).columns[1], "second-angle");
}

}  // namespace
}  // namespace mechwright::testing::drawn_linkages
