#include "synthesis/command_line/options.h"

#include <charconv>
#include <cmath>

namespace mechwright {

namespace {

/// The number that the whole text is, or nothing.
template <class Number>
std::optional<Number> parsed(const std::string& text) {
    Number number{};
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, number);
    if (error != std::errc{} || stop != end) return std::nullopt;
    return number;
}

}  // namespace

CLI::Option* add_whole_number(CLI::App& command, const std::string& name, std::optional<std::uint64_t>& number,
                              std::uint64_t least, std::uint64_t most, const std::string& help) {
    const auto take = [&number, name, least, most](const std::string& text) {
        number = parsed<std::uint64_t>(text);
        if (!number || *number < least || *number > most)
            throw CLI::ValidationError(name, "'" + text + "' is not a whole number from " + std::to_string(least) +
                                                 " to " + std::to_string(most));
    };
    return command.add_option_function<std::string>(name, take, help)->type_name("N");
}

CLI::Option* add_positive_number(CLI::App& command, const std::string& name, std::optional<double>& number,
                                 const std::string& help) {
    const auto take = [&number, name](const std::string& text) {
        number = parsed<double>(text);
        if (!number || !std::isfinite(*number) || *number <= 0)
            throw CLI::ValidationError(name, "'" + text + "' is not a number above 0");
    };
    return command.add_option_function<std::string>(name, take, help)->type_name("X");
}

CLI::Option* add_digits(CLI::App& command, std::optional<std::uint64_t>& digits) {
    return add_whole_number(command, "--digits", digits, fewest_digits, most_digits,
                            "Digits of the numbers in the text (" + std::to_string(usual_digits) + ")");
}

TextStyle style_of(const Console& console, const std::optional<std::uint64_t>& digits) {
    return {colour_wanted(console), static_cast<int>(digits.value_or(usual_digits))};
}

std::optional<double> decimal(const std::string& text) {
    const auto number = parsed<double>(text);
    return number && std::abs(*number) <= 1e9 ? number : std::nullopt;
}

std::string not_empty(const std::string& text) { return text.empty() ? "may not be empty" : ""; }

}  // namespace mechwright
