#include <fmt/format.h>
#include <fmt/ranges.h>

#include "synthesis/command_line/shell/completion.h"

namespace mechwright {

namespace {

/// A text inside single quotes, with a backslash before what _arguments and _describe take for their own.
std::string escaped(std::string_view text) {
    std::string result;
    for (const char c : text) {
        if (c == '\'')
            result += "'\\''";
        else if (c == '[' || c == ']' || c == ':' || c == '\\')
            result += {'\\', c};
        else
            result += c;
    }
    return result;
}

std::string zsh_action(const Values& values) {
    switch (values.kind) {
        case Values::Kind::words: return fmt::format("({})", fmt::join(values.names, " "));
        case Values::Kind::folders: return "_files -/";
        case Values::Kind::files:
            if (values.names.empty()) return "_files";
            // A single ending in parentheses would be qualifiers of the pattern.
            return values.names.size() == 1 ? fmt::format("_files -g \"*.{}\"", values.names[0])
                                            : fmt::format("_files -g \"*.({})\"", fmt::join(values.names, "|"));
        case Values::Kind::unknown: break;
    }
    return {};
}

std::string specification(const OptionNode& option) {
    const std::string value =
        option.value.empty() ? "" : fmt::format(":{}:{}", escaped(option.value), zsh_action(option.values));
    std::string text;
    for (const std::string& name : {option.short_name, option.name})
        if (!name.empty()) text += fmt::format(" \\\n        '{}[{}]{}'", name, escaped(option.help), value);
    return text;
}

std::string specification(const ArgumentNode& argument) {
    return fmt::format(" \\\n        '{}:{}:{}'",
                       argument.repeated   ? "*"
                       : argument.required ? ""
                                           : ":",
                       escaped(argument.name), zsh_action(argument.values));
}

std::string function_name(const CommandNode& node) {
    return node.path.empty() ? "_mechwright" : fmt::format("_mechwright_{}", fmt::join(node.path, "_"));
}

/// The names of the commands below a node, each with its help.
std::string commands_below(const CommandNode& node) {
    std::string text = "    local -a commands=(\n";
    for (const CommandNode& below : node.below)
        text += fmt::format("        '{}:{}'\n", below.name, escaped(below.help));
    return text + "    )\n";
}

/// A command with others below it: the first word that is no option says which, unless it is an argument.
std::string body_with_commands(const CommandNode& node) {
    std::string text = "    local curcontext=$curcontext state line\n    typeset -A opt_args\n" + commands_below(node);
    text += "    _arguments -C";
    for (const OptionNode& option : node.options)
        text += specification(option);
    text += " \\\n        '1:command:->command' \\\n        '*::argument:->arguments'\n";
    text += "    case $state in\n        command)\n            _describe command commands\n";
    if (!node.arguments.empty() && node.arguments[0].values.kind != Values::Kind::unknown)
        text += fmt::format("            {}\n", zsh_action(node.arguments[0].values));
    text += "            ;;\n        arguments)\n            case $line[1] in\n";
    for (const CommandNode& below : node.below)
        text += fmt::format("                {}) {} ;;\n", below.name, function_name(below));
    return text + "            esac\n            ;;\n    esac\n";
}

std::string body(const CommandNode& node) {
    if (!node.below.empty()) return body_with_commands(node);
    std::string text = "    _arguments";
    for (const OptionNode& option : node.options)
        text += specification(option);
    for (const ArgumentNode& argument : node.arguments)
        text += specification(argument);
    return text + "\n";
}

}  // namespace

std::string zsh_completion(const CommandNode& program) {
    std::string text =
        "#compdef mechwright\n# Completion of mechwright for zsh; made by 'mechwright completion zsh'.\n";
    for (const CommandNode* node : all_nodes(program))
        text += fmt::format("\n{}() {{\n{}}}\n", function_name(*node), body(*node));
    return text +
           "\n# Loaded by itself the function completes at once, sourced it is registered.\n"
           "if [[ $funcstack[1] == _mechwright ]]; then\n    _mechwright \"$@\"\nelse\n    compdef _mechwright "
           "mechwright\nfi\n";
}

}  // namespace mechwright
