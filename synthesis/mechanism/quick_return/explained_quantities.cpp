// Quantities of mechanisms that drive a ram.

#include "synthesis/mechanism/explanations/explanations.h"

namespace mechwright {

std::vector<Explanation> ram_explanations() {
    constexpr std::string_view per_crank =
        "It is a length per radian: times the angular velocity of the crank, in radians per second, a speed.";
    return {
        {.name = "stroke",
         .what = "How far the ram moves.",
         .over = "the whole motion, between the extreme positions of the ram",
         .usual = "the task says it.",
         .undefined = "for designs that assemble at no crank angle",
         .require = "equal = 200",
         .objective = "maximize",
         .related = "time-ratio, ram-speed-max, speed-variation"},
        {.name = "ram-speed-max",
         .what = "The greatest speed of the ram, of either stroke, for a crank of unit angular velocity.",
         .over = "the whole motion, at every place where the velocity is stationary",
         .formulas = {{"",
                       "greatest |dx/dt|, x the position of the ram, t the crank angle: the driven "
                       "arm's angular velocity times that of a slider-crank whose crank is the arm",
                       "derivative of the position"}},
         .usual = per_crank,
         .undefined = "for designs that assemble at no crank angle",
         .require = "max = 150",
         .objective = "minimize",
         .related = "ram-speed-min-working, speed-variation, ram-acceleration-max"},
        {.name = "ram-speed-min-working",
         .what = "The least speed of the ram while it works, for a crank of unit angular velocity.",
         .over = "the middle [quick-return] working-share (0.6 unless given) of the slow stroke, by the way of the ram",
         .formulas = {{"", "least |dx/dt| there, x the position of the ram, t the crank angle",
                       "derivative of the position, at the ends of the working part and where it is "
                       "stationary"}},
         .usual = per_crank,
         .undefined = "for designs that do not make two strokes in each turn of the crank",
         .require = "min = 40",
         .objective = "maximize",
         .related = "speed-variation, ram-speed-max, working-share"},
        {.name = "speed-variation",
         .what = "How uneven the speed is while the ram works: 0 would be a constant cutting speed.",
         .over = "the middle [quick-return] working-share (0.6 unless given) of the slow stroke, by the way of the ram",
         .formulas = {{"",
                       "(v_max - v_min) / v_mean there, v_mean = working-share stroke / (crank angle "
                       "that the working part takes)",
                       "definition; the mean is one in time"}},
         .usual = "0.16 is the best that slotted drives reach at time ratio 2 over 60 percent of the stroke, a drag "
                  "link reaches half of that (problems/quick-return/uniform-speed-*.toml).",
         .undefined = "for designs that do not make two strokes in each turn of the crank",
         .require = "max = 0.2",
         .objective = "minimize",
         .related = "ram-speed-min-working, ram-speed-max, working-share"},
        {.name = "ram-acceleration-max",
         .what = "The greatest acceleration of the ram for a crank of unit angular velocity: times the ram's mass, and "
                 "the square of the angular velocity, the force of inertia.",
         .over = "the whole motion, at every place where the acceleration is stationary",
         .formulas = {{"", "greatest |d2x/dt2|, x the position of the ram, t the crank angle",
                       "second derivative of the position; Theory of Machines, section 4-4-2 for the "
                       "slider-crank"}},
         .usual = "stroke / 2 would be that of a harmonic motion; slider-cranks of short rod come to twice as much. It "
                  "is a length per radian squared.",
         .undefined = "for designs that assemble at no crank angle",
         .require = "max = 300",
         .objective = "minimize",
         .related = "ram-speed-max, stroke, time-ratio"},
    };
}

}  // namespace mechwright
