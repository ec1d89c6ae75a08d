#include "synthesis/exact/closed_form/half_planes.h"

#include <limits>
#include <vector>

namespace mechwright {

namespace {

using Fine = Digits50;
using Plane = HalfPlane<Fine>;

/// What is active: the closest point of these half-planes lies on all their boundaries.
struct Active {
    std::array<std::size_t, 3> plane{};
    std::array<Fine, 3> weight{};
    std::size_t count = 0;
    Vector<Fine> step{Fine(0), Fine(0)};  ///< from the target to the point
};

/// Levels count from the target; normals have length 1.
std::vector<Plane> seen_from(const Vector<double>& target, std::span<const HalfPlane<double>> region) {
    std::vector<Plane> planes;
    const Vector<Fine> from{target.x, target.y};
    for (const HalfPlane<double>& h : region) {
        const Vector<Fine> normal{h.normal.x, h.normal.y};
        const Fine scale = 1 / sqrt(dot(normal, normal));
        planes.push_back({scale * normal, scale * (h.level - dot(normal, from))});
    }
    return planes;
}

Fine missed_by(const Plane& plane, const Vector<Fine>& step) { return plane.level - dot(plane.normal, step); }

/// Far above the rounding of fifty digits, far below that of what comes in.
constexpr double zero_within = 1e-40;

Active foot(const std::vector<Plane>& planes, std::size_t i) {
    return {{i}, {planes[i].level}, 1, planes[i].level * planes[i].normal};
}

/// Where two boundaries meet; with a negative weight where they are parallel.
Active corner(const std::vector<Plane>& planes, std::size_t i, std::size_t j) {
    const Plane &a = planes[i], &b = planes[j];
    const Fine determinant = cross(a.normal, b.normal);
    if (determinant == 0) return {{i, j}, {-1, -1}, 2};
    const Vector<Fine> step{(a.level * b.normal.y - b.level * a.normal.y) / determinant,
                            (b.level * a.normal.x - a.level * b.normal.x) / determinant};
    return {{i, j}, {cross(step, b.normal) / determinant, cross(a.normal, step) / determinant}, 2, step};
}

bool has_valid_weights(const Active& active) {
    for (std::size_t i = 0; i < active.count; ++i)
        if (!(active.weight[i] >= 0)) return false;
    return true;
}

bool holds_all(const std::vector<Plane>& planes, const Active& before, const Vector<Fine>& step) {
    for (std::size_t i = 0; i < before.count; ++i) {
        const Plane& plane = planes[before.plane[i]];
        if (missed_by(plane, step) > zero_within * (abs(plane.level) + sqrt(dot(step, step)))) return false;
    }
    return true;
}

/// Weights of at most three half-planes by which they exclude each other; none (count 0) where they do not.
Active contradiction(const std::vector<Plane>& planes, const Active& before, std::size_t added) {
    const auto holds = [&](const Active& active) {
        Fine sum(0);
        for (std::size_t i = 0; i < active.count; ++i)
            sum += active.weight[i] * planes[active.plane[i]].level;
        return has_valid_weights(active) && sum > 0;
    };
    const Plane& c = planes[added];
    for (std::size_t i = 0; i < before.count; ++i) {
        const Plane& a = planes[before.plane[i]];
        const Active opposite{{before.plane[i], added}, {1, 1}, 2};
        if (cross(a.normal, c.normal) == 0 && dot(a.normal, c.normal) < 0 && holds(opposite)) return opposite;
    }
    if (before.count < 2) return {};
    const Plane &a = planes[before.plane[0]], &b = planes[before.plane[1]];
    Active all{{before.plane[0], before.plane[1], added},
               {cross(b.normal, c.normal), cross(c.normal, a.normal), cross(a.normal, b.normal)},
               3};
    if (all.weight[2] < 0)
        for (Fine& weight : all.weight)
            weight = -weight;
    return holds(all) ? all : Active{};
}

/// The closest point of some half-planes and one more, which it misses.
Active with_one_more(const std::vector<Plane>& planes, const Active& before, std::size_t added) {
    if (const Active one = foot(planes, added); has_valid_weights(one) && holds_all(planes, before, one.step))
        return one;
    for (std::size_t i = 0; i < before.count; ++i)
        if (const Active two = corner(planes, before.plane[i], added);
            has_valid_weights(two) && holds_all(planes, before, two.step))
            return two;
    return {};
}

ClosestPoint rounded(Region region, const Vector<double>& target, std::span<const HalfPlane<double>> given,
                     const Active& active) {
    const auto plain = [](const Fine& x) { return x.convert_to<double>(); };
    ClosestPoint out{region, {plain(target.x + active.step.x), plain(target.y + active.step.y)}};
    out.binding_count = active.count;
    for (std::size_t i = 0; i < active.count; ++i) {
        const Vector<Fine> normal{given[active.plane[i]].normal.x, given[active.plane[i]].normal.y};
        out.binding[i] = active.plane[i];
        out.weight[i] = plain(active.weight[i] / sqrt(dot(normal, normal)));
    }
    return out;
}

}  // namespace

/// The half-plane that is missed most is added, one after the other, to those that hold the point (Goldfarb and
/// Idnani's dual method): the distance grows with each, so that none comes twice with the same others.
ClosestPoint closest_point(const Vector<double>& target, std::span<const HalfPlane<double>> region) {
    const std::vector<Plane> planes = seen_from(target, region);
    Active active;
    for (std::size_t step = 0; step < 20 * planes.size() + 20; ++step) {
        std::size_t worst = planes.size();
        Fine most(0);
        for (std::size_t i = 0; i < planes.size(); ++i) {
            const Fine missed = missed_by(planes[i], active.step);
            if (missed > zero_within * (abs(planes[i].level) + sqrt(dot(active.step, active.step))) && missed > most) {
                most = missed;
                worst = i;
            }
        }
        if (worst == planes.size()) return rounded(Region::holds_the_point, target, region, active);
        const Active next = with_one_more(planes, active, worst);
        if (next.count == 0) {
            const Active none = contradiction(planes, active, worst);
            return rounded(none.count > 0 ? Region::is_empty : Region::is_unknown, target, region, none);
        }
        active = next;
    }
    return rounded(Region::is_unknown, target, region, active);
}

}  // namespace mechwright
