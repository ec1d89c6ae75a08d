#include "synthesis/mechanism/four_bar/as_linkage.h"

#include <numbers>

namespace mechwright {

namespace {

constexpr char linkage_sections[] = {
#include "as_linkage_four_bar.inc"
};

constexpr std::array<std::string_view, 2> sides{"left", "right"};

constexpr std::array<AsLinkage::Target, 5> targets{{{"path", "point = \"P\"\n"},
                                                    {"poses", "point = \"P\"\nlink = \"coupler\"\n"},
                                                    {"line", "point = \"P\"\n"},
                                                    {"function", "signal = \"rocker-angle\"\n"},
                                                    {"arc", "point = \"P\"\n"}}};

constexpr std::array<Assurance, 2> crank_rocker{
    {{.quantity = "full-turn-margin", .unit = Unit::length, .min = 0, .why = "the crank turns fully"},
     {.quantity = "rocker-angle.range", .unit = Unit::angle, .max = std::numbers::pi, .why = "the rocker swings"}}};

constexpr std::array<Counterpart, 10> counterparts{
    {{.quantity = "time-ratio", .is = {"rocker-angle.time-ratio"}, .assured = crank_rocker},
     {.quantity = "swing", .is = {"rocker-angle.range"}, .assured = crank_rocker},
     {.quantity = "transmission-angle-min", .is = {"transmission-angle.least"}},
     {.quantity = "transmission-angle-max", .is = {"transmission-angle.greatest"}},
     same_of_linkages("transmission-angle-worst"),
     {.quantity = "velocity-ratio-min", .is = {"rocker-angle.speed.least"}},
     {.quantity = "velocity-ratio-max", .is = {"rocker-angle.speed.greatest"}},
     same_of_linkages("link-ratio"),
     same_of_linkages("total-length"),
     // Of crank-rockers and double cranks both are the least of the same three sums of lengths.
     {.quantity = "grashof-margin", .is = {"full-turn-margin"}, .of_full_turn = true}}};

}  // namespace

AsLinkage four_bar_as_linkage() { return {linkage_sections, sides, targets, counterparts}; }

}  // namespace mechwright
