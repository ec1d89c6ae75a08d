#pragma once
/// \file
/// The data files of the hard cases: comma-separated, the first line says what they are, the second names the columns.

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

#include "analysis/four_bar.h"
#include "tests/analysis/precise.h"

namespace mechwright::test {

class Row {
public:
    Row(const std::vector<std::string>& columns, const std::string& line) : line_(line) {
        std::stringstream cells(line);
        for (const std::string& column : columns)
            std::getline(cells, cell_[column], ',');
    }

    const std::string& text(const std::string& column) const { return cell_.at(column); }
    bool has(const std::string& column) const { return !cell_.at(column).empty(); }
    bool yes(const std::string& column) const { return cell_.at(column) == "yes"; }
    double number(const std::string& column) const { return std::strtod(cell_.at(column).c_str(), nullptr); }
    Precise exact(const std::string& column) const { return Precise(cell_.at(column)); }

    FourBar<double> links() const { return {number("ground"), number("crank"), number("coupler"), number("rocker")}; }
    Assembly assembly() const { return text("assembly") == "open" ? Assembly::open : Assembly::crossed; }
    HalfTurn<double> half() const {
        return text("crank_angle") == "pi" ? HalfTurn<double>{0, 1} : half_turn(number("crank_angle"));
    }
    std::string label() const { return line_.substr(0, 120); }

private:
    std::map<std::string, std::string> cell_;
    std::string line_;
};

/// A test that asks for a file that is missing or has no rows fails.
inline std::vector<Row> table(const std::string& file) {
    std::ifstream in(std::string(MECHWRIGHT_SOURCE_DIR) + "/tests/hard_cases/data/" + file);
    if (!in) ADD_FAILURE() << "there is no " << file;
    std::string line, name;
    std::getline(in, line);
    std::getline(in, line);
    std::vector<std::string> columns;
    for (std::stringstream names(line); std::getline(names, name, ',');)
        columns.push_back(name);
    std::vector<Row> rows;
    while (std::getline(in, line))
        rows.emplace_back(columns, line);
    EXPECT_FALSE(rows.empty()) << file;
    return rows;
}

/// Fourteen digits of the answer itself, and no error at all where it is zero.
inline void expect_all_digits(const Row& row, const std::string& column, double value) {
    EXPECT_LE(abs(Precise(value) - row.exact(column)), 1e-14 * abs(row.exact(column))) << column << ": " << row.label();
}

}  // namespace mechwright::test
