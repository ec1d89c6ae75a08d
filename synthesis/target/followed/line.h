#pragma once
/// \file
/// A straight line that a guided point follows.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "synthesis/target/followed/formulas.h"

namespace mechwright {

/// A line by its direction in the drawing and its offset: the distance from the drawing's origin, positive to the left.
struct LineShape {
    static constexpr std::string_view name = "line";
    static constexpr std::size_t parameters = 2;
    static std::vector<Dimension> numbers() {
        return {
            number_of_target("line-angle", DimensionKind::angle, "direction in the drawing of a line to be followed"),
            number_of_target("line-offset", DimensionKind::coordinate,
                             "distance of that line from the drawing's origin, to its left")};
    }
    static ShapeTexts texts() {
        return {"line-deviation", "line-length", "way along the line between the two ends of the stretch",
                Unit::length};
    }
    static bool is_followed(const Motion& motion) { return motion.followed == Followed::line; }

    /// Positive to the left of the line's direction.
    template <class T>
    static T distance(const std::array<T, parameters>& line, const Vector<T>& p) {
        using std::cos, std::sin;
        return cross(Vector<T>{cos(line[0]), sin(line[0])}, p) - line[1];
    }

    /// The way along the line from one point to another.
    template <class T>
    static T extent(const std::array<T, parameters>& line, const Vector<T>& from, const Vector<T>& to) {
        using std::abs, std::cos, std::sin;
        return abs(dot(Vector<T>{cos(line[0]), sin(line[0])}, to - from));
    }

    /// The principal axis of the points, in the middle of their band.
    static void fit(const StretchPoints& points, std::array<bool, parameters> free,
                    std::array<double, parameters>& line) {
        Vector<double> mean{0, 0};
        for (const Vector<double>& p : points)
            mean = mean + (1 / static_cast<double>(points.size())) * p;
        double xx = 0, xy = 0, yy = 0;
        for (const Vector<double>& p : points) {
            const Vector<double> d = p - mean;
            xx += d.x * d.x;
            xy += d.x * d.y;
            yy += d.y * d.y;
        }
        if (free[0]) line[0] = 0.5 * std::atan2(2 * xy, xx - yy);
        double least = std::numeric_limits<double>::infinity(), greatest = -least;
        for (const Vector<double>& p : points) {
            const double d = distance({line[0], 0.0}, p);
            least = std::min(least, d);
            greatest = std::max(greatest, d);
        }
        if (free[1]) line[1] = 0.5 * (least + greatest);
    }
};

}  // namespace mechwright
