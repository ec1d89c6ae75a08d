#include "synthesis/mechanism/four_bar/function.h"

namespace mechwright::four_bar {

bool fit_function(const FunctionTarget& f, std::span<double> dimensions, std::span<double, 4> scales, bool turns_input,
                  bool turns_output) {
    const auto constants = loop_constants(f, scales, rocker_loop_row<double>);
    if (!constants || (*constants)[0] == 0 || (*constants)[1] == 0) return false;
    const std::array<double, 3>& k = *constants;
    if ((k[0] < 0 && !turns_input) || (k[1] < 0 && !turns_output)) return false;
    const double ground = dimensions[0];
    const double crank = ground / k[0], rocker = ground / k[1];
    const double coupler_square = ground * ground + crank * crank + rocker * rocker - 2 * crank * rocker * k[2];
    if (!(coupler_square > 0)) return false;
    dimensions[1] = std::abs(crank);
    dimensions[2] = std::sqrt(coupler_square);
    dimensions[3] = std::abs(rocker);
    if (k[0] < 0) scales[0] += std::numbers::pi;
    if (k[1] < 0) scales[2] += std::numbers::pi;
    return true;
}

}  // namespace mechwright::four_bar
