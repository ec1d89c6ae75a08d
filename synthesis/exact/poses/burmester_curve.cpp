#include "synthesis/exact/poses/burmester_curve.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "synthesis/exact/poses/dyad_equation.h"
#include "synthesis/exact/poses/orthogonal_basis.h"

namespace mechwright {

namespace {

using Conditions = Eigen::Matrix<double, 3, 7>;
/// fixed.x, fixed.y, moving.x, moving.y
using Point = Eigen::Vector4d;
using Slopes = Eigen::Matrix<double, 3, 4>;

constexpr std::size_t most_steps = 100000;  ///< along one stretch

Dyad dyad_at(const Point& z) { return {{z[0], z[1]}, {z[2], z[3]}}; }
Point point_of(const Dyad& dyad) {
    return {dyad.fixed.real(), dyad.fixed.imag(), dyad.moving.real(), dyad.moving.imag()};
}

struct Equations {
    Eigen::Vector3d values;
    Slopes slopes;
};

Equations equations_at(const Conditions& c, const Point& z) {
    Equations out;
    for (Eigen::Index i = 0; i < 3; ++i) {
        const auto equation = dyad_equation(c.row(i), z[0], z[1], z[2], z[3]);
        out.values[i] = equation.value;
        out.slopes.row(i) = Eigen::Map<const Eigen::RowVector4d>(equation.slopes.data());
    }
    return out;
}

/// The direction of the curve, in the sense of another.
Point tangent_at(const Conditions& c, const Point& z, const Point& sense) {
    const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 4, 3>> qr(equations_at(c, z).slopes.transpose());
    const Point tangent = orthogonal_basis(qr).col(3);
    return tangent.dot(sense) < 0 ? Point(-tangent) : tangent;
}

/// Newton's corrections square to the curve; false where they do not converge.
bool correct(const Conditions& c, Point& z) {
    constexpr int most = 8;
    for (int k = 0; k < most; ++k) {
        const auto [values, s] = equations_at(c, z);
        const Point change = s.transpose() * (s * s.transpose()).ldlt().solve(values);
        if (!change.allFinite()) return false;
        z -= change;
        if (change.norm() <= 1e-13 * (1 + z.norm())) return true;
    }
    return false;
}

/// A step along the curve, in parts where it bends; nothing where it cannot be followed.
struct CurvePlace {
    Point at;
    Point tangent;
};

std::optional<CurvePlace> advanced(const Conditions& c, CurvePlace place, double step) {
    constexpr double least_part = 1e-4, sharpest_bend = 0.95;  // cosine
    double left = step, part = step;
    while (left > 1e-12 * step) {
        part = std::min(part, left);
        CurvePlace next{place.at + part * place.tangent, {}};
        const bool on_curve = correct(c, next.at);
        if (on_curve) next.tangent = tangent_at(c, next.at, place.tangent);
        if (on_curve && next.tangent.dot(place.tangent) > sharpest_bend && (next.at - place.at).norm() < 1.5 * part) {
            left -= part;
            part *= 2;
            place = next;
        } else if ((part *= 0.5) < least_part * step) {
            return {};
        }
    }
    return place;
}

struct Traced {
    std::vector<Point> points;
    bool closed = false;
};

Traced traced(const Conditions& c, const Point& start, const Point& sense, double step, double reach) {
    Traced out;
    CurvePlace place{start, tangent_at(c, start, sense)};
    for (std::size_t k = 0; k < most_steps; ++k) {
        const auto next = advanced(c, place, step);
        if (!next || next->at.norm() > reach) break;
        // Round a closed stretch the start is passed between two points.
        const Point way = next->at - place.at, to_start = start - place.at;
        const double along = to_start.dot(way) / way.squaredNorm();
        if (k > 1 && along >= 0 && along < 1 && (to_start - along * way).norm() < 0.2 * step) {
            out.closed = true;
            break;
        }
        place = *next;
        out.points.push_back(place.at);
    }
    return out;
}

bool is_on(const std::vector<BurmesterStretch>& stretches, const Point& z, double step) {
    for (const BurmesterStretch& stretch : stretches)
        for (const Dyad& dyad : stretch.dyads)
            if ((point_of(dyad) - z).norm() < step) return true;
    return false;
}

BurmesterStretch stretch_through(const Conditions& c, const Point& start, double step, double reach) {
    const Point sense = Point::Ones();
    const Traced ahead = traced(c, start, sense, step, reach);
    BurmesterStretch stretch;
    stretch.closed = ahead.closed;
    if (!ahead.closed) {
        const Traced back = traced(c, start, -sense, step, reach);
        for (auto at = back.points.rbegin(); at != back.points.rend(); ++at)
            stretch.dyads.push_back(dyad_at(*at));
    }
    stretch.dyads.push_back(dyad_at(start));
    for (const Point& z : ahead.points)
        stretch.dyads.push_back(dyad_at(z));
    return stretch;
}

}  // namespace

std::vector<BurmesterStretch> burmester_curves(std::span<const Displacement, 3> displacements, double step,
                                               double reach) {
    constexpr int lines = 96;
    Conditions c;
    DyadConditions with_line;
    for (Eigen::Index i = 0; i < 3; ++i)
        with_line.row(i) = c.row(i) = condition_of(displacements[static_cast<std::size_t>(i)]);
    std::vector<BurmesterStretch> stretches;
    for (int k = 0; k < lines; ++k) {
        // Every stretch that is not small meets some of these lines, or has its moving pivots on one.
        const std::complex<double> point(0.1, -0.2), direction = std::polar(1.0, std::numbers::pi * k / lines);
        for (const bool of_fixed : {true, false}) {
            with_line.row(3) =
                of_fixed ? fixed_pivot_on_line(point, direction) : moving_pivot_on_line(point, direction);
            for (const ComplexDyad& found : dyads_meeting(with_line).dyads) {
                const auto dyad = real_dyad(found);
                if (!dyad || point_of(*dyad).norm() > reach || is_on(stretches, point_of(*dyad), 1.5 * step)) continue;
                stretches.push_back(stretch_through(c, point_of(*dyad), step, reach));
            }
        }
    }
    return stretches;
}

}  // namespace mechwright
