#pragma once
/// \file
/// Where the error of a generated function, or the distance from a line, is extreme, and what the number of extremes
/// says: of a minimax optimum in n independent dimensions n + 1 are equal and alternate in sign.

#include <vector>

#include "synthesis/program/result.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

struct ErrorExtremes {
    std::vector<ErrorExtreme> all;  ///< in order along the range; no more than forty
    int alternating = 0;            ///< as great as the greatest, with alternating signs
    int free = 0;                   ///< dimensions left open on which the error depends independently
};

/// Every extreme of the error of a function, a line or an arc, in order along the input range.
std::vector<ErrorExtreme> every_extreme(const Problem& problem, const Design& design);

/// Of a problem with a function or a line.
ErrorExtremes error_extremes_of(const Problem& problem, const Design& design);

/// Whether the greatest error alone is to be least: beside other objectives and requirements a design may stand where
/// its extremes do not balance, and their number shows nothing.
bool asks_for_least_error(const Problem& problem);

/// The unit of the error.
Unit error_unit(const Problem& problem);

/// The place at a share of the range, in the file's unit: x of a function, the crank angle of a line or an arc.
double place_of(const Problem& problem, const Design& design, double share);

}  // namespace mechwright
