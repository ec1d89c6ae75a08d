#include "synthesis/mechanism/quick_return/explained.h"

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
