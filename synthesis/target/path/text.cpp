#include "synthesis/target/path/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/input.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

constexpr std::size_t most_points_shown = 12;

/// Digits after the point for so many significant ones of the greatest coordinate.
int decimals_of(const std::vector<Vector<double>>& points, int digits) {
    double greatest = 0;
    for (const Vector<double>& p : points)
        greatest = std::max({greatest, std::abs(p.x), std::abs(p.y)});
    if (greatest == 0) return 3;
    return std::clamp(digits - 1 - static_cast<int>(std::floor(std::log10(greatest))), 0, 9);
}

/// The crank angle at a point, or the displacement.
std::string place_text(const Problem& problem, const Design& design, std::size_t point, int digits) {
    const double input = design.path_angles[point];
    const Unit unit = input_unit(*problem.mechanism);
    if (unit == Unit::length) return quantity_text(input, unit, problem, design, digits);
    return fixed_text(in_file_unit(input, unit, problem.units), problem.units.degrees ? 2 : 4);
}

std::string point_table(const Problem& problem, const Design& design, const PathValues& values,
                        const PointRange& points, int digits) {
    const bool body = problem.path->guides_body_at(points.first);
    Table table{{Align::right, Align::point, Align::point, Align::right, Align::right, Align::right, Align::point}, {}};
    const char* input = input_unit(*problem.mechanism) == Unit::angle ? "crank" : "drive";
    table.rows.push_back({"#", "target x", "y", "reached x", "y", input, "distance"});
    if (body) {
        table.columns = {Align::right, Align::point, Align::point, Align::point, Align::right,
                         Align::right, Align::right, Align::right, Align::point};
        table.rows.front() = {"#", "target x", "y", "angle", "reached x", "y", "angle", input, "distance"};
    }
    const int decimals = decimals_of(problem.path->points, digits + 1);
    for (std::size_t i = points.first; i < points.end(); ++i) {
        const Vector<double>& target = problem.path->points[i];
        const Vector<double>& reached = values.reached[i];
        table.rows.push_back({std::to_string(i - points.first + 1), number_text(target.x, 6), number_text(target.y, 6),
                              fixed_text(reached.x, decimals), fixed_text(reached.y, decimals),
                              place_text(problem, design, i, digits),
                              quantity_text(values.distances[i], Unit::length, problem, design, digits)});
        if (!body) continue;
        auto& row = table.rows.back();
        const auto in_unit = [&](double a) { return in_file_unit(a, Unit::angle, problem.units); };
        const double asked = problem.path->directions[i];
        row.insert(row.begin() + 3, std::isnan(asked) ? "any" : number_text(in_unit(asked), 6));
        row.insert(row.begin() + 6, fixed_text(in_unit(values.directions[i]), problem.units.degrees ? 3 : 5));
    }
    return to_text(table, 2);
}

std::string means_line(const PathMeans& means, const Problem& problem, const Design& design, int digits) {
    return fmt::format("  distance: root mean square {}, greatest {}\n",
                       quantity_with_unit(means.root_mean_square, Unit::length, problem, design, digits),
                       quantity_with_unit(means.greatest, Unit::length, problem, design, digits));
}

/// "Path: 5 points", "Poses: 3", of one of several with its name.
std::string title_of(bool body, const std::string& name, std::size_t count) {
    const std::string of = name.empty() ? "" : " '" + name + "'";
    return body ? fmt::format("Poses{}: {}", of, count)
                : fmt::format("Path{}: {} point{}", of, count, count == 1 ? "" : "s");
}

std::string target_section(const Problem& problem, const Design& design, const PathValues& values,
                           const std::string& name, const PointRange& points, const PathMeans& means,
                           const TextStyle& style) {
    std::string text = heading(title_of(problem.path->guides_body_at(points.first), name, points.count), style);
    if (points.count <= most_points_shown) text += point_table(problem, design, values, points, style.digits);
    return text + means_line(means, problem, design, style.digits);
}

}  // namespace

std::string path_section(const Problem& problem, const Design& design, const TextStyle& style) {
    const std::optional<PathValues> values = path_values(problem, design);
    if (!values) return {};
    const std::vector<PathPart>& parts = problem.path->parts;
    if (parts.empty())
        return target_section(problem, design, *values, {}, {0, values->distances.size()}, *values, style);
    std::string text;
    for (std::size_t i = 0; i < parts.size(); ++i)
        text += target_section(problem, design, *values, parts[i].name, parts[i].points, values->of_targets[i], style);
    if (parts.size() > 1)
        text += heading(fmt::format("All {} targets", parts.size()), style) +
                means_line(*values, problem, design, style.digits);
    return text;
}

}  // namespace mechwright
