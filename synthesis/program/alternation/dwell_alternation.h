#pragma once
/// \file
/// Of a dwell that is to be as still as can be: where its signal is extreme, and what the number of extremes says. In n
/// free numbers, the middle value among them, of which limits hold r, n - r + 1 extremes that are equal and alternate
/// in sign make a least deviation to first order, if weights above 0 balance them; fewer leave it to curvature.

#include <vector>

#include "synthesis/mechanism/linkage/dwell.h"
#include "synthesis/program/result.h"

namespace mechwright {

struct DwellAlternation {
    const Quantity* quantity = nullptr;
    double middle = 0;                   ///< halfway between the least and the greatest value
    std::vector<DwellExtreme> extremes;  ///< in order along the stretch; no more than forty
    int alternating = 0;                 ///< as far from the middle as the farthest, on alternating sides of it
    int free = 0;                        ///< open numbers that the signal depends on independently; the middle is one
    int held = 0;                        ///< limits that the design stands at: requirements and ends of ranges
    /// The extremes and these limits balance, and no small change of the dimensions that keeps to the limits brings all
    /// of them closer to a middle, to first order. False where something else is asked for, too, and where a limit has
    /// no slope of its own: that is no proof of the contrary.
    bool balanced = false;
};

/// Those of the objective's terms.
std::vector<DwellAlternation> dwell_alternations(const Problem& problem, const Design& design);

/// -1 where a dimension that is open lies at the lower end of its range, 1 at the upper one, else 0.
int end_of_range(const Problem& problem, const Design& design, std::size_t dimension);

/// Extremes are as great as the greatest within this part of it, and within this much, which rounding explains.
inline constexpr double as_far_within = 1e-6;
double rounding_of_dwell(const Problem& problem, const Quantity& quantity, const Design& design);

}  // namespace mechwright
