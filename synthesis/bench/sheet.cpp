#include <algorithm>
#include <limits>
#include <stdexcept>

#include "synthesis/bench/section.h"

namespace mechwright::bench {

const Cell& Sheet::cell(const Row& row, std::string_view column) const {
    const auto found = std::find(columns.begin(), columns.end(), column);
    if (found == columns.end()) throw std::logic_error("a table has no column " + std::string(column));
    return row.at(static_cast<std::size_t>(found - columns.begin()));
}

double Sheet::number(const Row& row, std::string_view column) const {
    const Cell& held = cell(row, column);
    return held.is_number() ? held.get<double>() : std::numeric_limits<double>::quiet_NaN();
}

std::string Sheet::text(const Row& row, std::string_view column) const {
    const Cell& held = cell(row, column);
    return held.is_string() ? held.get<std::string>() : std::string();
}

std::vector<Row> Sheet::where(std::string_view column, std::string_view wanted) const {
    std::vector<Row> found;
    for (const Row& row : rows)
        if (text(row, column) == wanted) found.push_back(row);
    return found;
}

std::vector<std::string> Sheet::distinct(std::string_view column) const {
    std::vector<std::string> found;
    for (const Row& row : rows)
        if (std::find(found.begin(), found.end(), text(row, column)) == found.end()) found.push_back(text(row, column));
    return found;
}

}  // namespace mechwright::bench
