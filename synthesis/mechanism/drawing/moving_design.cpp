#include "synthesis/mechanism/drawing/moving_design.h"

namespace mechwright {

double MovingDesign::operator[](std::string_view dimension) const {
    const int index = find_dimension(*mechanism, dimension);
    return index < 0 ? 0 : dimensions[static_cast<std::size_t>(index)];
}

std::vector<double> ends_of(const Motion& motion) { return {motion.from, motion.to}; }

}  // namespace mechwright
