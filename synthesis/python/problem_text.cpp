#include "synthesis/python/problem_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "synthesis/problem/text.h"
#include "synthesis/python/values.h"

namespace mechwright::python {

namespace {

using Json = nlohmann::ordered_json;

struct Writer {
    ProblemText out;
    reading::Place place{};
};

void write(Writer& to, std::string_view text) {
    to.out.text += text;
    to.place.column += reading::count_characters(text);
}

void end_line(Writer& to) {
    to.out.text += '\n';
    to.place = {to.place.line + 1, 1};
}

/// Strings of JSON are strings of TOML, but for the character DEL, which TOML wants escaped.
std::string string_text(const std::string& string) {
    std::string text = Json(string).dump();
    for (std::size_t at = 0; (at = text.find('\x7F', at)) != std::string::npos;)
        text.replace(at, 1, "\\u007F");
    return text;
}

std::string plain_text(const Json& value) {
    if (value.is_string()) return string_text(value.get_ref<const std::string&>());
    if (!value.is_number_float() || std::isfinite(value.get<double>())) return value.dump();
    if (std::isnan(value.get<double>())) return "nan";
    return value.get<double>() > 0 ? "inf" : "-inf";
}

void write_value(Writer& to, const Json& value, const std::string& name);

void write_entry(Writer& to, const std::string& key, const Json& value, const std::string& name) {
    to.out.marks.push_back({to.place, name});
    write(to, string_text(key) + " = ");
    write_value(to, value, name);
}

void write_value(Writer& to, const Json& value, const std::string& name) {
    to.out.marks.push_back({to.place, name});
    if (!value.is_structured()) return write(to, plain_text(value));
    write(to, value.is_object() ? "{" : "[");
    // Entries of a list of sections stand on lines of their own, by which messages name them.
    const bool is_section_list = value.is_array() && !value.empty() && value.front().is_object();
    std::size_t index = 0;
    for (const auto& [key, entry] : value.items()) {
        if (index > 0) write(to, ", ");
        if (is_section_list) end_line(to);
        if (value.is_object())
            write_entry(to, key, entry, place_in(name, key));
        else
            write_value(to, entry, place_in(name, index));
        ++index;
    }
    write(to, value.is_object() ? "}" : "]");
}

}  // namespace

ProblemText problem_text(const Json& problem) {
    Writer to;
    end_line(to);  // what the reader says at the start of the text is about the whole
    for (const auto& [key, value] : problem.items()) {
        write_entry(to, key, value, place_in("", key));
        end_line(to);
    }
    if (problem.empty()) to.out.text.clear();
    return std::move(to.out);
}

std::string with_names(const ProblemText& text, const std::string& message) {
    constexpr std::string_view phrase = " in line ";
    const std::size_t at = message.rfind(phrase);
    if (at == std::string::npos) return message;
    int line = 0;
    const char* const end = message.data() + message.size();
    if (std::from_chars(message.data() + at + phrase.size(), end, line).ptr != end) return message;
    const auto first =
        std::find_if(text.marks.begin(), text.marks.end(), [&](const Mark& mark) { return mark.place.line == line; });
    return first == text.marks.end() ? message : message.substr(0, at + 1) + first->name;
}

std::string name_at(const ProblemText& text, reading::Place place) {
    const auto after = std::upper_bound(text.marks.begin(), text.marks.end(), place,
                                        [](const reading::Place& p, const Mark& mark) { return p < mark.place; });
    return after == text.marks.begin() ? std::string() : std::prev(after)->name;
}

}  // namespace mechwright::python
