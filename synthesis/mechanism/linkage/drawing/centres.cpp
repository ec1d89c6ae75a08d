#include "synthesis/mechanism/linkage/drawing/centres.h"

#include <algorithm>

namespace mechwright {

namespace {

using Moving = Series<double, 1>;

/// Whether a dyad is so near its limit that nothing is left of its margin but rounding.
bool is_at_a_limit(const linkage::Driven<Moving>& driven) {
    constexpr double rounding = 1e-14;
    const double size = linkage::size_of(driven);
    return std::any_of(driven.order.steps.begin(), driven.order.steps.end(), [&](const linkage::Step& step) {
        if (step.margin == linkage::none || step.choice == linkage::none) return false;
        const linkage::Margin<Moving>& margin = driven.pose.margins[step.margin];
        return !(std::min(margin.outer.c[0], margin.inner.c[0]) > rounding * size);
    });
}

}  // namespace

std::optional<std::vector<linkage::InstantCentre>> centres_in_drawing(const LinkageModel& model,
                                                                      std::span<const double> dimensions,
                                                                      std::size_t assembly, double master) {
    const std::vector<double> plain = numbers_of(model, dimensions);
    const std::vector<Moving> numbers(plain.begin(), plain.end());
    linkage::Driven<Moving> driven(model.structure, model.order, std::span<const Moving>(numbers),
                                   model.sides[assembly], laws_of(model));
    if (!driven.place(Moving::variable(master)) || is_at_a_limit(driven)) return {};
    const LinkagePlacement placement = placement_of(model, dimensions);
    const auto is_slot = [&](std::size_t link) {
        const auto& circular = model.structure.circular;
        return std::any_of(circular.begin(), circular.end(), [&](const auto& slot) { return slot.link == link; });
    };
    std::vector<linkage::InstantCentre> centres;
    for (linkage::InstantCentre centre : linkage::instant_centres(linkage::motions_of(driven.pose))) {
        if (is_slot(centre.first) || is_slot(centre.second)) continue;
        using Kind = linkage::InstantCentre::Kind;
        if (centre.kind == Kind::place) centre.at = placement.in_drawing(centre.at);
        if (centre.kind == Kind::at_infinity) centre.at = turned(centre.at, placement.frame.turn);
        centres.push_back(centre);
    }
    return centres;
}

}  // namespace mechwright
