// mechwright-bench: speed against error, measured here.

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <thread>

#include "synthesis/bench/run.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/interrupt.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/other_programs.h"
#include "synthesis/command_line/progress_line.h"
#include "synthesis/command_line/run.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

struct BenchOptions {
    std::string folder = "results";
    std::string problems = "problems";
    std::vector<std::string> only;
    std::optional<std::uint64_t> jobs;
    bool full = false;
    bool anew = false;
    bool quiet = false;
};

/// What is wrong with the options; empty if nothing is.
std::string fault_of(const BenchOptions& options) {
    std::vector<std::string_view> names;
    for (const bench::Section& section : bench::sections())
        names.push_back(section.name);
    for (const std::string& name : options.only)
        if (std::find(names.begin(), names.end(), name) == names.end())
            return fmt::format("unknown section {}; {}", reading::quoted(std::string_view(name)),
                               reading::remedy(name, names));
    if (!std::filesystem::is_directory(options.problems))
        return fmt::format(
            "there is no folder {}: bench needs the problems that come with mechwright; run it where "
            "they are, or name them by --problems DIR",
            reading::quoted(std::string_view(options.problems)));
    return {};
}

bench::BenchRun run_of(const BenchOptions& options) {
    bench::BenchRun run;
    run.effort.full = options.full;
    run.effort.jobs = static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
    run.effort.problems = options.problems;
    run.effort.program = called("mechwright");
    run.effort.stop = &Interrupt::requested();
    run.folder = options.folder;
    run.only = options.only;
    run.anew = options.anew;
    return run;
}

int measure(const BenchOptions& options, Console& console) {
    if (const std::string fault = fault_of(options); !fault.empty()) {
        complain(console, fault);
        return exit_code::wrong_usage;
    }
    bench::BenchRun run = run_of(options);
    ProgressLine line{&console, "", ""};
    if (!options.quiet && progress_wanted(console))
        run.progress = [&](std::string_view section, std::string_view name, int done, int total) {
            line.label = fmt::format("{}: {}", section, name);
            draw_measurements(line, done, total);
        };
    const Interrupt interrupt(!options.quiet);
    const bench::BenchOutcome outcome = run_bench(run);
    erase(line);
    if (!outcome.fault.empty()) {
        complain(console, outcome.fault);
        return exit_code::no_access;
    }
    if (!outcome.finished) {
        if (!options.quiet) console.err << "What was measured is kept; the same command goes on.\n" << std::flush;
        return exit_code::interrupted;
    }
    if (!options.quiet) {
        if (outcome.taken_over > 0) console.err << outcome.taken_over << " measurements are of an earlier run.\n";
        print(console, fmt::format("Report: {}\n", (run.folder / "README.md").string()));
    }
    return exit_code::solved;
}

void add_options(CLI::App& program, BenchOptions& options) {
    std::string names;
    for (const bench::Section& section : bench::sections())
        names += fmt::format("{}{}", names.empty() ? "" : ", ", section.name);
    program.add_option("--out", options.folder, "Folder for the report and its data (results)")->option_text("DIR");
    program.add_flag("--full", options.full, "Thorough: two hours instead of two minutes");
    program.add_option("--only", options.only, "Sections to measure; all stay in the report")->option_text("SECTION");
    program.add_option("--problems", options.problems, "Problems that come with mechwright (problems)")
        ->option_text("DIR");
    program.add_flag("--anew", options.anew, "Measure again what was measured before");
    add_whole_number(program, "--jobs", options.jobs, 1, 1024, "Threads (all)");
    program.add_flag("--quiet", options.quiet, "Nothing but errors on standard error");
    program.footer(folded("Sections: ", names + ".") +
                   "A run that was interrupted goes on when the command is repeated.");
}

}  // namespace

}  // namespace mechwright

int main(int argc, char** argv) {
    using namespace mechwright;
    // A closed pipe and a full file are errors of writing, not the end of the program.
    ::signal(SIGPIPE, SIG_IGN);
    ::signal(SIGXFSZ, SIG_IGN);
    Console console{std::cout, std::cerr, ::isatty(STDOUT_FILENO) == 1, ::isatty(STDERR_FILENO) == 1};
    return run_guarded(console, [&] {
        CLI::App program("Measure speed against error: tables, diagrams.", "mechwright bench");
        BenchOptions options;
        add_options(program, options);
        if (const auto code = read_command_line(program, argc, argv, console)) return *code;
        return measure(options, console);
    });
}
