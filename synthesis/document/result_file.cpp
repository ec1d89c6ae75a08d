#include "synthesis/document/result_file.h"

#include "synthesis/problem/bytes.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

constexpr std::size_t largest_document = std::size_t{64} << 20;
constexpr std::size_t longest_reason = 2000;

/// The parser's message without its own name in front.
std::string reason(const nlohmann::json::exception& exception) {
    const std::string what = exception.what();
    const std::size_t end = what.find("] ");
    return reading::printable(end == std::string::npos ? what : what.substr(end + 2), longest_reason);
}

}  // namespace

std::string why_not_a_result(const nlohmann::ordered_json& json) {
    if (!json.is_object()) return "it is not an object";
    if (!json.contains("schema") || !json["schema"].is_number_integer()) return "it has no schema number";
    if (json["schema"] != 1)
        return "its schema " + json["schema"].dump() + " is not known to this version of mechwright, only 1 is";
    if (!json.contains("problem") || !json["problem"].is_object()) return "it does not say of which problem";
    return {};
}

ReadJson read_result_file(const std::string& file) {
    const reading::Bytes content = reading::read_bytes(file, largest_document, true);
    if (!content.failure.empty()) return {{}, content.failure, true};
    try {
        return {nlohmann::ordered_json::parse(content.bytes), {}, false};
    } catch (const nlohmann::json::exception& exception) {
        return {{}, "not a result document: " + reason(exception), false};
    }
}

}  // namespace mechwright
