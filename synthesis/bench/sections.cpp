#include "synthesis/bench/sections.h"

#include <array>

namespace mechwright::bench {

std::span<const Section> sections() {
    static const std::array all{kernels(),  start_up(),       linkages(),      derivatives(), gradients(),
                                extremes(), work_precision(), data_profiles(), recovery(),    linkage_synthesis(),
                                curves(),   curve_peers(),    everyday(),      agreement(),   exact(),
                                scaling(),  peers()};
    return all;
}

}  // namespace mechwright::bench
