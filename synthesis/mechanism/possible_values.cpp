#include "synthesis/mechanism/possible_values.h"

#include <algorithm>
#include <array>
#include <numbers>

namespace mechwright {

namespace {

struct Named {
    std::string_view quantity;
    PossibleValues values;
};

constexpr double any = std::numeric_limits<double>::infinity();
constexpr double right_angle = std::numbers::pi / 2;

/// Of ratios of the greater to the lesser, angles between two lines, and sizes; by the meaning of each.
constexpr std::array<Named, 28> known{{
    {"time-ratio", {1, any}},
    {"link-ratio", {1, any}},
    {"swing", {0, 2 * right_angle}},
    {"transmission-angle-min", {0, 2 * right_angle}},
    {"transmission-angle-max", {0, 2 * right_angle}},
    {"transmission-angle-worst", {0, right_angle}},
    {"total-length", {0, any}},
    {"stroke", {0, any}},
    {"ram-speed-max", {0, any}},
    {"ram-acceleration-max", {0, any}},
    {"speed-variation", {0, any}},
    {"path-sse", {0, any}},
    {"path-rms", {0, any}},
    {"path-max", {0, any}},
    {"pose-rms", {0, any}},
    {"pose-max", {0, any}},
    {"function-rms", {0, any}},
    {"function-max", {0, any}},
    {"line-deviation", {0, any}},
    {"arc-deviation", {0, any}},
    {"pressure-angle-rise", {0, any}},
    {"pressure-angle-return", {0, any}},
    {"pressure-angle-max", {0, any}},
    {"cam-size", {0, any}},
    {"face-length", {0, any}},
    {"drive-torque-max", {0, any}},
    {"acceleration-max", {0, any}},
    {"jerk-max", {0, any}},
}};

}  // namespace

PossibleValues possible_values(std::string_view quantity) {
    const auto* at = std::find_if(known.begin(), known.end(), [&](const Named& k) { return k.quantity == quantity; });
    return at == known.end() ? PossibleValues{} : at->values;
}

}  // namespace mechwright
