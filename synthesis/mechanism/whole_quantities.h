#pragma once
/// \file
/// Quantities over the whole motion, in problems that judge designs over a part of it: over the range of use of a path,
/// or the input range of a line though the crank turns fully.

#include <memory>
#include <string_view>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// What the name of such a quantity ends with.
inline constexpr std::string_view whole_suffix = ".whole";

/// Without that ending, where a name has it.
std::string_view without_whole(std::string_view name);

/// A mechanism with a quantity NAME.whole behind all others for each of its own that depends on the motion
/// (Quantity::of_motion): the same by the same functions, over the whole motion. It comes back itself where its motion
/// has no part that moves with the design (Mechanism::input).
std::shared_ptr<const Mechanism> with_whole_quantities(const std::shared_ptr<const Mechanism>& mechanism);

}  // namespace mechwright
