#include "synthesis/mechanism/quick_return/as_linkage.h"

#include "synthesis/mechanism/whitworth/whitworth.h"

namespace mechwright {

namespace {

constexpr char linkage_sections[] = {
#include "as_linkage_whitworth.inc"
};

constexpr auto counterparts =
    quick_return::ram_counterparts(quick_return::with_crank_that_turns, quick_return::transmission_at_ram);

}  // namespace

AsLinkage whitworth_as_linkage() { return {linkage_sections, {}, {}, counterparts}; }

}  // namespace mechwright
