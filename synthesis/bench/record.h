#pragma once
/// \file
/// What has been measured so far, in one file of the results' folder, so that a run that was interrupted goes on.

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "synthesis/bench/section.h"

namespace mechwright::bench {

/// Where and with what was measured: what has to be the same for a run to go on.
struct Surroundings {
    std::string program;       ///< version and revision
    std::string compiler;      ///< with its flags
    std::string libraries;     ///< versions
    std::string processor;     ///< and how many
    std::string instructions;  ///< that lanes use
    bool full = false;

    bool operator==(const Surroundings&) const = default;
};

Surroundings surroundings(bool full);

/// The rows of a section by measurement, in the order in which they were made.
using SectionRecord = std::vector<std::pair<std::string, std::vector<Row>>>;

struct Record {
    Surroundings surroundings;
    std::map<std::string, SectionRecord, std::less<>> sections;

    bool has(std::string_view section, std::string_view measurement) const;
};

/// The table of a section in the order of its measurements; those not made yet are not in it.
Sheet sheet_of(const Record& record, const Section& section, const std::vector<Measurement>& measurements);

/// What stands in the file; nothing where there is none, or it is no record.
std::optional<Record> read_record(const std::filesystem::path& file);

/// Writes it, whole or not at all; what went wrong, or nothing.
std::optional<std::string> write_record(const std::filesystem::path& file, const Record& record);

}  // namespace mechwright::bench
