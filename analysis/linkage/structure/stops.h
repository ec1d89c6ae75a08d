#pragma once
/// \file
/// Stops of joints and drives: the last steps of an order, each of which measures how far what is placed is from one.

#include <cstddef>

#include "analysis/linkage/structure/steps.h"
#include "analysis/linkage/structure/structure.h"

namespace mechwright::linkage::detail {

inline void add_stops(const Structure& s, Order& order) {
    const auto add = [&](const Stops& stops, Step step) {
        step.kind = Step::Kind::stopped;
        for (const bool greatest : {false, true}) {
            if (!(greatest ? stops.max : stops.min)) continue;
            step.reversed = greatest;
            step.margin = order.margins++;
            ++order.stops;
            order.steps.push_back(step);
        }
    };
    for (std::size_t i = 0; i < s.drives.size(); ++i) {
        Step step;
        step.input = i;
        if (s.drives[i].of_slide) step.joint = s.drives[i].slide;
        add(s.drives[i].stops, step);
    }
    for (std::size_t i = 0; i < s.slides.size(); ++i) {
        Step step;
        step.link = s.slides[i].link;
        step.other = s.slides[i].line.on;
        step.joint = i;
        add(s.slides[i].stops, step);
    }
    for (std::size_t i = 0; i < s.slots.size(); ++i) {
        Step step;
        step.pin = s.slots[i].pin;
        step.other = s.slots[i].line.on;
        step.joint = i;
        add(s.slots[i].stops, step);
    }
    for (std::size_t i = 0; i < s.circular.size(); ++i) {
        if (!s.circular[i].ends) continue;
        Step step;
        step.pin = s.circular[i].pin;
        step.far_pin = s.circular[i].centre;
        step.other = s.circular[i].on;
        step.joint = i;
        add(s.circular[i].ends->stops, step);
    }
}

}  // namespace mechwright::linkage::detail
