#include "synthesis/problem/toml/toml_text.h"

#include <fmt/format.h>

#include "synthesis/problem/text.h"

namespace mechwright::reading {

std::optional<toml::table> parse_toml(std::string_view text, Messages& messages) {
    constexpr std::size_t most_bytes = 4 << 20;
    if (text.size() > most_bytes) {
        add_error(messages,
                  fmt::format("larger than {} MB: put long lists of points into a points_file", most_bytes >> 20));
        return {};
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);  // a byte order mark takes no column
    if (const auto bad = find_bad_text(text)) {
        add_error(messages, bad->place, fmt::format("{}; a problem file is TOML, in UTF-8", bad->why));
        return {};
    }
    const std::optional<Objection> objection = find_objection(text);
    if (objection) text = text.substr(0, objection->statement);  // what is wrong before it is reported instead
    try {
        toml::table table = toml::parse(text);
        if (!objection) return table;
        add_error(messages, objection->place, objection->text);
        return {};
    } catch (const toml::parse_error& error) {
        const toml::source_position at = error.source().begin;
        report_syntax_error(text, {static_cast<int>(at.line), static_cast<int>(at.column)}, error.description(),
                            messages);
        return {};
    }
}

}  // namespace mechwright::reading
