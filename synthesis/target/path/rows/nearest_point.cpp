#include "synthesis/target/path/rows/nearest_point.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "analysis/numbers/extremes.h"
#include "synthesis/program/program.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

/// Samples of the curve; a coupler curve is of degree six and has few local minima of distance, far apart.
constexpr int curve_samples = 360;
/// Chords are divided, again and again, that are longer than so many times the mean one or, near the targets, than that
/// part of their box; each time into no more parts than so many.
constexpr double long_chord = 2;
constexpr double part_of_box = 1.0 / 60;
constexpr int divisions = 6;
constexpr int most_parts = 16;
/// At the ends of a limited motion velocities are infinite, and rounding gives them any sign: slopes are taken so far
/// from an end, as a part of the interval.
constexpr double inset = 1e-11;
constexpr int most_doublings = 44;
/// Where the nearest sample is, the curve is looked at again in so many parts between its neighbours.
constexpr std::size_t finer_parts = 8;

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

/// The box of the targets of one path.
struct Box {
    Vector<double> low{unlimited, unlimited};
    Vector<double> high{-unlimited, -unlimited};

    double diagonal() const { return std::hypot(high.x - low.x, high.y - low.y); }
    /// Whether a curve between two samples may come near it.
    bool is_near(const Sample& a, const Sample& b) const {
        const double around = distance(a, b) + diagonal();
        return std::min(a.point.x, b.point.x) - around < high.x && std::max(a.point.x, b.point.x) + around > low.x &&
               std::min(a.point.y, b.point.y) - around < high.y && std::max(a.point.y, b.point.y) + around > low.y;
    }
};

Box box_of(const Problem& problem, const PointRange& points) {
    Box box;
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const Vector<double>& p = problem.path->points[i];
        box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
        box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
    }
    return box;
}

/// The samples and, where chords are long, others between them: next to a change point a curve has corners that its
/// point goes round in a moment, and of a great curve only a small part may be near the targets.
std::vector<Sample> divided(const Problem& problem, const Design& design, std::size_t guided, const Box& box,
                            double longest, const std::vector<Sample>& samples) {
    std::vector<Sample> all;
    for (std::size_t k = 0; k < samples.size(); ++k) {
        if (k > 0) {
            const Sample& before = samples[k - 1];
            const double chord = distance(before, samples[k]);
            const double near_targets = part_of_box * box.diagonal();
            const double allowed = box.is_near(before, samples[k]) ? std::min(longest, near_targets) : longest;
            const int parts = chord > allowed ? static_cast<int>(std::min<double>(chord / allowed + 1, most_parts)) : 1;
            for (int i = 1; i < parts; ++i) {
                Sample s{before.angle + i * (samples[k].angle - before.angle) / parts, {}};
                if (point_at(problem, design, guided, s.angle, s.point, nullptr)) all.push_back(s);
            }
        }
        all.push_back(samples[k]);
    }
    return all;
}

/// The crank angle nearest to an end of the motion at which it is sure where the point is: so far inwards, which may be
/// negative, or twice as far, again and again; then halved. The end itself where nothing ends there.
double sure_end(const Problem& problem, const Design& design, std::size_t guided, double end, double inwards) {
    constexpr int halvings = 50;
    const double wanted = judged_part * longest_length(*problem.mechanism, design.dimensions);
    const auto is_sure = [&](double way) {
        PathMiss miss{};
        miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly, guided), design.dimensions,
                      end + way, {0, 0}, miss);
        return miss.margin >= wanted;
    };
    if (is_sure(0)) return end;
    double far = inwards;
    for (int doubled = 0; !is_sure(far) && doubled < most_doublings; ++doubled)
        far *= 2;
    double near = 0;
    for (int i = 0; i < halvings; ++i) {
        const double middle = 0.5 * (near + far);
        (is_sure(middle) ? far : near) = middle;
    }
    return end + far;
}

