#pragma once
/// \file
/// Of many random candidates of a path those whose mechanism assembles at every target, most of which do not: looked at
/// eight side by side, target by target, as far as the mechanism can do that (linkage/targets/margins_in_lanes.h).

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// A candidate and its number among those that are drawn.
struct NumberedDraw {
    std::uint64_t number;
    Eigen::VectorXd x;
};

/// Leaves out, in their order, those that are found not to assemble at a target; where the mechanism cannot tell, none.
/// Targets far from each other are looked at first.
void keep_assembled(const Program& program, std::vector<NumberedDraw>& draws);

}  // namespace mechwright
