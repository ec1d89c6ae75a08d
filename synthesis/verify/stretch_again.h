#pragma once
/// \file
/// The stretch of crank angles in which all targets of a claim are met, derived again in fifty digits.

#include <optional>
#include <span>
#include <vector>

#include "synthesis/document/claim.h"

namespace mechwright {

/// Crank angles that are swept, radians.
struct SweptRange {
    Digits50 from;
    Digits50 to;
};

/// The angle counted up from zero, in [0, period).
Digits50 within_period(const Digits50& angle, const Digits50& period);

/// The turns of the crank after which everything is where it was, radians; infinite where a slide drives.
Digits50 cycle_again(const Mechanism& mechanism);

/// The shortest range that holds several, each turned on by whole periods: it begins where one of them does, of such
/// that are equally short to 1e-9 where the first does.
SweptRange shortest_over(const std::vector<SweptRange>& ranges, const Digits50& period);

/// The input range of a function, a line or an arc that is the only target; of several targets the shortest range in
/// which all are met. Nothing where no target is over an input range, where a path is closed, or where the claim does
/// not say at which crank angles its path is met.
std::optional<SweptRange> stretch_again(const Claim& claim, std::span<const Digits50> dimensions);

}  // namespace mechwright
