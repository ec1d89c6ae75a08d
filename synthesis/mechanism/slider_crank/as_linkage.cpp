#include "synthesis/mechanism/quick_return/as_linkage.h"

#include "synthesis/mechanism/slider_crank/slider_crank.h"

namespace mechwright {

namespace {

constexpr char linkage_sections[] = {
#include "as_linkage_slider_crank.inc"
};

constexpr std::array<AsLinkage::Target, 5> targets{{{"path", "point = \"P\"\n"},
                                                    {"poses", "point = \"P\"\nlink = \"rod\"\n"},
                                                    {"line", "point = \"P\"\n"},
                                                    {"function", "signal = \"ram-position\"\n"},
                                                    {"arc", "point = \"P\"\n"}}};

// The only dyad is that at the ram.
constexpr std::array<Counterpart, 3> transmission_counterparts{
    {{.quantity = "transmission-angle-min", .is = {"transmission-angle-worst"}},
     same_of_linkages("transmission-angle-worst"),
     {.quantity = "transmission-angle-max", .why_not = quick_return::folded_at_the_ram}}};

constexpr auto counterparts =
    quick_return::ram_counterparts(quick_return::with_crank_that_turns, transmission_counterparts);

}  // namespace

AsLinkage slider_crank_as_linkage() { return {linkage_sections, {}, targets, counterparts}; }

}  // namespace mechwright
