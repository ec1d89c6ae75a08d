#pragma once
/// \file
/// The output of a linkage that generates a function in fifty digits, for verification: by the equations of its joints,
/// followed over the whole input range (scan.h).

#include <cstddef>
#include <span>

#include "synthesis/mechanism/linkage/again/scan.h"

namespace mechwright {

/// The error by formulas of its own (target/function/formulas_again.h). The arguments are those of function-max.
class LinkageOutputAgain {
public:
    LinkageOutputAgain(const Motion& motion, std::span<const Digits50> arguments);

    /// The output at an input of the motion less the one asked for, in doubles or in fifty digits; not a number where
    /// the linkage does not close.
    double error(double input, double asked) const;
    Digits50 error(const Digits50& input, const Digits50& asked) const;

private:
    Scan scan_;
    std::size_t output_;
    double whole_turns_ = 0;  ///< by which it is counted on, to be next to what is asked at the start
};

}  // namespace mechwright
