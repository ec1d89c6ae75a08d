#include "synthesis/bench/sections.h"

#include <array>

namespace mechwright::bench {

std::span<const Section> sections() {
    static const std::array all{kernels(), start_up()};
    return all;
}

}  // namespace mechwright::bench
