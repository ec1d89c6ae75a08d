#include "synthesis/mechanism/quick_return/as_linkage.h"

#include <numbers>

#include "synthesis/mechanism/drag_link/drag_link.h"

namespace mechwright {

namespace {

constexpr char linkage_sections[] = {
#include "as_linkage_drag_link.inc"
};

constexpr std::array<std::string_view, 2> sides{"left", "right"};

constexpr std::array<Assurance, 2> both_turn{
    quick_return::crank_turns, {.quantity = "follower-angle.speed.least", .min = 0, .why = "the follower turns fully"}};

constexpr std::array<Counterpart, 3> transmission_counterparts{
    {same_of_linkages("transmission-angle-worst"),
     {.quantity = "transmission-angle-min",
      .by = Counterpart::By::least,
      .is = {"coupler-transmission-angle.least", "transmission-angle.least", "transmission-other.least"}},
     // That at the ram is folded at a right angle.
     {.quantity = "transmission-angle-max",
      .by = Counterpart::By::greatest,
      .is = {"coupler-transmission-angle.greatest"},
      .least_limit = std::numbers::pi / 2}}};

constexpr auto counterparts = quick_return::ram_counterparts(both_turn, transmission_counterparts);

}  // namespace

AsLinkage drag_link_as_linkage() { return {linkage_sections, sides, {}, counterparts}; }

}  // namespace mechwright
