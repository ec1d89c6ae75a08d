#include "synthesis/bench/sections.h"

#include <array>

namespace mechwright::bench {

std::span<const Section> sections() {
    static const std::array all{kernels(), work_precision(), data_profiles(), recovery(), agreement()};
    return all;
}

}  // namespace mechwright::bench
