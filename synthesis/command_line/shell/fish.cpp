#include <fmt/format.h>
#include <fmt/ranges.h>

#include "synthesis/command_line/shell/completion.h"

namespace mechwright {

namespace {

std::string quoted_for_fish(std::string_view text) {
    std::string result = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\') result += '\\';
        result += c;
    }
    return result + "'";
}

std::string values_for_fish(const Values& values) {
    switch (values.kind) {
        case Values::Kind::words: return fmt::format("{}", fmt::join(values.names, " "));
        case Values::Kind::folders: return "(__fish_complete_directories)";
        case Values::Kind::files: {
            if (values.names.empty()) return "(__fish_complete_path)";
            std::vector<std::string> parts;
            for (const std::string& ending : values.names)
                parts.push_back("(__fish_complete_suffix ." + ending + ")");
            return fmt::format("{}", fmt::join(parts, " "));
        }
        case Values::Kind::unknown: break;
    }
    return {};
}

/// "__fish_seen_subcommand_from study; and __fish_seen_subcommand_from export", and none of those below.
std::string condition(const CommandNode& node) {
    if (node.path.empty()) return "__fish_use_subcommand";
    std::vector<std::string> parts;
    for (const std::string& name : node.path)
        parts.push_back("__fish_seen_subcommand_from " + name);
    if (!node.below.empty()) {
        std::vector<std::string> below;
        for (const CommandNode& other : node.below)
            below.push_back(other.name);
        parts.push_back(fmt::format("not __fish_seen_subcommand_from {}", fmt::join(below, " ")));
    }
    return fmt::format("{}", fmt::join(parts, "; and "));
}

std::string line(const CommandNode& node, std::string_view rest) {
    return fmt::format("complete -c mechwright -n {} {}\n", quoted_for_fish(condition(node)), rest);
}

std::string lines_of(const CommandNode& node) {
    std::string text;
    for (const OptionNode& option : node.options) {
        std::string rest;
        if (!option.short_name.empty()) rest += "-s " + option.short_name.substr(1) + " ";
        rest += "-l " + option.name.substr(2);
        if (!option.value.empty()) rest += " -x";
        if (const std::string values = values_for_fish(option.values); !values.empty())
            rest += " -a " + quoted_for_fish(values);
        text += line(node, rest + " -d " + quoted_for_fish(option.help));
    }
    for (const CommandNode& below : node.below)
        text += line(node, "-a " + below.name + " -d " + quoted_for_fish(below.help));
    for (const ArgumentNode& argument : node.arguments)
        if (const std::string values = values_for_fish(argument.values); !values.empty())
            text += line(node, "-a " + quoted_for_fish(values));
    return text;
}

}  // namespace

std::string fish_completion(const CommandNode& program) {
    std::string text =
        "# Completion of mechwright for fish; made by 'mechwright completion fish'.\n"
        "complete -c mechwright -f\n";
    for (const CommandNode* node : all_nodes(program))
        text += lines_of(*node);
    return text;
}

}  // namespace mechwright
