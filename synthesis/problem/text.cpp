#include "synthesis/problem/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright::reading {

namespace {

using Byte = unsigned char;

bool continues(Byte byte) { return (byte & 0xC0) == 0x80; }

/// The second byte's range is narrower than that of the others where the first alone allows overlong forms,
/// surrogates or values beyond Unicode (The Unicode Standard, table 3-7).
bool second_byte_fits(Byte first, Byte second) {
    switch (first) {
        case 0xE0: return second >= 0xA0 && second <= 0xBF;
        case 0xED: return second >= 0x80 && second <= 0x9F;
        case 0xF0: return second >= 0x90 && second <= 0xBF;
        case 0xF4: return second >= 0x80 && second <= 0x8F;
        default: return continues(second);
    }
}

std::size_t length_by_first_byte(Byte first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first <= 0xDF) return 2;
    if (first >= 0xE0 && first <= 0xEF) return 3;
    if (first >= 0xF0 && first <= 0xF4) return 4;
    return 0;
}

/// The number of bytes of the character that text starts with, or 0 if it is not UTF-8.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<Byte>(text[i]); };
    const std::size_t length = length_by_first_byte(byte(0));
    if (length < 2) return length;
    if (text.size() < length || !second_byte_fits(byte(0), byte(1))) return 0;
    for (std::size_t i = 2; i < length; ++i)
        if (!continues(byte(i))) return 0;
    return length;
}

bool is_control(std::string_view character) {
    const Byte first = static_cast<Byte>(character[0]);
    if (first < 0x20 || first == 0x7F) return true;
    return first == 0xC2 && static_cast<Byte>(character[1]) < 0xA0;
}

}  // namespace

std::string printable(std::string_view text, std::size_t most_bytes) {
    std::string shown;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(length, 1));
        if (shown.size() + character.size() > most_bytes) return shown + "...";
        if (length > 0 && !is_control(character))
            shown += character;
        else
            for (const char c : character)
                shown += fmt::format("\\x{:02x}", static_cast<Byte>(c));
        text.remove_prefix(character.size());
    }
    return shown;
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 60;
    return "'" + printable(text, longest) + "'";
}

std::string listed(std::span<const std::string_view> names) { return fmt::format("{}", fmt::join(names, ", ")); }

std::string remedy(std::string_view unknown, std::span<const std::string_view> known) {
    const std::string_view meant = nearest_name(unknown, known);
    if (!meant.empty()) return fmt::format("did you mean '{}'?", meant);
    return "known are " + listed(known);
}

int count_characters(std::string_view text) {
    return static_cast<int>(
        std::count_if(text.begin(), text.end(), [](char c) { return !continues(static_cast<Byte>(c)); }));
}

std::optional<BadText> find_bad_text(std::string_view bytes) {
    FilePlace place;
    while (!bytes.empty()) {
        const std::size_t length = character_length(bytes);
        if (length == 0) return BadText{place, "this byte is not UTF-8 text"};
        if (bytes[0] == '\0') return BadText{place, "a NUL byte: this is a binary file, not text"};
        place = bytes[0] == '\n' ? FilePlace{place.line + 1, 1} : FilePlace{place.line, place.column + 1};
        bytes.remove_prefix(length);
    }
    return {};
}

std::string_view needed_of(double number) {
    constexpr double greatest = 1e60, least = 1e-60;
    if (!std::isfinite(number)) return "a finite number";
    if (std::abs(number) > greatest) return "at most 1e60 in size";
    if (number != 0 && std::abs(number) < least) return "0, or at least 1e-60 in size";
    return {};
}

}  // namespace mechwright::reading
