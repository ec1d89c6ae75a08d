#include <fmt/format.h>

#include <array>
#include <cmath>

#include "synthesis/problem/sections.h"

namespace mechwright::reading {

namespace {

constexpr std::size_t most_free_points = 200;

/// A list that goes with the points must have as many entries.
bool same_length(const Section& path, std::string_view key, std::size_t length, const PointList& list,
                 Messages& messages) {
    if (!list.whole || length == list.points.size()) return true;
    add_error(messages, place_of(path, key),
              fmt::format("{} has {} numbers for {} points: give one for each point", name_of(path, key), length,
                          list.points.size()));
    return false;
}

Place element_place(const Section& path, std::string_view key, std::size_t i) {
    return place_of((*path.table->get_as<toml::array>(key))[i]);
}

std::vector<double> read_weights(Section& path, const PointList& list, Messages& messages) {
    const auto weights = read_numbers(path, "weights", messages);
    std::vector<double> even(list.points.size(), 1.0);
    if (!weights) return even;
    same_length(path, "weights", weights->size(), list, messages);
    for (std::size_t i = 0; i < weights->size(); ++i)
        if ((*weights)[i] <= 0)
            add_error(messages, element_place(path, "weights", i),
                      fmt::format("the weight of point {} must be greater than 0, not {}", i + 1, (*weights)[i]));
    return *weights;
}

/// The mechanism passes the points in one turn, in one direction.
void check_order(const Section& path, const std::vector<double>& angles, double turn, Messages& messages) {
    if (angles.size() < 2) return;
    const bool rising = angles[1] > angles[0];
    for (std::size_t i = 1; i < angles.size(); ++i) {
        const bool follows = rising ? angles[i] > angles[i - 1] : angles[i] < angles[i - 1];
        if (follows) continue;
        add_error(messages, element_place(path, "crank_angles", i),
                  fmt::format("crank angle {} ({}) breaks the order: crank_angles must all rise or all fall", i + 1,
                              angles[i]));
        return;
    }
    if (std::abs(angles.back() - angles.front()) > turn)
        add_error(messages, place_of(path, "crank_angles"),
                  fmt::format("crank_angles go from {} to {}: they must stay within one full turn", angles.front(),
                              angles.back()));
}

std::vector<double> read_crank_angles(Section& path, const Units& units, const PointList& list, Messages& messages) {
    if (!has(path, "crank_angles"))
        add_error(messages, place_of(path, "timing"),
                  "timing = \"prescribed\" needs 'crank_angles', one for each point");
    auto angles = read_numbers(path, "crank_angles", messages);
    if (!angles) return {};
    same_length(path, "crank_angles", angles->size(), list, messages);
    check_order(path, *angles, full_turn(units), messages);
    for (double& angle : *angles)
        angle = to_radians(units, angle);
    return *angles;
}

/// Each freely timed point brings a variable of its own.
void check_free_timing(Section& path, const PointList& list, Messages& messages) {
    if (const toml::node* angles = find(path, "crank_angles"); angles != nullptr)
        add_error(messages, place_of(*angles),
                  "'crank_angles' in [path] need timing = \"prescribed\"; with any other leave them out");
    if (list.points.size() > most_free_points)
        add_error(messages, list.named_at,
                  fmt::format("{} points are too many for free timing: thin the list to at most {}, or prescribe the "
                              "timing",
                              list.points.size(), most_free_points));
}

}  // namespace

void read_path(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> path = read_section(file, "path", messages);
    if (!path) return;
    if (problem.mechanism != nullptr && problem.mechanism->path_reads == 0)
        return add_error(messages, path->place,
                         fmt::format("a {} guides no point along a path: leave [path] out", problem.mechanism->name));
    constexpr std::array<std::string_view, 3> timings{"free", "prescribed", "none"};
    PointList list = read_points(*path, problem, messages);
    PathTarget target;
    const auto timing = read_choice(*path, "timing", "timing", timings, messages);
    target.prescribed_timing = timing == 1u;
    target.any_order = timing == 2u;
    target.closed = read_bool(*path, "closed", messages).value_or(false);
    target.weights = read_weights(*path, list, messages);
    if (target.prescribed_timing)
        target.crank_angles = read_crank_angles(*path, problem.units, list, messages);
    else if (timing || !has(*path, "timing"))
        check_free_timing(*path, list, messages);
    find(*path, "crank_angles");
    report_unknown_keys(*path, messages);
    target.points = std::move(list.points);
    problem.path = std::move(target);
}

}  // namespace mechwright::reading
