#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/solving.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/summary.h"
#include "synthesis/report/table.h"

namespace mechwright {

namespace {

int solve(const SolvingOptions& options, Console& console) {
    nlohmann::ordered_json documents = nlohmann::ordered_json::array();
    bool first = true;
    const SolvingRun run =
        solve_files(options, console, [&](const Problem& problem, const Result& result, const auto& document) {
            documents.push_back(document);
            if (options.json) return;
            const std::string rule = first ? "" : "\n" + std::string(terminal_width, '-') + "\n\n";
            print(console, rule + summary(problem, result, colour_wanted(console)));
            first = false;
        });
    if (!options.json) return run.code;
    if (options.files.size() > 1)
        print(console, json_text(documents));
    else if (!documents.empty())
        print(console, json_text(documents.front()));
    return run.code;
}

}  // namespace

Command add_solve(CLI::App& program) {
    const auto options = std::make_shared<SolvingOptions>();
    CLI::App* command = program.add_subcommand("solve", "Synthesise mechanisms and verify them");
    CLI::Option* out = add_solving_options(*command, *options);
    command->add_flag("--all", options->all, "Put solutions with defects into the alternatives too");
    command->add_flag("--csv", options->csv, "Write tables too: motion; with --all all designs")->needs(out);
    command->add_option("--start-system", options->start_system, "Start system of a homotopy (see start-system)")
        ->type_name("FILE")
        ->check(not_empty);
    return {command, [options](Console& console) { return solve(*options, console); }};
}

}  // namespace mechwright
