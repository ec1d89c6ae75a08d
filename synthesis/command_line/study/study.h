#pragma once
/// \file
/// What the commands of studies share.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/console.h"
#include "synthesis/study/run.h"

namespace mechwright {

struct StudyOptions {
    std::string file;    ///< of the problem, or the folder
    std::string folder;  ///< --out
    bool quiet = false;
    std::optional<std::uint64_t> jobs;
    std::optional<double> time_limit;
};

/// Adds --jobs, --time-limit and --quiet.
void add_run_options(CLI::App& command, StudyOptions& options);

/// Reads the study of a file and reports what is wrong with it. Returns the exit code.
int prepare_and_report(const std::string& file, bool quiet, Console& console, PreparedStudy& prepared);

/// Runs strands with progress and Ctrl-C, and says in `outcome` what came of it. Returns the exit code: 0 if all of
/// them are done.
int run_strands(const PreparedStudy& prepared, StudyStore& store, const StudyOptions& options, std::uint64_t first,
                std::uint64_t last, Console& console, StudyRun& outcome);

/// Below `study`: plan, run and merge; status, export and charts; driver.
std::vector<Command> add_study_chunks(CLI::App& study);
std::vector<Command> add_study_data(CLI::App& study);
Command add_study_driver(CLI::App& study);

/// "10 000 points: 9 012 solved, 988 infeasible", and what came of neighbours.
std::string standing_text(const std::filesystem::path& data);

/// Runs what touches the files of a study: their faults are reported. Returns the exit code.
int guarded(Console& console, const std::function<int()>& work);

}  // namespace mechwright
