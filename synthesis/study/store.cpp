#include "synthesis/study/store.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <cstring>

#include "synthesis/problem/bytes.h"
#include "synthesis/study/points.h"

namespace mechwright {

namespace {

const std::string named_file_prefix = "file:";
/// Of the layout of the file.
constexpr int layout = 2;

/// The design's numbers as they are, so that a run that goes on has the same ones.
std::vector<double> packed(const Design& design) {
    std::vector<double> numbers{static_cast<double>(design.assembly), static_cast<double>(design.dimensions.size())};
    numbers.insert(numbers.end(), design.dimensions.begin(), design.dimensions.end());
    numbers.insert(numbers.end(), design.path_angles.begin(), design.path_angles.end());
    return numbers;
}

void bind(SQLite::Statement& statement, int index, const Cell& cell) {
    std::visit(
        [&](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::monostate>)
                statement.bind(index);
            else
                statement.bind(index, value);
        },
        cell);
}

/// Runs a statement that gives no rows, and leaves it ready for the next time.
void run(SQLite::Statement& statement) {
    statement.exec();
    statement.reset();
}

std::string columns_of(const StudyColumns& columns) {
    std::string list;
    for (const std::string& name : columns.names())
        list += ", " + sql_name(name);
    return list;
}

void make_tables(SQLite::Database& database, const PreparedStudy& prepared) {
    database.exec("CREATE TABLE IF NOT EXISTS study (name TEXT PRIMARY KEY, value) WITHOUT ROWID");
    database.exec("CREATE TABLE IF NOT EXISTS points (point INTEGER PRIMARY KEY" + columns_of(prepared.columns) + ")");
    database.exec("CREATE TABLE IF NOT EXISTS designs (point INTEGER PRIMARY KEY, numbers BLOB)");
    database.exec(
        "CREATE TABLE IF NOT EXISTS strands (strand INTEGER PRIMARY KEY, differed INTEGER, finished INTEGER)");
    make_sums_table(database);
    RowSums sums(database, summed::study);
    SQLite::Statement about(database, "INSERT OR IGNORE INTO study VALUES (?, ?)");
    const auto put = [&](const char* name, const auto& value) {
        about.bind(1, name);
        about.bind(2, value);
        run(about);
        sums.put(name);
    };
    put("fingerprint", prepared.fingerprint);
    put("layout", layout);
    put("points", static_cast<std::int64_t>(point_count(*prepared.study)));
    put("text", prepared.text);
    put("title", prepared.base.title);
    // With the files that it names the study can be looked at wherever its data go.
    for (const std::string& name : prepared.named_files) {
        const auto place = std::filesystem::path(prepared.file).parent_path() / name;
        const reading::Bytes read = reading::read_bytes(place.string(), most_bytes_of_a_study, true);
        if (read.failure.empty()) put((named_file_prefix + name).c_str(), read.bytes);
    }
}

}  // namespace

std::optional<Design> stored_design(const SQLite::Column& blob) {
    const auto bytes = static_cast<std::size_t>(blob.getBytes());
    std::vector<double> numbers(bytes / sizeof(double));
    if (numbers.size() < 2) return {};
    std::memcpy(numbers.data(), blob.getBlob(), numbers.size() * sizeof(double));
    const auto most = static_cast<double>(numbers.size() - 2);
    if (!(numbers[1] >= 0 && numbers[1] <= most && numbers[0] >= 0 && numbers[0] < 1e9)) return {};
    const auto dimensions = static_cast<std::ptrdiff_t>(numbers[1]);
    return Design{{numbers.begin() + 2, numbers.begin() + 2 + dimensions},
                  static_cast<std::size_t>(numbers[0]),
                  {numbers.begin() + 2 + dimensions, numbers.end()}};
}

std::string sql_name(std::string_view name) {
    std::string quoted = "\"";
    for (const char c : name)
        quoted += c == '"' ? "\"\"" : std::string(1, c);
    return quoted + '"';
}

