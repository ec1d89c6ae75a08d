#pragma once
/// \file
/// Runs a study, or the part of it that is not done yet.

#include <atomic>
#include <chrono>
#include <functional>
#include <memory>
#include <string>

#include "synthesis/study/store.h"

namespace mechwright {

struct StudyRunOptions {
    int jobs = 1;
    const std::atomic<bool>* stop = nullptr;
    std::chrono::steady_clock::time_point deadline = std::chrono::steady_clock::time_point::max();
    /// Called now and then, one call at a time: points in the data, those of them from this run, and how many there are
    /// to be.
    std::function<void(std::uint64_t done, std::uint64_t newly, std::uint64_t total)> progress;
    std::uint64_t first_strand = 0;
    std::uint64_t last_strand = UINT64_MAX;  ///< not run itself
};

struct TolerancedDesign;

struct StudyRun {
    std::uint64_t points = 0;      ///< of the strands asked for
    std::uint64_t solved = 0;      ///< points dealt with in this run
    bool complete = false;         ///< all strands asked for are done
    std::string fault;             ///< of the store, which ended the run; what was done before is kept
    bool unsolved_design = false;  ///< the fault is that there is no design whose tolerances could be sampled
    std::shared_ptr<const TolerancedDesign> design{};  ///< whose tolerances were sampled, where that was asked for
};

/// Runs the strands that are not finished. Each point goes into the store as soon as it is done. What the data are at
/// the end depends neither on the number of jobs nor on how often the run was ended and begun again, unless a point
/// meets its time limit.
StudyRun run_study(const PreparedStudy& prepared, StudyStore& store, const StudyRunOptions& options);

}  // namespace mechwright
