// mechwright completion and mechwright man-page: what shells and man read, made from the commands as they are.

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/shell/completion.h"
#include "synthesis/command_line/shell/manual.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

struct Shell {
    std::string_view name;
    std::string (*script)(const CommandNode&);
};

constexpr std::array<Shell, 3> shells{{{"bash", bash_completion}, {"zsh", zsh_completion}, {"fish", fish_completion}}};

int complete(const std::string& shell, const CLI::App& program, Console& console) {
    std::vector<std::string_view> known;
    for (const Shell& one : shells) {
        if (one.name == shell) {
            print(console, one.script(tree_of(program)));
            return exit_code::solved;
        }
        known.push_back(one.name);
    }
    complain(console, "unknown shell " + reading::quoted(shell) + "; known are " + reading::listed(known));
    return exit_code::wrong_usage;
}

}  // namespace

Command add_completion(CLI::App& program) {
    const auto shell = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("completion", "Print a script that completes commands in a shell");
    command->add_option("SHELL", *shell, "bash, zsh or fish")->required()->option_text(" ");
    return {command, [shell, &program](Console& console) { return complete(*shell, program, console); }};
}

Command add_man_page(CLI::App& program) {
    CLI::App* command = program.add_subcommand("man-page", "Print the manual page")->group("");
    return {command, [&program](Console& console) {
                print(console, manual_page(tree_of(program)));
                return exit_code::solved;
            }};
}

}  // namespace mechwright
