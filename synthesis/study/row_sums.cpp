#include "synthesis/study/row_sums.h"

#include <fmt/format.h>

#include <bit>
#include <string_view>

#include "synthesis/study/store.h"

namespace mechwright {

namespace {

/// Fowler, Noll and Vo's hash (FNV-1a) of 64 bits: each byte changes it, and no other byte at the same place undoes
/// that.
struct Hash {
    std::uint64_t value = 0xcbf29ce484222325;

    void add(std::string_view bytes) {
        for (const char byte : bytes)
            value = (value ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
    }
    void add(std::uint64_t number) {
        for (int i = 0; i < 8; ++i, number >>= 8)
            value = (value ^ (number & 0xff)) * 0x100000001b3;
    }
};

/// Of the first columns of a row, with their types.
std::int64_t sum_of(SQLite::Statement& row, int columns) {
    Hash hash;
    for (int i = 0; i < columns; ++i) {
        const SQLite::Column cell = row.getColumn(i);
        hash.add(static_cast<std::uint64_t>(cell.getType()));
        if (cell.isInteger()) {
            hash.add(static_cast<std::uint64_t>(cell.getInt64()));
        } else if (cell.isFloat()) {
            hash.add(std::bit_cast<std::uint64_t>(cell.getDouble()));
        } else if (!cell.isNull()) {
            const auto bytes = static_cast<std::size_t>(cell.getBytes());
            hash.add(bytes);
            hash.add({static_cast<const char*>(cell.getBlob()), bytes});
        }
    }
    return std::bit_cast<std::int64_t>(hash.value);
}

}  // namespace

void make_sums_table(SQLite::Database& database) {
    database.exec(
        "CREATE TABLE IF NOT EXISTS sums (of_table TEXT, key, sum INTEGER, PRIMARY KEY (of_table, key)) WITHOUT ROWID");
    RowSums sums(database, summed::layout);
    SQLite::Statement tables(database, "SELECT name FROM sqlite_master WHERE sql IS NOT NULL");
    while (tables.executeStep())
        sums.put(tables.getColumn(0).getString());
}

RowSums::RowSums(SQLite::Database& database, const SummedTable& table)
    : row_(database, fmt::format("SELECT {} FROM {} WHERE {} = ?", table.columns, table.name, table.key)),
      insert_(database, fmt::format("INSERT OR REPLACE INTO sums VALUES ('{}', ?, ?)", table.name)) {}

void RowSums::store() {
    if (row_.executeStep()) {
        insert_.bind(2, sum_of(row_, row_.getColumnCount()));
        insert_.exec();
        insert_.reset();
    }
    row_.reset();
}

void check_rows(SQLite::Database& database, const std::filesystem::path& file, const std::string& schema) {
    const auto is_there = [&](const char* table) {
        SQLite::Statement query(database, fmt::format("SELECT count(*) FROM {}.sqlite_master WHERE name = ?", schema));
        query.bind(1, table);
        return query.executeStep() && query.getColumn(0).getInt() > 0;
    };
    if (!is_there("sums"))
        throw StoreFault(file.string() +
                         ": has no checksums: it is of another version of the program; name another "
                         "folder, or run the study again");
    for (const SummedTable& table : {summed::layout, summed::study, summed::points, summed::designs, summed::strands}) {
        // The plus keeps the type of the key's column out of the comparison: with it the index would not serve.
        SQLite::Statement rows(database, fmt::format("SELECT t.*, s.sum FROM (SELECT {3} FROM {0}.{1} WHERE {4}) t "
                                                     "LEFT JOIN {0}.sums s ON s.of_table = '{1}' AND s.key = +t.{2}",
                                                     schema, table.name, table.key, table.columns, table.condition));
        const int columns = rows.getColumnCount() - 1;
        while (rows.executeStep()) {
            const SQLite::Column sum = rows.getColumn(columns);
            if (sum.isInteger() && sum.getInt64() == sum_of(rows, columns)) continue;
            throw StoreFault(
                fmt::format("{}: is damaged: {} {} of its table {} is not what was written; use a copy of "
                            "the file, or move it away and run the study again",
                            file.string(), table.key, rows.getColumn(0).getString(), table.name));
        }
    }
}

}  // namespace mechwright
