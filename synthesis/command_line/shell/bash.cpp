#include <fmt/format.h>
#include <fmt/ranges.h>

#include "synthesis/command_line/shell/completion.h"

namespace mechwright {

namespace {

/// What fills COMPREPLY with the values of a place. `files` shows folders too: a file may lie in one.
constexpr std::string_view helpers = R"sh(# Completion of mechwright for bash; made by 'mechwright completion bash'.

_mechwright_words() {
    mapfile -t COMPREPLY < <(compgen -W "$*" -- "$cur")
}

_mechwright_folders() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen -d -- "$cur")
}

_mechwright_files() {
    local ending more
    _mechwright_folders
    (($#)) || mapfile -t COMPREPLY < <(compgen -f -- "$cur")
    for ending; do
        mapfile -t more < <(compgen -f -X "!*.$ending" -- "$cur")
        COMPREPLY+=("${more[@]}")
    done
}

)sh";

/// Walks over the words before the cursor: commands, options with their values, arguments.
constexpr std::string_view walk = R"sh(
_mechwright() {
    local cur=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]}
    local command='' place=0 word i options valued below repeats
    COMPREPLY=()
    _mechwright_about ''
    for ((i = 1; i < COMP_CWORD; ++i)); do
        word=${COMP_WORDS[i]}
        if [[ " $valued " == *" $word "* ]]; then
            ((++i))
        elif [[ $word != -* ]]; then
            if ((place == 0)) && [[ " $below " == *" $word "* ]]; then
                command=${command:+$command }$word
                _mechwright_about "$command"
            else
                ((++place))
            fi
        fi
    done
    if [[ " $valued " == *" $previous "* ]]; then
        _mechwright_value "$command" "$previous"
    elif [[ $cur == -* ]]; then
        _mechwright_words $options
    else
        ((repeats > 0 && place >= repeats)) && place=$((repeats - 1))
        _mechwright_value "$command" "$place"
        if [[ -n $below ]] && ((place == 0)); then
            local arguments=("${COMPREPLY[@]}")
            _mechwright_words $below
            COMPREPLY+=("${arguments[@]}")
        fi
    fi
}

complete -F _mechwright mechwright
)sh";

std::string bash_action(const Values& values) {
    const std::string names = fmt::format("{}{}", values.names.empty() ? "" : " ", fmt::join(values.names, " "));
    switch (values.kind) {
        case Values::Kind::words: return "_mechwright_words" + names;
        case Values::Kind::files: return "_mechwright_files" + names;
        case Values::Kind::folders: return "_mechwright_folders";
        case Values::Kind::unknown: break;
    }
    return {};
}

std::string case_of_about(const CommandNode& node) {
    std::vector<std::string> options, valued, below;
    for (const OptionNode& option : node.options)
        for (const std::string& name : {option.short_name, option.name}) {
            if (name.empty()) continue;
            options.push_back(name);
            if (!option.value.empty()) valued.push_back(name);
        }
    for (const CommandNode& other : node.below)
        below.push_back(other.name);
    const bool repeats = !node.arguments.empty() && node.arguments.back().repeated;
    return fmt::format("        '{}') options='{}' valued='{}' below='{}' repeats={} ;;\n", fmt::join(node.path, " "),
                       fmt::join(options, " "), fmt::join(valued, " "), fmt::join(below, " "),
                       repeats ? node.arguments.size() : 0);
}

std::string cases_of_values(const CommandNode& node) {
    std::string text;
    const std::string path = fmt::format("{}", fmt::join(node.path, " "));
    const auto add = [&](std::string_view place, const Values& values) {
        if (const std::string action = bash_action(values); !action.empty())
            text += fmt::format("        '{} {}') {} ;;\n", path, place, action);
    };
    for (const OptionNode& option : node.options)
        if (!option.value.empty()) add(option.name, option.values);
    for (std::size_t i = 0; i < node.arguments.size(); ++i)
        add(std::to_string(i), node.arguments[i].values);
    return text;
}

}  // namespace

std::string bash_completion(const CommandNode& program) {
    std::string about, values;
    for (const CommandNode* node : all_nodes(program)) {
        about += case_of_about(*node);
        values += cases_of_values(*node);
    }
    return fmt::format(
        "{}# What a command takes: its options, those with a value, the commands below it, and from which argument on\n"
        "# they repeat.\n"
        "_mechwright_about() {{\n    case $1 in\n{}    esac\n}}\n\n"
        "# The values of an option, or of an argument by its number.\n"
        "_mechwright_value() {{\n    case \"$1 $2\" in\n{}    esac\n}}\n{}",
        helpers, about, values, walk);
}

}  // namespace mechwright
