#include "synthesis/mechanism/four_bar/explained.h"

namespace mechwright {

std::vector<QuantityFormula> four_bar_formulas() {
    return {{"time-ratio",
             "(180 deg + |f - e|) / (180 deg - |f - e|), where e and f are the angles from the ground "
             "link to the line from crank pivot to rocker pin at the two limits of the rocker: cos e "
             "= (ground^2 + p^2 - rocker^2) / (2 ground p) with p = coupler + crank, and cos f the "
             "same with p = coupler - crank",
             "law of cosines in the triangles of the limit positions, crank and coupler in line"},
            {"transmission-angle-min",
             "acos((coupler^2 + rocker^2 - d^2) / (2 coupler rocker)), d the distance from crank pin "
             "to rocker pivot: |ground - crank| at the least over a full turn",
             "Theory of Machines, equation (2-1)"},
            {"transmission-angle-max",
             "acos((coupler^2 + rocker^2 - d^2) / (2 coupler rocker)), d the distance from crank pin "
             "to rocker pivot: ground + crank at the greatest over a full turn",
             "Theory of Machines, equation (2-1)"},
            {"transmission-angle-worst",
             "least of mu and 180 deg - mu, cos mu = (coupler^2 + rocker^2 - d^2) / (2 coupler "
             "rocker), d^2 = ground^2 + crank^2 - 2 ground crank cos(crank angle); over a full turn "
             "extreme at 0 and 180 deg",
             "Theory of Machines, equation (2-1)"},
            {"link-ratio", "longest over shortest of ground, crank, coupler, rocker", "definition"},
            {"total-length", "ground + crank + coupler + rocker", "definition"},
            {"function-max",
             "greatest |r - r*|, r the rocker angle, r* = output-start + output-range (f(x) - f(x1)) "
             "/ (f(x2) - f(x1)), x going evenly from x1 to x2 with the crank",
             "definition; extremes where the error is stationary, and at the ends"}};
}

}  // namespace mechwright
