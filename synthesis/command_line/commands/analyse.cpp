#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/options.h"
#include "synthesis/document/document.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/program/assess.h"
#include "synthesis/program/left_open.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/csv/motion_table.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/structure/centres.h"
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
    std::optional<std::uint64_t> digits;
    bool centres = false;
    std::string at;
};

/// The instant centres of a design at the input that is asked for, else where pictures show it. Returns the exit code.
int show_centres(const AnalyseOptions& options, const Problem& problem, const Design& design, Console& console) {
    if (!is_of_links(*problem.mechanism)) {
        complain(console, fmt::format("{}: a {} has no links and joints, of which instant centres are", options.file,
                                      problem.mechanism->name));
        return exit_code::invalid_file;
    }
    double master = pictured_angle(finished_design(problem, design));
    if (!options.at.empty()) {
        const std::optional<double> at = decimal(options.at);
        if (!at) {
            complain(console, "--at must be a number, not " + reading::quoted(options.at));
            return exit_code::wrong_usage;
        }
        master = from_file_unit(*at, input_unit(*problem.mechanism), problem.units);
    }
    const auto centres = centres_of({problem.mechanism, design.dimensions, design.assembly}, master);
    if (!centres) {
        complain(console,
                 fmt::format("{}: at {} it does not close, or stands at a dead position: links are infinitely "
                             "fast there",
                             options.file, in_file_unit(master, input_unit(*problem.mechanism), problem.units)));
        return exit_code::infeasible;
    }
    print(console,
          options.json
              ? json_text(centres_json(*centres, in_file_unit(master, input_unit(*problem.mechanism), problem.units),
                                       problem.units))
              : centres_text(*centres, in_file_unit(master, input_unit(*problem.mechanism), problem.units),
                             problem.units));
    return exit_code::solved;
}

int analyse(const AnalyseOptions& options, Console& console) {
    ReadProblem read;
    if (const int outcome = read_and_report(options.file, options.quiet, console, read)) return outcome;
    const Problem& problem = read.problem;
    if (const std::string open = why_not_analysable(problem); !open.empty()) {
        console.err << to_string(Message{.file = problem.file, .text = open}) << std::endl;
        return exit_code::invalid_file;
    }

    const Solution given = evaluate_given(problem);
    if (options.centres) return show_centres(options, problem, given.design, console);
    if (options.csv)
        print(console,
              motion_table(problem, given.design, static_cast<int>(options.steps.value_or(default_table_steps))));
    else if (options.json)
        print(console, json_text(analysis_document(problem, given)));
    else
        print(console, analysis_summary(problem, given, style_of(console, options.digits)));

    const Motion motion = motion_of(problem, given.design);
    if (!(motion.from <= motion.to)) {
        complain(console, fmt::format("{}: the mechanism does not assemble at any {}", options.file,
                                      input_word(*problem.mechanism)));
        return exit_code::infeasible;
    }
    const std::string apart = where_it_comes_apart(problem, given.design, style_of(console, options.digits).digits);
    if (apart.empty()) return exit_code::solved;
    complain(console, options.file + ": " + apart);
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
    CLI::Option* centres =
        command->add_flag("--instant-centres", options->centres, "The instant centres of all pairs of links")
            ->excludes(csv);
    command->add_option("--at", options->at, "Crank angle of these")->option_text("NUMBER")->needs(centres);
    add_digits(*command, options->digits);
    command->add_flag("--quiet", options->quiet, "No warnings");
    return {command, [options](Console& console) { return analyse(*options, console); }};
}

}  // namespace mechwright
