#pragma once
/// \file
/// The sections of targets in problem files, by what they have in common.

#include <array>
#include <string_view>

namespace mechwright {

/// What a point is at, or a body, one place after the other.
inline constexpr std::array<std::string_view, 2> sections_of_places{"path", "poses"};
/// What a point follows over an input range.
inline constexpr std::array<std::string_view, 2> sections_of_shapes{"line", "arc"};
/// All that is asked for over an input range.
inline constexpr std::array<std::string_view, 3> sections_over_input{"function", sections_of_shapes[0],
                                                                     sections_of_shapes[1]};
/// Those of which a linkage can have several.
inline constexpr std::array<std::string_view, 5> repeated_sections{sections_of_places[0], sections_of_places[1],
                                                                   sections_over_input[0], sections_over_input[1],
                                                                   sections_over_input[2]};

}  // namespace mechwright
