#pragma once
/// \file
/// Up to where it is sure where a guided point is.

namespace mechwright {

/// Where a mechanism assembles by less than this part of its longest length the end of its motion and rounding decide
/// where its point is: at such a place nobody can say how far it is from a target that is met at any time.
inline constexpr double sure_part = 1e-10;

/// Beside the end of a motion designs are judged by the place where they assemble by this part: with some to spare.
inline constexpr double judged_part = 2 * sure_part;

}  // namespace mechwright
