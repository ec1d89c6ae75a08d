#include "synthesis/target/followed/draw.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "analysis/numbers/scalar.h"
#include "synthesis/mechanism/drawing/outlines.h"

namespace mechwright {

namespace {

/// Where the guided point is in the drawing.
Vector<double> followed_point(const FinishedDesign& design, const InputTask& task, double crank_angle) {
    PathMiss from_origin{};
    miss_of_point(*design.mechanism, task.form(*design.mechanism, design.motion.assembly), design.dimensions,
                  crank_angle, {0, 0}, from_origin);
    return Vector<double>{0, 0} - from_origin.miss;
}

/// The line that the guided point is to follow, beside where it is over the input range.
Outline followed_line(std::span<const double> line, std::span<const Vector<double>> reached, double beyond) {
    const double angle = line[0];
    const Vector<double> along{std::cos(angle), std::sin(angle)};
    const Vector<double> foot = line[1] * left_of(along);
    const auto [least, greatest] = std::minmax_element(
        reached.begin(), reached.end(), [&](const auto& a, const auto& b) { return dot(a, along) < dot(b, along); });
    return outlines::segment(foot + (dot(*least, along) - beyond) * along,
                             foot + (dot(*greatest, along) + beyond) * along, Layer::follow);
}

Outline followed_arc(std::span<const double> of, std::span<const Vector<double>> reached) {
    const Vector<double> centre{of[0], of[1]};
    const double radius = std::abs(of[2]);
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

/// The numbers of a line or an arc.
std::span<const double> numbers_of(const FinishedDesign& design, const InputTask& task) {
    return std::span<const double>(design.dimensions).subspan(task.shape->place, task.shape->numbers.size());
}

}  // namespace

void add_followed(const FinishedDesign& design, Scene& scene) {
    constexpr int steps = 64;
    for (const InputTask& task : input_tasks(design)) {
        if (task.is_function()) continue;
        const double start = design.dimensions[task.start], range = design.dimensions[task.start + 1];
        std::vector<Vector<double>> reached;
        for (int i = 0; i <= steps; ++i)
            reached.push_back(followed_point(design, task, start + range * i / steps));
        const auto numbers = numbers_of(design, task);
        scene.fixed.push_back(task.is_line() ? followed_line(numbers, reached, 2 * scene.symbol)
                                             : followed_arc(numbers, reached));
    }
}

double distance_from_followed(const FinishedDesign& design, const InputTask& task, double crank_angle) {
    const Vector<double> point = followed_point(design, task, crank_angle);
    const auto numbers = numbers_of(design, task);
    if (task.is_line()) return dot(point, Vector<double>{-std::sin(numbers[0]), std::cos(numbers[0])}) - numbers[1];
    return std::hypot(point.x - numbers[0], point.y - numbers[1]) - numbers[2];
}

}  // namespace mechwright
