#pragma once
/// \file
/// Numbers of a linkage's file: how sums of multiples of dimensions are written.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "synthesis/mechanism/linkage/affine.h"

namespace mechwright {

/// Adds `factor` times `more`.
void add(Affine& sum, const Affine& more, double factor);

struct ParsedAffine {
    Affine value{};
    std::string fault{};  ///< what is wrong, and what would be right; empty if nothing is
};

/// `term + term - term`, with spaces around the signs between terms; a term is a number, a name, `number name`,
/// `number * name`, or one of these `/ number`, with or without a leading `-`. `find` gives a name's index, or what is
/// wrong with the name.
ParsedAffine parse_affine(std::string_view text,
                          const std::function<std::optional<std::size_t>(std::string_view, std::string& fault)>& find);

}  // namespace mechwright
