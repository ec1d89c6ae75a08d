#include "synthesis/command_line/tree.h"

#include <CLI/CLI.hpp>
#include <algorithm>

#include "synthesis/command_line/commands/start_system.h"
#include "synthesis/command_line/new/task.h"
#include "synthesis/report/names.h"
#include "synthesis/report/section_words.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

template <class Names>
std::vector<std::string> as_strings(const Names& names) {
    std::vector<std::string> strings;
    for (const auto& name : names)
        strings.emplace_back(name);
    return strings;
}

/// What `explain` knows: names of the mechanisms, then those of problem files.
std::vector<std::string> all_explained() {
    std::vector<std::string> names = as_strings(explained_names());
    for (std::string& name : section_names())
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
    return names;
}

std::vector<std::string> method_names() {
    std::vector<std::string> names;
    for (const MethodDescription& method : all_methods())
        names.emplace_back(method.name);
    return names;
}

std::vector<std::string> task_names() {
    std::vector<std::string> names;
    for (const Task& task : tasks())
        if (std::find(names.begin(), names.end(), task.name) == names.end()) names.emplace_back(task.name);
    return names;
}

/// What stands behind an option, or in the place of an argument, of a command; an empty command is any.
struct Known {
    std::string_view command;
    std::string_view name;
    Values values;
};

const std::vector<Known>& known_values() {
    using enum Values::Kind;
    static const std::vector<Known> all = [] {
        std::vector<Known> rows{{"", "--method", {words, method_names()}},
                                {"", "--mechanism", {words, as_strings(mechanism_names())}},
                                {"", "--task", {words, task_names()}},
                                {"", "QUANTITY", {words, all_explained()}},
                                {"", "MECHANISM", {words, as_strings(mechanism_names())}},
                                {"", "SHELL", {words, {"bash", "zsh", "fish"}}},
                                {"", "DOCUMENT", {words, {"problem", "result"}}},
                                {"start-system", "PROBLEM", {words, start_system_names()}},
                                {"", "RESULT", {files, {"json"}}},
                                {"", "--result", {files, {"json"}}},
                                {"", "PARAMETERS", {files, {}}},
                                {"", "RESULTS", {files, {}}},
                                {"", "--start-system", {files, {}}},
                                {"draw", "--out", {files, {"svg", "png", "pdf"}}},
                                {"export", "--out", {files, {"dxf", "slvs", "csv", "json"}}},
                                {"export", "--format", {words, {"dxf", "slvs", "csv", "json"}}},
                                {"report", "--out", {files, {"html"}}},
                                {"", "--out", {folders, {}}},
                                {"", "DIR", {folders, {}}}};
        for (const std::string_view command : {"new", "check", "solve", "compare", "study", "plan", "analyse",
                                               "structure", "expand", "methods", "driver"})
            rows.push_back({command, "FILE", {files, {"toml"}}});
        rows.push_back({"", "FILE", {files, {"toml", "json"}}});
        return rows;
    }();
    return all;
}

Values values_of(std::string_view command, std::string_view name) {
    for (const Known& known : known_values())
        if ((known.command.empty() || known.command == command) && known.name == name) return known.values;
    return {};
}

std::string value_name(const CLI::Option& option) {
    if (option.get_items_expected_max() == 0) return {};
    const std::string text = option.get_option_text();
    return text.empty() || text == " " ? option.get_type_name() : text;
}

void add_option(const CLI::Option& option, CommandNode& node) {
    if (option.get_positional()) {
        const std::string name = option.get_name(true);
        node.arguments.push_back({name, option.get_description(), option.get_required(),
                                  option.get_items_expected_max() > 1, values_of(node.name, name)});
        return;
    }
    const std::string name = "--" + option.get_lnames().front();
    node.options.push_back({option.get_snames().empty() ? "" : "-" + option.get_snames().front(), name,
                            value_name(option), option.get_description(), values_of(node.name, name)});
}

CommandNode node_of(const CLI::App& app, std::vector<std::string> path) {
    CommandNode node{app.get_name(), std::move(path), app.get_description(), {}, {}, {}};
    for (const CLI::Option* option : app.get_options())
        add_option(*option, node);
    for (const CLI::App* below : app.get_subcommands([](const CLI::App* one) { return !one->get_group().empty(); })) {
        std::vector<std::string> longer = node.path;
        longer.push_back(below->get_name());
        node.below.push_back(node_of(*below, longer));
    }
    return node;
}

}  // namespace

CommandNode tree_of(const CLI::App& program) { return node_of(program, {}); }

std::vector<const CommandNode*> all_nodes(const CommandNode& node) {
    std::vector<const CommandNode*> all{&node};
    for (const CommandNode& below : node.below) {
        const auto more = all_nodes(below);
        all.insert(all.end(), more.begin(), more.end());
    }
    return all;
}

}  // namespace mechwright
