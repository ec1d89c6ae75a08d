#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

std::vector<QuantityFormula> slider_crank_formulas() {
    return {{"time-ratio",
             "(180 deg + |a|) / (180 deg - |a|), a = asin(offset / (rod - crank)) - asin(offset / "
             "(rod + crank))",
             "Theory of Machines, section 2.4"},
            {"transmission-angle-min", "acos((crank + |offset|) / rod) over a full turn",
             "90 deg less the slope of the rod, which is steepest with the crank square to the slide"},
            {"transmission-angle-worst", "acos((crank + |offset|) / rod) over a full turn",
             "90 deg less the slope of the rod, which is steepest with the crank square to the slide"},
            {"link-ratio", "longer over shorter of crank and rod", "definition"},
            {"total-length", "crank + rod", "definition"},
            {"stroke", "sqrt((rod + crank)^2 - offset^2) - sqrt((rod - crank)^2 - offset^2) over a full turn",
             "Theory of Machines, section 2.4"},
            {"ram-speed-max",
             "greatest of crank |sin(t - b)| / cos b, t the crank angle, b the slope of the rod: sin "
             "b = (offset - crank sin t) / rod",
             "Theory of Machines, section 4-4-2, derived anew"}};
}

}  // namespace mechwright
