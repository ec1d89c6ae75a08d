#pragma once
/// \file
/// How many digits a family of hard cases keeps. How well an answer is conditioned stands beside it in the data: how
/// far it moves when the inputs move by their rounding.

#include <algorithm>
#include <cmath>
#include <string>

#include "tests/hard_cases/table.h"

namespace mechwright::test {

/// Counts the answers of a family and holds each to what its conditioning allows; at its end the counts go into the
/// test's report, as properties of the test.
class Digits {
public:
    explicit Digits(std::string family) : family_(std::move(family)) {}
    Digits(const Digits&) = delete;
    Digits& operator=(const Digits&) = delete;

    ~Digits() {
        const auto record = [&](const char* what, const std::string& value) {
            ::testing::Test::RecordProperty(family_ + ": " + what, value);
        };
        EXPECT_GT(answers_, 0) << family_;
        record("answers", std::to_string(answers_));
        record("well conditioned", std::to_string(well_conditioned_));
        record("fewest digits of these", std::to_string(fewest_digits_));
        record("greatest error of the others over what the inputs' rounding moves", std::to_string(greatest_part_));
    }

    /// Well conditioned is what moves by at most ten roundings of `scale`: of that fourteen digits must be right.
    /// Elsewhere the error is at most ten times what the inputs' rounding moves.
    void expect(const Row& row, const std::string& column, double value, double scale) {
        expect(row, column, value, scale, row.number(column + "_moves"));
    }

    /// Both components of a vector, which share what moves it: turned a little, one of them may hardly move.
    void expect(const Row& row, const std::string& name, const Vector<double>& value, double scale) {
        const double moves = std::hypot(row.number(name + "_x_moves"), row.number(name + "_y_moves"));
        expect(row, name + "_x", value.x, scale, moves);
        expect(row, name + "_y", value.y, scale, moves);
    }

    /// On the scale of the answer itself.
    void expect(const Row& row, const std::string& column, double value) {
        expect(row, column, value, std::abs(row.number(column)));
    }

private:
    static constexpr double ten_roundings = 10 * 0x1p-53, fourteen_digits = 1e-14;

    static double digits(double error, double scale) { return error > 0 ? -std::log10(error / scale) : 17; }

    void expect(const Row& row, const std::string& column, double value, double scale, double moves) {
        if (!row.has(column)) return;
        ++answers_;
        const double error = static_cast<double>(abs(Precise(value) - row.exact(column)));
        if (moves <= ten_roundings * scale) {
            ++well_conditioned_;
            fewest_digits_ = std::min(fewest_digits_, digits(error, scale));
            EXPECT_LE(error, fourteen_digits * scale) << column << ": " << row.label();
        } else {
            greatest_part_ = std::max(greatest_part_, error / moves);
            EXPECT_LE(error, 10 * moves) << column << ": " << row.label();
        }
    }

    std::string family_;
    int answers_ = 0;
    int well_conditioned_ = 0;
    double fewest_digits_ = 17;
    double greatest_part_ = 0;
};

}  // namespace mechwright::test
