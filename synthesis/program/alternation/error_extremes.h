#pragma once
/// \file
/// Where the error of a generated function, or the distance from a line, is extreme, and what the number of extremes
/// says: of a minimax optimum in n independent dimensions n + 1 are equal and alternate in sign.

#include <vector>

#include "synthesis/problem/input_tasks.h"
#include "synthesis/program/result.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

struct ErrorExtremes {
    std::vector<ErrorExtreme> all;  ///< in order along the range; no more than forty
    int alternating = 0;            ///< as great as the greatest, with alternating signs
    int free = 0;                   ///< dimensions left open on which the error depends independently
};

/// Every extreme of the error of a function, a line or an arc, in order along the input range.
std::vector<ErrorExtreme> every_extreme(const Problem& problem, const InputTask& task, const Design& design);

/// The same with what its number says.
ErrorExtremes error_extremes_of(const Problem& problem, const InputTask& task, const Design& design);

/// Whether the greatest error of this alone is to be least: beside other objectives, requirements and targets a design
/// may stand where its extremes do not balance, and their number shows nothing.
bool asks_for_least_error(const Problem& problem, const InputTask& task);

/// The place at a share of the range, in the file's unit: x of a function, the crank angle of a line or an arc.
double place_of(const Problem& problem, const InputTask& task, const Design& design, double share);

}  // namespace mechwright
