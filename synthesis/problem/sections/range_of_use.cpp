// Which part of the motion designs are judged over, and quantities over all of it.

#include <fmt/format.h>

#include <algorithm>

#include "synthesis/mechanism/input.h"
#include "synthesis/mechanism/whole_quantities.h"
#include "synthesis/problem/schema/keys.h"
#include "synthesis/problem/sections/sections.h"
#include "synthesis/target/names.h"

namespace mechwright::reading {

namespace {

void add_quantities(const toml::node* node, std::vector<std::string>& names) {
    if (node == nullptr) return;
    if (const auto name = node->value_exact<std::string>()) names.push_back(*name);
    if (const toml::array* list = node->as_array())
        for (const toml::node& entry : *list)
            add_quantities(&entry, names);
}

constexpr std::array<std::string_view, 4> keys_of_use{"from", "to", "before", "after"};

/// Whether a file says that its crank turns fully beyond the input range of its line or arc.
bool turns_beyond_input(const toml::table& file) {
    for (const std::string_view target : sections_of_shapes)
        if (const toml::table* one = only_table(file, target); one != nullptr && (*one)["full_turn"].value_or(false))
            return true;
    return false;
}

/// Why there is no range of use; empty where there can be one.
std::string why_no_use(const Section& file, const Problem& problem, const Section& motion) {
    for (const std::string_view target : sections_over_input)
        if (has(file, target))
            return fmt::format("[{}] is judged over its own input range: leave 'from' and 'to' out", target);
    if (!has(file, "path") && !has(file, "poses"))
        return "a range of use is between the targets of [path] or [poses], and there are none: leave 'from' and 'to' "
               "out, or write crank_range = [0, 120]";
    if (has(motion, "crank_range"))
        return "'crank_range' in [motion] is another range to be judged over: write either that, or 'from' and 'to'";
    if (problem.path && problem.path->closed)
        return "the crank goes round a closed path, and its full turn is used: leave 'from' and 'to' out";
    if (problem.path && problem.path->any_order)
        return "timing = \"none\" says of no target that it is the first: leave 'from' and 'to' out, or write timing = "
               "\"free\"";
    return {};
}

/// A margin in radians, or as a displacement; 0 where there is none.
double read_margin(Section& motion, std::string_view key, const Problem& problem, Messages& messages) {
    const double margin = read_number(motion, key, messages).value_or(0);
    if (input_unit(*problem.mechanism) == Unit::length) {
        if (margin >= 0) return margin;
        add_error(messages, place_of(motion, key),
                  fmt::format("{} must be a displacement of 0 or more, not {}", name_of(motion, key), margin));
        return 0;
    }
    const double most = full_turn(problem.units) / 2;
    if (margin >= 0 && margin <= most) return to_radians(problem.units, margin);
    add_error(messages, place_of(motion, key),
              fmt::format("{} must be a crank angle from 0 to half a turn, not {}", name_of(motion, key), margin));
    return 0;
}

}  // namespace

std::vector<std::string> quantities_in(const toml::table& file) {
    std::vector<std::string> names;
    const auto add = [&](const toml::node& section) {
        const toml::table* one = section.as_table();
        if (one == nullptr) return;
        for (const char* key : {"quantity", "minimize", "maximize", "quantities"})
            add_quantities(one->get(key), names);
    };
    for (const char* section : {"require", "objective", "study"}) {
        const toml::node* node = file.get(section);
        if (node == nullptr) continue;
        add(*node);
        if (const toml::array* list = node->as_array())
            for (const toml::node& entry : *list)
                add(entry);
    }
    return names;
}

void add_whole_quantities(const toml::table& file, Problem& problem) {
    if (problem.mechanism == nullptr) return;
    const toml::table* motion = file["motion"].as_table();
    const bool used = motion != nullptr && (motion->contains("from") || motion->contains("to"));
    const std::vector<std::string> names = quantities_in(file);
    const bool named =
        std::any_of(names.begin(), names.end(), [](const std::string& name) { return name.ends_with(whole_suffix); });
    if (used || (named && turns_beyond_input(file))) problem.mechanism = with_whole_quantities(problem.mechanism);
}

void accept_range_of_use(Section& motion) {
    for (const std::string_view key : keys_of_use)
        find(motion, key);
}

void read_range_of_use(Section& file, Problem& problem, Messages& messages) {
    const toml::node* node = file.table->get("motion");
    if (node == nullptr || !node->is_table()) return;  // which [motion] itself reports
    Section motion{node->as_table(), "[motion]", place_of(*node), keys::motion};
    const auto named =
        std::find_if(keys_of_use.begin(), keys_of_use.end(), [&](std::string_view key) { return has(motion, key); });
    if (named == keys_of_use.end() || problem.mechanism == nullptr) return;
    const bool from = read_choice(motion, "from", "beginning of the range of use", messages).has_value();
    const bool to = read_choice(motion, "to", "end of the range of use", messages).has_value();
    const RangeOfUse use{read_margin(motion, "before", problem, messages),
                         read_margin(motion, "after", problem, messages)};
    for (const auto& [key, word] : {std::pair("from", keys::use_begins[0]), {"to", keys::use_ends[0]}})
        if (!has(motion, key))
            add_error(messages, key_place(motion, *named),
                      fmt::format("'{}' in [motion] needs '{}' beside it: write {} = \"{}\"", *named, key, key, word));
    if (const std::string why = why_no_use(file, problem, motion); !why.empty())
        return add_error(messages, key_place(motion, *named), why);
    if (problem.path && problem.path->points.size() < 2 && !(use.before + use.after > 0))
        return add_error(messages, key_place(motion, *named),
                         "there is one target, and the range of use would be a single " +
                             std::string(input_word(*problem.mechanism)) +
                             ": give more targets, or 'before' and 'after'");
    if (from && to && problem.path) problem.use = use;
}

}  // namespace mechwright::reading
