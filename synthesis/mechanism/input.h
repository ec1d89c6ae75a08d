#pragma once
/// \file
/// What the input of a mechanism is: a crank angle, or the displacement of a driven slide.

#include <string_view>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The unit of the input, which the first column of the motion table is.
inline Unit input_unit(const Mechanism& mechanism) { return mechanism.table.units.front(); }

/// What messages call it.
inline std::string_view input_word(const Mechanism& mechanism) {
    return input_unit(mechanism) == Unit::angle ? "crank angle" : "displacement";
}

}  // namespace mechwright
