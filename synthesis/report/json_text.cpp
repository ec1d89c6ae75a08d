#include "synthesis/report/json_text.h"

#include <algorithm>

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

std::string on_one_line(const Json& plain) { return plain.dump(-1, ' ', false, Json::error_handler_t::replace); }

void write(const Json& json, std::size_t indent, std::string& text) {
    const bool plain_list =
        json.is_array() && std::none_of(json.begin(), json.end(), [](const Json& e) { return e.is_structured(); });
    if (!json.is_structured() || json.empty()) {
        text += on_one_line(json);
        return;
    }
    const std::string outer = '\n' + std::string(indent, ' ');
    const std::string inner = plain_list ? " " : outer + "  ";
    text += json.is_object() ? '{' : '[';
    if (!plain_list) text += inner;
    bool first = true;
    for (const auto& [key, value] : json.items()) {
        if (!first) text += "," + inner;
        first = false;
        if (json.is_object()) text += on_one_line(key) + ": ";
        write(value, indent + 2, text);
    }
    if (!plain_list) text += outer;
    text += json.is_object() ? '}' : ']';
}

}  // namespace

std::string json_text(const nlohmann::ordered_json& json) {
    std::string text;
    write(json, 0, text);
    text += '\n';
    return text;
}

}  // namespace mechwright
