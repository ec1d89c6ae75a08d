#pragma once
/// \file
/// The motion of a linkage for verification, from the equations of its joints (loop.h): followed step by step from one
/// pose in both senses, to where no pose is next to the last one. The pose to start from is that of the dyads on their
/// sides; which sides they are on further along follows from the poses.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// As Mechanism::motion_again and check_motion.
Motion linkage_motion_again(Form form, std::span<const Digits50> dimensions,
                            const std::optional<Vector<Digits50>>& crank_range);
std::vector<Check> check_linkage_motion(const Motion& motion, std::span<const Digits50> dimensions);

}  // namespace mechwright
