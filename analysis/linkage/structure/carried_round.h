#pragma once
/// \file
/// Dyads between the frame and a link that is driven against it: the triangle of their outer pins and the pivot of that
/// link is known by its angle.

#include <utility>

#include "analysis/linkage/structure/steps.h"

namespace mechwright::linkage::detail {

/// How a dyad of two links of constant lengths is carried round; nothing of any other step.
inline CarriedRound carried_round(const Order& order, const Step& dyad) {
    using Kind = Step::Kind;
    if (dyad.kind != Kind::dyad || dyad.is_extended() || dyad.first.kind != Locus::Kind::circle ||
        dyad.second.kind != Locus::Kind::circle)
        return {};
    const auto find = [&](Kind kind, const auto& is) -> const Step* {
        for (const Step& step : order.steps)
            if (step.kind == kind && is(step)) return &step;
        return nullptr;
    };
    const auto link_of = [&](std::size_t pin) {
        const Step* carried = find(Kind::carried, [&](const Step& step) { return step.pin == pin; });
        return carried == nullptr ? none : carried->link;
    };
    for (const auto& [pin, fixed] :
         {std::pair(dyad.first.centre, dyad.second.centre), std::pair(dyad.second.centre, dyad.first.centre)}) {
        const std::size_t link = link_of(pin);
        if (link == none || link == 0 || link_of(fixed) != 0) continue;
        const Step* driven = find(Kind::driven, [&](const Step& step) { return step.link == link && step.other == 0; });
        const Step* pinned = find(Kind::pinned, [&](const Step& step) { return step.link == link; });
        if (driven != nullptr && pinned != nullptr && link_of(pinned->pin) == 0)
            return {pin, pinned->pin, link, driven->input, fixed};
    }
    return {};
}

}  // namespace mechwright::linkage::detail
