#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/options.h"
#include "synthesis/document/document.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/left_open.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv/motion_table.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/text/summary.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

namespace {

struct AnalyseOptions {
    std::string file;
    bool csv = false;
    bool json = false;
    bool quiet = false;
    std::optional<std::uint64_t> steps;
};

int analyse(const AnalyseOptions& options, Console& console) {
    ReadProblem read;
    if (const int outcome = read_and_report(options.file, options.quiet, console, read)) return outcome;
    const Problem& problem = read.problem;
    if (const std::string open = why_not_analysable(problem); !open.empty()) {
        console.err << to_string(Message{.file = problem.file, .text = open}) << std::endl;
        return exit_code::invalid_file;
    }

    const Solution given = evaluate_given(problem);
    if (options.csv)
        print(console,
              motion_table(problem, given.design, static_cast<int>(options.steps.value_or(default_table_steps))));
    else if (options.json)
        print(console, json_text(analysis_document(problem, given)));
    else
        print(console, analysis_summary(problem, given, colour_wanted(console)));

    const Motion motion = motion_of(problem, given.design);
    if (motion.from <= motion.to) return exit_code::solved;
    complain(console, fmt::format("{}: the mechanism does not assemble at any {}", options.file,
                                  input_word(*problem.mechanism)));
    return exit_code::infeasible;
}

}  // namespace

Command add_analyse(CLI::App& program) {
    const auto options = std::make_shared<AnalyseOptions>();
    CLI::App* command = program.add_subcommand("analyse", "Evaluate a fully dimensioned mechanism");
    command->add_option("FILE", options->file, "Problem file with one value for each dimension")
        ->required()
        ->option_text(" ");
    CLI::Option* csv = command->add_flag("--csv", options->csv, "Print the motion as a table");
    add_whole_number(*command, "--steps", options->steps, 1, most_table_steps, "Steps over the motion (360)")
        ->needs(csv);
    command->add_flag("--json", options->json, "Print the result document")->excludes(csv);
    command->add_flag("--quiet", options->quiet, "No warnings");
    return {command, [options](Console& console) { return analyse(*options, console); }};
}

}  // namespace mechwright