std::vector<Sample> sampled_curve(const Problem& problem, const Design& design, std::size_t guided, const Box& box) {
    const Motion motion = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
    std::vector<Sample> curve;
    if (!(motion.from <= motion.to)) return curve;
    const double rounding = (motion.to - motion.from) * std::numeric_limits<double>::epsilon();
    const double from = motion.full_turn ? motion.from : sure_end(problem, design, guided, motion.from, rounding);
    const double to = motion.full_turn ? motion.to : sure_end(problem, design, guided, motion.to, -rounding);
    for (int i = 0; i <= curve_samples; ++i) {
        Sample s{i == curve_samples ? to : from + i * (to - from) / curve_samples, {}};
        if (point_at(problem, design, guided, s.angle, s.point, nullptr)) curve.push_back(s);
    }
    double length = 0;
    for (std::size_t k = 1; k < curve.size(); ++k)
        length += distance(curve[k - 1], curve[k]);
    for (int i = 0; i < divisions; ++i)
        curve = divided(problem, design, guided, box, long_chord * length / curve_samples, curve);
    return curve;
}

/// The crank angle between two at which the distance from a target is least; `otherwise` where it is not least there.
double refined(const Problem& problem, const Design& design, std::size_t guided, const Vector<double>& target,
               double left, double right, double otherwise) {
    const auto slope = [&](double angle) {
        Vector<double> point;
        Vector<double> tangent;
        point_at(problem, design, guided, angle, point, &tangent);
        return dot(point - target, tangent);
    };
    const double beside = inset * (right - left);
    const double at_left = slope(left + beside);
    const double at_right = slope(right - beside);
    if (!(at_left < 0 && at_right > 0)) return otherwise;
    return zero_between(slope, left + beside, right - beside, at_left, at_right);
}

/// The crank angles between two at which the distance from a target is least, looked for in finer parts: next to change
/// points there are several of them between samples. With them the angle that is `known` to be less far than both.
std::vector<double> nearest_between(const Problem& problem, const Design& design, std::size_t guided,
                                    const Vector<double>& target, double left, double right, double known) {
    std::array<double, finer_parts + 1> angles{}, squares{};
    for (std::size_t i = 0; i < angles.size(); ++i) {
        angles[i] = i == finer_parts ? right : left + static_cast<double>(i) / finer_parts * (right - left);
        Vector<double> point;
        const bool assembled = point_at(problem, design, guided, angles[i], point, nullptr);
        squares[i] = assembled ? dot(point - target, point - target) : std::numeric_limits<double>::infinity();
    }
    std::vector<double> all{known};
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const std::size_t before = i > 0 ? i - 1 : 0, after = std::min(i + 1, angles.size() - 1);
        if (squares[i] > squares[before] || squares[i] > squares[after]) continue;
        all.push_back(refined(problem, design, guided, target, angles[before], angles[after], known));
    }
    return all;
}

/// The points of one target, by the curve that is guided along them.
void meet_points(const Problem& problem, std::size_t guided, Design& design) {
    const PointRange points = problem.path->points_of(guided);
    const std::vector<Sample> curve = sampled_curve(problem, design, guided, box_of(problem, points));
    if (curve.empty()) return;
    design.path_angles.resize(problem.path->points.size());
    const auto last = curve.size() - 1;
    const Motion motion = motion_of(*problem.mechanism, design.dimensions, design.assembly, nullptr);
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
            const bool first = k == 0 && !motion.full_turn;
            const bool final = k == last && !motion.full_turn;
            const double left = k > 0 || first ? curve[before].angle : curve[before].angle - turn;
            const double right = k < last || final ? curve[after].angle : curve[after].angle + turn;
            for (const double angle : nearest_between(problem, design, guided, target, left, right, curve[k].angle)) {
                Vector<double> point;
                if (!point_at(problem, design, guided, angle, point, nullptr) || !(square(point) < least)) continue;
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
