#include "synthesis/mechanism/quick_return/as_linkage.h"

#include "synthesis/mechanism/crank_shaper/crank_shaper.h"

namespace mechwright {

namespace {

constexpr char linkage_sections[] = {
#include "as_linkage_crank_shaper.inc"
};

constexpr auto counterparts =
    quick_return::ram_counterparts(quick_return::with_crank_that_turns, quick_return::transmission_at_ram);

}  // namespace

AsLinkage crank_shaper_as_linkage() { return {linkage_sections, {}, {}, counterparts}; }

}  // namespace mechwright
