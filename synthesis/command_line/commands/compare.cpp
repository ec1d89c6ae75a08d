#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/solving.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/text/comparison.h"

namespace mechwright {

namespace {

struct CompareOptions {
    SolvingOptions solving;
    bool csv = false;
};

int compare(const CompareOptions& options, Console& console) {
    if (options.solving.files.size() < 2) {
        complain(console, "compare needs two problem files or more");
        return exit_code::wrong_usage;
    }
    std::vector<Compared> all;
    const SolvingRun run =
        solve_files(options.solving, console, [&](const Problem& problem, const Result& result, const auto&, auto) {
            all.push_back({problem, result});
        });
    if (all.empty()) return run.code;
    if (!options.solving.quiet)
        if (const std::string differences = differences_of_tasks(all); !differences.empty())
            console.err << "The tasks differ: " << differences << std::flush;
    const TextStyle style = style_of(console, options.solving.digits);
    const std::vector<Compared> rows = ranked(std::move(all));
    print(console, options.solving.json ? json_text(comparison_json(rows))
                   : options.csv        ? comparison_csv(rows)
                                        : comparison_table(rows, style));
    return run.code;
}

}  // namespace

Command add_compare(CLI::App& program) {
    const auto options = std::make_shared<CompareOptions>();
    CLI::App* command = program.add_subcommand("compare", "Solve one task on several mechanisms: one table");
    add_solving_options(*command, options->solving);
    command->add_flag("--csv", options->csv, "Print the table as comma-separated values")
        ->excludes(command->get_option("--json"));
    return {command, [options](Console& console) { return compare(*options, console); }};
}

}  // namespace mechwright
