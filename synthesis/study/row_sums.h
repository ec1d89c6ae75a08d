#pragma once
/// \file
/// Checksums of the rows of a study's tables, in a table `sums` of the same file: SQLite itself believes what a damaged
/// disk makes of a number.

#include <SQLiteCpp/SQLiteCpp.h>

#include <cstdint>
#include <filesystem>
#include <string>

namespace mechwright {

/// A table that has them: what of it counts, its key being the first column.
struct SummedTable {
    const char* name;
    const char* key;
    const char* columns = "*";
    const char* condition = "1";
};

namespace summed {
inline constexpr SummedTable study{"study", "name"}, points{"points", "point"}, designs{"designs", "point"},
    strands{"strands", "strand"},
    layout{"sqlite_master", "name", "name, sql", "sql IS NOT NULL"};  ///< what SQLite knows of all tables
}  // namespace summed

/// Makes the table, with the checksums of the layout of all tables that there are.
void make_sums_table(SQLite::Database& database);

/// Puts the checksum of a row as it stands in its table.
class RowSums {
public:
    explicit RowSums(SQLite::Database& database, const SummedTable& table);
    /// The row of this key.
    template <class Key>
    void put(const Key& key) {
        row_.bind(1, key);
        insert_.bind(1, key);
        store();
    }

private:
    void store();
    SQLite::Statement row_, insert_;
};

/// Compares every row with its checksum; throws StoreFault for the first that differs. `schema`: main, or the name of
/// an attached file.
void check_rows(SQLite::Database& database, const std::filesystem::path& file, const std::string& schema = "main");

}  // namespace mechwright
