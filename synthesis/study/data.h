#pragma once
/// \file
/// The data of a study as its users see them.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

enum class DataFormat { csv, json };

/// How far a study is.
struct StudyStanding {
    std::string title;
    std::uint64_t points = 0;  ///< there are to be
    std::uint64_t done = 0;
    std::vector<std::pair<std::string, std::uint64_t>> statuses;  ///< points by status, the most frequent first
    std::uint64_t from_neighbours = 0;  ///< points whose design was found from that of the point before
    std::uint64_t both_ways = 0;        ///< points solved by a search of their own too
    std::uint64_t differed = 0;         ///< of those the ones where that found a better design
};

/// "49 of 100 points: 40 solved, 9 infeasible"
std::string tally(const StudyStanding& standing);

/// Throws StoreFault where there are no data, as do the others.
StudyStanding standing_of_study(const std::filesystem::path& data);

/// The text of the study's problem file.
std::string problem_text(const std::filesystem::path& data);

/// Writes the study's problem file and the files that it names below a folder, to the same places as seen from the
/// problem file, and returns that. Files with absolute names are left out.
std::filesystem::path write_study_files(const std::filesystem::path& data, const std::filesystem::path& folder);

struct StudyQuery {
    std::string sql;         ///< one SELECT; empty for all points in order
    double time_limit = 60;  ///< seconds
};

/// What a query gives, as text, row by row. It can read the data, and neither change them nor reach other files. `take`
/// returns whether it wants more. False where the time limit ended it. Throws SqlFault for a query that SQLite does not
/// understand, or that does more than read.
bool export_data(const std::filesystem::path& data, const StudyQuery& query, DataFormat format,
                 const std::function<bool(std::string_view)>& take);

/// A point of a study as it stands in the data.
struct StudyPoint {
    std::uint64_t number = 0;
    nlohmann::ordered_json row;    ///< column -> value, without those that are empty
    std::optional<Design> design;  ///< exactly, where there is one that the data can be trusted with
};

/// Hands out all points in order.
void for_each_point(const std::filesystem::path& data, const std::function<void(const StudyPoint&)>& take);

struct SqlFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

}  // namespace mechwright
