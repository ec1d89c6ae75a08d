#pragma once
/// \file
/// How sums of multiples of dimensions are written in files.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "synthesis/mechanism/affine.h"

namespace mechwright {

/// Adds `factor` times `more`.
void add(Affine& sum, const Affine& more, double factor);

struct ParsedAffine {
    Affine value{};
    std::string fault{};  ///< what is wrong, and what would be right; empty if nothing is
};

/// As parse_affine reads it; `name_of` gives a dimension's name.
std::string text_of(const Affine& sum, const std::function<std::string(std::size_t)>& name_of);

/// `term + term - term`, with spaces around the signs between terms; a term is a number, a name, `number name`,
/// `number * name`, or one of these `/ number`, with or without a leading `-`. `find` gives a name's index, or what is
/// wrong with the name.
ParsedAffine parse_affine(std::string_view text,
                          const std::function<std::optional<std::size_t>(std::string_view, std::string& fault)>& find);

}  // namespace mechwright
