#pragma once
/// \file
/// A run of the benchmarks: measures what has not been measured, keeps each measurement as soon as it is made, and
/// writes tables, diagrams and the report from what has been kept.

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/bench/section.h"

namespace mechwright::bench {

struct BenchRun {
    Effort effort;
    std::filesystem::path folder;   ///< README.md stands here, all else in bench/ below it
    std::vector<std::string> only;  ///< names of sections; empty: all
    bool anew = false;              ///< nothing that was measured before counts
    /// Called before each measurement: its section, its name, how many of how many are done.
    std::function<void(std::string_view section, std::string_view name, int done, int total)> progress;
};

/// What became of it: a fault that a user can put right (no folder, no room), or nothing. After a stop the report is
/// not written: what was measured is kept for the next run.
struct BenchOutcome {
    std::string fault;
    bool finished = false;
    int taken_over = 0;  ///< measurements of an earlier run of the same program on the same machine
};

BenchOutcome run_bench(const BenchRun& run);

}  // namespace mechwright::bench
