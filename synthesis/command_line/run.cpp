#include "synthesis/command_line/run.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <sstream>
#include <system_error>
#include <utility>

#include "analysis/numbers/instruction_set.h"
#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/defect.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/document/versions.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

std::string version_text() {
    return fmt::format("mechwright {}\nwith Ipopt {}, NLopt {}, Eigen {}", program_version(), ipopt_version(),
                       nlopt_version(), eigen_version());
}

std::vector<Command> add_commands(CLI::App& program) {
    program.get_formatter()->label("SUBCOMMAND", "COMMAND");
    program.get_formatter()->column_width(26);
    std::vector<Command> commands{add_new(program),       add_check(program),      add_solve(program),
                                  add_compare(program),   add_study(program),      add_analyse(program),
                                  add_structure(program), add_expand(program),     add_verify(program),
                                  add_report(program),    add_draw(program),       add_export(program),
                                  add_profile(program),   add_quantities(program), add_explain(program),
                                  add_methods(program),   add_schema(program),     add_start_system(program),
                                  add_bench(program),     add_completion(program), add_man_page(program)};
    for (const Command& command : commands)
        if (!command.options->get_group().empty()) command.options->group("Commands");
    return commands;
}

/// What is wrong with the first word of a command line that is not an option; empty if it is a command.
std::string command_fault(int argc, const char* const* argv, const std::vector<Command>& commands) {
    if (argc < 2 || argv[1][0] == '-') return {};
    std::vector<std::string> names;
    for (const Command& command : commands)
        names.push_back(command.options->get_name());
    for (const std::string& name : names)
        if (name == argv[1]) return {};
    const std::vector<std::string_view> known(names.begin(), names.end());
    return "unknown command " + reading::quoted(argv[1]) + "; " + reading::remedy(argv[1], known);
}

/// The option that a command line has and its command does not, with the one that was meant; empty if there is none.
std::string option_fault(const CLI::App& program) {
    const CLI::App* command = &program;
    while (!command->get_subcommands().empty())
        command = command->get_subcommands().front();
    std::vector<std::string> names;
    for (const CLI::Option* option : command->get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    const std::vector<std::string_view> known(names.begin(), names.end());
    for (const std::string& word : program.remaining(true))
        if (word.starts_with("--"))
            return "unknown option " + reading::quoted(word) + "; " +
                   reading::remedy(word.substr(0, word.find('=')), known);
    return {};
}

/// Takes MECHWRIGHT_INSTRUCTIONS into account. Returns what is wrong with it, or nothing.
std::string instructions_fault() {
    constexpr std::array<std::pair<std::string_view, InstructionSet>, 3> sets{
        {{"baseline", InstructionSet::baseline}, {"avx2", InstructionSet::avx2}, {"avx512", InstructionSet::avx512}}};
    const char* wanted = std::getenv("MECHWRIGHT_INSTRUCTIONS");
    if (wanted == nullptr || *wanted == 0) return {};
    for (const auto& [name, set] : sets) {
        if (name != wanted) continue;
        if (!is_available(set)) return fmt::format("MECHWRIGHT_INSTRUCTIONS: this processor does not have {}", name);
        allow_instruction_sets_up_to(set);
        return {};
    }
    return fmt::format("MECHWRIGHT_INSTRUCTIONS must be baseline, avx2 or avx512, not {}", reading::quoted(wanted));
}

int wrong_usage(std::string_view fault, Console& console) {
    complain(console,
             fmt::format("{}\nRun 'mechwright --help', or 'mechwright COMMAND --help', for what there is.", fault));
    return exit_code::wrong_usage;
}

int run_command(int argc, const char* const* argv, Console& console) {
    CLI::App program("Synthesis and optimisation of planar mechanisms.", "mechwright");
    program.set_version_flag("--version", version_text, "Print the versions of the program and its libraries");
    program.footer(exit_code::explained());
    program.require_subcommand(0, 1);
    const std::vector<Command> commands = add_commands(program);

    if (const std::string fault = command_fault(argc, argv, commands); !fault.empty())
        return wrong_usage(fault, console);
    if (const auto code = read_command_line(program, argc, argv, console)) return *code;
    for (const Command& command : commands)
        if (program.got_subcommand(command.options)) return command.run(console);
    console.err << program.help() << std::flush;
    return exit_code::wrong_usage;
}

/// The exit code after a look at what became of the data. A reader that has seen enough and closed its end of a pipe
/// (`| head`) is no failure.
int after_output(int code, Console& console) {
    if (console.out_error == 0 || console.out_error == EPIPE) return code;
    complain(console, "cannot write to standard output: " + std::generic_category().message(console.out_error));
    return exit_code::worse(code, exit_code::no_access);
}

}  // namespace

std::optional<int> read_command_line(CLI::App& program, int argc, const char* const* argv, Console& console) {
    try {
        program.parse(argc, argv);
        return std::nullopt;
    } catch (const CLI::Success& asked_for) {  // --help and --version
        std::ostringstream text;
        program.exit(asked_for, text, text);
        print(console, text.str());
        return exit_code::solved;
    } catch (const CLI::ExtrasError& error) {
        const std::string fault = option_fault(program);
        return wrong_usage(fault.empty() ? error.what() : fault, console);
    } catch (const CLI::ParseError& error) {
        return wrong_usage(error.what(), console);
    }
}

int run_guarded(Console& console, const std::function<int()>& work) {
    try {
        const std::string fault = instructions_fault();
        return after_output(fault.empty() ? work() : wrong_usage(fault, console), console);
    } catch (...) {
        return report_defect(console, "");
    }
}

int run(int argc, const char* const* argv, Console& console) {
    return run_guarded(console, [&] { return run_command(argc, argv, console); });
}

}  // namespace mechwright
