#include <fmt/format.h>

#include <numbers>

#include "synthesis/problem/sections.h"

namespace mechwright::reading {

namespace {

/// The line's direction and offset: as given, else free, the offset as far as the mechanism can reach.
void read_line_place(Section& line, Problem& problem, Messages& messages) {
    const Mechanism& mechanism = *problem.mechanism;
    constexpr double pi = std::numbers::pi;
    double reach = 0;
    for (std::size_t i = 0; i < mechanism.dimensions.size(); ++i)
        if (scales(mechanism.dimensions[i].kind))
            reach += std::max(std::abs(problem.dimensions[i].min), std::abs(problem.dimensions[i].max));
    const std::array<std::string_view, 2> keys{"angle", "offset"};
    const std::array<DimensionRange, 2> free{DimensionRange{-pi, pi, {}, true, {}},
                                             DimensionRange{-reach, reach, {}, true, {}}};
    for (std::size_t k = 0; k < keys.size(); ++k) {
        const std::size_t index = mechanism.line_place + k;
        const toml::node* node = find(line, keys[k]);
        const auto read =
            node == nullptr ? free[k] : to_dimension(*node, mechanism.dimensions[index], problem.units, messages);
        if (read) problem.dimensions[index] = *read;
    }
}

}  // namespace

void read_line(Section& file, Problem& problem, Messages& messages) {
    std::optional<Section> line = read_section(file, "line", messages);
    if (!line || problem.mechanism == nullptr) return;
    const Mechanism& mechanism = *problem.mechanism;
    if (mechanism.line_extremes == nullptr)
        return add_error(messages, line->place,
                         fmt::format("a {} guides no point along a line: leave [line] out", mechanism.name));
    if (problem.function || problem.path)
        return add_error(messages, line->place,
                         fmt::format("a problem has a [line] or {}, not both",
                                     problem.function ? "a [function]" : "a [path] or [poses]"));
    line->title = "line";
    read_scale(*line, mechanism.function_scales, problem, messages);
    line->title = "[line]";
    read_line_place(*line, problem, messages);
    problem.line.emplace();
    problem.line->full_turn = read_bool(*line, "full_turn", messages).value_or(false);
    report_unknown_keys(*line, messages);
    set_crank_range(problem);
}

}  // namespace mechwright::reading
