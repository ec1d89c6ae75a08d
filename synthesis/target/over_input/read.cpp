#include "synthesis/target/over_input/read.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace mechwright::reading {

namespace {

bool is_linkage(const Problem& problem) { return is_described(*problem.mechanism); }

/// Whether a mechanism can do such a thing at all; says so where it cannot.
bool can_be_asked(const Section& section, std::string_view name, const Problem& problem, Messages& messages) {
    const std::vector<std::string>& targets = problem.mechanism->targets;
    if (std::find(targets.begin(), targets.end(), name) != targets.end()) return true;
    add_error(messages, section.place,
              fmt::format("a {} {}: leave {} out", problem.mechanism->name,
                          name == "function" ? "generates no functions here" : "guides no point along a line or an arc",
                          section.title));
    return false;
}

/// Whether a mechanism that is described by no links can have so many targets; says so where it cannot.
bool is_over_one_input(const std::vector<Section>& sections, const Problem& problem, Messages& messages) {
    if (is_linkage(problem)) return true;
    if (sections.size() < 2 && !problem.function && !problem.followed) return true;
    const std::string there = problem.function ? "[function]" : problem.followed ? "[line]" : sections.front().title;
    const Section& more = sections.back();
    add_error(messages, more.place,
              fmt::format("a {} has one input range: it cannot have {} beside {}; a mechanism that is described by its "
                          "links, mechanism = \"linkage\", can ('mechwright expand' writes it so)",
                          problem.mechanism->name, more.title, there));
    return false;
}

/// Points that count by the nearest of the curve are sought over the whole of a motion, not over one that they bound.
void check_timing_of_path(const Section& section, const Problem& problem, Messages& messages) {
    if (problem.path && problem.path->any_order && !problem.path->closed)
        add_error(
            messages, section.place,
            fmt::format("{} goes with a path with timing = \"none\" only where the path has closed = true: say so, "
                        "or give the path another timing",
                        section.title));
}

}  // namespace

std::vector<OverInputSection> read_over_input_sections(Section& file, std::string_view name, const Problem& problem,
                                                       Messages& messages) {
    std::vector<OverInputSection> made;
    std::vector<Section> sections = read_sections(file, name, messages);
    if (sections.empty() || problem.mechanism == nullptr) return made;
    if (!can_be_asked(sections.front(), name, problem, messages) || !is_over_one_input(sections, problem, messages))
        return made;
    std::size_t number = problem.over_input ? problem.over_input->size() : 0;
    for (Section& section : sections) {
        check_timing_of_path(section, problem, messages);
        if (is_linkage(problem))
            for (const char* key : {"name", "weight", "point", "link", "signal"})
                if (find_key(section.known, key) != nullptr) find(section, key);  // which were read with the links
        const bool named = !problem.mechanism->over_input.empty();
        made.push_back({std::move(section), named ? number++ : every_target});
    }
    return made;
}

void add_over_input(const OverInputSection& of, AskedOverInput&& asked, Problem& problem) {
    if (of.number == every_target) {
        if (asked.function)
            problem.function = std::move(asked.function);
        else
            problem.followed = FollowedTarget{asked.followed, asked.full_turn};
        return;
    }
    const toml::table& table = *of.section.table;
    asked.name = problem.mechanism->over_input[of.number].name;
    asked.weight = table["weight"].value<double>().value_or(1);
    auto all = problem.over_input ? std::make_shared<std::vector<AskedOverInput>>(*problem.over_input)
                                  : std::make_shared<std::vector<AskedOverInput>>();
    all->push_back(std::move(asked));
    problem.over_input = std::move(all);
}

}  // namespace mechwright::reading
