/// \file
/// The parser recurses once for every part of a dotted key and looks through lists of sections; both are bounded here,
/// far above what a problem needs. Up to the first syntax error, where the parser stops, this scan sees the same
/// tokens.

#include <fmt/format.h>

#include "synthesis/problem/toml_text.h"

namespace mechwright::reading {

namespace {

constexpr int most_dots = 7;
constexpr int most_sections = 10000;

struct Scan {
    std::string_view text;
    std::size_t at = 0;
    Place place{};
    int dots = 0;      ///< since the last separator
    int sections = 0;  ///< headers and dotted keys
    int depth = 0;     ///< open brackets and braces
    bool line_start = true;
};

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

/// A string over several lines ends with three quotes; one on a line ends with one, or broken, with its line.
void skip_string(Scan& scan) {
    const char quote = scan.text[scan.at];
    const std::string three(3, quote);
    const bool many_lines = starts_with(scan, three);
    const std::string_view end = many_lines ? std::string_view(three) : std::string_view(three).substr(0, 1);
    step(scan, end.size());
    while (scan.at < scan.text.size() && !starts_with(scan, end)) {
        if (!many_lines && scan.text[scan.at] == '\n') return;
        step(scan, quote == '"' && scan.text[scan.at] == '\\' ? 2 : 1);
    }
    step(scan, end.size());
}

void take_separator(Scan& scan, char c) {
    const bool header = c == '[' && scan.line_start && scan.depth == 0;
    if (header || (c == '=' && scan.dots > 0)) ++scan.sections;
    if (c == '[' || c == '{') ++scan.depth;
    if ((c == ']' || c == '}') && scan.depth > 0) --scan.depth;
    scan.dots = 0;
    scan.line_start = c == '\n';
    step(scan);
}

void take_token(Scan& scan) {
    constexpr std::string_view separators = "\n=,[]{}";
    const char c = scan.text[scan.at];
    if (c == '#') return skip_rest_of_line(scan);
    if (separators.find(c) != std::string_view::npos) return take_separator(scan, c);
    if (c != ' ' && c != '\t') scan.line_start = false;
    if (c == '"' || c == '\'') return skip_string(scan);
    if (c == '.') ++scan.dots;
    step(scan);
}

}  // namespace

bool within_parser_limits(std::string_view text, Messages& messages) {
    Scan scan{.text = text};
    while (scan.at < text.size()) {
        const Place before = scan.place;
        take_token(scan);
        if (scan.dots > most_dots) {
            add_error(messages, before,
                      fmt::format("a dotted key of more than {} parts; no section goes so deep", most_dots + 1));
            return false;
        }
        if (scan.sections > most_sections) {
            add_error(messages, before, fmt::format("more than {} sections in one file; split it", most_sections));
            return false;
        }
    }
    return true;
}

}  // namespace mechwright::reading
