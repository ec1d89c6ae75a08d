#include "synthesis/mechanism/drag_link/drag_link.h"

namespace mechwright {

std::vector<QuantityFormula> drag_link_formulas() {
    return {{"time-ratio",
             "(360 deg - b) / b, b the smaller of the two angles that the crank turns through between "
             "the limits of the ram. There arm and rod are in line, which gives the follower's "
             "angles, and the four-bar seen from its follower the crank's",
             "limits of a slider-crank of arm, rod and slide-offset; law of cosines in the four-bar"},
            {"transmission-angle-min",
             "the lesser of acos((coupler^2 + follower^2 - (ground - crank)^2) / (2 coupler "
             "follower)) and, at the ram, acos((arm + |slide-offset|) / rod), over a full turn",
             "Theory of Machines, equation (2-1), and the slope of the rod"},
            {"transmission-angle-max",
             "the greater of acos((coupler^2 + follower^2 - (ground + crank)^2) / (2 coupler "
             "follower)) and the greatest angle at the ram, 90 deg where the rod comes to lie along "
             "the slide",
             "Theory of Machines, equation (2-1), and the slope of the rod"},
            {"transmission-angle-worst",
             "least of the angle between coupler and follower, its supplement, and the angle at the "
             "ram, acos((arm + |slide-offset|) / rod) over a full turn",
             "Theory of Machines, equation (2-1), and the slope of the rod"},
            {"link-ratio", "longest over shortest of ground, crank, coupler, follower, arm, rod", "definition"},
            {"total-length", "ground + crank + coupler + follower + arm + rod", "definition"},
            {"stroke",
             "sqrt((rod + arm)^2 - slide-offset^2) - sqrt((rod - arm)^2 - slide-offset^2) over a full "
             "turn",
             "limits of a slider-crank of arm, rod and slide-offset"}};
}

}  // namespace mechwright
