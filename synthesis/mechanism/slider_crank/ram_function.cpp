#include "synthesis/mechanism/slider_crank/ram_function.h"

namespace mechwright::quick_return {

bool fit_ram_function(const FunctionTarget& f, std::span<double> dimensions, std::span<double, 4> scales,
                      bool turns_input, bool) {
    const auto constants = loop_constants(f, scales, ram_loop_row<double>);
    if (!constants || (*constants)[0] == 0 || ((*constants)[0] < 0 && !turns_input)) return false;
    const std::array<double, 3>& k = *constants;
    const double crank = k[0] / 2, offset = k[1] / k[0];
    const double rod_square = k[2] + crank * crank + offset * offset;
    if (!(rod_square > 0)) return false;
    dimensions[0] = std::abs(crank);
    dimensions[1] = std::sqrt(rod_square);
    dimensions[2] = offset;
    if (k[0] < 0) scales[0] += std::numbers::pi;
    return true;
}

}  // namespace mechwright::quick_return
