#pragma once
/// \file
/// Text of files: is it text at all, and how pieces of it are shown in messages.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "synthesis/problem/messages.h"

namespace mechwright::reading {

/// A piece of a file in single quotes, shortened if long, with control characters made visible.
std::string quoted(std::string_view text);

/// The same without quotes, for a whole sentence.
std::string printable(std::string_view text, std::size_t most_bytes);

/// "a, b, c"
std::string listed(std::span<const std::string_view> names);

/// What to write instead of an unknown name: "did you mean 'a'?", or else "known are a, b, c".
std::string remedy(std::string_view unknown, std::span<const std::string_view> known);

/// How many characters a piece of UTF-8 has.
int count_characters(std::string_view text);

/// What a number of a file would have to be, or nothing: "a finite number". Products of four lengths stay in the range
/// of doubles.
std::string_view needed_of(double number);

struct BadText {
    FilePlace place;
    std::string_view why;
};

/// Where a file first shows that it is not text: a NUL byte, or bytes that are not UTF-8.
std::optional<BadText> find_bad_text(std::string_view bytes);

}  // namespace mechwright::reading
