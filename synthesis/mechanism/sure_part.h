#pragma once
/// \file
/// Up to where it is sure where a guided point is.

namespace mechwright {

/// Where a mechanism assembles by less than this part of its longest length the end of its motion and rounding decide
/// where its point is: at such a place nobody can say how far it is from a target that is met at any time. Designs are
/// judged by places where it assembles by twice that.
inline constexpr double sure_part = 1e-10;

}  // namespace mechwright
