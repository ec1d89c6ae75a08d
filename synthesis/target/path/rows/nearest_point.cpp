#include "synthesis/target/path/rows/nearest_point.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "analysis/numbers/extremes.h"

namespace mechwright {

namespace {

/// Samples of the curve; a coupler curve is of degree six and has few local minima of distance, far apart.
constexpr int curve_samples = 360;
/// Where two of them are farther apart than so many times the mean, there are so many parts between them.
constexpr double long_chord = 2;
constexpr int samples_round_corner = 64;

struct Sample {
    double angle;
    Vector<double> point;
};

/// A point of the curve and, if asked for, its derivative by the crank angle.
bool point_at(const Problem& problem, const Design& design, std::size_t guided, double angle, Vector<double>& point,
              Vector<double>* slope) {
    std::array<double, PointGuidance::most_reads + 1> x{};
    std::array<double, PointGuidance::most_reads + 1> y{};
    PathMiss miss{};
    if (slope) {
        miss.gradient_x = x;
        miss.gradient_y = y;
    }
    miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly, guided), design.dimensions, angle,
                  {0, 0}, miss);
    point = -miss.miss;
    const std::size_t last = problem.mechanism->point->reads.size();
    if (slope) *slope = {-x[last], -y[last]};
    return miss.margin >= 0;
}

double distance(const Sample& a, const Sample& b) { return std::hypot(b.point.x - a.point.x, b.point.y - a.point.y); }

/// Next to a change point a curve has corners that its point goes round in a moment: samples between those that are far
/// apart.
std::vector<Sample> with_corners(const Problem& problem, const Design& design, std::size_t guided,
                                 const std::vector<Sample>& even) {
    double mean = 0;
    for (std::size_t k = 1; k < even.size(); ++k)
        mean += distance(even[k - 1], even[k]) / static_cast<double>(even.size());
    std::vector<Sample> all;
    for (std::size_t k = 0; k < even.size(); ++k) {
        if (k > 0 && distance(even[k - 1], even[k]) > long_chord * mean)
            for (int i = 1; i < samples_round_corner; ++i) {
                Sample s{even[k - 1].angle + i * (even[k].angle - even[k - 1].angle) / samples_round_corner, {}};
                if (point_at(problem, design, guided, s.angle, s.point, nullptr)) all.push_back(s);
            }
        all.push_back(even[k]);
    }
    return all;
}

std::vector<Sample> sampled_curve(const Problem& problem, const Design& design, std::size_t guided) {
    const Motion motion = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
    std::vector<Sample> curve;
    if (!(motion.from <= motion.to)) return curve;
    for (int i = 0; i <= curve_samples; ++i) {
        Sample s{motion.from + i * (motion.to - motion.from) / curve_samples, {}};
        if (point_at(problem, design, guided, s.angle, s.point, nullptr)) curve.push_back(s);
    }
    return with_corners(problem, design, guided, curve);
}

/// The crank angle at which the distance from a target is least between two samples around a third.
double refined(const Problem& problem, const Design& design, std::size_t guided, const Vector<double>& target,
               double left, double right, double middle) {
    const auto slope = [&](double angle) {
        Vector<double> point;
        Vector<double> tangent;
        point_at(problem, design, guided, angle, point, &tangent);
        return dot(point - target, tangent);
    };
    const double at_left = slope(left);
    const double at_right = slope(right);
    if (!(at_left < 0 && at_right > 0)) return middle;
    return zero_between(slope, left, right, at_left, at_right);
}

/// The points of one target, by the curve that is guided along them.
void meet_points(const Problem& problem, std::size_t guided, Design& design) {
    const std::vector<Sample> curve = sampled_curve(problem, design, guided);
    if (curve.empty()) return;
    const auto last = curve.size() - 1;
    const Motion motion = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
    const PointRange points = problem.path->points_of(guided);
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const Vector<double>& target = problem.path->points[i];
        const auto square = [&](const Vector<double>& p) { return dot(p - target, p - target); };
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k <= last; ++k) {
            // Round a full turn the first sample follows the last but one.
            const std::size_t before = k > 0 ? k - 1 : motion.full_turn ? last - 1 : 0;
            const std::size_t after = k < last ? k + 1 : motion.full_turn ? 1 : last;
            const double here = square(curve[k].point);
            if (here > square(curve[before].point) || here > square(curve[after].point)) continue;
            const double turn = motion.to - motion.from;
            const double left = k > 0 ? curve[before].angle : curve[before].angle - turn;
            const double right = k < last ? curve[after].angle : curve[after].angle + turn;
            const bool at_end = !motion.full_turn && (k == 0 || k == last);
            const double angle =
                at_end ? curve[k].angle : refined(problem, design, guided, target, left, right, curve[k].angle);
            Vector<double> point;
            if (!point_at(problem, design, guided, angle, point, nullptr)) continue;
            if (square(point) < least) {
                least = square(point);
                design.path_angles[i] = angle;
            }
        }
    }
}

}  // namespace

void set_prescribed_angles(const Problem& problem, Design& design) {
    const PathTarget& path = *problem.path;
    design.path_angles.resize(path.crank_angles.size());
    for (std::size_t i = 0; i < path.crank_angles.size(); ++i)
        design.path_angles[i] =
            design.dimensions[problem.mechanism->roles_of(path.target_of(i)).start] + path.crank_angles[i];
}

void meet_nearest_points(const Problem& problem, Design& design) {
    for (std::size_t target = 0; target < problem.path->targets(); ++target)
        meet_points(problem, target, design);
}

}  // namespace mechwright
