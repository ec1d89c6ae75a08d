#pragma once
/// \file
/// The motion of a finished design derived again, for verification.

#include <optional>
#include <span>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The family of a design, and the crank angles over which it is judged: the given range, or else the full turn where
/// the crank can make it, or else the whole range in which the mechanism assembles (from > to where there is none). Of
/// several ranges the widest, of equally wide ones the first from crank angle 0 on. Derived in fifty digits from the
/// geometry of the problem format (Mechanism::motion_again), and not by `motion`, from which designs have it. Radians.
Motion motion_again(const Mechanism& mechanism, std::size_t assembly, std::span<const Digits50> dimensions,
                    const std::optional<Vector<Digits50>>& range);

}  // namespace mechwright
