#include "synthesis/verify/proofs/timed_path_again.h"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

namespace mechwright {

namespace {

using Complex = std::complex<double>;
constexpr std::size_t parameters = 4;
using UnitCubePoint = std::array<double, parameters>;  ///< each in [0, 1]

constexpr double none = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;

double plain(const Digits50& value) { return value.convert_to<double>(); }

struct TimedPath {
    const Claim& claim;
    std::vector<double> angles;
    std::vector<Complex> points;
    std::vector<double> weights;

    double angle(double stated) const { return plain(from_document(stated, Unit::angle, claim.units)); }
    /// Least and greatest of a dimension; of one that is tied to another nothing is known.
    std::array<double, 2> range(std::size_t i, bool is_angle) const {
        const auto& given = claim.given[i];
        if (!given) return {0, 0};
        if (given->tied()) return {-none, none};
        if (!is_angle) return {given->min, given->max};
        return {angle(given->min), angle(given->max)};
    }
    bool fixed(std::size_t i) const { return range(i, false)[0] == range(i, false)[1]; }

    /// The least sum for ground, coupler and rocker in cranks and a start.
    double sum_at(const UnitCubePoint& place) const {
        const PathRoles& roles = claim.mechanism->point->roles;
        constexpr double widest = 3;  // of the logarithms of ratios
        std::array<double, 3> link{};
        for (std::size_t k = 0; k < link.size(); ++k)
            link[k] = std::exp(widest * (2 * place[k] - 1));
        const auto [ground, coupler, rocker] = link;
        const auto [from, to] = range(roles.start, true);
        const double start = from + place[3] * (std::min(to, from + 2 * pi) - from);
        const auto n = static_cast<Eigen::Index>(points.size());
        std::vector<Complex> crank_at, coupler_at;
        for (const double a : angles) {
            const Complex crank = std::polar(1.0, start + a), diagonal = ground - crank;
            const double length = std::abs(diagonal);
            const double cosine = (length * length + coupler * coupler - rocker * rocker) / (2 * coupler * length);
            if (!(std::abs(cosine) < 1)) return none;
            const double side = claim.assembly == 0 ? 1 : -1;
            crank_at.push_back(crank);
            coupler_at.push_back(diagonal / length * std::polar(1.0, side * std::acos(cosine)));
        }
        // Columns of what is free: origin, crank, guided point; real parts above imaginary ones.
        std::vector<Eigen::VectorXd> columns;
        const auto column = [&](const auto& at) {
            Eigen::VectorXd v(2 * n);
            for (Eigen::Index i = 0; i < n; ++i) {
                const Complex z = std::sqrt(weights[static_cast<std::size_t>(i)]) * at(static_cast<std::size_t>(i));
                v[i] = z.real();
                v[n + i] = z.imag();
            }
            return v;
        };
        const Complex quarter(0, 1);
        const double tilt = range(roles.tilt, true)[0];
        Complex origin = 0;
        if (fixed(roles.origin_x))
            origin += range(roles.origin_x, false)[0];
        else
            columns.push_back(column([](std::size_t) { return Complex(1, 0); }));
        if (fixed(roles.origin_y))
            origin += quarter * range(roles.origin_y, false)[0];
        else
            columns.push_back(column([&](std::size_t) { return quarter; }));
        const auto first_crank = static_cast<Eigen::Index>(columns.size());
        const bool turned = fixed(roles.tilt);
        const Complex frame = turned ? std::polar(1.0, tilt) : Complex(1, 0);
        columns.push_back(column([&](std::size_t i) { return frame * crank_at[i]; }));
        if (!turned) columns.push_back(column([&](std::size_t i) { return quarter * crank_at[i]; }));
        const auto first_point = static_cast<Eigen::Index>(columns.size());
        columns.push_back(column([&](std::size_t i) { return coupler_at[i]; }));
        columns.push_back(column([&](std::size_t i) { return quarter * coupler_at[i]; }));
        Eigen::MatrixXd matrix(2 * n, static_cast<Eigen::Index>(columns.size()));
        for (Eigen::Index k = 0; k < matrix.cols(); ++k)
            matrix.col(k) = columns[static_cast<std::size_t>(k)];
        const Eigen::VectorXd target = column([&](std::size_t i) { return points[i] - origin; });
        const Eigen::VectorXd x = matrix.colPivHouseholderQr().solve(target);
        const double crank = turned ? x[first_crank] : std::hypot(x[first_crank], x[first_crank + 1]);
        const double reach_along =
            std::max(std::abs(range(roles.along, false)[0]), std::abs(range(roles.along, false)[1]));
        const double reach_across =
            std::max(std::abs(range(roles.across, false)[0]), std::abs(range(roles.across, false)[1]));
        const bool allowed = crank > 0 && crank <= range(1, false)[1] && crank * ground <= range(0, false)[1] &&
                             std::hypot(x[first_point], x[first_point + 1]) <= std::hypot(reach_along, reach_across);
        return allowed ? (matrix * x - target).squaredNorm() : none;
    }
};

/// Evenly spread places (additive recurrence of the root of x^5 = x + 1).
UnitCubePoint spread(int number) {
    constexpr double root = 1.1673039782614187;
    UnitCubePoint place{};
    double step = 1;
    for (double& p : place) {
        step /= root;
        p = std::fmod(0.5 + number * step, 1.0);
    }
    return place;
}

}  // namespace

SearchedLinkages search_timed_path(const Rebuilt& design) {
    const Claim& claim = *design.claim;
    const int samples = std::clamp(300000 / static_cast<int>(claim.path->points.size()), 100, 6000);
    const int most_steps = samples / 15;
    constexpr int descents = 12;
    TimedPath path{claim, {}, {}, claim.path->weights};
    for (const double a : claim.path->prescribed_angles)
        path.angles.push_back(path.angle(a));
    for (const Vector<double>& p : claim.path->points)
        path.points.emplace_back(p.x, p.y);
    SearchedLinkages found{none, 0};
    std::vector<std::pair<double, UnitCubePoint>> best;
    const auto sum_at = [&](const UnitCubePoint& place) {
        ++found.linkages;
        const double sum = path.sum_at(place);
        found.least = std::min(found.least, sum);
        return sum;
    };
    for (int i = 0; i < samples; ++i)
        best.emplace_back(sum_at(spread(i)), spread(i));
    std::sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    best.resize(descents);
    // Downhill along the axes, with steps that grow where they help and shrink where none does.
    for (auto& [sum, place] : best) {
        UnitCubePoint step;
        step.fill(0.02);
        for (int i = 0; i < most_steps && std::isfinite(sum); ++i) {
            const auto k = static_cast<std::size_t>(i) % parameters;
            UnitCubePoint there = place;
            there[k] = std::clamp(place[k] + step[k], 0.0, 1.0);
            const double value = sum_at(there);
            if (value < sum) {
                sum = value;
                place = there;
                step[k] *= 1.5;
            } else {
                step[k] *= -0.5;
            }
        }
    }
    return found;
}

}  // namespace mechwright
