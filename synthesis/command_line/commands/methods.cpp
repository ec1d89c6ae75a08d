#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/report/text/table.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

struct MethodsOptions {
    std::string file;
    bool quiet = false;
};

/// All methods; with a problem, which of them apply to it and why the others do not.
std::string list_of_methods(const Problem* problem, bool colour) {
    const std::vector<MethodDescription> methods = all_methods();
    std::size_t width = 0;
    for (const MethodDescription& method : methods)
        width = std::max(width, method.name.size());

    std::string text;
    for (const MethodDescription& method : methods) {
        const std::string lead = fmt::format("{:<{}}  ", method.name, width);
        if (!problem) {
            text += folded(lead, method.meaning);
            continue;
        }
        const std::string why = why_not_applicable(method.name, *problem);
        const std::string mark = why.empty() ? emphasised("applies", Emphasis::good, colour) : "no     ";
        text += folded(lead + mark + "  ", why.empty() ? std::string(method.meaning) : why);
    }
    return text;
}

int list_methods(const MethodsOptions& options, Console& console) {
    if (options.file.empty()) {
        print(console, list_of_methods(nullptr, colour_wanted(console)));
        return exit_code::solved;
    }
    ReadProblem read;
    if (const int outcome = read_and_report(options.file, options.quiet, console, read)) return outcome;
    print(console, list_of_methods(&read.problem, colour_wanted(console)));
    return exit_code::solved;
}

}  // namespace

Command add_methods(CLI::App& program) {
    const auto options = std::make_shared<MethodsOptions>();
    CLI::App* command = program.add_subcommand("methods", "List the methods, or which of them apply to a problem");
    command->add_option("FILE", options->file, "Problem file")->option_text(" ");
    command->add_flag("--quiet", options->quiet, "No warnings");
    return {command, [options](Console& console) { return list_methods(*options, console); }};
}

}  // namespace mechwright
