#include "synthesis/mechanism/cam/figure/figure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/figure/panels.h"
#include "synthesis/mechanism/drawing/motion_row.h"

namespace mechwright {

namespace {

using namespace figure;

using Shared = std::shared_ptr<const Mechanism>;
using Numbers = std::vector<std::pair<std::string_view, double>>;

constexpr double degree = std::numbers::pi / 180;

// Rise, dwell, return, dwell, in degrees of the cam.
constexpr std::array<double, 4> segment_angles{120, 50, 110, 80};
constexpr double lift = 20, swing = 18, face_swing = 9;

/// Up and down by a cycloid, each with a dwell after it.
std::shared_ptr<const MotionProgram> program() {
    const auto laws = cam_laws();
    const auto cycloidal =
        std::find_if(laws.begin(), laws.end(), [](const auto& law) { return law.name == "cycloidal"; });
    const auto law = static_cast<std::size_t>(cycloidal - laws.begin());
    MotionProgram program;
    for (const cam::SegmentKind kind :
         {cam::SegmentKind::rise, cam::SegmentKind::dwell, cam::SegmentKind::fall, cam::SegmentKind::dwell}) {
        SegmentPlan plan;
        plan.kind = kind;
        if (kind != cam::SegmentKind::dwell) plan.laws = {law};
        program.segments.push_back(plan);
    }
    return std::make_shared<const MotionProgram>(std::move(program));
}

Numbers with_motion(Numbers numbers, double lifts) {
    static constexpr std::array<std::string_view, 4> names{"angle-1", "angle-2", "angle-3", "angle-4"};
    for (std::size_t i = 0; i < names.size(); ++i)
        numbers.emplace_back(names[i], segment_angles[i]);
    for (const char* name : {"lift-1", "lift-3"})
        numbers.emplace_back(name, lifts);
    return numbers;
}

/// The cam moves its follower by the program.
FigurePanel moved(const Shared& cam, Numbers numbers, double input) {
    const CamKind kind = cam_kind(*cam);
    const double lifts = !kind.oscillating ? lift : kind.follower == CamFollower::flat ? face_swing : swing;
    FigurePanel panel{.title = cam->meaning,
                      .design = figure_design(with_program(*cam, program()), with_motion(std::move(numbers), lifts)),
                      .input = input * degree};
    panel.places = {pivot("A0", 0)};
    return panel;
}

FigurePanel translating_roller(const Shared& cam, bool knife) {
    FigurePanel panel = moved(cam, {{"prime-radius", 44}, {"offset", 16}, {"roller-radius", knife ? 0 : 13}}, 40);
    panel.places.push_back(fixed("C", {0, 0}, "follower"));
    panel.places.push_back(corner("prime", "cam", knife ? 1 : 2, 2));
    panel.dimensions = {length("prime-radius", "A0", "prime", 0), coordinate("offset", "A0", "C", x_axis(), -70)};
    if (knife) return panel;
    panel.places.push_back(corner("rim", "follower", 0, 0));
    panel.dimensions.push_back(length("roller-radius", "C", "rim", 0));
    return panel;
}

FigurePanel oscillating_roller(const Shared& cam, bool knife) {
    FigurePanel panel = moved(
        cam, {{"prime-radius", 44}, {"pivot-distance", 92}, {"arm-length", 76}, {"roller-radius", knife ? 0 : 13}}, 40);
    panel.places.insert(panel.places.end(),
                        {pivot("B0", 1), fixed("C", {76, 0}, "arm"), corner("prime", "cam", knife ? 1 : 2, 2)});
    panel.dimensions = {length("prime-radius", "A0", "prime", 0), length("pivot-distance", "A0", "B0", -62),
                        length("arm-length", "C", "B0", 30)};
    if (knife) return panel;
    panel.places.push_back(corner("rim", "arm", 0, 1));
    panel.dimensions.push_back(length("roller-radius", "C", "rim", 0));
    return panel;
}

FigurePanel translating_flat(const Shared& cam) {
    FigurePanel panel = moved(cam, {{"base-radius", 48}}, 40);
    panel.places.push_back(corner("base", "cam", 1, 2));
    panel.dimensions = {length("base-radius", "A0", "base", 0)};
    return panel;
}

FigurePanel oscillating_flat(const Shared& cam) {
    FigurePanel panel = moved(cam, {{"base-radius", 45}, {"pivot-distance", 130}, {"face-offset", 14}}, 40);
    panel.places.insert(panel.places.end(), {pivot("B0", 1), corner("base", "cam", 1, 2), corner("near", "arm", 0, 0),
                                             corner("far", "arm", 0, 1)});
    panel.dimensions = {length("base-radius", "A0", "base", 0), length("pivot-distance", "A0", "B0", -62),
                        by("B0", coordinate("face-offset", "B0", "near", side("near", "far", 90), -24))};
    return panel;
}

/// Where the follower touches the cam, in the cam's frame.
Vector<double> contact(const MovingDesign& design, double cam_angle) {
    return MotionRow(design, cam_angle).vector("profile");
}

Vector<double> unit(const Vector<double>& v) { return (1 / std::hypot(v.x, v.y)) * v; }

FigurePanel contour(const Shared& cam) {
    const CamKind kind = cam_kind(*cam);
    const bool eccentric = kind.contour == cam::ContourKind::eccentric,
               arc = kind.contour == cam::ContourKind::circular_arc;
    Numbers numbers{{"base-radius", 36}, {"centre-distance", eccentric ? 16 : 40}, {"angle-1", 360}};
    if (!eccentric) numbers.emplace_back("nose-radius", 14);
    if (arc) numbers.emplace_back("flank-radius", 90);
    if (kind.follower != CamFollower::flat) numbers.emplace_back("roller-radius", 13);
    FigurePanel panel{.title = cam->meaning,
                      .design = figure_design(with_program(*cam, contour_program(kind.contour)), numbers)};
    const std::vector<double> limits = cam->drawing->limits(panel.design);
    const double lowest = limits[0], highest = limits[1];
    panel.input = eccentric ? 110 * degree : highest - 35 * degree;
    const Vector<double> nose = panel.design["centre-distance"] * unit(contact(panel.design, highest));
    // Opposite the nose the base circle is touched.
    const double back = highest + std::numbers::pi;
    panel.places = {pivot("A0", 0), fixed(eccentric ? "E" : "N", nose, "cam"),
                    fixed("base", contact(panel.design, eccentric ? lowest : back - 50 * degree), "cam")};
    const std::string centre = eccentric ? "E" : "N";
    panel.dimensions = {length("base-radius", "A0", "base", 0),
                        length("centre-distance", "A0", centre, eccentric ? 30 : 0)};
    if (!eccentric) {
        panel.places.push_back(fixed("tip", contact(panel.design, highest + 2 * degree), "cam"));
        panel.dimensions.push_back(length("nose-radius", "N", "tip", 0));
    }
    if (arc) {
        const Vector<double> start = contact(panel.design, 0);
        panel.places.push_back(fixed("F", start - panel.design["flank-radius"] * unit(start), "cam"));
        panel.places.push_back(fixed("flank", contact(panel.design, 12 * degree), "cam"));
        panel.dimensions.push_back(length("flank-radius", "F", "flank", 0));
    }
    if (kind.follower == CamFollower::flat) return panel;
    panel.places.insert(panel.places.end(), {fixed("C", {0, 0}, "follower"), corner("rim", "follower", 0, 0)});
    panel.dimensions.push_back(length("roller-radius", "C", "rim", 0));
    return panel;
}

FigurePanel follower(const Shared& cam) {
    const CamKind kind = cam_kind(*cam);
    if (kind.contour != cam::ContourKind::none) return contour(cam);
    const bool knife = kind.follower == CamFollower::knife;
    if (kind.follower == CamFollower::flat) return kind.oscillating ? oscillating_flat(cam) : translating_flat(cam);
    return kind.oscillating ? oscillating_roller(cam, knife) : translating_roller(cam, knife);
}

}  // namespace

std::vector<FigurePanel> cam_figure(const Shared& cam) {
    const CamKind kind = cam_kind(*cam);
    std::vector<FigurePanel> panels{follower(cam)};
    const MovingDesign design = panels[0].design;
    if (kind.contour == cam::ContourKind::none) panels.push_back(cam_motion_panel(design));
    if (!kind.oscillating) panels.push_back(cam_load_panel(design));
    return panels;
}

}  // namespace mechwright
