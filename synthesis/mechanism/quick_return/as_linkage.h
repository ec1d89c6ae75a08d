#pragma once
/// \file
/// What mechanisms that drive a ram have in common as the linkages that they are: signals of the same names.

#include "synthesis/mechanism/as_linkage.h"

namespace mechwright::quick_return {

inline constexpr Assurance crank_turns{
    .quantity = "full-turn-margin", .unit = Unit::length, .min = 0, .why = "the crank turns fully"};
inline constexpr std::array<Assurance, 1> with_crank_that_turns{crank_turns};

/// All but the transmission angles, then some more. `two_strokes` are of the designs that make two strokes in each
/// turn.
template <std::size_t count>
constexpr std::array<Counterpart, 8 + count> ram_counterparts(std::span<const Assurance> two_strokes,
                                                              const std::array<Counterpart, count>& more) {
    constexpr std::string_view no_working_part =
        "the part of the stroke over which cutting is judged follows from the design, and stretches of signals are of "
        "given crank angles: ask for ram-position.speed over such a stretch";
    std::array<Counterpart, 8 + count> all{
        {{.quantity = "time-ratio", .is = {"ram-position.time-ratio"}, .assured = two_strokes},
         {.quantity = "stroke", .is = {"ram-position.range"}},
         {.quantity = "ram-speed-max", .is = {"ram-speed.greatest"}},
         {.quantity = "ram-acceleration-max", .is = {"ram-acceleration.greatest"}},
         {.quantity = "ram-speed-min-working", .why_not = no_working_part},
         {.quantity = "speed-variation", .why_not = no_working_part},
         same_of_linkages("link-ratio"),
         same_of_linkages("total-length")}};
    for (std::size_t i = 0; i < count; ++i)
        all[8 + i] = more[i];
    return all;
}

inline constexpr std::string_view folded_at_the_ram =
    "the greatest of an angle that is folded at 90 deg is not the greatest of a signal: limit transmission-angle";

/// The angle at the ram, folded at a right angle, is the lesser of those on both sides of the rod.
inline constexpr std::array<Counterpart, 3> transmission_at_ram{
    {{.quantity = "transmission-angle-min",
      .by = Counterpart::By::least,
      .is = {"transmission-angle.least", "transmission-other.least"}},
     {.quantity = "transmission-angle-worst",
      .by = Counterpart::By::least,
      .is = {"transmission-angle.least", "transmission-other.least"}},
     {.quantity = "transmission-angle-max", .why_not = folded_at_the_ram}}};

}  // namespace mechwright::quick_return
