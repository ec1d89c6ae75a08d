#include "synthesis/mechanism/cam/drawing.h"

#include <algorithm>
#include <array>
#include <numbers>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/curves.h"
#include "synthesis/mechanism/cam/figure/figure.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/mechanism/drawing/motion_row.h"
#include "synthesis/mechanism/drawing/moving_design.h"
#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

constexpr double full_turn = 2 * std::numbers::pi;

constexpr int steps = 720;

/// How far the contact goes along a flat face, to both sides.
Vector<double> face_reach(const MovingDesign& design) {
    // The contact of a face that moves along a guide is counted along the turning of the cam.
    const double side = cam_kind(*design.mechanism).oscillating ? 1 : sense_of(design.motion.assembly);
    Vector<double> reach{0, 0};
    for (int i = 0; i < steps; ++i) {
        const double along = side * MotionRow(design, full_turn * i / steps)["face-contact"];
        reach = {std::min(reach.x, along), std::max(reach.y, along)};
    }
    return reach;
}

/// The least distance of the roller centre, or of the face, from the cam centre.
double least_radius(const MovingDesign& design) {
    const double prime = design["prime-radius"];
    return prime > 0 ? prime : design["base-radius"] + roller_radius(design);
}

double stem_length(const MovingDesign& design) { return 0.8 * least_radius(design) + roller_radius(design); }

Body cam_body(const MovingDesign& design, double tolerance) {
    Body cam{"cam", {}, {{0, 0}}, {}};
    cam.outlines.push_back({Layer::cam, cam_curve(design, 0, tolerance), true});
    const double roller = roller_radius(design);
    if (roller > 0) cam.outlines.push_back({Layer::pitch, cam_curve(design, roller, tolerance), true});
    cam.outlines.push_back(outlines::circle({0, 0}, least_radius(design), Layer::base));
    return cam;
}

/// The follower in the frame of its guide, its end at the origin; an arm in that of its pivot.
Body follower_body(const MovingDesign& design, double symbol) {
    const CamKind kind = cam_kind(*design.mechanism);
    const bool flat = kind.follower == CamFollower::flat;
    const double roller = roller_radius(design), length = design["arm-length"];
    Body body{kind.oscillating ? "arm" : "follower", {}, {}, {}};
    const Vector<double> end = kind.oscillating && !flat ? Vector<double>{length, 0} : Vector<double>{0, 0};
    if (roller > 0) body.outlines.push_back(outlines::circle(end, roller, Layer::block));
    if (flat) {
        const Vector<double> reach = face_reach(design);
        const double height = kind.oscillating ? design["face-offset"] : 0;
        body.outlines.push_back(outlines::segment({reach.x - symbol, height}, {reach.y + symbol, height}));
        if (height != 0) body.outlines.push_back(outlines::segment({0, 0}, {0, height}));
    }
    if (kind.oscillating) {
        body.pins.push_back({0, 0});
        if (!flat) body.outlines.push_back(outlines::segment({0, 0}, end));
    } else {
        body.outlines.push_back(outlines::segment({0, 0}, {0, stem_length(design)}));
    }
    if (roller > 0) body.pins.push_back(end);
    return body;
}

std::vector<Body> bodies(const MovingDesign& design, double symbol, double tolerance) {
    return {cam_body(design, tolerance), follower_body(design, symbol)};
}

bool place(const MovingDesign& design, double cam_angle, std::size_t, std::span<BodyPlace> places) {
    const MotionRow row(design, cam_angle);
    const CamKind kind = cam_kind(*design.mechanism);
    const double turned_by = sense_of(design.motion.assembly) * cam_angle;
    const Vector<double> with_cam{std::cos(turned_by), std::sin(turned_by)};
    places[0] = {{0, 0}, with_cam};
    // A knife edge is a roller without radius: its centre is on the profile.
    const Vector<double> centre = turned(row.vector("pitch"), with_cam), pivot{design["pivot-distance"], 0};
    if (kind.follower == CamFollower::flat) {
        const Vector<double> outward = turned(row.vector("normal"), with_cam);
        places[1] = kind.oscillating ? BodyPlace{pivot, left_of(outward)} : BodyPlace{{0, centre.y}, {1, 0}};
    } else if (kind.oscillating) {
        const Vector<double> arm = centre - pivot;
        places[1] = {pivot, (1 / std::hypot(arm.x, arm.y)) * arm};
    } else {
        places[1] = {centre, {1, 0}};
    }
    return row.assembled();
}

std::vector<Vector<double>> pivots(const MovingDesign& design) {
    std::vector<Vector<double>> all{{0, 0}};
    if (cam_kind(*design.mechanism).oscillating) all.push_back({design["pivot-distance"], 0});
    return all;
}

/// Where the lift is least and where it is greatest, of the ends of segments and of even steps.
std::vector<double> limits(const MovingDesign& design) {
    std::vector<double> angles = cam_corners(design);
    for (int i = 0; i < steps; ++i)
        angles.push_back(full_turn * i / steps);
    const auto lower = [&](double a, double b) { return MotionRow(design, a)["lift"] < MotionRow(design, b)["lift"]; };
    const auto [lowest, highest] = std::minmax_element(angles.begin(), angles.end(), lower);
    return {*lowest, *highest};
}

/// The guide of a translating follower: walls beside its stem, where the file says, else where the stem always is.
Body ground(const MovingDesign& design, double symbol) {
    Body guide;
    if (cam_kind(*design.mechanism).oscillating) return guide;
    std::array<BodyPlace, 2> lowest, highest;
    const std::vector<double> at = limits(design);
    place(design, at[0], design.motion.assembly, lowest);
    place(design, at[1], design.motion.assembly, highest);
    const double length = design["guide-length"], stem = design["stem-diameter"];
    const Vector<double> low = lowest[1].at, high = highest[1].at;
    const double from = length > 0 ? low.y + design["overhang"] : high.y + roller_radius(design) + symbol;
    const double to = length > 0 ? from + length : low.y + stem_length(design);
    if (!(from < to)) return guide;
    const double half = stem > 0 ? 0.5 * stem : symbol;
    for (const double x : {low.x - half, low.x + half})
        guide.outlines.push_back(outlines::segment({x, from}, {x, to}, Layer::ground));
    return guide;
}

}  // namespace

Drawing cam_drawing() { return {bodies, place, pivots, limits, ground, cam_figure}; }

}  // namespace mechwright
