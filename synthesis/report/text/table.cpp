#include "synthesis/report/text/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace mechwright {

namespace {

bool is_number(std::string_view cell) {
    return !cell.empty() && (cell.front() == '-' || (cell.front() >= '0' && cell.front() <= '9'));
}

/// Columns before the decimal point, or before the exponent where there is no point.
std::size_t before_point(std::string_view number) { return std::min(number.find_first_of(".e"), number.size()); }

struct ColumnWidth {
    std::size_t before = 0;  ///< the decimal points of the numbers in an Align::point column,
    std::size_t after = 0;   ///< and from there on
    std::size_t all = 0;
};

ColumnWidth width_of_column(const Table& table, std::size_t column) {
    ColumnWidth width;
    for (const auto& row : table.rows) {
        if (column >= row.size()) continue;
        const std::string& cell = row[column];
        width.all = std::max(width.all, width_of(cell));
        if (table.columns[column] != Align::point || !is_number(cell)) continue;
        width.before = std::max(width.before, before_point(cell));
        width.after = std::max(width.after, cell.size() - before_point(cell));
    }
    width.all = std::max(width.all, width.before + width.after);
    return width;
}

/// Text in a column of numbers, such as its heading, stands to the right.
std::string padded(const std::string& cell, Align align, const ColumnWidth& width) {
    const std::size_t room = width.all - width_of(cell);
    std::size_t left = 0;
    if (align == Align::point && is_number(cell))
        left = width.all - width.after - before_point(cell);
    else if (align != Align::left)
        left = room;
    return std::string(left, ' ') + cell + std::string(room - left, ' ');
}

}  // namespace

std::string to_text(const Table& table, std::size_t indent) {
    std::vector<ColumnWidth> widths;
    for (std::size_t c = 0; c < table.columns.size(); ++c)
        widths.push_back(width_of_column(table, c));
    std::string text;
    for (const auto& row : table.rows) {
        std::string line(indent, ' ');
        for (std::size_t c = 0; c < row.size(); ++c)
            if (widths[c].all > 0) line += padded(row[c], table.columns[c], widths[c]) + "  ";
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + '\n';
    }
    return text;
}

std::string folded(std::string_view lead, std::string_view text) {
    const std::string indent(width_of(lead), ' ');
    std::string result(lead);
    std::size_t column = indent.size();
    bool line_is_empty = true;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find(' '), text.size());
        const std::string_view word = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (word.empty()) continue;
        if (!line_is_empty && column + 1 + width_of(word) > terminal_width) {
            result += '\n' + indent;
            column = indent.size();
            line_is_empty = true;
        }
        if (!line_is_empty) {
            result += ' ';
            ++column;
        }
        result += word;
        column += width_of(word);
        line_is_empty = false;
    }
    result.erase(result.find_last_not_of(' ') + 1);
    std::replace(result.begin(), result.end(), tied_space, ' ');
    return result + '\n';
}

std::string number_text(double value, int digits) {
    std::string text = fmt::format("{:.{}g}", value, digits);
    return text == "-0" ? "0" : text;
}

std::string fixed_text(double value, int decimals) {
    std::string text = fmt::format("{:.{}f}", value, decimals);
    const bool is_zero = text.find_first_not_of("-0.") == std::string::npos;
    return is_zero && text.front() == '-' ? text.substr(1) : text;
}

std::size_t width_of(std::string_view text) {
    std::size_t width = 0;
    bool escaped = false;  // within the terminal's codes, which end with a letter
    for (const char c : text) {
        if (c == '\x1b')
            escaped = true;
        else if (escaped)
            escaped = c != 'm';
        else if ((static_cast<unsigned char>(c) & 0xc0) != 0x80)
            ++width;
    }
    return width;
}

std::string emphasised(std::string_view text, Emphasis emphasis, bool colour) {
    if (!colour || emphasis == Emphasis::none) return std::string(text);
    const std::string_view code = emphasis == Emphasis::strong ? "1" : emphasis == Emphasis::good ? "1;32" : "1;31";
    return fmt::format("\x1b[{}m{}\x1b[0m", code, text);
}

}  // namespace mechwright
