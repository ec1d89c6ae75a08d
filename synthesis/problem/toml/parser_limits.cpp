/// \file
/// What toml++ 3.3 does not stand: it recurses once for every part of a dotted key, looks through lists of sections,
/// and takes for granted that a section's name starts as a name, that no brace closes a list, that times are written
/// rightly and that characters between tokens are ASCII. Lengths are bounded far above what a problem needs. Up to the
/// first syntax error this scan sees the same tokens as the parser.

#include <fmt/format.h>

#include <utility>

#include "synthesis/problem/toml/toml_text.h"

namespace mechwright::reading {

namespace {

constexpr int most_dots = 7;
constexpr int most_sections = 10000;

struct Scan {
    std::string_view text;
    std::size_t at = 0;
    FilePlace place{};
    int dots = 0;               ///< since the last separator
    int sections = 0;           ///< headers and dotted keys
    std::string open{};         ///< brackets and braces
    std::size_t statement = 0;  ///< where the last line starts that is not in the middle of something
    bool line_start = true;
    bool word = false;         ///< in a key, number or word, or blanks behind it
    std::string_view wrong{};  ///< with the token that was taken last
};

bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

bool starts_with(const Scan& scan, std::string_view token) { return scan.text.substr(scan.at).starts_with(token); }

void step(Scan& scan) {
    const char c = scan.text[scan.at++];
    if (c == '\n')
        scan.place = {scan.place.line + 1, 1};
    else if ((static_cast<unsigned char>(c) & 0xC0) != 0x80)
        ++scan.place.column;
}

void step(Scan& scan, std::size_t count) {
    for (std::size_t i = 0; i < count && scan.at < scan.text.size(); ++i)
        step(scan);
}

void skip_rest_of_line(Scan& scan) {
    while (scan.at < scan.text.size() && scan.text[scan.at] != '\n')
        step(scan);
}

/// In a string of several lines a backslash ends a line; it is the first character of the next that matters.
void check_continued_line(Scan& scan) {
    constexpr std::string_view white = " \t\r\n";
    const std::size_t next = scan.text.find_first_not_of(white, scan.at + 1);
    if (next != std::string_view::npos && !is_ascii(scan.text[next]))
        scan.wrong = "a line of a string that is continued after '\\' must go on with an ASCII character";
}

/// A string over several lines ends with three quotes; one on a line ends with one, or broken, with its line.
void skip_string(Scan& scan) {
    const char quote = scan.text[scan.at];
    const std::string three(3, quote);
    const bool many_lines = starts_with(scan, three);
    const std::string_view end = many_lines ? std::string_view(three) : std::string_view(three).substr(0, 1);
    step(scan, end.size());
    while (scan.at < scan.text.size() && !starts_with(scan, end)) {
        if (!many_lines && scan.text[scan.at] == '\n') return;
        const bool escape = quote == '"' && scan.text[scan.at] == '\\';
        if (escape && many_lines) check_continued_line(scan);
        step(scan, escape ? 2 : 1);
    }
    step(scan, end.size());
}

/// Whether a name, or what is missing there, follows the brackets of a header.
bool names_section(std::string_view header) {
    constexpr std::string_view starts = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-\"']";
    constexpr std::string_view blanks = " \t";
    header.remove_prefix(header.starts_with("[[") ? 2 : 1);
    const std::size_t name = header.find_first_not_of(blanks);
    return name == std::string_view::npos || starts.find(header[name]) != std::string_view::npos;
}

void take_closing(Scan& scan, char c) {
    if (scan.open.empty()) return;  // the parser says what to make of it
    const char opening = c == ']' ? '[' : '{';
    if (scan.open.back() != opening)
        scan.wrong = "not valid TOML: a bracket or brace is closed by one of the other kind";
    scan.open.pop_back();
}

void take_separator(Scan& scan, char c) {
    const bool header = c == '[' && scan.line_start && scan.open.empty();
    if (header || (c == '=' && scan.dots > 0)) ++scan.sections;
    if (header && !names_section(scan.text.substr(scan.at)))
        scan.wrong = "not valid TOML: the name of a [section] starts with a letter, a digit, '_', '-' or a quote";
    if (c == '[' || c == '{') scan.open += c;
    if (c == ']' || c == '}') take_closing(scan, c);
    scan.dots = 0;
    scan.word = false;
    scan.line_start = c == '\n';
    step(scan);
    if (c == '\n' && scan.open.empty()) scan.statement = scan.at;
}

/// Characters of keys, numbers and words.
void take_plain(Scan& scan, char c) {
    if (c == '.') ++scan.dots;
    if (c != ' ' && c != '\t') {
        scan.line_start = false;
        scan.word = c != '.';
    }
    if (c == ':')
        scan.wrong = "':' can stand only in quotes: write key = value; no value of a problem is a time of day";
    if (!is_ascii(c)) scan.wrong = "not valid TOML: this character can stand only in quotes or in a # comment";
    step(scan);
}

void take_quote(Scan& scan) {
    if (scan.word) scan.wrong = "not valid TOML: a quote can stand only at the start of a key or value";
    scan.line_start = false;
    skip_string(scan);
}

void take_token(Scan& scan) {
    constexpr std::string_view separators = "\n=,[]{}";
    const char c = scan.text[scan.at];
    if (c == '#')
        skip_rest_of_line(scan);
    else if (separators.find(c) != std::string_view::npos)
        take_separator(scan, c);
    else if (c == '"' || c == '\'')
        take_quote(scan);
    else
        take_plain(scan, c);
}

/// What is wrong with the token that was taken last; empty if nothing.
std::string objection(const Scan& scan) {
    if (!scan.wrong.empty()) return std::string(scan.wrong);
    if (scan.dots > most_dots)
        return fmt::format("a dotted key of more than {} parts; no section goes so deep", most_dots + 1);
    if (scan.sections > most_sections) return fmt::format("more than {} sections in one file; split it", most_sections);
    return {};
}

}  // namespace

std::optional<Objection> find_objection(std::string_view text) {
    Scan scan{.text = text};
    while (scan.at < text.size()) {
        const FilePlace before = scan.place;
        const std::size_t statement = scan.statement;
        take_token(scan);
        if (std::string why = objection(scan); !why.empty()) return Objection{before, std::move(why), statement};
    }
    return {};
}

}  // namespace mechwright::reading