std::string why_not_a_data_file(const std::filesystem::path& file) {
    std::error_code error;
    const auto status = std::filesystem::status(file, error);
    return !std::filesystem::exists(status) || std::filesystem::is_regular_file(status)
               ? ""
               : file.string() + ": is not a regular file, and no data of a study";
}

std::string explained(const SQLite::Exception& fault, const std::filesystem::path& file) {
    switch (fault.getErrorCode()) {
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return fmt::format(
                "{}: another program holds it locked; let it finish and run the command again: what is "
                "done is kept",
                file.string());
        case SQLITE_FULL:
            return fmt::format("{}: the disk is full; make room and run the command again: what is done is kept",
                               file.string());
        case SQLITE_NOTADB:
        case SQLITE_CORRUPT:
            return fmt::format(
                "{}: is not the data of a study, or damaged ({}); name another folder, or move the file "
                "away",
                file.string(), fault.what());
        default: return fmt::format("{}: {}", file.string(), fault.what());
    }
}

template <class Use>
auto StudyStore::guarded(const Use& use) -> decltype(use()) {
    const std::lock_guard lock(mutex_);
    try {
        return use();
    } catch (const SQLite::Exception& fault) {
        throw StoreFault(explained(fault, file_));
    }
}

StudyStore::StudyStore(const std::filesystem::path& file, const PreparedStudy& prepared, bool alone) : file_(file) {
    guarded([&] {
        if (const std::string why = why_not_a_data_file(file); !why.empty()) throw StoreFault(why);
        database_.emplace(file.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, patience_in_milliseconds);
        SQLite::Database& database = *database_;
        if (alone) database.exec("PRAGMA locking_mode = EXCLUSIVE");
        database.exec("PRAGMA journal_mode = WAL");
        database.exec("PRAGMA synchronous = NORMAL");
        {
            SQLite::Transaction transaction(database, SQLite::TransactionBehavior::IMMEDIATE);
            if (!database.tableExists("study")) make_tables(database, prepared);
            transaction.commit();
        }
        const std::string known = database.execAndGet("SELECT value FROM study WHERE name = 'fingerprint'").getString();
        if (known != prepared.fingerprint)
            throw StoreFault(
                fmt::format("{}: holds another study, or one of another version of its file or of the "
                            "program; name another folder with --out",
                            file.string()));
        check_rows(database, file);
        std::string marks = "?";
        for (std::size_t i = 0; i < prepared.columns.names().size(); ++i)
            marks += ", ?";
        insert_point_.emplace(database, "INSERT OR REPLACE INTO points VALUES (" + marks + ")");
        insert_design_.emplace(database, "INSERT OR REPLACE INTO designs VALUES (?, ?)");
        find_point_.emplace(database,
                            "SELECT status, start, proved, numbers FROM points LEFT JOIN designs "
                            "USING (point) WHERE point = ?");
        find_check_.emplace(database, "SELECT differed, finished FROM strands WHERE strand = ?");
        insert_check_.emplace(database, "INSERT OR REPLACE INTO strands VALUES (?, ?, ?)");
        point_sums_.emplace(database, summed::points);
        design_sums_.emplace(database, summed::designs);
        strand_sums_.emplace(database, summed::strands);
        mark_.emplace(database, "UPDATE points SET start = 'both', differed = 0 WHERE point = ?");
    });
}

std::optional<KnownPoint> StudyStore::find(std::uint64_t point) {
    return guarded([&]() -> std::optional<KnownPoint> {
        SQLite::Statement& find = *find_point_;
        find.bind(1, static_cast<std::int64_t>(point));
        std::optional<KnownPoint> known;
        if (find.executeStep()) {
            known = KnownPoint{find.getColumn(0).getString(), find.getColumn(1).getString(),
                               find.getColumn(2).getInt() != 0, std::nullopt};
            if (!find.getColumn(3).isNull()) known->design = stored_design(find.getColumn(3));
        }
        find.reset();
        return known;
    });
}

