#include "synthesis/mechanism/crank_shaper/crank_shaper.h"

namespace mechwright {

std::vector<QuantityFormula> crank_shaper_formulas() {
    return {{"time-ratio", "(360 deg - b) / b, b = 2 acos(crank / centre-distance)", "Theory of Machines, section 2.5"},
            {"transmission-angle-min",
             "acos(|ram-distance - lever cos(w)| / rod) at the worse of w = 0 and w = asin(crank / "
             "centre-distance), w the angle of the lever to the line of centres",
             "90 deg less the slope of the rod, which is extreme with the lever upright or at an end "
             "of its swing"},
            {"transmission-angle-worst",
             "acos(|ram-distance - lever cos(w)| / rod) at the worse of w = 0 and w = asin(crank / "
             "centre-distance)",
             "90 deg less the slope of the rod; in the slot the block pushes square to the lever"},
            {"link-ratio", "longest over shortest of centre-distance, crank, lever, rod", "definition"},
            {"total-length", "centre-distance + crank + lever + rod", "definition"},
            {"stroke", "2 lever crank / centre-distance over a full turn",
             "both ends of the lever's swing lie at the same distance from the ram line"}};
}

}  // namespace mechwright
