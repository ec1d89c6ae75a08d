#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/figure/panels.h"
#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

using namespace figure;

constexpr double guide_length = 46, overhang = 26, stem_diameter = 16, precompression = 14;
constexpr double wall = 14;  ///< of the guide, thick

/// Up from a place, as wide as the stem and more; its coils to scale with the room.
Outline spring(double from, double to) {
    constexpr int coils = 6;
    Outline outline{Layer::path, {}, false};
    for (int i = 0; i <= 2 * coils; ++i)
        outline.vertices.push_back({{(i % 2 == 0 ? -1 : 1) * stem_diameter, from + (to - from) * i / (2 * coils)}, 0});
    return outline;
}

/// Half of the guide on one side of the stem.
Outline guide(double side, double from, double to) {
    const double near = 0.5 * stem_diameter * side, far = near + wall * side;
    return outlines::polygon({{near, from}, {far, from}, {far, to}, {near, to}}, Layer::block);
}

MovingDesign loaded(const MovingDesign& cam) {
    MovingDesign design = cam;
    const auto set = [&](const char* name, double value) {
        design.dimensions[static_cast<std::size_t>(find_dimension(*cam.mechanism, name))] = value;
    };
    set("guide-length", guide_length);
    set("overhang", overhang);
    set("stem-diameter", stem_diameter);
    set("precompression", precompression);
    if (find_dimension(*cam.mechanism, "offset") >= 0) set("offset", 0);
    return design;
}

}  // namespace

FigurePanel cam_load_panel(const MovingDesign& cam) {
    FigurePanel panel{.title = "What holds a translating follower to its cam, at the lowest position",
                      .design = loaded(cam)};
    const Drawing& drawing = *cam.mechanism->drawing;
    panel.input = drawing.limits(panel.design).front();
    std::vector<BodyPlace> places(2);
    drawing.place(panel.design, panel.input, panel.design.motion.assembly, places);
    const double end = places[1].at.y, near = end + overhang, far = near + guide_length;
    const double collar = far + precompression + 12, top = collar + 50, half = 0.5 * stem_diameter;
    panel.lines = {{guide(-1, near, far)},
                   {guide(1, near, far)},
                   {outlines::segment({-half, end}, {-half, top + 30}, Layer::ground)},
                   {outlines::segment({half, end}, {half, top + 30}, Layer::ground)},
                   {outlines::segment({-stem_diameter - 6, collar}, {stem_diameter + 6, collar}, Layer::link)},
                   {outlines::segment({-stem_diameter - 10, top}, {-half, top}, Layer::link)},
                   {outlines::segment({half, top}, {stem_diameter + 10, top}, Layer::link)},
                   {spring(collar, top)},
                   {outlines::segment({-stem_diameter - 6, collar - precompression},
                                      {stem_diameter + 6, collar - precompression}, Layer::base)},
                   {outlines::arrow({0, top + 64}, {0, -1}, 32, Layer::link)},
                   {outlines::arrow({52, end + 10}, {0, -1}, 28, Layer::link)}};
    panel.places = {fixed("C", {0, 0}, "follower"),
                    fixed("near", {-half - wall, near}),
                    fixed("far", {-half - wall, far}),
                    fixed("left", {-half, top + 15}),
                    fixed("right", {half, top + 15}),
                    fixed("held", {stem_diameter + 6, collar}),
                    fixed("free", {stem_diameter + 6, collar - precompression}),
                    fixed("coils", {-stem_diameter, 0.5 * (collar + top)}),
                    fixed("pressed", {0, top + 58}),
                    fixed("heavy", {52, end - 2})};
    panel.dimensions = {length("guide-length", "near", "far", 24),
                        by("near", length_along("overhang", "C", "near", y_axis(), 24)),
                        length("stem-diameter", "left", "right", 0),
                        length("precompression", "free", "held", -30),
                        word("spring-rate", "coils"),
                        word("load", "pressed"),
                        word("weight", "heavy")};
    panel.names_links = false;
    panel.remark =
        "The broken line is where the spring would end without its precompression. load is any other force towards the "
        "cam.";
    return panel;
}

}  // namespace mechwright
