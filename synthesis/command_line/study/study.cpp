#include "synthesis/command_line/study/study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <thread>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/interrupt.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/progress_line.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/report/text/table.h"
#include "synthesis/study/data.h"
#include "synthesis/study/folder.h"
#include "synthesis/study/tolerance.h"
#include "synthesis/study/tolerance_text.h"

namespace mechwright {

namespace {

/// All cores, or as many as Slurm gives a task.
int default_jobs() {
    const char* given = std::getenv("SLURM_CPUS_PER_TASK");
    const int cores = given != nullptr ? std::atoi(given) : 0;
    return cores > 0 ? std::min(cores, 1024) : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
}

int run_all(const PreparedStudy& prepared, const StudyOptions& options, Console& console) {
    if (const auto fault = prepare_folder(options.folder)) {
        complain(console, *fault);
        return exit_code::no_access;
    }
    const FolderLock lock(options.folder);
    if (!lock.fault().empty()) {
        complain(console, lock.fault());
        return exit_code::no_access;
    }
    StudyStore store(data_file(options.folder), prepared, false);
    StudyRun outcome;
    const int code = run_strands(prepared, store, options, 0, UINT64_MAX, console, outcome);
    store.close();
    if (options.quiet) return code;
    const std::filesystem::path data = data_file(options.folder);
    print(console, standing_text(data));
    if (code == exit_code::solved && outcome.design)
        print(console, tolerance_text(tolerance_report(prepared, *outcome.design, data)));
    print(console, fmt::format("Data: {}\n", data.string()));
    return code;
}

int study(const StudyOptions& options, Console& console) {
    if (options.file.empty()) {
        complain(console,
                 "study needs a FILE and --out DIR, or one of plan, run, merge, status, export, charts, driver");
        return exit_code::wrong_usage;
    }
    if (options.folder.empty()) {
        complain(console, "study needs --out DIR: the folder that keeps the data, so that a study can go on");
        return exit_code::wrong_usage;
    }
    PreparedStudy prepared;
    const int code = prepare_and_report(options.file, options.quiet, console, prepared);
    if (code != exit_code::solved) return code;
    return guarded(console, [&] { return run_all(prepared, options, console); });
}

}  // namespace

void add_run_options(CLI::App& command, StudyOptions& options) {
    add_whole_number(command, "--jobs", options.jobs, 1, 1024, "Threads (all); the data do not depend on it");
    add_positive_number(command, "--time-limit", options.time_limit, "Seconds after which no other point is begun");
    command.add_flag("--quiet", options.quiet, "Nothing but errors");
}

int prepare_and_report(const std::string& file, bool quiet, Console& console, PreparedStudy& prepared) {
    PreparedOrNot outcome = prepare_study(file);
    for (const Message& message : outcome.messages)
        if (!message.warning || !quiet) console.err << to_string(message) << '\n';
    console.err << std::flush;
    if (outcome.unreadable) return exit_code::no_access;
    if (!outcome.ok) return exit_code::invalid_file;
    prepared = std::move(outcome.prepared);
    return report_method_fault(prepared.base, console);
}

int run_strands(const PreparedStudy& prepared, StudyStore& store, const StudyOptions& options, std::uint64_t first,
                std::uint64_t last, Console& console, StudyRun& outcome) {
    const Interrupt interrupt(!options.quiet && console.err_is_terminal);
    ProgressLine line{&console, prepared.file, ""};
    StudyRunOptions run;
    run.jobs = static_cast<int>(options.jobs.value_or(static_cast<std::uint64_t>(default_jobs())));
    run.stop = &Interrupt::requested();
    run.first_strand = first;
    run.last_strand = last;
    const auto begin = std::chrono::steady_clock::now();
    if (options.time_limit)
        run.deadline = begin + std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                                   std::chrono::duration<double>(std::min(*options.time_limit, 1e9)));
    if (!options.quiet && progress_wanted(console))
        run.progress = [&line](std::uint64_t done, std::uint64_t newly, std::uint64_t total) {
            draw_points(line, done, newly, total);
        };
    outcome = run_study(prepared, store, run);
    erase(line);
    if (!outcome.fault.empty()) {
        complain(console, outcome.fault);
        return outcome.unsolved_design ? exit_code::infeasible : exit_code::no_access;
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    if (!options.quiet && outcome.solved > 0)
        console.err << fmt::format("{} points in {:.1f} s, {:.4g} a second", outcome.solved, seconds,
                                   static_cast<double>(outcome.solved) / seconds)
                    << std::endl;
    if (outcome.complete) return exit_code::solved;
    return Interrupt::requested() ? exit_code::interrupted : exit_code::limit;
}

std::string standing_text(const std::filesystem::path& data) {
    const StudyStanding standing = standing_of_study(data);
    std::string text = standing.title.empty() ? "" : standing.title + "\n";
    text += tally(standing) + '\n';
    if (standing.both_ways + standing.from_neighbours > 0)
        text += folded("", fmt::format("{} solved from their neighbours alone; {} both ways, of which {} had a better "
                                       "design of their own (all points beside those were solved again)",
                                       standing.from_neighbours, standing.both_ways, standing.differed));
    return text;
}

int guarded(Console& console, const std::function<int()>& work) {
    try {
        return work();
    } catch (const StoreFault& fault) {
        complain(console, fault.what());
        return exit_code::no_access;
    }
}

Command add_study(CLI::App& program) {
    const auto options = std::make_shared<StudyOptions>();
    CLI::App* command = program.add_subcommand("study", "Solve a problem for many values of what it says");
    command->add_option("FILE", options->file, "Problem file with a [study]")->option_text(" ");
    command->add_option("--out", options->folder, "Folder of the study: new, or one to go on with")
        ->type_name("DIR")
        ->check(not_empty);
    add_run_options(*command, *options);
    command->require_subcommand(0, 1);
    std::vector<Command> below = add_study_chunks(*command);
    for (Command& other : add_study_data(*command))
        below.push_back(std::move(other));
    below.push_back(add_study_driver(*command));
    const auto run = [options, command, below](Console& console) {
        for (const Command& other : below)
            if (command->got_subcommand(other.options)) return other.run(console);
        return study(*options, console);
    };
    return {command, run};
}

}  // namespace mechwright
