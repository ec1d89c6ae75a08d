#include "synthesis/bench/pages/markdown.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace mechwright::bench {

namespace {

std::string line(const std::vector<std::string>& cells) { return fmt::format("| {} |\n", fmt::join(cells, " | ")); }

}  // namespace

std::string to_markdown(const MarkdownTable& table) {
    std::string text = line(table.head);
    text += line(std::vector<std::string>(table.head.size(), "---"));
    for (const auto& row : table.rows)
        text += line(row);
    return text;
}

std::string significant(double number, int digits) {
    if (std::isnan(number)) return {};
    const double size = std::abs(number);
    if (size == 0) return "0";
    if (size < 1e-3 || size >= 1e7) return fmt::format("{:.{}e}", number, digits - 1);
    const int before = static_cast<int>(std::floor(std::log10(size))) + 1;
    std::string text = fmt::format("{:.{}f}", number, std::max(digits - before, 0));
    const std::size_t whole = text.find('.') == std::string::npos ? text.size() : text.find('.');
    for (std::size_t i = whole; i > 3 + (text.front() == '-') && whole > 4; i -= 3)
        text.insert(i - 3, " ");
    return text;
}

std::string whole_number(double number) { return significant(number, 1); }

std::string time_text(double seconds) {
    if (std::isnan(seconds)) return {};
    struct Scale {
        double unit;
        const char* name;
    };
    constexpr std::array scales{Scale{1e-9, "ns"}, Scale{1e-6, "us"}, Scale{1e-3, "ms"}, Scale{1, "s"}};
    std::size_t i = 0;
    while (i + 1 < scales.size() && seconds >= scales[i + 1].unit)
        ++i;
    return significant(seconds / scales[i].unit) + " " + scales[i].name;
}

std::string ratio_text(double ratio) { return std::isnan(ratio) ? "" : significant(ratio, 2) + " x"; }

}  // namespace mechwright::bench
