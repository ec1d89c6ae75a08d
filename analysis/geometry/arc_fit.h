#pragma once
/// \file
/// A smooth curve as circular arcs within a tolerance: each arc as long as the tolerance lets it be.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "analysis/geometry/vector.h"

namespace mechwright {

/// Start of an arc (or line) to the next vertex. The bulge is the tangent of a quarter of the arc's angle, positive to
/// the left, 0 for a line: what DXF files have.
struct ArcVertex {
    Vector<double> at;
    double bulge;
};

/// The bulge of the arc from a to b through m.
inline double bulge_through(const Vector<double>& a, const Vector<double>& m, const Vector<double>& b) {
    // The angle at m over the chord is pi less half the arc's angle.
    const Vector<double> to_a = a - m, to_b = b - m;
    const double turn = std::atan2(cross(to_b, to_a), dot(to_b, to_a));
    const double half = turn > 0 ? std::numbers::pi - turn : -std::numbers::pi - turn;
    return std::tan(0.5 * half);
}

/// Distance of a point from the arc of a vertex to `b`, half a circle at most.
inline double distance_from_arc(const ArcVertex& a, const Vector<double>& b, const Vector<double>& p) {
    const Vector<double> chord = b - a.at;
    const double length = std::hypot(chord.x, chord.y);
    const Vector<double> from = p - a.at, to = p - b;
    if (length == 0) return std::hypot(from.x, from.y);
    // Tangents at the ends: the chord, turned by half of the arc's angle to either side.
    const double square = a.bulge * a.bulge, cosine = (1 - square) / (1 + square), sine = 2 * a.bulge / (1 + square);
    if (dot(from, turned(chord, {cosine, -sine})) < 0) return std::hypot(from.x, from.y);
    if (dot(to, turned(chord, {cosine, sine})) > 0) return std::hypot(to.x, to.y);
    const double along = dot(from, chord) / length, left = cross(chord, from) / length;
    if (std::abs(a.bulge) < 1e-12) return std::abs(left);
    // Centre on the perpendicular bisector; the sagitta is bulge * length / 2 to the right of the chord.
    const double sagitta = -0.5 * a.bulge * length;
    const double centre = 0.5 * (sagitta - 0.25 * length * length / sagitta);
    return std::abs(std::hypot(along - 0.5 * length, left - centre) - std::abs(sagitta - centre));
}

/// Appends the vertices of arcs that follow curve(t), t from `from` to `to`, to `vertices`; the end is left to what
/// comes next. No point of the curve between is farther from its arc than the tolerance, as `samples` points on each
/// arc show; except where even an arc of 1e-9 of the range is farther, at corners or where the tolerance is less than
/// the rounding of the curve: there arcs are forced, each twice as long as the one before. Where the curve is not
/// finite the arcs end.
template <class Curve>
void fit_arcs(const Curve& curve, double from, double to, double tolerance, std::vector<ArcVertex>& vertices) {
    constexpr int samples = 64;
    constexpr double margin = 0.95;  // between samples the curve can deviate a little more
    const auto arc = [&](double a, double b) {
        const Vector<double> start = curve(a);
        return ArcVertex{start, bulge_through(start, curve(0.5 * (a + b)), curve(b))};
    };
    const auto follows = [&](double a, double b) {
        const ArcVertex v = arc(a, b);
        const Vector<double> end = curve(b);
        if (!(std::abs(v.bulge) <= 1)) return false;  // half a circle at most
        for (int i = 1; i < samples; ++i)
            if (!(distance_from_arc(v, end, curve(a + (b - a) * i / samples)) <= margin * tolerance)) return false;
        return true;
    };
    constexpr double shortest = 1e-9;
    const auto finite = [&](const Vector<double>& p) { return std::isfinite(p.x) && std::isfinite(p.y); };
    double forced = shortest;
    for (double a = from; a < to && finite(curve(a));) {
        double good = a, bad = to;
        if (follows(a, to)) {
            good = to;
        } else {
            for (int i = 0; i < 40 && bad - good > 1e-4 * (bad - a); ++i) {
                const double middle = 0.5 * (good + bad);
                (follows(a, middle) ? good : bad) = middle;
            }
            const bool follows_nowhere = good < a + shortest * (to - from);
            if (follows_nowhere) good = std::min(to, a + forced * (to - from));
            forced = follows_nowhere ? 2 * forced : shortest;
        }
        vertices.push_back(arc(a, good));
        a = good;
    }
}

}  // namespace mechwright
