#include "tests/analysis/known_linkages.h"

#include <cmath>

namespace mechwright::test {

MadeLinkage four_bar_linkage(const FourBar<double>& m, double along, double across) {
    MadeLinkage made;
    made.points(0, {{"A", 0, 0}, {"D", m.ground, 0}});
    made.drive(made.link({{"A", 0, 0}, {"B", m.crank, 0}}));
    made.link({{"B", 0, 0}, {"C", m.coupler, 0}, {"P", along, across}});
    made.link({{"D", 0, 0}, {"C", m.rocker, 0}});
    return made;
}

MadeLinkage slider_crank_linkage(const SliderCrank<double>& m) {
    MadeLinkage made;
    made.points(0, {{"A", 0, 0}});
    made.drive(made.link({{"A", 0, 0}, {"B", m.crank, 0}}));
    made.link({{"B", 0, 0}, {"C", m.rod, 0}});
    made.slide(made.link({{"C", 0, 0}}), made.line(0, 0, 0, 0), 0, m.offset);
    return made;
}

MadeLinkage jansen() {
    MadeLinkage m;
    m.points(0, {{"O", 0, 0}, {"C", 38, 7.8}});
    m.drive(m.link({{"C", 0, 0}, {"X", 15, 0}}));
    const auto bar = [&](const char* a, const char* b, double length) { m.link({{a, 0, 0}, {b, length, 0}}); };
    bar("X", "Y", 50);
    bar("O", "Y", 41.5);
    bar("X", "W", 61.9);
    bar("O", "W", 39.3);
    // The two triangles: Y and V on one about O, U and T on one about W.
    const double v = (41.5 * 41.5 + 40.1 * 40.1 - 55.8 * 55.8) / (2 * 41.5);
    m.points(3, {{"V", v, std::sqrt(40.1 * 40.1 - v * v)}});
    bar("V", "U", 39.4);
    const double t = (36.7 * 36.7 + 49. * 49 - 65.7 * 65.7) / (2 * 36.7);
    m.link({{"W", 0, 0}, {"U", 36.7, 0}, {"T", t, std::sqrt(49. * 49 - t * t)}});
    return m;
}

MadeLinkage six_bar(bool watt) {
    MadeLinkage m = four_bar_linkage({4, 1, 3.5, 3}, 1.5, 1.2);
    m.points(0, {{"G", watt ? 8.5 : 6., watt ? 1. : 3.}});
    if (watt) m.points(3, {{"Q", 2 * std::cos(100 * degree), -2 * std::sin(100 * degree)}});
    m.link({{watt ? "Q" : "P", 0, 0}, {"H", watt ? 4. : 4.5, 0}});
    m.link({{"G", 0, 0}, {"H", watt ? 2.5 : 3., 0}});
    return m;
}

std::vector<std::int8_t> sides_of(const MadeLinkage& made, const std::vector<std::pair<std::string, int>>& named) {
    const linkage::Order order = linkage::order_of(made.s);
    std::vector<std::int8_t> sides(order.choices, 1);
    for (const auto& group : order.groups)
        for (const auto& [name, side] : named)
            if (group.choice != linkage::none && made.pins[group.pin] == name)
                sides[group.choice] = static_cast<std::int8_t>(side);
    return sides;
}

}  // namespace mechwright::test
