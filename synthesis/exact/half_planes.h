#pragma once
/// \file
/// The point of a region of the plane that is closest to a target, where the region is an intersection of half-planes:
/// a convex program, solved exactly, with the multipliers that prove its answer.

#include <array>
#include <cstddef>
#include <optional>
#include <span>

#include "analysis/geometry/vector.h"

namespace mechwright {

/// normal . x >= level
struct HalfPlane {
    Vector<double> normal;
    double level;
};

/// The answer: x - target = sum of multiplier * normal over the binding half-planes, multipliers >= 0 (Karush, Kuhn and
/// Tucker), which no other point of the region can have.
struct ClosestPoint {
    Vector<double> at;
    std::array<std::size_t, 2> binding{};
    std::array<double, 2> multiplier{};
    std::size_t binding_count = 0;
};

/// Nothing where no point lies in all half-planes. Normals differ from zero; `rounding` is the distance by which a
/// point may lie outside and still counts as inside.
std::optional<ClosestPoint> closest_point(const Vector<double>& target, std::span<const HalfPlane> region,
                                          double rounding);

}  // namespace mechwright
