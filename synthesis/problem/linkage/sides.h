#pragma once
/// \file
/// The sides of dyads: their words, and how files and documents say them.

#include <array>
#include <cstddef>
#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// The words for 1, -1 and 0 of a dyad with two assemblies: "left" and "right", or "ahead" and "behind"; "either".
const std::array<std::string_view, 3>& side_words(const linkage::Group& group);

/// The word of a side: 1, -1 or 0.
std::string_view word_of(const linkage::Group& group, int side);

/// A side whatever the order of the links: { side, from, to } of a dyad of two links, else { side }.
nlohmann::ordered_json side_document(const Linkage& linkage, const linkage::Group& group, int side);

/// A line of [assembly]: `C = { side = "left", from = "B", to = "D" }`, whatever the order of the links, or
/// `C = "ahead"`.
std::string assembly_line(const Linkage& linkage, const linkage::Group& group, int side);

/// Of how many dyads both sides can be left open.
inline constexpr std::size_t most_open_sides = 6;

}  // namespace mechwright
