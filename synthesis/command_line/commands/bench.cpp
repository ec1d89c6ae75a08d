// mechwright bench: hands its arguments to mechwright-bench, a program of its own that not everybody builds.

#include <fmt/format.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <cerrno>
#include <system_error>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/other_programs.h"

namespace mechwright {

namespace {

constexpr const char* bench_program = "mechwright-bench";

/// Becomes the bench, which ends with an exit code of its own; returns only where there is none.
int become_bench(std::vector<std::string> arguments, Console& console) {
    std::string program = called(bench_program);
    std::vector<char*> words{program.data()};
    for (std::string& argument : arguments)
        words.push_back(argument.data());
    words.push_back(nullptr);
    ::execvp(words.front(), words.data());
    complain(console,
             errno == ENOENT
                 ? fmt::format("there is no {} beside mechwright or in PATH: './bootstrap bench' builds it, in "
                               "the folder of mechwright's sources",
                               bench_program)
                 : fmt::format("cannot run {}: {}", program, std::generic_category().message(errno)));
    return exit_code::no_access;
}

}  // namespace

Command add_bench(CLI::App& program) {
    CLI::App* command = program.add_subcommand("bench", "Measure speed against error (mechwright-bench)");
    command->set_help_flag();
    command->prefix_command();
    return {command, [command](Console& console) { return become_bench(command->remaining(), console); }};
}

}  // namespace mechwright
