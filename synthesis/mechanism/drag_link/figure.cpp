#include "synthesis/mechanism/drawing/figure.h"

#include <numbers>

#include "synthesis/mechanism/drag_link/drag_link.h"

namespace mechwright {

namespace {

using namespace figure;

/// The same mechanism for both panels.
FigurePanel drawn(const std::shared_ptr<const Mechanism>& mechanism, std::string title) {
    FigurePanel panel{.title = std::move(title),
                      .design = figure_design(mechanism, {{"ground", 40},
                                                          {"crank", 84},
                                                          {"coupler", 78},
                                                          {"follower", 90},
                                                          {"arm", 66},
                                                          {"arm-angle", 60},
                                                          {"rod", 170},
                                                          {"slide-angle", 50},
                                                          {"slide-offset", 24}}),
                      .input = 100 * std::numbers::pi / 180};
    panel.places = {pivot("A0", 0),          pivot("B0", 1),     pin("A", "crank", 1),         pin("B", "follower", 1),
                    pin("C", "follower", 2), pin("D", "ram", 0), fixed("ahead", {1, 0}, "ram")};
    return panel;
}

}  // namespace

std::vector<FigurePanel> drag_link_figure(const std::shared_ptr<const Mechanism>& mechanism) {
    FigurePanel input = drawn(mechanism, "The four-bar");
    input.dimensions = {length("ground", "A0", "B0", -34), length("crank", "A0", "A", 26),
                        length("coupler", "A", "B", 26), length("follower", "B0", "B", -24)};
    FigurePanel output = drawn(mechanism, "The arm on the follower, and what it drives");
    output.dimensions = {length("arm", "B0", "C", 26), angle("arm-angle", "B0", side("B0", "B"), side("B0", "C"), 44),
                         length("rod", "C", "D", 26),
                         angle("slide-angle", "B0", side("A0", "B0"), side("D", "ahead"), 90),
                         by("D", coordinate("slide-offset", "B0", "D", side("D", "ahead", 90), -40))};
    return {input, output};
}

}  // namespace mechwright
