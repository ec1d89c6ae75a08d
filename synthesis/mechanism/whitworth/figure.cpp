#include "synthesis/mechanism/drawing/figure.h"

#include <numbers>

#include "synthesis/mechanism/whitworth/whitworth.h"

namespace mechwright {

std::vector<FigurePanel> whitworth_figure(const std::shared_ptr<const Mechanism>& mechanism) {
    using namespace figure;
    FigurePanel panel{
        .title = "The links",
        .design = figure_design(
            mechanism, {{"centre-distance", 44}, {"crank", 80}, {"arm", 60}, {"rod", 150}, {"slide-angle", 70}}),
        .input = 250 * std::numbers::pi / 180};
    panel.places = {pivot("A0", 0),     pivot("B0", 1),     pin("A", "crank", 1),
                    pin("C", "arm", 1), pin("D", "ram", 0), fixed("ahead", {1, 0}, "ram")};
    panel.dimensions = {length("centre-distance", "B0", "A0", 62), length("crank", "A0", "A", 26),
                        length("arm", "B0", "C", 26), length("rod", "C", "D", 26),
                        angle("slide-angle", "B0", side("B0", "A0"), side("D", "ahead"), 38)};
    return {panel};
}

}  // namespace mechwright
