#include "synthesis/study/iso_tolerances.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace mechwright {

namespace {

/// Steps of nominal sizes up to and including so many millimetres, and the tolerances of grades 5 to 13 in micrometres:
/// ISO 286-1:2010, table 1.
constexpr std::array<double, 21> size_steps{3,   6,   10,  18,  30,   50,   80,   120,  180,  250, 315,
                                            400, 500, 630, 800, 1000, 1250, 1600, 2000, 2500, 3150};
constexpr int least_grade = 5;
constexpr std::array<std::array<int, 21>, 9> tolerances{{
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27, 32, 36, 40, 47, 55, 65, 78, 96},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40, 44, 50, 56, 66, 78, 92, 110, 135},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63, 70, 80, 90, 105, 125, 150, 175, 210},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97, 110, 125, 140, 165, 195, 230, 280, 330},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155, 175, 200, 230, 260, 310, 370, 440, 540},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250, 280, 320, 360, 420, 500, 600, 700, 860},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400, 440, 500, 560, 660, 780, 920, 1100, 1350},
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630, 700, 800, 900, 1050, 1250, 1500, 1750, 2100},
    {140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970, 1100, 1250, 1400, 1650, 1950, 2300, 2800, 3300},
}};

/// Limit deviations in micrometres for sizes from 0.5 and up to and including so many millimetres, 0 where there is
/// none: ISO 2768-1:1989, table 1.
constexpr double least_general_size = 0.5;
constexpr std::array<double, 8> general_steps{3, 6, 30, 120, 400, 1000, 2000, 4000};
constexpr std::array<std::array<int, 8>, 4> general_limits{{
    {50, 50, 100, 150, 200, 300, 500, 0},
    {100, 100, 200, 300, 500, 800, 1200, 2000},
    {200, 300, 500, 800, 1200, 2000, 3000, 4000},
    {0, 500, 1000, 1500, 2500, 4000, 6000, 8000},
}};

constexpr double millimetre = 1e-3;  // of a micrometre

template <std::size_t N>
std::size_t step_of(const std::array<double, N>& steps, double size) {
    return static_cast<std::size_t>(std::lower_bound(steps.begin(), steps.end(), size) - steps.begin());
}

}  // namespace

std::optional<double> iso_tolerance(int grade, double size) {
    const int row = grade - least_grade;
    if (row < 0 || row >= static_cast<int>(tolerances.size()) || !(size > 0) || size > size_steps.back()) return {};
    return tolerances[static_cast<std::size_t>(row)][step_of(size_steps, size)] * millimetre;
}

std::optional<double> general_tolerance(int tolerance_class, double size) {
    const int row = tolerance_class - 1;
    if (row < 0 || row >= static_cast<int>(general_limits.size())) return {};
    if (!(size >= least_general_size) || size > general_steps.back()) return {};
    const int limit = general_limits[static_cast<std::size_t>(row)][step_of(general_steps, size)];
    return limit > 0 ? std::optional(2 * limit * millimetre) : std::nullopt;
}

}  // namespace mechwright
