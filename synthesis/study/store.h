#pragma once
/// \file
/// The data of a study in an SQLite file: one table `points`, a row for each point, and beside it what a run needs to
/// go on. Every row is safe from the end of the program once it has been put.

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/study/prepare.h"
#include "synthesis/study/row_sums.h"

namespace mechwright {

/// How long another program may hold the data before this one gives up.
constexpr int patience_in_milliseconds = 5'000;

/// A value of the data; nothing where there is none.
using Cell = std::variant<std::monostate, std::int64_t, double, std::string>;

/// A point as it stands in the data, without what can be found from its number.
struct StudyRow {
    std::uint64_t point = 0;
    std::vector<Cell> cells;       ///< in the order of StudyColumns::names
    std::optional<Design> design;  ///< exactly; where there is one
};

/// What a run needs of a point that has been solved.
struct KnownPoint {
    std::string status;
    std::string start;
    bool proved = false;
    std::optional<Design> design;
};

/// How far a strand is: whether its last point, solved without help, was better than with it, so that all of them are
/// solved again.
struct StrandCheck {
    bool differed = false;
    bool finished = false;
};

/// What is wrong with a study's files, for its user.
struct StoreFault : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Throws StoreFault if the file cannot be used, is locked by another program, or the disk is full; what has been put
/// before stays. Safe to use from several threads.
class StudyStore {
public:
    /// Opens the file of a study, or makes it. `alone`: nobody else can use it meanwhile, which works on network file
    /// systems too.
    StudyStore(const std::filesystem::path& file, const PreparedStudy& prepared, bool alone);

    std::optional<KnownPoint> find(std::uint64_t point);
    void put(const StudyRow& row);
    void put(std::span<const StudyRow> rows);
    /// Notes that a point was solved without help too, and that this did not find a better design.
    void put_solved_both_ways(std::uint64_t point);

    StrandCheck check_of(std::uint64_t strand);
    void put_check(std::uint64_t strand, const StrandCheck& check);

    /// Points that are in the data.
    std::uint64_t count();

    /// Takes over all that another study's file holds.
    void take_over(const std::filesystem::path& part);

    /// Writes a file whose bytes depend on the data alone, and not on how they were gathered. It must not exist.
    void write_compact(const std::filesystem::path& file);

    /// Brings everything into the one file. To be called last.
    void close();

private:
    void insert(const StudyRow& row);
    template <class Use>
    auto guarded(const Use& use) -> decltype(use());

    std::filesystem::path file_;
    std::optional<SQLite::Database> database_;
    std::optional<SQLite::Statement> insert_point_, insert_design_, find_point_, find_check_, insert_check_, mark_;
    std::optional<RowSums> point_sums_, design_sums_, strand_sums_;
    std::mutex mutex_;
};

/// The design in a column of the data; nothing where its numbers are not those of a design.
std::optional<Design> stored_design(const SQLite::Column& numbers);

/// Why something cannot be the data of a study, by what kind of file it is: reading a pipe can take forever. Empty if
/// it can, or is not there.
std::string why_not_a_data_file(const std::filesystem::path& file);

/// A name in an SQL statement.
std::string sql_name(std::string_view name);

/// What went wrong with a file of a study, and what its user can do.
std::string explained(const SQLite::Exception& fault, const std::filesystem::path& file);

}  // namespace mechwright
