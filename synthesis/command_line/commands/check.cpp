#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"

namespace mechwright {

namespace {

struct CheckOptions {
    std::vector<std::string> files;
    bool quiet = false;
};

int check(const CheckOptions& options, Console& console) {
    int code = exit_code::solved;
    for (const std::string& file : options.files) {
        ReadProblem read;
        int outcome = read_and_report(file, options.quiet, console, read);
        if (outcome == exit_code::solved) outcome = report_method_fault(read.problem, console);
        code = exit_code::worse(code, outcome);
    }
    return code;
}

}  // namespace

Command add_check(CLI::App& program) {
    const auto options = std::make_shared<CheckOptions>();
    CLI::App* command = program.add_subcommand("check", "Validate problem files; says nothing but errors");
    command->add_option("FILE", options->files, "Problem files")->required()->option_text(" ");
    command->add_flag("--quiet", options->quiet, "No warnings");
    return {command, [options](Console& console) { return check(*options, console); }};
}

}  // namespace mechwright
