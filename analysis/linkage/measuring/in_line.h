#pragma once
/// \file
/// Dyads between the frame and a link that is driven against it: the distance of their outer pins, and with it margins
/// and transmission angle, is extreme where that link is in line with the frame (the law of cosines), at inputs in
/// closed form.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "analysis/geometry/vector.h"
#include "analysis/linkage/structure/steps.h"

namespace mechwright::linkage::detail {

struct InLine {
    struct Input {
        double at;       ///< of the master
        bool stretched;  ///< the outer pins are as far apart as they can be, else as near
    };
    std::vector<Input> inputs{};  ///< in order
    bool constant = false;        ///< there are none, for the distance is always the same
    bool pins_meet = false;       ///< where they are near: the distance has no derivative there
};

/// The inputs in [from, to] at which the driven link is in line. `ratio` is its drive's to the master (not 0 unless it
/// stands still), `size` that of the linkage, and pin_at(pin) where a pin is at the input `from`.
template <class PinAt>
InLine in_line(const CarriedRound& round, double ratio, double from, double to, double size, const PinAt& pin_at) {
    constexpr double none_left = 1e-9;  // of the size
    const Vector<double> centre = pin_at(round.centre), arm = pin_at(round.pin) - centre,
                         base = centre - pin_at(round.fixed);
    const double arm_length = std::hypot(arm.x, arm.y), base_length = std::hypot(base.x, base.y);
    InLine found;
    found.constant = !(arm_length > none_left * size) || !(base_length > none_left * size) || ratio == 0;
    found.pins_meet = !(std::abs(arm_length - base_length) > none_left * size);
    if (found.constant) return found;
    // Stretched after an even number of half turns from where the arm goes on from the base.
    const double apart = std::atan2(cross(base, arm), dot(base, arm)), way = (to - from) * ratio;
    const auto halves_at = [&](double turned) { return (apart + turned) / std::numbers::pi; };
    const double least = std::floor(halves_at(std::min(way, 0.0))), greatest = std::ceil(halves_at(std::max(way, 0.0)));
    const int count = static_cast<int>(greatest - least) + 1;
    for (int k = 0; k < count; ++k) {
        const double halves = ratio > 0 ? least + k : greatest - k;
        const double at = from + (halves * std::numbers::pi - apart) / ratio;
        if (at >= from && at <= to) found.inputs.push_back({at, std::remainder(halves, 2) == 0});
    }
    return found;
}

}  // namespace mechwright::linkage::detail
