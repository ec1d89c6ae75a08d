#pragma once
/// \file
/// What the commands that solve problem files share: their options, reading, solving with progress, and keeping
/// results.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/command_line/console.h"
#include "synthesis/program/search_trace.h"

namespace mechwright {

struct SolvingOptions {
    std::vector<std::string> files;
    std::string out;
    bool csv = false;  ///< motion tables beside the results
    bool json = false;
    bool all = false;      ///< solutions with defects too
    bool explain = false;  ///< keep what the search went through
    bool quiet = false;
    std::optional<std::uint64_t> seed;
    std::optional<std::uint64_t> jobs;
    std::optional<double> time_limit;
    std::optional<std::uint64_t> digits;
    std::string method;
    std::string start_system;  ///< a file; none: what comes with the program
};

/// Adds FILE, --out, --json, --seed, --jobs, --time-limit, --method, --digits and --quiet; returns --out. `options`
/// must outlive the command.
CLI::Option* add_solving_options(CLI::App& command, SolvingOptions& options);

/// What a run over several files came to.
struct SolvingRun {
    int code = 0;
    std::vector<Status> outcomes;      ///< of those that were solved, in order
    std::vector<std::string> written;  ///< names of their files in the folder of --out, without endings
};

/// Reads all files, solves those that can be, one after the other, writes what --out asks for and hands each result
/// out, with its trace if `explain` asks for it, else null. A file that cannot be solved costs the others nothing. At
/// the end of several, a tally on standard error.
using TakeResult = std::function<void(const Problem&, const Result&, const nlohmann::ordered_json& document,
                                      const SearchTrace* trace)>;
SolvingRun solve_files(const SolvingOptions& options, Console& console, const TakeResult& take);

}  // namespace mechwright
