#include "synthesis/exact/half_planes.h"

#include <cmath>

namespace mechwright {

namespace {

double length(const Vector<double>& v) { return std::hypot(v.x, v.y); }

/// How far a point lies inside; negative outside.
double inside(const HalfPlane& h, const Vector<double>& x) { return (dot(h.normal, x) - h.level) / length(h.normal); }

bool in_all(const Vector<double>& x, std::span<const HalfPlane> region, double rounding) {
    for (const HalfPlane& h : region)
        if (!(inside(h, x) >= -rounding)) return false;
    return true;
}

ClosestPoint foot(const Vector<double>& target, std::span<const HalfPlane> region, std::size_t i) {
    const HalfPlane& h = region[i];
    const double multiplier = (h.level - dot(h.normal, target)) / dot(h.normal, h.normal);
    return {target + multiplier * h.normal, {i, 0}, {multiplier, 0}, 1};
}

/// Where two boundaries meet; with negative multipliers where they are parallel.
ClosestPoint corner(const Vector<double>& target, std::span<const HalfPlane> region, std::size_t i, std::size_t j) {
    const HalfPlane &a = region[i], &b = region[j];
    const double determinant = cross(a.normal, b.normal);
    if (determinant == 0) return {target, {i, j}, {-1, -1}, 2};
    const double p = a.level - dot(a.normal, target), q = b.level - dot(b.normal, target);
    const Vector<double> step{(p * b.normal.y - q * a.normal.y) / determinant,
                              (q * a.normal.x - p * b.normal.x) / determinant};
    return {target + step, {i, j}, {cross(step, b.normal) / determinant, cross(a.normal, step) / determinant}, 2};
}

}  // namespace

std::optional<ClosestPoint> closest_point(const Vector<double>& target, std::span<const HalfPlane> region,
                                          double rounding) {
    if (in_all(target, region, rounding)) return ClosestPoint{target};
    for (std::size_t i = 0; i < region.size(); ++i)
        if (const ClosestPoint p = foot(target, region, i); p.multiplier[0] >= 0 && in_all(p.at, region, rounding))
            return p;
    std::optional<ClosestPoint> best;
    for (std::size_t i = 0; i < region.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) {
            const ClosestPoint p = corner(target, region, i, j);
            if (!(p.multiplier[0] >= 0 && p.multiplier[1] >= 0) || !in_all(p.at, region, rounding)) continue;
            if (!best || length(p.at - target) < length(best->at - target)) best = p;
        }
    return best;
}

}  // namespace mechwright
