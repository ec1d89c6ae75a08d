// study plan, run and merge: one study on many machines.

#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <system_error>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/study/study.h"
#include "synthesis/study/folder.h"
#include "synthesis/study/points.h"

namespace mechwright {

namespace {

struct ChunkOptions : StudyOptions {
    std::optional<std::uint64_t> chunks;
    std::optional<std::uint64_t> chunk;
};

int plan(const ChunkOptions& options, Console& console) {
    PreparedStudy prepared;
    const int code = prepare_and_report(options.file, options.quiet, console, prepared);
    if (code != exit_code::solved) return code;
    StudyPlan plan{prepared.fingerprint, point_count(*prepared.study), strand_count(*prepared.study), *options.chunks};
    if (plan.chunks > plan.strands) {
        complain(console, fmt::format("--chunks: this study can be cut into {} at most: its points are solved in "
                                      "strands of neighbours",
                                      plan.strands));
        return exit_code::wrong_usage;
    }
    const StudyPlanOrNot earlier = read_plan(options.folder);
    if (!earlier.fault.empty() || (earlier.plan && *earlier.plan != plan)) {
        complain(console, earlier.plan
                              ? fmt::format("'{}' holds another plan; name another folder with --out", options.folder)
                              : earlier.fault);
        return exit_code::no_access;
    }
    if (const auto fault = write_plan(options.folder, prepared, plan)) {
        complain(console, *fault);
        return exit_code::no_access;
    }
    if (!options.quiet)
        print(console, fmt::format("{} points in {} chunks; 'mechwright study status {}' says how to run them\n",
                                   plan.points, plan.chunks, options.folder));
    return exit_code::solved;
}

/// The plan of a folder and its study; else the exit code.
int read_planned(const std::string& folder, bool quiet, Console& console, StudyPlan& plan, PreparedStudy& prepared) {
    const StudyPlanOrNot read = read_plan(folder);
    if (!read.plan) {
        complain(console, read.fault.empty()
                              ? fmt::format("there is no plan in '{}': make one with 'mechwright study plan'", folder)
                              : read.fault);
        return exit_code::no_access;
    }
    plan = *read.plan;
    const int code = prepare_and_report(planned_problem(folder).string(), quiet, console, prepared);
    if (code != exit_code::solved) return code;
    if (prepared.fingerprint == plan.fingerprint) return exit_code::solved;
    complain(console, fmt::format("'{}': the problem, a file that it names or the version of mechwright is not that of "
                                  "the plan; plan the study again into a new folder",
                                  folder));
    return exit_code::no_access;
}

/// --chunk, or what Slurm's array or GNU parallel says.
std::optional<std::uint64_t> chosen_chunk(const ChunkOptions& options) {
    if (options.chunk) return options.chunk;
    for (const char* name : {"SLURM_ARRAY_TASK_ID", "PARALLEL_SEQ"}) {
        const char* text = std::getenv(name);
        if (text == nullptr) continue;
        std::uint64_t number = 0;
        const char* end = text + std::strlen(text);
        const auto [stop, error] = std::from_chars(text, end, number);
        if (error == std::errc{} && stop == end) return number;
    }
    return {};
}

int run_chunk(const StudyPlan& plan, const PreparedStudy& prepared, std::uint64_t chunk, const ChunkOptions& options,
              Console& console) {
    const std::filesystem::path part = part_file(options.file, chunk), partial = partial_file(options.file, chunk);
    if (std::filesystem::exists(part)) {
        if (!options.quiet) console.err << fmt::format("chunk {} is complete", chunk) << std::endl;
        return exit_code::solved;
    }
    StudyStore store(partial, prepared, true);
    const auto [first, last] = strands_of_chunk(plan, chunk);
    StudyRun outcome;
    const int code = run_strands(prepared, store, options, first, last, console, outcome);
    store.close();
    if (code != exit_code::solved) return code;
    std::error_code error;
    std::filesystem::rename(partial, part, error);
    if (!error) return exit_code::solved;
    complain(console, fmt::format("cannot rename '{}': {}", partial.string(), error.message()));
    return exit_code::no_access;
}

int run(const ChunkOptions& options, Console& console) {
    const auto chunk = chosen_chunk(options);
    if (!chunk) {
        complain(console, "study run needs --chunk K, or SLURM_ARRAY_TASK_ID or PARALLEL_SEQ in the environment");
        return exit_code::wrong_usage;
    }
    StudyPlan plan;
    PreparedStudy prepared;
    const int code = read_planned(options.file, options.quiet, console, plan, prepared);
    if (code != exit_code::solved) return code;
    if (*chunk < 1 || *chunk > plan.chunks) {
        complain(console,
                 fmt::format("chunk {} is not one of the plan: they are counted from 1 to {}", *chunk, plan.chunks));
        return exit_code::wrong_usage;
    }
    return guarded(console, [&] { return run_chunk(plan, prepared, *chunk, options, console); });
}

int merge_parts(const StudyPlan& plan, const PreparedStudy& prepared, const ChunkOptions& options, Console& console) {
    const std::filesystem::path data = data_file(options.file);
    const std::filesystem::path gathered = data.string() + ".gathered", compact = data.string() + ".compact";
    std::error_code error;
    for (const auto& left_over : {gathered, compact})
        std::filesystem::remove(left_over, error);
    StudyStore store(gathered, prepared, true);
    for (std::uint64_t chunk = 1; chunk <= plan.chunks; ++chunk)
        store.take_over(part_file(options.file, chunk));
    if (const std::uint64_t points = store.count(); points != plan.points)
        throw StoreFault(
            fmt::format("the parts hold {} points and not {}: one of them is damaged; remove it and run its "
                        "chunk again",
                        points, plan.points));
    store.write_compact(compact);
    store.close();
    std::filesystem::remove(gathered, error);
    std::filesystem::rename(compact, data, error);
    if (error) throw StoreFault(fmt::format("cannot rename '{}': {}", compact.string(), error.message()));
    if (options.quiet) return exit_code::solved;
    print(console, standing_text(data) + fmt::format("Data: {}\n", data.string()));
    return exit_code::solved;
}

int merge(const ChunkOptions& options, Console& console) {
    StudyPlan plan;
    PreparedStudy prepared;
    const int code = read_planned(options.file, options.quiet, console, plan, prepared);
    if (code != exit_code::solved) return code;
    if (const auto missing = missing_chunks(options.file, plan); !missing.empty()) {
        complain(console, fmt::format("{} of {} chunks are missing: {}; 'mechwright study status {}' says how to run "
                                      "them",
                                      missing.size(), plan.chunks, as_ranges(missing), options.file));
        return exit_code::limit;
    }
    return guarded(console, [&] { return merge_parts(plan, prepared, options, console); });
}

}  // namespace

std::vector<Command> add_study_chunks(CLI::App& study) {
    constexpr std::uint64_t most_chunks = 99'999;
    const auto planning = std::make_shared<ChunkOptions>();
    CLI::App* planned = study.add_subcommand("plan", "Cut a study into chunks for many machines");
    planned->add_option("FILE", planning->file, "Problem file with a [study]")->required()->option_text(" ");
    planned->add_option("--out", planning->folder, "Folder of the study")
        ->required()
        ->type_name("DIR")
        ->check(not_empty);
    add_whole_number(*planned, "--chunks", planning->chunks, 1, most_chunks, "Number of chunks")->required();
    planned->add_flag("--quiet", planning->quiet, "Nothing but errors");

    const auto running = std::make_shared<ChunkOptions>();
    CLI::App* ran = study.add_subcommand("run", "Run one chunk of a plan");
    ran->add_option("DIR", running->file, "Folder of the study")->required()->option_text(" ");
    add_whole_number(*ran, "--chunk", running->chunk, 1, most_chunks,
                     "Which chunk (SLURM_ARRAY_TASK_ID or PARALLEL_SEQ)");
    add_run_options(*ran, *running);

    const auto merging = std::make_shared<ChunkOptions>();
    CLI::App* merged = study.add_subcommand("merge", "Join the parts of all chunks");
    merged->add_option("DIR", merging->file, "Folder of the study")->required()->option_text(" ");
    merged->add_flag("--quiet", merging->quiet, "Nothing but errors");

    return {{planned, [planning](Console& console) { return plan(*planning, console); }},
            {ran, [running](Console& console) { return run(*running, console); }},
            {merged, [merging](Console& console) { return merge(*merging, console); }}};
}

}  // namespace mechwright
