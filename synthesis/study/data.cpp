#include "synthesis/study/data.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "synthesis/report/csv/csv_text.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/study/store.h"

namespace mechwright {

namespace {

constexpr std::size_t flushed_beyond = 1 << 16;

/// Opens the data of a study to be read, and hands them to `use` where every row is as it was written.
template <class Use>
auto with_data(const std::filesystem::path& file, const Use& use) {
    if (!std::filesystem::exists(file))
        throw StoreFault(fmt::format("there is no study in '{}' (no file {})", file.parent_path().string(),
                                     file.filename().string()));
    if (const std::string why = why_not_a_data_file(file); !why.empty()) throw StoreFault(why);
    try {
        SQLite::Database database(file.string(), SQLite::OPEN_READONLY, patience_in_milliseconds);
        if (!database.tableExists("study") || !database.tableExists("points"))
            throw StoreFault(file.string() + ": is not the data of a study");
        check_rows(database, file);
        return use(database);
    } catch (const SQLite::Exception& fault) {
        throw StoreFault(explained(fault, file));
    }
}

std::uint64_t counted(SQLite::Database& database, const std::string& where) {
    return static_cast<std::uint64_t>(database.execAndGet("SELECT count(*) FROM points" + where).getInt64());
}

std::string csv_cell(const SQLite::Column& value) {
    if (value.isNull()) return {};
    if (value.isInteger()) return std::to_string(value.getInt64());
    if (value.isFloat()) return csv_number(value.getDouble());
    return csv_field(value.getString());
}

nlohmann::ordered_json json_cell(const SQLite::Column& value) {
    if (value.isNull()) return nullptr;
    if (value.isInteger()) return value.getInt64();
    if (value.isFloat()) return value.getDouble();
    return value.getString();
}

std::string csv_header(SQLite::Statement& query) {
    std::string line;
    for (int i = 0; i < query.getColumnCount(); ++i)
        line += (i == 0 ? "" : ",") + csv_field(query.getColumnName(i));
    return line + '\n';
}

std::string csv_line(SQLite::Statement& query) {
    std::string line;
    for (int i = 0; i < query.getColumnCount(); ++i)
        line += (i == 0 ? "" : ",") + csv_cell(query.getColumn(i));
    return line + '\n';
}

std::string json_line(SQLite::Statement& query, bool first) {
    nlohmann::ordered_json row = nlohmann::ordered_json::object();
    for (int i = 0; i < query.getColumnCount(); ++i)
        row[query.getColumnName(i)] = json_cell(query.getColumn(i));
    return (first ? "\n  " : ",\n  ") + row.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

void export_rows(SQLite::Statement& query, DataFormat format, const std::function<bool(std::string_view)>& take) {
    std::string text = format == DataFormat::csv ? csv_header(query) : "[";
    bool first = true;
    while (query.executeStep()) {
        text += format == DataFormat::csv ? csv_line(query) : json_line(query, first);
        first = false;
        if (text.size() < flushed_beyond) continue;
        if (!take(text)) return;
        text.clear();
    }
    if (format == DataFormat::json) text += first ? "]\n" : "\n]\n";
    take(text);
}

/// What a query of a user may do: read, compute, and nothing that reaches other files.
int allowed(void*, int action, const char*, const char*, const char*, const char*) {
    for (const int known : {SQLITE_SELECT, SQLITE_READ, SQLITE_FUNCTION, SQLITE_RECURSIVE})
        if (action == known) return SQLITE_OK;
    return SQLITE_DENY;
}

/// Keeps a user's query to reading, until a deadline.
struct Fence {
    std::chrono::steady_clock::time_point deadline;

    void around(SQLite::Database& database) {
        constexpr int steps_between_looks = 10'000, longest_value = 64 << 20;
        sqlite3* handle = database.getHandle();
        sqlite3_set_authorizer(handle, allowed, nullptr);
        sqlite3_limit(handle, SQLITE_LIMIT_LENGTH, longest_value);
        sqlite3_progress_handler(
            handle, steps_between_looks, [](void* fence) { return static_cast<Fence*>(fence)->is_over() ? 1 : 0; },
            this);
    }
    bool is_over() const { return std::chrono::steady_clock::now() >= deadline; }
};

/// Whether SQL has another statement behind its first.
bool has_second_statement(SQLite::Database& database, const std::string& query) {
    const char* rest = nullptr;
    sqlite3_stmt* first = nullptr;
    sqlite3_prepare_v2(database.getHandle(), query.c_str(), -1, &first, &rest);
    sqlite3_finalize(first);
    sqlite3_stmt* second = nullptr;
    const int outcome = sqlite3_prepare_v2(database.getHandle(), rest, -1, &second, nullptr);
    sqlite3_finalize(second);
    return second != nullptr || outcome != SQLITE_OK;
}

constexpr const char* only_reading = "only queries that read are allowed: SELECT";

SQLite::Statement understood(SQLite::Database& database, const std::string& query) {
    try {
        SQLite::Statement statement(database, query);
        if (has_second_statement(database, query)) throw SqlFault("one statement is wanted, and there are more");
        return statement;
    } catch (const SQLite::Exception& fault) {
        if (fault.getErrorCode() == SQLITE_AUTH) throw SqlFault(only_reading);
        throw SqlFault(fault.what());
    }
}

}  // namespace

std::string tally(const StudyStanding& standing) {
    std::string text = standing.done == standing.points
                           ? fmt::format("{} points", standing.points)
                           : fmt::format("{} of {} points", standing.done, standing.points);
    for (std::size_t i = 0; i < standing.statuses.size(); ++i)
        text += fmt::format("{}{} {}", i == 0 ? ": " : ", ", standing.statuses[i].second, standing.statuses[i].first);
    return text;
}

StudyStanding standing_of_study(const std::filesystem::path& data) {
    return with_data(data, [](SQLite::Database& database) {
        StudyStanding standing;
        standing.title = database.execAndGet("SELECT value FROM study WHERE name = 'title'").getString();
        standing.points =
            static_cast<std::uint64_t>(database.execAndGet("SELECT value FROM study WHERE name = 'points'").getInt64());
        standing.done = counted(database, "");
        SQLite::Statement statuses(database, "SELECT status, count(*) FROM points GROUP BY status ORDER BY 2 DESC, 1");
        while (statuses.executeStep())
            standing.statuses.emplace_back(statuses.getColumn(0).getString(),
                                           static_cast<std::uint64_t>(statuses.getColumn(1).getInt64()));
        standing.from_neighbours = counted(database, " WHERE start = 'neighbour'");
        standing.both_ways = counted(database, " WHERE start = 'both'");
        standing.differed = counted(database, " WHERE differed = 1");
        return standing;
    });
}

std::string problem_text(const std::filesystem::path& data) {
    return with_data(data, [](SQLite::Database& database) {
        return database.execAndGet("SELECT value FROM study WHERE name = 'text'").getString();
    });
}

std::filesystem::path write_study_files(const std::filesystem::path& data, const std::filesystem::path& folder) {
    std::vector<std::pair<std::filesystem::path, std::string>> files{{"study.toml", problem_text(data)}};
    with_data(data, [&](SQLite::Database& database) {
        SQLite::Statement query(database, "SELECT substr(name, 6), value FROM study WHERE name LIKE 'file:%'");
        while (query.executeStep()) {
            const auto name = std::filesystem::path(query.getColumn(0).getString()).lexically_normal();
            if (name.is_relative()) files.emplace_back(name, query.getColumn(1).getString());
        }
    });
    // As deep as a name goes up.
    std::ptrdiff_t depth = 0;
    for (const auto& [name, text] : files)
        depth = std::max<std::ptrdiff_t>(depth, std::count(name.begin(), name.end(), ".."));
    std::filesystem::path problem_folder = folder;
    for (std::ptrdiff_t i = 0; i < depth; ++i)
        problem_folder /= "below";
    for (const auto& [name, text] : files) {
        const std::filesystem::path place = (problem_folder / name).lexically_normal();
        if (const auto fault = prepare_folder(place.parent_path())) throw StoreFault(*fault);
        if (const auto fault = write_atomically(place, text)) throw StoreFault(*fault);
    }
    return problem_folder / "study.toml";
}

bool export_data(const std::filesystem::path& data, const StudyQuery& query, DataFormat format,
                 const std::function<bool(std::string_view)>& take) {
    return with_data(data, [&](SQLite::Database& database) {
        Fence fence{std::chrono::steady_clock::now() +
                    std::chrono::duration_cast<std::chrono::steady_clock::duration>(
                        std::chrono::duration<double>(std::min(query.time_limit, 1e9)))};
        if (!query.sql.empty()) fence.around(database);
        SQLite::Statement statement =
            understood(database, query.sql.empty() ? "SELECT * FROM points ORDER BY point" : query.sql);
        try {
            export_rows(statement, format, take);
        } catch (const SQLite::Exception& fault) {
            if (fault.getErrorCode() == SQLITE_AUTH) throw SqlFault(only_reading);
            if (fault.getErrorCode() != SQLITE_INTERRUPT) throw;
            return false;
        }
        return true;
    });
}

void for_each_point(const std::filesystem::path& data, const std::function<void(const StudyPoint&)>& take) {
    with_data(data, [&](SQLite::Database& database) {
        SQLite::Statement query(database,
                                "SELECT numbers, points.* FROM points LEFT JOIN designs USING (point) ORDER BY point");
        while (query.executeStep()) {
            StudyPoint point;
            for (int i = 1; i < query.getColumnCount(); ++i)
                if (!query.getColumn(i).isNull()) point.row[query.getColumnName(i)] = json_cell(query.getColumn(i));
            point.number = point.row.value("point", std::uint64_t{0});
            if (query.getColumn(0).isBlob()) point.design = stored_design(query.getColumn(0));
            take(point);
        }
    });
}

}  // namespace mechwright
