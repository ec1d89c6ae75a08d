#pragma once
/// \file
/// How far designs stay from the ends of their kind of motion.

namespace mechwright {

/// How far a condition of motion is kept from its limit, in lengths of the program: at the limit itself lies a change
/// point, where no design passes verification.
inline constexpr double condition_margin = 1e-6;

}  // namespace mechwright
