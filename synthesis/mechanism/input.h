#pragma once
/// \file
/// What the input of a mechanism is: a crank angle, or the displacement of a driven slide.

#include <array>
#include <optional>
#include <string_view>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The unit of the input, which the first column of the motion table is.
inline Unit input_unit(const Mechanism& mechanism) { return mechanism.table.units.front(); }

/// Of what kind dimensions are that stand for an input.
inline DimensionKind kind_of_input(const Mechanism& mechanism) {
    return input_unit(mechanism) == Unit::angle ? DimensionKind::angle : DimensionKind::coordinate;
}

/// What messages call it.
inline std::string_view input_word(const Mechanism& mechanism) {
    return input_unit(mechanism) == Unit::angle ? "crank angle" : "displacement";
}

/// Where it is a displacement: the least and the greatest that it can be in any design, in the file's lengths.
std::optional<std::array<double, 2>> reach_of_input(const Mechanism& mechanism);

}  // namespace mechwright
