#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "synthesis/exact/geared/geared_five_bar.h"
#include "synthesis/exact/geared/geared_rows.h"
#include "synthesis/program/quantity_value.h"

namespace mechwright {

namespace {

using Point = std::complex<double>;

constexpr double full_turn = 2 * std::numbers::pi;

/// The crank pin of a dyad once its crank has turned by an angle.
Point pin_at(const Dyad& crank, double angle) { return crank.fixed - crank.moving * std::polar(1.0, angle); }

/// Whether the rods change sides between the places.
bool changes_side(const GearedParts& parts, double speed) {
    const auto side = [&](std::size_t i) {
        const Point from = pin_at(parts.driving, parts.turned[i]), to = pin_at(parts.driven, speed * parts.turned[i]);
        return (std::conj(to - from) * (parts.displacements[i].shift - from)).imag() > 0;
    };
    for (std::size_t i = 1; i < parts.displacements.size(); ++i)
        if (side(i) != side(0)) return true;
    return false;
}

/// Crank angles of the drive at the first place, up to whole turns equal to one: within the range of the start of a
/// timing, where that is given.
std::vector<double> first_angles(const Problem& problem, const Design& some, double angle) {
    const auto& path = *problem.path;
    const int cycle = std::max(problem.mechanism->model.as<LinkageModel>()->turns, 1);
    if (!path.prescribed_timing) return {angle};
    const std::size_t start = problem.mechanism->point->roles.start;
    Design timed = some;
    timed.dimensions[start] = angle - path.crank_angles.front();
    move_angles_into_ranges(problem, timed);
    std::vector<double> all;
    for (int k = 0; k < cycle; ++k)
        if (k == 0 || timed.dimensions[start] + full_turn * k <= problem.dimensions[start].max)
            all.push_back(timed.dimensions[start] + full_turn * k + path.crank_angles.front());
    return all;
}

/// Whether the rods reach each other all along the way from the first place to the last, as far as samples tell:
/// verification looks at all of it.
bool assembles_along(const Problem& problem, const Design& design) {
    constexpr double step = full_turn / 720;
    const auto [from, to] = std::minmax_element(design.path_angles.begin(), design.path_angles.end());
    const int steps = static_cast<int>(std::ceil((*to - *from) / step));
    for (int i = 0; i <= steps; ++i) {
        PathMiss miss{};
        miss_of_point(*problem.mechanism, problem.mechanism->form(design.assembly), design.dimensions,
                      i == steps ? *to : *from + i * step, {0, 0}, miss);
        if (!(miss.margin >= 0)) return false;
    }
    return true;
}

/// The design whose drive stands at an angle at the first place, in the best assembly.
ExactDesign at_angle(const Problem& problem, Design design, const GearedParts& parts, double angle) {
    const auto& path = *problem.path;
    if (path.prescribed_timing)
        design.dimensions[problem.mechanism->point->roles.start] = angle - path.crank_angles.front();
    std::vector<double> angles;
    for (const double turned : parts.turned)
        angles.push_back(angle + turned);
    std::optional<ExactDesign> best;
    for (const std::size_t assembly : problem.assemblies) {
        Design one = design;
        one.assembly = assembly;
        if (path.prescribed_timing) {
            one.path_angles = angles;
            keep_better(problem, best, exact_design(problem, std::move(one)));
        } else {
            keep_better(problem, best, exact_design(problem, std::move(one), angles));
        }
    }
    if (best->defect.empty() && !assembles_along(problem, best->solution.design))
        return excluded_design(std::move(best->solution.design),
                               "circuit: it does not assemble everywhere between the targets");
    return *std::move(best);
}

}  // namespace

ExactDesign geared_design(const Problem& problem, const GearedFiveBar& bars, const GearedParts& parts,
                          const DrawingPlace& place) {
    Design design;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.min);
    design.assembly = problem.assemblies.front();
    const auto drawn = [&](const Point& at) { return place.origin + place.size * at; };
    const std::array<Point, 5> pins{drawn(parts.driving.fixed), drawn(pin_at(parts.driving, 0)),
                                    drawn(pin_at(parts.driven, 0)), drawn(parts.driven.fixed),
                                    drawn(parts.displacements.front().shift)};
    auto reading = reading_of(problem, bars, pins);
    if (!reading) return excluded_design(std::move(design), "degenerate: two of its pins coincide");
    std::optional<ExactDesign> best;
    const bool apart = changes_side(parts, *speed_of_driven(problem, bars));
    for (const double angle : first_angles(problem, design, reading->driving))
        for (const double phase : phases_at(problem, bars, angle, reading->driven)) {
            Design one = design;
            reading->rows.back().value = phase;
            const bool agree = solve_rows(*problem.mechanism, problem.dimensions, reading->rows, one.dimensions);
            if (apart) return excluded_design(std::move(one), "branch: it has to be taken apart between the targets");
            if (agree)
                keep_better(problem, best, at_angle(problem, std::move(one), parts, angle));
            else
                design = std::move(one);
        }
    if (best) return *std::move(best);
    return excluded_design(std::move(design), "range: what is given of its links does not allow it");
}

}  // namespace mechwright
