// Quantities of linkages of every kind.

#include "synthesis/mechanism/explanations/explanations.h"

namespace mechwright {

std::vector<Explanation> linkage_explanations() {
    return {
        {.name = "time-ratio",
         .what = "How much longer the slow stroke takes than the fast one while the crank turns evenly: 1 is a drive "
                 "that goes back as it came, 2 one that returns in half the time. Which stroke is the slow one depends "
                 "on the direction in which the crank turns, so that the ratio never is below 1.",
         .over = "one full turn of the crank",
         .usual = "1 where both strokes work. Up to 1.3 or so a four-bar keeps good transmission angles at a useful "
                  "swing; shapers work with 1.5 to 2; more makes the return jerky.",
         .undefined = "for designs whose crank does not turn fully, or whose output does not make two strokes a turn "
                      "(double cranks)",
         .require = "equal = 1.2",
         .objective = "maximize",
         .related = "swing, stroke, transmission-angle-worst, ram-speed-max"},
        {.name = "swing",
         .what = "How far the rocker turns to and fro.",
         .over = "one full turn of the crank, between the two positions with crank and coupler in line",
         .formulas = {{"",
                       "acos((ground^2 + rocker^2 - (coupler + crank)^2) / (2 ground rocker)) - "
                       "acos((ground^2 + rocker^2 - (coupler - crank)^2) / (2 ground rocker))",
                       "law of cosines in the triangles of the limit positions"}},
         .usual = "30 to 90 deg; the best possible transmission angle falls as the swing grows "
                  "(problems/studies/transmission-chart.toml draws how).",
         .undefined = "for designs that are no crank-rockers",
         .require = "equal = 60",
         .objective = "maximize",
         .related = "time-ratio, transmission-angle-worst"},
        {.name = "transmission-angle-min",
         .what = "The least angle at which a link pushes the driven one. At 90 deg all of the force turns it, at 0 "
                 "none does: the linkage jams.",
         .over = "the whole motion: the full turn, or the crank's range; extremes are found on the continuous motion",
         .usual = "at least 40 deg (Theory of Machines, section 2.3); 45 deg or more where forces are large or the "
                  "machine is fast. With transmission-angle-max it says the same as transmission-angle-worst.",
         .undefined = "for designs that assemble at no crank angle",
         .require = "min = 40",
         .objective = "maximize",
         .related = "transmission-angle-max, transmission-angle-worst, grashof-margin"},
        {.name = "transmission-angle-max",
         .what = "The greatest angle at which a link pushes the driven one. Beyond 90 deg what counts is how far it "
                 "stays below 180 deg.",
         .over = "the whole motion: the full turn, or the crank's range",
         .formulas = {{"",
                       "90 deg where the rod comes to lie along the slide in the motion; else 90 deg "
                       "less its least slope",
                       "the angle at the ram is 90 deg less the slope of the rod"}},
         .usual = "at most 140 deg (Theory of Machines, section 2.3); 135 deg where forces are large.",
         .undefined = "for designs that assemble at no crank angle",
         .require = "max = 140",
         .objective = "minimize",
         .related = "transmission-angle-min, transmission-angle-worst"},
        {.name = "transmission-angle-worst",
         .what = "How badly the driven link is pushed at the worst position: the transmission angle mu, or 180 deg - "
                 "mu where that is less. The one number to keep large.",
         .over = "the whole motion: the full turn, or the crank's range; with [function], [line] or [arc] their range",
         .usual = "at least 40 deg (Theory of Machines, section 2.3); 45 deg or more where forces are large or the "
                  "machine is fast. Short light swings get by with 30 deg.",
         .undefined = "for designs that assemble at no crank angle",
         .require = "min = 40",
         .objective = "maximize",
         .related = "transmission-angle-min, transmission-angle-max, time-ratio, swing"},
        {.name = "velocity-ratio-min",
         .what = "The slowest, or most backward, that the rocker turns for a crank of unit angular velocity. Negative "
                 "where it turns against the crank.",
         .over = "the whole motion, at every place where the ratio is stationary",
         .formulas = {{"",
                       "least of crank sin(t - c) / (rocker sin(r - c)), t, c, r the angles of crank, "
                       "coupler and rocker from the ground link",
                       "Theory of Machines, equations (4-39) and (4-40)"}},
         .usual = "depends on the task: a double crank has positive ratios only, 1 on average over a turn.",
         .undefined = "for designs that assemble at no crank angle; beyond all bounds at a toggle",
         .require = "min = 0.5",
         .objective = "maximize",
         .related = "velocity-ratio-max, instant-rocker-velocity"},
        {.name = "velocity-ratio-max",
         .what = "The fastest that the rocker turns, with the crank, for a crank of unit angular velocity.",
         .over = "the whole motion, at every place where the ratio is stationary",
         .formulas = {{"",
                       "greatest of crank sin(t - c) / (rocker sin(r - c)), t, c, r the angles of "
                       "crank, coupler and rocker from the ground link",
                       "Theory of Machines, equations (4-39) and (4-40)"}},
         .usual = "depends on the task; drag links for quick returns work with 2 to 3.",
         .undefined = "for designs that assemble at no crank angle; beyond all bounds at a toggle",
         .require = "equal = 2.2",
         .objective = "minimize",
         .related = "velocity-ratio-min, transmission-angle-worst"},
        {.name = "link-ratio",
         .what = "How uneven the links are. Long links beside short ones are hard to build, and magnify errors of the "
                 "short ones.",
         .over = "none: it depends on the lengths alone",
         .usual = "up to 4 or 5 is easy to build. As an upper limit it keeps an optimiser from very long links.",
         .undefined = "",
         .require = "max = 4",
         .objective = "minimize",
         .related = "total-length, transmission-angle-worst"},
        {.name = "total-length",
         .what = "The size of a linkage in one number.",
         .over = "none: it depends on the lengths alone",
         .usual = "as small as the other requirements let it be.",
         .undefined = "",
         .require = "max = 500",
         .objective = "minimize",
         .related = "link-ratio"},
        {.name = "grashof-margin",
         .what = "How far a four-bar is from the limit at which no link turns fully. At 0 all pins can come to lie in "
                 "one line, where the linkage may leave its assembly; below 0 no link turns fully.",
         .over = "none: it depends on the lengths alone",
         .formulas = {{"", "p + q - s - l: the two middle links less the shortest and the longest",
                       "Grashof's rule, Theory of Machines, section 2.2"}},
         .usual = "well above 0, some hundredths of the longest link, where the crank is to turn fully: bearings have "
                  "play and links tolerances.",
         .undefined = "",
         .require = "min = 0.05",
         .objective = "maximize",
         .related = "transmission-angle-worst, link-ratio"},
    };
}

}  // namespace mechwright
