#include "synthesis/target/followed/draw.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "analysis/numbers/scalar.h"
#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

/// Where the guided point is in the drawing.
Vector<double> followed_point(const FinishedDesign& design, double crank_angle) {
    PathMiss from_origin{};
    miss_of_point(*design.mechanism, design.mechanism->form(design.motion.assembly), design.dimensions, crank_angle,
                  {0, 0}, from_origin);
    return Vector<double>{0, 0} - from_origin.miss;
}

/// The line that the guided point is to follow, beside where it is over the input range.
Outline followed_line(const FinishedDesign& design, std::span<const Vector<double>> reached, double beyond) {
    const double angle = design["line-angle"];
    const Vector<double> along{std::cos(angle), std::sin(angle)};
    const Vector<double> foot = design["line-offset"] * left_of(along);
    const auto [least, greatest] = std::minmax_element(
        reached.begin(), reached.end(), [&](const auto& a, const auto& b) { return dot(a, along) < dot(b, along); });
    return outlines::segment(foot + (dot(*least, along) - beyond) * along,
                             foot + (dot(*greatest, along) + beyond) * along, Layer::follow);
}

Outline followed_arc(const FinishedDesign& design, std::span<const Vector<double>> reached) {
    const Vector<double> centre{design["arc-x"], design["arc-y"]};
    const double radius = std::abs(design["arc-radius"]);
    std::vector<double> angles;
    for (const Vector<double>& p : reached) {
        const double angle = std::atan2(p.y - centre.y, p.x - centre.x);
        angles.push_back(angles.empty() ? angle
                                        : angles.back() + std::remainder(angle - angles.back(), 2 * pi<double>()));
    }
    const auto [least, greatest] = std::minmax_element(angles.begin(), angles.end());
    // In eight parts: no bulge is large, whatever the angle.
    constexpr int parts = 8;
    const double step = (*greatest - *least) / parts;
    Outline arc{Layer::follow, {}, false};
    for (int i = 0; i <= parts; ++i) {
        const double angle = *least + step * i;
        arc.vertices.push_back({centre + radius * Vector<double>{std::cos(angle), std::sin(angle)},
                                i < parts ? std::tan(0.25 * step) : 0});
    }
    return arc;
}

}  // namespace

void add_followed(const FinishedDesign& design, Scene& scene) {
    if (design.motion.followed == Followed::nothing) return;
    constexpr int steps = 64;
    std::vector<Vector<double>> reached;
    for (int i = 0; i <= steps; ++i)
        reached.push_back(followed_point(design, design["input-start"] + design["input-range"] * i / steps));
    scene.fixed.push_back(design.motion.followed == Followed::line ? followed_line(design, reached, 2 * scene.symbol)
                                                                   : followed_arc(design, reached));
}

double distance_from_followed(const FinishedDesign& design, double crank_angle) {
    const Vector<double> point = followed_point(design, crank_angle);
    if (design.motion.followed == Followed::line) {
        const double angle = design["line-angle"];
        return dot(point, Vector<double>{-std::sin(angle), std::cos(angle)}) - design["line-offset"];
    }
    return std::hypot(point.x - design["arc-x"], point.y - design["arc-y"]) - design["arc-radius"];
}

}  // namespace mechwright
