#include "synthesis/target/over_input/read.h"

#include <fmt/format.h>

#include <numbers>

#include "synthesis/mechanism/cycle.h"
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

void read_shape(OverInputSection& of, Followed followed, Problem& problem, Messages& messages) {
    Section& section = of.section;
    const Mechanism& mechanism = *problem.mechanism;
    const bool alone = of.number == every_target;
    const FollowedShape& shape =
        alone ? *followed_shape_of(mechanism, FollowedTarget{followed}) : *mechanism.over_input[of.number].shape;
    const std::string title = section.title;
    section.title = shape.name;
    read_scale(section, alone ? mechanism.input->start : mechanism.over_input[of.number].start, problem, messages);
    section.title = title;
    read_place(section, followed, shape.place, problem, messages);
    AskedOverInput asked;
    asked.followed = followed;
    asked.full_turn = read_bool(section, "full_turn", messages).value_or(false);
    if (asked.full_turn && !comes_round(mechanism))
        add_error(messages, place_of(section, "full_turn"),
                  "the linkage is driven by a slide, which goes to and fro and never round: leave 'full_turn' out");
    report_unknown_keys(section, messages);
    add_over_input(of, std::move(asked), problem);
}

}  // namespace

void read_followed(Section& file, Problem& problem, Messages& messages) {
    for (const auto& [name, followed] : {std::pair("line", Followed::line), {"arc", Followed::arc}})
        for (OverInputSection& of : read_over_input_sections(file, name, problem, messages))
            read_shape(of, followed, problem, messages);
}

}  // namespace mechwright::reading
