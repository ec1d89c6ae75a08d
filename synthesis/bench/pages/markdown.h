#pragma once
/// \file
/// Tables and numbers of results/README.md.

#include <string>
#include <vector>

namespace mechwright::bench {

struct MarkdownTable {
    std::vector<std::string> head;
    std::vector<std::vector<std::string>> rows;  ///< as long as the head
};

std::string to_markdown(const MarkdownTable& table);

/// A number with so many significant digits; "" for NaN. Thousands are set apart by thin spaces.
std::string significant(double number, int digits = 3);

/// A count, or a size that is a whole number.
std::string whole_number(double number);

/// A time in ns, us, ms or s, whichever reads best; "" for NaN.
std::string time_text(double seconds);

/// "1.8 x"; "" for NaN.
std::string ratio_text(double ratio);

}  // namespace mechwright::bench
