#pragma once
/// \file
/// The point of a region of the plane that is closest to a target, where the region is an intersection of half-planes:
/// a convex program, solved with the weights that prove its answer.

#include <array>
#include <cstddef>
#include <span>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// normal . x >= level
template <class T>
struct HalfPlane {
    Vector<T> normal;
    T level;
};

/// How far from a target every point of a region is at least, by non-negative weights of its half-planes: their
/// weighted sum is a half-plane that holds the region too (Farkas; Karush, Kuhn and Tucker). Where it says 0 >= more
/// than 0, the region is empty and the distance infinite; 0 where the weights say nothing, or one is negative.
template <class T>
T distance_by_weights(const Vector<T>& target, std::span<const HalfPlane<T>> region, std::span<const T> weights) {
    Vector<T> normal{T(0), T(0)};
    T missed(0);
    for (std::size_t i = 0; i < region.size(); ++i) {
        if (!(weights[i] >= 0)) return T(0);
        normal = normal + weights[i] * region[i].normal;
        missed += weights[i] * (region[i].level - dot(region[i].normal, target));
    }
    using std::sqrt;
    if (!(missed > 0)) return T(0);
    const T length = sqrt(dot(normal, normal));
    return length > 0 ? T(missed / length) : std::numeric_limits<T>::infinity();
}

enum class Region { holds_the_point, is_empty, is_unknown };

/// The point, and the half-planes with the weights that show that no other point of the region is closer, or that the
/// region is empty. The point then is the closest one of a part of the half-planes.
struct ClosestPoint {
    Region region = Region::holds_the_point;
    Vector<double> at;
    std::array<std::size_t, 3> binding{};
    std::array<double, 3> weight{};
    std::size_t binding_count = 0;
};

/// Normals differ from zero. Boundaries may be as close to parallel as they like: all is computed in fifty digits.
ClosestPoint closest_point(const Vector<double>& target, std::span<const HalfPlane<double>> region);

}  // namespace mechwright
