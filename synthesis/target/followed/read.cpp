#include <fmt/format.h>

#include <numbers>

#include "synthesis/problem/sections/sections.h"

namespace mechwright::reading {

namespace {

/// How far the mechanism can reach, from above.
double reach_of(const Problem& problem) {
    double reach = 0;
    for (std::size_t i = 0; i < problem.mechanism->dimensions.size(); ++i)
        if (scales(problem.mechanism->dimensions[i].kind))
            reach += std::max(std::abs(problem.dimensions[i].min), std::abs(problem.dimensions[i].max));
    return reach;
}

/// The dimensions of the shape itself: as given, else free as far as they make sense.
void read_place(Section& section, Followed followed, std::size_t place, Problem& problem, Messages& messages) {
    constexpr double pi = std::numbers::pi;
    const double reach = reach_of(problem);
    const DimensionRange direction{-pi, pi, {}, true}, anywhere{-reach, reach, {}, true}, radius{0, reach, {}, true};
    struct Entry {
        std::string_view key;
        DimensionRange free;
    };
    const std::vector<Entry> entries =
        followed == Followed::line
            ? std::vector<Entry>{{"angle", direction}, {"offset", anywhere}}
            : std::vector<Entry>{{"centre-x", anywhere}, {"centre-y", anywhere}, {"radius", radius}};
    for (std::size_t k = 0; k < entries.size(); ++k) {
        const toml::node* node = find(section, entries[k].key);
        const auto read = node == nullptr
                              ? entries[k].free
                              : to_dimension(*node, problem.mechanism->dimensions[place + k], problem.units, messages);
        if (!read) continue;
        problem.dimensions[place + k] = *read;
        if (entries[k].key == "radius" && (read->min < 0 || !(read->max > 0)))
            add_error(messages, place_of(*node), "the radius of an arc must be greater than 0");
    }
}

void read_shape(Section& file, std::string_view name, Followed followed, Problem& problem, Messages& messages) {
    std::optional<Section> section = read_section(file, name, messages);
    if (!section || problem.mechanism == nullptr) return;
    const Mechanism& mechanism = *problem.mechanism;
    const FollowedTarget target{followed};
    const std::optional<FollowedShape>& shape = followed_shape_of(mechanism, target);
    const std::string title = section->title;
    if (!shape)
        return add_error(
            messages, section->place,
            fmt::format("a {} guides no point along a line or an arc: leave {} out", mechanism.name, title));
    if (problem.function || problem.path || problem.followed)
        return add_error(messages, section->place,
                         fmt::format("a problem has one target, {} or {}: not both", title,
                                     problem.function   ? "[function]"
                                     : problem.followed ? "[line]"
                                                        : "[path] or [poses]"));
    if (mechanism.point->named) {
        find(*section, "point");
        find(*section, "link");
    }
    section->title = name;
    read_scale(*section, mechanism.input->start, problem, messages);
    section->title = title;
    read_place(*section, followed, shape->place, problem, messages);
    problem.followed = target;
    problem.followed->full_turn = read_bool(*section, "full_turn", messages).value_or(false);
    report_unknown_keys(*section, messages);
}

}  // namespace

void read_followed(Section& file, Problem& problem, Messages& messages) {
    read_shape(file, "line", Followed::line, problem, messages);
    read_shape(file, "arc", Followed::arc, problem, messages);
}

}  // namespace mechwright::reading
