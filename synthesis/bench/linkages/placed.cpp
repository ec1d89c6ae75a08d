#include "synthesis/bench/linkages/placed.h"

#include <cmath>

namespace mechwright::bench {

PointOfLinkage four_bar_linkage(const std::array<double, CouplerPointKernel::size>& x) {
    PointOfLinkage made;
    const auto place = [&](std::size_t pin, std::size_t link, double along, double across) {
        made.numbers.push_back(along);
        made.numbers.push_back(across);
        const std::size_t first = made.numbers.size() - 2;
        made.structure.pins[pin].points.push_back({link, {first, first + 1}});
    };
    constexpr std::size_t crank_pivot = 0, rocker_pivot = 1, crank_pin = 2, rocker_pin = 3, point = 4;
    made.structure.links = 4;
    made.structure.pins.resize(5);
    place(crank_pivot, 0, 0, 0);
    place(rocker_pivot, 0, x[0], 0);
    place(crank_pivot, 1, 0, 0);
    place(crank_pin, 1, x[1], 0);
    place(crank_pin, 2, 0, 0);
    place(rocker_pin, 2, x[2], 0);
    place(point, 2, x[4], x[5]);
    place(rocker_pivot, 3, 0, 0);
    place(rocker_pin, 3, x[3], 0);
    made.structure.drives.push_back({false, 1, 0, 0});
    made.order = linkage::order_of(made.structure);
    made.sides = {1};
    made.needed = linkage::needed_of(made.structure, made.order, made.numbers.size(), point, linkage::none, false);
    return made;
}

AngleBlock whole_turn() {
    AngleBlock block;
    for (std::size_t i = 0; i < AngleBlock::count; ++i) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(i) / AngleBlock::count;
        const HalfTurn<double> half = half_turn(angle);
        block.cosine[i] = std::cos(angle);
        block.sine[i] = std::sin(angle);
        block.half_cosine[i] = half.cosine;
        block.half_sine[i] = half.sine;
    }
    return block;
}

}  // namespace mechwright::bench
