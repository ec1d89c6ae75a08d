#include "synthesis/mechanism/drawing/figure.h"

#include <numbers>

#include "synthesis/mechanism/crank_shaper/crank_shaper.h"

namespace mechwright {

std::vector<FigurePanel> crank_shaper_figure(const std::shared_ptr<const Mechanism>& mechanism) {
    using namespace figure;
    FigurePanel panel{
        .title = "The links",
        .design = figure_design(
            mechanism, {{"centre-distance", 100}, {"crank", 42}, {"lever", 180}, {"rod", 90}, {"ram-distance", 196}}),
        .input = -20 * std::numbers::pi / 180};
    panel.places = {pivot("A0", 0), pivot("B0", 1), pin("A", "crank", 1), pin("C", "lever", 1), pin("D", "ram", 0)};
    panel.dimensions = {length("centre-distance", "B0", "A0", 40), length("crank", "A0", "A", 26),
                        length("lever", "B0", "C", -44), length("rod", "C", "D", -26),
                        by("D", length_along("ram-distance", "B0", "D", side("B0", "A0"), 40))};
    return {panel};
}

}  // namespace mechwright
