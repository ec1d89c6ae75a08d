#pragma once
/// \file
/// Curves of four-bars that tests fit to points in any order.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "analysis/four_bar.h"
#include "synthesis/problem/reader.h"
#include "synthesis/search/curve/descent.h"

namespace mechwright::whole_curves {

using std::numbers::pi;

inline const std::string wide_ranges =
    "ground = { min = 1, max = 200 }\ncrank = { min = 1, max = 200 }\ncoupler = { min = 1, max = 200 }\n"
    "rocker = { min = 1, max = 200 }\npoint-along = { min = -200, max = 200 }\n"
    "point-across = { min = -200, max = 200 }\norigin-x = { min = -200, max = 200 }\n"
    "origin-y = { min = -200, max = 200 }\ntilt = { min = 0, max = 360 }\n";

inline Problem problem_of(const std::vector<Vector<double>>& points, const std::string& of_path = "",
                          const std::string& objective = "path-rms") {
    std::string list;
    for (const Vector<double>& p : points)
        list += (list.empty() ? "[" : ", [") + std::to_string(p.x) + ", " + std::to_string(p.y) + "]";
    const ReadProblem read =
        parse_problem("schema = 1\nmechanism = \"four-bar\"\n[dimensions]\n" + wide_ranges +
                          "assembly = \"either\"\n[path]\npoints = [" + list + "]\ntiming = \"none\"\n" + of_path +
                          "[solver]\nstarts = 1\n[objective]\nminimize = \"" + objective + "\"\n",
                      "curve.toml");
    for (const Message& message : read.messages)
        ADD_FAILURE() << to_string(message);
    return read.problem;
}

inline std::vector<Program> programs_of(const Problem& problem) {
    std::vector<Program> all;
    for (const Variant& variant : variants(problem))
        all.push_back(build_program(problem, variant));
    return all;
}

/// A rounded square of 20 by 20: no coupler curve.
inline std::vector<Vector<double>> rounded_square(int points) {
    std::vector<Vector<double>> all;
    for (int k = 0; k < points; ++k) {
        const double angle = 2 * pi * k / points;
        const auto of = [](double v) { return std::copysign(10 * std::sqrt(std::abs(v)), v); };
        all.push_back({of(std::cos(angle)), of(std::sin(angle))});
    }
    return all;
}

inline Vector<double> coupler_point(const CurveArguments& a, std::size_t assembly, double crank_angle) {
    const FourBar<double> m{a[0], a[1], a[2], a[3]};
    const auto p = pose(m, crank_angle, assembly == 0 ? Assembly::open : Assembly::crossed);
    return placed(position(m, CouplerPoint<double>{a[4], a[5]}, p), Placement<double>{{a[6], a[7]}, a[8]});
}

/// Squared distance of the nearest of very many points of the curve, of those where the linkage assembles by a part of
/// its longest link.
inline double scanned(const CurveArguments& a, std::size_t assembly, const Vector<double>& target, double sure = 0) {
    const FourBar<double> m{a[0], a[1], a[2], a[3]};
    const CrankRange<double> range = assembled_range(m);
    const double longest = std::max({m.ground, m.crank, m.coupler, m.rocker});
    constexpr int points = 8000;
    double least = unlimited;
    for (int k = 0; k <= points; ++k) {
        const double angle = (range.from + range.to) / 2 - (range.to - range.from) / 2 * std::cos(pi * k / points);
        const auto margins = assembly_margins(m, half_turn(angle));
        if (sure > 0 && std::min(margins.stretch, margins.fold) < sure * longest) continue;
        const Vector<double> miss = coupler_point(a, assembly, angle) - target;
        least = std::min(least, dot(miss, miss));
    }
    return least;
}

inline double greatest_distance(const CurveProblem& p, const FittedCurve& design, CurveWork& work) {
    EXPECT_TRUE(find_nearest_points(p, InstructionSet::baseline, design.assembly, design.arguments, work));
    double greatest = 0;
    for (std::size_t i = 0; i < p.targets.count; ++i)
        greatest = std::max(greatest, std::sqrt(work.nearest.square[i / 8][i % 8]));
    return greatest;
}

}  // namespace mechwright::whole_curves
