#pragma once
/// \file
/// What makes a design one that can be used, besides requirements and ranges: written once, as margins by name.

#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// A condition that a design has to meet, >= 0 where it does.
struct ValidityMargin {
    std::string name;
    double margin;   ///< minus infinity where there is no number for it
    bool tolerated;  ///< an angle in radians, or a part of the longest length: the problem's tolerance may be missing
};

/// The margins of a design. A cam's follower is held, and the cam is not undercut. A linkage assembles over the crank
/// angles over which it is judged. For a path or poses it assembles at every target and along the stretch between them,
/// on one branch; the crank goes round a closed path; an ordered path is met in its order within one turn. What
/// verification asks (target/path/verify.h, the mechanisms' check_motion) are these conditions again.
std::vector<ValidityMargin> validity_margins(const Problem& problem, const Design& design);

}  // namespace mechwright
