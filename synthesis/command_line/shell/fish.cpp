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

/// "__mechwright_in study export", and none of those below: a name of a command can be that of one below another.
std::string condition(const CommandNode& node) {
    if (node.path.empty()) return "__fish_use_subcommand";
    std::string text = fmt::format("__mechwright_in {}", fmt::join(node.path, " "));
    if (node.below.empty()) return text;
    std::vector<std::string> below;
    for (const CommandNode& other : node.below)
        below.push_back(other.name);
    return text + fmt::format("; and not __fish_seen_subcommand_from {}", fmt::join(below, " "));
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
        "function __mechwright_in\n"
        "    set -l words (commandline -opc)\n"
        "    for i in (seq (count $argv))\n"
        "        set -l next (math $i + 1)\n"
        "        test \"$words[$next]\" = \"$argv[$i]\"; or return 1\n"
        "    end\n"
        "end\n"
        "complete -c mechwright -f\n";
    for (const CommandNode* node : all_nodes(program))
        text += lines_of(*node);
    return text;
}

}  // namespace mechwright
