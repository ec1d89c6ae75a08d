#pragma once
/// \file
/// Plain text for a terminal of eighty columns: tables, folded paragraphs, numbers, emphasis.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mechwright {

inline constexpr std::size_t terminal_width = 80;

/// In a text to be folded: a space at which no line ends, as between a number and its unit.
inline constexpr char tied_space = '\x1f';

enum class Align {
    left,
    right,
    point  ///< numbers, with their decimal points below each other
};

struct Table {
    std::vector<Align> columns;
    std::vector<std::vector<std::string>> rows;  ///< no row longer than `columns`
};

/// One line per row, two spaces between columns; columns that are empty in all rows take no room.
std::string to_text(const Table& table, std::size_t indent);

/// The text folded at spaces into lines of at most eighty columns; the first starts with `lead`, the others are
/// indented as far as `lead` is wide.
std::string folded(std::string_view lead, std::string_view text);

/// A number for reading: eight significant digits at most, the same in every locale.
std::string number_text(double value, int digits = 8);

/// A number with this many digits after the point, for columns of comparable numbers.
std::string fixed_text(double value, int decimals);

/// How many columns a text takes: one for each character of UTF-8, none for the terminal's codes.
std::size_t width_of(std::string_view text);

enum class Emphasis { none, strong, good, bad };

/// The text with the terminal's codes around it if `colour`, else as it is.
std::string emphasised(std::string_view text, Emphasis emphasis, bool colour);

}  // namespace mechwright
