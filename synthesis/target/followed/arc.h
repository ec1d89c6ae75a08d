#pragma once
/// \file
/// A circular arc that a guided point follows.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "analysis/numbers/scalar.h"
#include "synthesis/target/followed/formulas.h"

namespace mechwright {

/// An arc by its centre and its radius.
struct ArcShape {
    static constexpr std::string_view name = "arc";
    static constexpr std::size_t parameters = 3;
    static std::vector<Dimension> numbers() {
        constexpr const char* centre = "centre in the drawing of an arc to be followed";
        return {number_of_target("arc-x", DimensionKind::coordinate, centre),
                number_of_target("arc-y", DimensionKind::coordinate, centre),
                number_of_target("arc-radius", DimensionKind::coordinate, "radius of that arc")};
    }
    static ShapeTexts texts() {
        return {"arc-deviation", "arc-angle", "angle between the two ends of the stretch, seen from the arc's centre",
                Unit::angle};
    }
    static bool is_followed(const Motion& motion) { return motion.followed == Followed::arc; }

    /// Positive outside the circle.
    template <class T>
    static T distance(const std::array<T, parameters>& arc, const Vector<T>& p) {
        const Vector<T> away = p - Vector<T>{arc[0], arc[1]};
        return hypotenuse(away.x, away.y) - arc[2];
    }

    /// The angle between two points, seen from the centre, in [0, pi].
    template <class T>
    static T extent(const std::array<T, parameters>& arc, const Vector<T>& from, const Vector<T>& to) {
        using std::abs, std::atan2;
        const Vector<T> a = from - Vector<T>{arc[0], arc[1]}, b = to - Vector<T>{arc[0], arc[1]};
        return atan2(abs(cross(a, b)), dot(a, b));
    }

    /// The circle through the first, the middle and the last point.
    static void fit(const StretchPoints& points, std::array<bool, parameters> free,
                    std::array<double, parameters>& arc) {
        const Vector<double>&a = points.front(), &b = points[points.size() / 2], &c = points.back();
        const Vector<double> u = b - a, v = c - a;
        const double twice_area = cross(u, v);
        if (twice_area != 0) {
            const Vector<double> centre = a + (0.5 / twice_area) * (dot(v, v) * left_of(u) - dot(u, u) * left_of(v));
            if (free[0]) arc[0] = centre.x;
            if (free[1]) arc[1] = centre.y;
        }
        double least = std::numeric_limits<double>::infinity(), greatest = 0;
        for (const Vector<double>& p : points) {
            const double d = distance({arc[0], arc[1], 0.0}, p);
            least = std::min(least, d);
            greatest = std::max(greatest, d);
        }
        if (free[2]) arc[2] = 0.5 * (least + greatest);
    }
};

}  // namespace mechwright
