#include "synthesis/report/csv/csv_text.h"

#include <charconv>

namespace mechwright {

std::string csv_number(double number) {
    char text[64];
    const auto written = std::to_chars(text, text + sizeof text, number + 0.0);  // no "-0"
    return {text, written.ptr};
}

std::string csv_field(const std::string& text) {
    if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text) {
        if (c == '"') quoted += '"';
        quoted += c;
    }
    return quoted + '"';
}

}  // namespace mechwright
