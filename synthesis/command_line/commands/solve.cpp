#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/commands/report.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/solving.h"
#include "synthesis/report/json_text.h"
#include "synthesis/report/text/search_explained.h"
#include "synthesis/report/text/summary.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

struct SolveOptions {
    SolvingOptions solving;
    bool report = false;
};

int solve(const SolveOptions& options, Console& console) {
    nlohmann::ordered_json documents = nlohmann::ordered_json::array();
    NamedDocuments shown;
    const TextStyle style = style_of(console, options.solving.digits);
    bool first = true;
    SolvingRun run =
        solve_files(options.solving, console,
                    [&](const Problem& problem, const Result& result, const auto& document, const SearchTrace* trace) {
                        documents.push_back(document);
                        if (options.report) shown.emplace_back(problem.file, document);
                        if (options.solving.json) return;
                        const std::string rule = first ? "" : "\n" + std::string(terminal_width, '-') + "\n\n";
                        print(console, rule + summary(problem, result, style) +
                                           (trace ? search_explained(problem, result, *trace, style) : ""));
                        first = false;
                    });
    if (!shown.empty()) {
        const std::filesystem::path folder = options.solving.out;
        const std::string page = (folder / "report.html").string();
        // What was solved now comes first.
        if (!options.solving.out.empty())
            for (auto& other : other_results(folder, run.written))
                shown.push_back(std::move(other));
        run.code = exit_code::worse(run.code, write_page(page_on_results(shown), page, options.solving.quiet, console));
    }
    if (!options.solving.json) return run.code;
    if (options.solving.files.size() > 1)
        print(console, json_text(documents));
    else if (!documents.empty())
        print(console, json_text(documents.front()));
    return run.code;
}

}  // namespace

Command add_solve(CLI::App& program) {
    const auto options = std::make_shared<SolveOptions>();
    CLI::App* command = program.add_subcommand("solve", "Synthesise mechanisms and verify them");
    CLI::Option* out = add_solving_options(*command, options->solving);
    command
        ->add_flag("--explain-search", options->solving.explain, "Print how searches ended and where the time went too")
        ->excludes(command->get_option("--json"));
    command->add_flag("--all", options->solving.all, "Put solutions with defects into the alternatives too");
    command->add_flag("--csv", options->solving.csv, "Write tables too: motion; with --all all designs")->needs(out);
    command->add_flag("--report", options->report, "Write report.html too: a page on the folder's results");
    command
        ->add_option("--start-system", options->solving.start_system, "Start system of a homotopy (see start-system)")
        ->type_name("FILE")
        ->check(not_empty);
    return {command, [options](Console& console) { return solve(*options, console); }};
}

}  // namespace mechwright