void StudyStore::insert(const StudyRow& row) {
    const auto point = static_cast<std::int64_t>(row.point);
    insert_point_->bind(1, point);
    for (std::size_t i = 0; i < row.cells.size(); ++i)
        bind(*insert_point_, static_cast<int>(i) + 2, row.cells[i]);
    run(*insert_point_);
    point_sums_->put(point);
    if (!row.design) return;
    const std::vector<double> numbers = packed(*row.design);
    insert_design_->bind(1, point);
    insert_design_->bind(2, numbers.data(), static_cast<int>(numbers.size() * sizeof(double)));
    run(*insert_design_);
    design_sums_->put(point);
}

void StudyStore::put(const StudyRow& row) { put(std::span(&row, 1)); }

void StudyStore::put(std::span<const StudyRow> rows) {
    guarded([&] {
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        for (const StudyRow& row : rows)
            insert(row);
        transaction.commit();
    });
}

void StudyStore::put_solved_both_ways(std::uint64_t point) {
    guarded([&] {
        const auto key = static_cast<std::int64_t>(point);
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        mark_->bind(1, key);
        run(*mark_);
        point_sums_->put(key);
        transaction.commit();
    });
}

StrandCheck StudyStore::check_of(std::uint64_t strand) {
    return guarded([&] {
        find_check_->bind(1, static_cast<std::int64_t>(strand));
        StrandCheck check;
        if (find_check_->executeStep())
            check = {find_check_->getColumn(0).getInt() != 0, find_check_->getColumn(1).getInt() != 0};
        find_check_->reset();
        return check;
    });
}

void StudyStore::put_check(std::uint64_t strand, const StrandCheck& check) {
    guarded([&] {
        const auto key = static_cast<std::int64_t>(strand);
        SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
        insert_check_->bind(1, key);
        insert_check_->bind(2, check.differed ? 1 : 0);
        insert_check_->bind(3, check.finished ? 1 : 0);
        run(*insert_check_);
        strand_sums_->put(key);
        transaction.commit();
    });
}

std::uint64_t StudyStore::count() {
    return guarded(
        [&] { return static_cast<std::uint64_t>(database_->execAndGet("SELECT count(*) FROM points").getInt64()); });
}

void StudyStore::take_over(const std::filesystem::path& part) {
    guarded([&] {
        SQLite::Statement attach(*database_, "ATTACH ? AS part");
        attach.bind(1, part.string());
        run(attach);
        const std::string fingerprint = "SELECT value FROM {}.study WHERE name = 'fingerprint'";
        if (database_->execAndGet(fmt::format(fmt::runtime(fingerprint), "part")).getString() !=
            database_->execAndGet(fmt::format(fmt::runtime(fingerprint), "main")).getString())
            throw StoreFault(part.string() + ": is a part of another study; remove it and run its chunk again");
        check_rows(*database_, part, "part");
        {
            SQLite::Transaction transaction(*database_);
            for (const char* table : {"points", "designs", "strands"})
                database_->exec(
                    fmt::format("INSERT OR REPLACE INTO main.{0} SELECT * FROM part.{0} ORDER BY 1", table));
            database_->exec(
                "INSERT OR REPLACE INTO main.sums SELECT * FROM part.sums WHERE of_table IN ('points', 'designs', "
                "'strands')");
            transaction.commit();
        }
        database_->exec("DETACH part");
    });
}

void StudyStore::write_compact(const std::filesystem::path& file) {
    guarded([&] {
        SQLite::Statement vacuum(*database_, "VACUUM INTO ?");
        vacuum.bind(1, file.string());
        run(vacuum);
    });
}

void StudyStore::close() {
    guarded([&] {
        for (auto* sums : {&point_sums_, &design_sums_, &strand_sums_})
            sums->reset();
        for (auto* statement : {&insert_point_, &insert_design_, &find_point_, &find_check_, &insert_check_, &mark_})
            statement->reset();
        database_->exec("PRAGMA journal_mode = DELETE");
        database_.reset();
    });
}

}  // namespace mechwright
