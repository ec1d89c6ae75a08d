#pragma once
/// \file
/// The inputs of the master at which a derivative of the motion may jump, because a drive comes to another piece of its
/// motion; and stretches of the motion as parts between them.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>
#include <vector>

#include "analysis/linkage/motion/driven.h"
#include "analysis/numbers/resolved.h"

namespace mechwright::linkage {

/// Those of all drives, rising, in [from, to]. What is nearer than rounding is one.
inline std::vector<double> breaks_between(std::span<const DriveLaw> laws, double from, double to) {
    constexpr double turn = 2 * std::numbers::pi, rounding = 1e-12;
    std::vector<double> all;
    for (const DriveLaw& law : laws) {
        if (!law.motion) continue;
        const std::vector<double> breaks = breaks_of(*law.motion);
        for (double k = std::floor(from / turn); k * turn <= to; ++k)
            for (const double at : breaks)
                if (const double x = k * turn + at; x >= from && x <= to) all.push_back(x);
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end(), [](double a, double b) { return b - a < rounding; }), all.end());
    return all;
}

/// An input by whose pieces drives follow from another one on; by itself where nothing has pieces.
inline double within_after(std::span<const DriveLaw> laws, double input) {
    constexpr double turn = 2 * std::numbers::pi, rounding = 1e-12;
    const std::vector<double> next = breaks_between(laws, input + rounding, input + turn + rounding);
    return next.empty() ? by_itself : 0.5 * (input + next.front());
}

/// A part of a stretch over which drives, and what else has corners, are analytic.
struct MotionPart {
    Stretch stretch{};
    double within = by_itself;  ///< an input in it, to ask for its pieces (input_by); none where nothing has pieces
};

/// The parts of a stretch: itself where no drive has a motion of its own, and there are no corners.
inline std::vector<MotionPart> parts_of(std::span<const DriveLaw> laws, const Stretch& all,
                                        std::span<const double> corners = {}) {
    constexpr double rounding = 1e-12;
    const bool any = std::any_of(laws.begin(), laws.end(), [](const DriveLaw& law) { return law.motion != nullptr; });
    if (!any && corners.empty()) return {{all}};
    std::vector<double> ends = breaks_between(laws, all.from + rounding, all.to - rounding);
    ends.insert(ends.end(), corners.begin(), corners.end());
    ends.insert(ends.end(), {all.from, all.to});
    std::sort(ends.begin(), ends.end());
    std::vector<MotionPart> parts;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        parts.push_back({{ends[i], ends[i + 1], all.root_at_from && i == 0, all.root_at_to && i + 2 == ends.size()},
                         0.5 * (ends[i] + ends[i + 1])});
    return parts;
}

}  // namespace mechwright::linkage
