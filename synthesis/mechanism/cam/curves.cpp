#include "synthesis/mechanism/cam/curves.h"

#include <algorithm>
#include <numbers>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/drawing/motion_row.h"

namespace mechwright {

double roller_radius(const MovingDesign& cam) { return cam["roller-radius"]; }

std::vector<double> cam_corners(const MovingDesign& cam) {
    constexpr double turn = 2 * std::numbers::pi;
    std::vector<double> angles{0};
    cam_corners(*cam.mechanism, cam.motion, cam.dimensions, angles);
    angles.push_back(turn);
    std::sort(angles.begin(), angles.end());
    constexpr double close = 1e-9;
    std::vector<double> distinct;
    for (const double angle : angles)
        if (distinct.empty() || angle - distinct.back() > close) distinct.push_back(angle);
    distinct.back() = turn;
    return distinct;
}

std::vector<ArcVertex> cam_curve(const MovingDesign& cam, double offset, double tolerance) {
    const auto curve = [&](double cam_angle) {
        const MotionRow row(cam, cam_angle);
        return row.vector("profile") + offset * row.vector("normal");
    };
    const std::vector<double> ends = cam_corners(cam);
    std::vector<ArcVertex> vertices;
    for (std::size_t i = 1; i < ends.size(); ++i)
        fit_arcs(curve, ends[i - 1], ends[i], tolerance, vertices);
    return vertices;
}

}  // namespace mechwright
