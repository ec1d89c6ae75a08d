/// \file
/// What the TOML parser finds wrong, in words that say what would be right, at the place where it stands.

#include <fmt/format.h>

#include <array>

#include "synthesis/problem/text.h"
#include "synthesis/problem/toml/toml_text.h"

namespace mechwright::reading {

namespace {

/// The bytes of a line before a column, and from it on.
struct SplitLine {
    std::string_view before;
    std::string_view after;
};

SplitLine split_at(std::string_view text, FilePlace place) {
    for (int line = 1; line < place.line; ++line) {
        const std::size_t end = text.find('\n');
        if (end == std::string_view::npos) break;
        text.remove_prefix(end + 1);
    }
    text = text.substr(0, text.find('\n'));
    std::size_t bytes = 0;
    int column = 1;
    for (; bytes < text.size(); ++bytes) {
        const bool starts_character = (static_cast<unsigned char>(text[bytes]) & 0xC0) != 0x80;
        if (starts_character && column++ == place.column) break;
    }
    return {text.substr(0, bytes), text.substr(bytes)};
}

std::string_view without_trailing(std::string_view text, std::string_view characters) {
    const std::size_t last = text.find_last_not_of(characters);
    return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

FilePlace back_over(FilePlace place, std::string_view longer, std::string_view shorter) {
    return {place.line, place.column - count_characters(longer.substr(shorter.size()))};
}

constexpr std::string_view plain_characters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+.";

std::string_view leading(std::string_view text, std::string_view characters) {
    return text.substr(0, text.find_first_not_of(characters));
}

int indentation(std::string_view line) { return static_cast<int>(leading(line, " \t").size()); }

/// The parser stops behind a number; this is where it starts.
FilePlace number_start(std::string_view text, FilePlace place) {
    const std::string_view before = split_at(text, place).before;
    return back_over(place, before, without_trailing(before, plain_characters));
}

/// The parser notices a key that stands twice at its value; this is where the key starts.
FilePlace key_start(std::string_view text, FilePlace place) {
    const std::string_view before = split_at(text, place).before;
    std::string_view key = without_trailing(before, "= \t");
    if (key.size() == before.size() || key.empty()) return place;
    const char quote = key.back();
    if (quote == '"' || quote == '\'') {
        const std::size_t open = key.substr(0, key.size() - 1).rfind(quote);
        return open == std::string_view::npos ? place : back_over(place, before, key.substr(0, open));
    }
    return back_over(place, before, without_trailing(key, plain_characters));
}

/// The part of a description that stands in single quotes, without them.
std::string_view quoted_part(std::string_view description) {
    const std::size_t first = description.find('\'');
    const std::size_t last = description.rfind('\'');
    return first < last ? description.substr(first + 1, last - first - 1) : std::string_view{};
}

bool says(std::string_view description, std::string_view words) {
    return description.find(words) != std::string_view::npos;
}

void report_duplicate(std::string_view text, FilePlace place, std::string_view description, Messages& messages) {
    if (!says(description, "table header") && !says(description, "dotted")) place = key_start(text, place);
    if (says(description, "table header")) place.column = indentation(split_at(text, place).before) + 1;
    std::string_view name = quoted_part(description);
    if (name.empty()) name = leading(split_at(text, place).after, plain_characters);
    const bool other_form = says(description, "' as ") || says(description, "dotted");
    add_error(messages, place,
              fmt::format("duplicate key {}: it is given above already{}; give it once", quoted(name),
                          other_form ? ", in another form" : ""));
}

void report_number(std::string_view text, FilePlace place, std::string_view description, Messages& messages) {
    const std::string_view range = says(description, "integer")
                                       ? "whole numbers go up to 9223372036854775807; for a larger one write a "
                                         "decimal point"
                                       : "numbers go from about 1e-307 to 1.7e308 in size";
    add_error(messages, number_start(text, place),
              fmt::format("{} is outside the range of numbers: {}", quoted(quoted_part(description)), range));
}

bool decimal_comma(std::string_view text, FilePlace place) {
    const auto [before, after] = split_at(text, place);
    constexpr std::string_view digits = "0123456789";
    return after.size() >= 2 && after[0] == ',' && digits.find(after[1]) != std::string_view::npos && !before.empty() &&
           digits.find(before.back()) != std::string_view::npos;
}

struct Remedy {
    std::string_view words;  ///< in what the parser says
    std::string_view remedy;
};

constexpr std::array<Remedy, 13> remedies{{
    {"maximum nested value depth", "lists and tables are nested too deep"},
    {"could not determine value type",
     "this is no value: write a number, a \"string\" in quotes, true, false, a [list] or a { table }"},
    {"end-of-file", "the file ends too early: a quote, bracket or brace is not closed, or a value is missing"},
    {"saw EOF", "the file ends too early: a quote, bracket or brace is not closed, or a value is missing"},
    {"inline table: expected key or closing '}', saw '\\n'", "a { table } must stand on one line"},
    {"inline table: expected comma or closing '}', saw '\\n'", "a { table } must stand on one line, closed by '}'"},
    {"expected '=', saw", "a key must be followed by '=' and a value"},
    {"expected value, saw", "a value is missing after '='"},
    {"leading zeroes", "a number must not start with a 0 that only fills up: 5, not 05"},
    {"expected decimal digit, saw '.'", "a number must have a digit before its decimal point: 0.5"},
    {"expected decimal digit, saw", "a number must have digits after its decimal point: 5.0"},
    {"string: unescaped control characters", "a \"string\" must be closed by a quote on the same line"},
    {"expected a comment or whitespace, saw", "only one key = value, or one [section], can stand on a line"},
}};

std::string explanation(std::string_view text, FilePlace place, std::string_view description) {
    const std::string_view after = split_at(text, place).after;
    if (decimal_comma(text, place)) return "write a decimal point, not a comma";
    if (says(description, "control characters") && !after.empty() && after[0] != '\r')
        return R"(a control character must be written as an escape in a "string": \t or \u0001)";
    for (const Remedy& remedy : remedies)
        if (says(description, remedy.words)) return std::string(remedy.remedy);
    constexpr std::string_view preamble = "Error while parsing ";
    if (description.starts_with(preamble)) description.remove_prefix(preamble.size());
    constexpr std::size_t most_bytes = 200;
    return printable(description, most_bytes);
}

}  // namespace

void report_syntax_error(std::string_view text, FilePlace place, std::string_view description, Messages& messages) {
    if (says(description, "cannot redefine") || says(description, "into existing inline table"))
        return report_duplicate(text, place, description, messages);
    if (says(description, "not representable") || says(description, "could not be interpreted"))
        return report_number(text, place, description, messages);
    if (says(description, "leading zeroes")) place = number_start(text, place);
    add_error(messages, place, "not valid TOML: " + explanation(text, place, description));
}

}  // namespace mechwright::reading
