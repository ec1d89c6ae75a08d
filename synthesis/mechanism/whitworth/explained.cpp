#include "synthesis/mechanism/whitworth/whitworth.h"

namespace mechwright {

std::vector<QuantityFormula> whitworth_formulas() {
    return {{"time-ratio", "(180 deg + b) / (180 deg - b), b = 2 asin(centre-distance |sin(slide-angle)| / crank)",
             "Theory of Machines, section 2.5, extended to any slide angle"},
            {"transmission-angle-min", "acos(arm / rod) over a full turn",
             "90 deg less the slope of the rod, with the arm square to the slide"},
            {"transmission-angle-worst", "acos(arm / rod) over a full turn",
             "90 deg less the slope of the rod, with the arm square to the slide"},
            {"link-ratio", "longest over shortest of centre-distance, crank, arm, rod", "definition"},
            {"total-length", "centre-distance + crank + arm + rod", "definition"},
            {"stroke", "2 arm over a full turn", "the slide line passes through the driven pivot"}};
}

}  // namespace mechwright
