#pragma once
/// \file
/// The numbers and quantities that targets bring to a mechanism. A kind says what it can do: guide a point, generate
/// functions. What is asked of it has numbers of its own, such as the direction of a line, the scales of a function or
/// the crank angle that prescribed ones are counted from; they follow the mechanism's dimensions in problems that have
/// such a target, and are designed like these.

#include <memory>
#include <span>
#include <string_view>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// A mechanism with the numbers and quantities of some targets, named as their sections. Among the names may be others,
/// and those of numbers that are given in [dimensions] (crank-start, body-angle): these then are there, whatever
/// targets there are. `mechanism` is one of `mechanisms()`; it comes back itself where no targets can be asked of it.
std::shared_ptr<const Mechanism> with_targets(const std::shared_ptr<const Mechanism>& mechanism,
                                              std::span<const std::string_view> names);

/// A kind without any of them with those of all targets.
std::shared_ptr<const Mechanism> with_all_targets(std::shared_ptr<const Mechanism> kind);

}  // namespace mechwright
