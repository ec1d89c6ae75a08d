#pragma once
/// \file
/// The folder of a study: its data, and for one that is run in chunks the plan, a copy of the problem file and a part
/// for each chunk.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "synthesis/study/prepare.h"

namespace mechwright {

/// The data of a whole study.
std::filesystem::path data_file(const std::filesystem::path& folder);

/// While one exists, no other process can run in the folder. The system gives the lock up with the process, however
/// that ends.
class FolderLock {
public:
    explicit FolderLock(const std::filesystem::path& folder);
    ~FolderLock();
    FolderLock(const FolderLock&) = delete;
    FolderLock& operator=(const FolderLock&) = delete;

    /// Why the folder could not be locked; empty if it is.
    const std::string& fault() const { return fault_; }

private:
    int folder_ = -1;
    std::string fault_;
};

/// How a study is cut for many machines.
struct StudyPlan {
    std::string fingerprint;  ///< of the study (PreparedStudy)
    std::uint64_t points = 0;
    std::uint64_t strands = 0;
    std::uint64_t chunks = 0;

    friend bool operator==(const StudyPlan&, const StudyPlan&) = default;
};

struct StudyPlanOrNot {
    std::optional<StudyPlan> plan;
    std::string fault;  ///< where there is a plan that cannot be read
};

/// The plan in a folder, if there is one.
StudyPlanOrNot read_plan(const std::filesystem::path& folder);

/// The problem file of a planned study.
std::filesystem::path planned_problem(const std::filesystem::path& folder);

/// Writes the plan, the problem file and the files that it names. Returns what went wrong, or nothing.
std::optional<std::string> write_plan(const std::filesystem::path& folder, const PreparedStudy& prepared,
                                      const StudyPlan& plan);

/// The strands of a chunk, counted from 1: from the first up to the second.
std::pair<std::uint64_t, std::uint64_t> strands_of_chunk(const StudyPlan& plan, std::uint64_t chunk);

/// The finished data of a chunk, and those of one that is being worked on.
std::filesystem::path part_file(const std::filesystem::path& folder, std::uint64_t chunk);
std::filesystem::path partial_file(const std::filesystem::path& folder, std::uint64_t chunk);

/// The chunks that are not finished.
std::vector<std::uint64_t> missing_chunks(const std::filesystem::path& folder, const StudyPlan& plan);

/// "1-3,7": how Slurm writes a list of numbers.
std::string as_ranges(const std::vector<std::uint64_t>& numbers);

}  // namespace mechwright
