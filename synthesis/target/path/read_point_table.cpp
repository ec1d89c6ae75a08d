/// \file
/// Tables of points: two columns of numbers between commas, semicolons, tabs or blanks; a header line, blank lines and
/// # comments are passed over.

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "synthesis/problem/text.h"
#include "synthesis/target/path/read_points.h"

namespace mechwright::reading {

namespace {

constexpr std::string_view blanks = " \t";

struct Row {
    int line;
    std::string_view text;  ///< the whole line up to a comment, from its first column
};

struct Cell {
    int column;
    std::string_view text;
};

/// Takes a line, ended by LF, CR LF or CR, off the front of the text.
std::string_view take_line(std::string_view& text) {
    const std::size_t end = text.find_first_of("\r\n");
    const std::string_view line = text.substr(0, end);
    if (end == std::string_view::npos)
        text = {};
    else
        text.remove_prefix(end + (text.substr(end).starts_with("\r\n") ? 2 : 1));
    return line;
}

/// The rows with anything in them, and how many there are; more than could be points are counted but not kept.
std::vector<Row> take_rows(std::string_view text, std::size_t& count) {
    std::vector<Row> rows;
    count = 0;
    for (int line = 1; !text.empty(); ++line) {
        const std::string_view whole = take_line(text);
        const std::string_view row = whole.substr(0, whole.find('#'));
        if (row.find_first_not_of(blanks) == std::string_view::npos) continue;
        ++count;
        if (rows.size() < most_points + 2) rows.push_back({line, row});
    }
    return rows;
}

char separator_of(std::string_view row) {
    for (const char separator : {';', ',', '\t'})
        if (row.find(separator) != std::string_view::npos) return separator;
    return ' ';
}

Cell trimmed(std::string_view row, std::size_t begin, std::size_t end) {
    while (begin < end && blanks.find(row[begin]) != std::string_view::npos)
        ++begin;
    while (begin < end && blanks.find(row[end - 1]) != std::string_view::npos)
        --end;
    return {count_characters(row.substr(0, begin)) + 1, row.substr(begin, end - begin)};
}

/// Blanks count as separators only between texts; any other separator counts always.
std::vector<Cell> split(std::string_view row, char separator) {
    constexpr std::size_t most_cells = 16;  // enough to say that there are too many
    std::vector<Cell> cells;
    for (std::size_t begin = 0; begin <= row.size() && cells.size() < most_cells;) {
        if (separator == ' ') begin = std::min(row.find_first_not_of(blanks, begin), row.size());
        const std::size_t end =
            std::min(separator == ' ' ? row.find_first_of(blanks, begin) : row.find(separator, begin), row.size());
        if (separator != ' ' || end > begin) cells.push_back(trimmed(row, begin, end));
        begin = end + 1;
    }
    return cells;
}

struct Parsed {
    double number = 0;
    std::string objection{};  ///< empty if it is a number
};

Parsed parse(std::string_view text) {
    Parsed parsed;
    if (text.starts_with('+') && !text.starts_with("+-")) text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), parsed.number);
    if (error == std::errc::result_out_of_range)
        parsed.objection = "is outside the range of numbers";
    else if (error != std::errc{} || end != text.data() + text.size())
        parsed.objection = "is not a number";
    else if (const std::string_view needed = needed_of(parsed.number); !needed.empty())
        parsed.objection = fmt::format("must be {}", needed);
    return parsed;
}

/// A header is a first line of nothing but words. A number with a slip in it is none: it must not pass unnoticed.
bool is_header(const std::vector<Cell>& cells) {
    return std::all_of(cells.begin(), cells.end(), [](const Cell& cell) {
        constexpr std::string_view starts_of_numbers = "+-.0123456789";
        return !cell.text.empty() && starts_of_numbers.find(cell.text[0]) == std::string_view::npos &&
               parse(cell.text).objection == "is not a number";
    });
}

bool read_row(const Row& row, char separator, PointList& list, Messages& messages) {
    const std::vector<Cell> cells = split(row.text, separator);
    if (cells.size() != 2) {
        add_point_error(list, {row.line, cells.empty() ? 1 : cells[0].column},
                        fmt::format("{} {} instead of 2, x and y (columns are separated by a comma, semicolon, tab or "
                                    "blanks; numbers take a decimal point)",
                                    cells.size(), cells.size() == 1 ? "column" : "columns"),
                        messages);
        add_point(list, {}, {row.line, 1});
        return false;
    }
    double numbers[2] = {};
    bool right = true;
    for (std::size_t i = 0; i < 2; ++i) {
        const Parsed parsed = parse(cells[i].text);
        numbers[i] = parsed.number;
        if (parsed.objection.empty()) continue;
        right = false;
        add_point_error(list, {row.line, cells[i].column},
                        fmt::format("{} {}: write numbers like -12.5 or 1e3", quoted(cells[i].text), parsed.objection),
                        messages);
    }
    const Vector<double> point{numbers[0], numbers[1]};
    add_point(list, right ? std::optional(point) : std::nullopt, {row.line, cells[0].column});
    return right;
}

}  // namespace

void read_point_table(std::string_view text, PointList& list, Messages& messages) {
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark, as spreadsheets write it
    std::size_t count = 0;
    const std::vector<Row> rows = take_rows(text, count);
    const bool header = !rows.empty() && is_header(split(rows[0].text, separator_of(rows[0].text)));
    const std::size_t first = header ? 1 : 0;
    if (count - first > most_points) {
        const FilePlace beyond{rows[first + most_points].line, 1};
        return add_point_error(
            list, beyond,
            fmt::format("{} points are too many: thin the list to at most {}", count - first, most_points), messages);
    }
    list.whole = true;
    for (std::size_t i = first; i < rows.size(); ++i)
        list.whole &= read_row(rows[i], separator_of(rows[first].text), list, messages);
}

}  // namespace mechwright::reading
