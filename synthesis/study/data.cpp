#include "synthesis/study/data.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "synthesis/report/csv_text.h"
#include "synthesis/report/write_file.h"
#include "synthesis/study/store.h"

namespace mechwright {

namespace {

constexpr std::size_t flushed_beyond = 1 << 16;

/// Opens the data of a study to be read, and hands them to `use`.
template <class Use>
auto with_data(const std::filesystem::path& file, const Use& use) {
    if (!std::filesystem::exists(file))
        throw StoreFault(fmt::format("there is no study in '{}' (no file {})", file.parent_path().string(),
                                     file.filename().string()));
    try {
        SQLite::Database database(file.string(), SQLite::OPEN_READONLY, patience_in_milliseconds);
        if (!database.tableExists("study") || !database.tableExists("points"))
            throw StoreFault(file.string() + ": is not the data of a study");
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

SQLite::Statement understood(SQLite::Database& database, const std::string& query) {
    try {
        return {database, query};
    } catch (const SQLite::Exception& fault) {
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

void export_data(const std::filesystem::path& data, const std::string& query, DataFormat format,
                 const std::function<bool(std::string_view)>& take) {
    with_data(data, [&](SQLite::Database& database) {
        SQLite::Statement statement =
            understood(database, query.empty() ? "SELECT * FROM points ORDER BY point" : query);
        export_rows(statement, format, take);
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
