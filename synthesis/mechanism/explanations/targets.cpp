// Quantities of paths, poses, functions, lines, arcs and instants.

#include "synthesis/mechanism/explanations/explanations.h"

namespace mechwright {

namespace {

constexpr std::string_view crank_angles =
    "all target points, each at the crank angle that [path] timing prescribes, or at the best one";
constexpr std::string_view whole_range = "the input range of the crank, continuously; with samples at the samples";

std::vector<Explanation> of_paths_and_poses() {
    return {
        {.name = "path-sse",
         .what =
             "How far a coupler point misses its target points, as the literature on path synthesis gives it: a sum "
             "of squares.",
         .over = crank_angles,
         .formulas = {{"",
                       "sum of w d^2, d the distance of a target point from the guided point, w its "
                       "weight",
                       "definition"}},
         .usual = "compare it only for the same points: it grows with their number and with the square of their "
                  "spread. path-rms is easier to read.",
         .undefined = "in problems without [path]",
         .require = "max = 0.01",
         .objective = "minimize",
         .related = "path-rms, path-max"},
        {.name = "path-rms",
         .what = "How far a coupler point misses its target points, typically.",
         .over = crank_angles,
         .formulas = {{"",
                       "sqrt(sum of w d^2 / sum of w), d the distance of a target point from the guided "
                       "point, w its weight",
                       "definition"}},
         .usual = "one percent of the size of the curve is good for a dozen points or more; five points can be met "
                  "exactly in many ways, nine in finitely many.",
         .undefined = "in problems without [path]",
         .require = "max = 0.5",
         .objective = "minimize",
         .related = "path-max, path-sse, pose-rms"},
        {.name = "path-max",
         .what = "How far a coupler point misses the target point that it misses most.",
         .over = crank_angles,
         .formulas = {{"",
                       "greatest d, the distance of a target point from the guided point; weights do "
                       "not count",
                       "definition"}},
         .usual = "the tolerance of the task.",
         .undefined = "in problems without [path]",
         .require = "max = 0.1",
         .objective = "minimize",
         .related = "path-rms, path-sse"},
        {.name = "pose-rms",
         .what = "How far a guided body misses its target poses, typically, turning weighed against distance.",
         .over = "all target poses, in their order, at prescribed crank angles or the best ones",
         .formulas = {{"",
                       "sqrt(sum of w d^2 / sum of w), d^2 = dx^2 + dy^2 + (2 length sin(turn / 2))^2, "
                       "length that of [poses], turn the angle between body and target, w the weight",
                       "distance of a point of the body at that length; definition"}},
         .usual = "0 can be reached for up to five poses (Burmester) if the linkage may be anything; choose length as "
                  "about half the size of the body.",
         .undefined = "in problems without [poses]",
         .require = "max = 0.5",
         .objective = "minimize",
         .related = "pose-max, path-rms, body-angle"},
        {.name = "pose-max",
         .what = "How far a guided body misses the target pose that it misses most.",
         .over = "all target poses, in their order, at prescribed crank angles or the best ones",
         .formulas = {{"",
                       "greatest d, d^2 = dx^2 + dy^2 + (2 length sin(turn / 2))^2, length that of "
                       "[poses], turn the angle between body and target",
                       "distance of a point of the body at that length; definition"}},
         .usual = "the tolerance of the task.",
         .undefined = "in problems without [poses]",
         .require = "max = 1",
         .objective = "minimize",
         .related = "pose-rms, body-angle"},
    };
}

std::vector<Explanation> of_functions() {
    return {
        {.name = "function-max",
         .what = "The greatest structural error of a function generator. At the least possible it is reached with "
                 "alternating signs, once more than there are free dimensions.",
         .over = whole_range,
         .formulas = {{"",
                       "greatest |s - s*|, s the position of the ram, s* = output-start + output-range "
                       "(f(x) - f(x1)) / (f(x2) - f(x1)), x going evenly from x1 to x2 with the crank",
                       "definition; extremes where the error is stationary, and at the ends"}},
         .usual =
             "a tenth of a degree to one degree for three free links over 60 to 90 deg; each free start of a scale "
             "gains about a digit.",
         .undefined = "in problems without [function], and where the linkage does not close over the whole range",
         .require = "max = 0.5",
         .objective = "minimize",
         .related = "function-rms, transmission-angle-worst"},
        {.name = "function-rms",
         .what = "The typical structural error of a function generator.",
         .over = whole_range,
         .formulas = {{"",
                       "square root of the mean of e^2 over the range, e the error that function-max "
                       "takes the greatest of; an integral, or the mean over the samples",
                       "definition"}},
         .usual = "about 0.7 of the greatest error at its optimum.",
         .undefined = "in problems without [function], and where the linkage does not close over the whole range",
         .require = "max = 0.3",
         .objective = "minimize",
         .related = "function-max, transmission-angle-worst"},
    };
}

std::vector<Explanation> of_shapes() {
    constexpr std::string_view range = "the stretch that [line] or [arc] gives by start and range, continuously";
    return {
        {.name = "line-deviation",
         .what = "How straight a stretch of a guided point's path is: half the width of the narrowest band that holds "
                 "it, if the line is free.",
         .over = range,
         .formulas = {{"",
                       "greatest |y cos a - x sin a - line-offset|, (x, y) the guided point, a = "
                       "line-angle",
                       "distance of a point from a line"}},
         .usual = "1e-4 of the crank over 120 deg, 2e-3 over 180 deg, for a lambda linkage "
                  "(problems/line/lambda-120.toml).",
         .undefined = "in problems without [line], and where the mechanism does not close over the whole stretch",
         .require = "max = 0.01",
         .objective = "minimize",
         .related = "line-length, arc-deviation"},
        {.name = "line-length",
         .what = "How long the straight stretch is.",
         .over = range,
         .formulas = {{"",
                       "|(x2 - x1) cos a + (y2 - y1) sin a|, from the first point of the stretch to the "
                       "last, a = line-angle",
                       "way along a line"}},
         .usual = "the task says it; about four cranks for a lambda linkage over half a turn.",
         .undefined = "in problems without [line], and where the mechanism does not close over the whole stretch",
         .require = "min = 100",
         .objective = "maximize",
         .related = "line-deviation"},
        {.name = "arc-deviation",
         .what = "How close a stretch of a guided point's path comes to an arc. A link of that radius, pinned to the "
                 "point, holds its other end still at the arc's centre, to this distance: a dwell.",
         .over = range,
         .formulas = {{"", "greatest |hypot(x - arc-x, y - arc-y) - arc-radius|, (x, y) the guided point",
                       "distance of a point from a circle"}},
         .usual = "a thousandth of the radius over 90 deg of the crank.",
         .undefined = "in problems without [arc], and where the mechanism does not close over the whole stretch",
         .require = "max = 0.05",
         .objective = "minimize",
         .related = "arc-angle, line-deviation"},
        {.name = "arc-angle",
         .what = "How much of the circle the stretch covers. Require some, or the point may hardly move.",
         .over = range,
         .formulas = {{"",
                       "angle between the first and the last point of the stretch, seen from (arc-x, "
                       "arc-y), 0 to 180 deg",
                       "angle between two directions"}},
         .usual = "20 deg or more for a dwell.",
         .undefined = "in problems without [arc], and where the mechanism does not close over the whole stretch",
         .require = "min = 20",
         .objective = "maximize",
         .related = "arc-deviation"},
    };
}

std::vector<Explanation> of_instants() {
    constexpr std::string_view at = "one position: the crank angle crank-start";
    constexpr std::string_view usual =
        "the task says it, in [instant] velocity and acceleration, in any unit of time; [[require]] can limit it too.";
    constexpr std::string_view undefined = "in problems without [instant]; beyond all bounds at a toggle";
    return {
        {.name = "instant-coupler-velocity",
         .what = "The angular velocity of the coupler at one crank angle, over that of the crank.",
         .over = at,
         .formulas = {{"",
                       "crank sin(t - r) / (coupler sin(r - c)), t, c, r the angles of crank, coupler "
                       "and rocker from the ground link",
                       "Theory of Machines, equation (4-39)"}},
         .usual = usual,
         .undefined = undefined,
         .require = "equal = 0.2",
         .objective = "",
         .related = "instant-rocker-velocity, instant-coupler-acceleration, crank-start"},
        {.name = "instant-rocker-velocity",
         .what = "The angular velocity of the rocker at one crank angle, over that of the crank.",
         .over = at,
         .formulas = {{"",
                       "crank sin(t - c) / (rocker sin(r - c)), t, c, r the angles of crank, coupler "
                       "and rocker from the ground link",
                       "Theory of Machines, equation (4-40)"}},
         .usual = usual,
         .undefined = undefined,
         .require = "equal = 0.5",
         .objective = "",
         .related = "instant-coupler-velocity, instant-rocker-acceleration, velocity-ratio-max, crank-start"},
        {.name = "instant-coupler-acceleration",
         .what = "The angular acceleration of the coupler at one crank angle, for a crank that turns evenly with unit "
                 "angular velocity.",
         .over = at,
         .formulas = {{"",
                       "(crank cos(t - r) + coupler u^2 cos(r - c) - rocker v^2) / (coupler sin(r - "
                       "c)), u and v the velocities of coupler and rocker, t, c, r the angles of crank, "
                       "coupler and rocker",
                       "Theory of Machines, equation (4-45)"}},
         .usual = usual,
         .undefined = undefined,
         .require = "equal = 0.3",
         .objective = "",
         .related = "instant-rocker-acceleration, instant-coupler-velocity, crank-start"},
        {.name = "instant-rocker-acceleration",
         .what = "The angular acceleration of the rocker at one crank angle, for a crank that turns evenly with unit "
                 "angular velocity.",
         .over = at,
         .formulas = {{"",
                       "(crank cos(t - c) + coupler u^2 - rocker v^2 cos(r - c)) / (rocker sin(r - c)), "
                       "u and v the velocities of coupler and rocker, t, c, r the angles of crank, "
                       "coupler and rocker",
                       "Theory of Machines, equation (4-44)"}},
         .usual = usual,
         .undefined = undefined,
         .require = "equal = 0.1",
         .objective = "",
         .related = "instant-coupler-acceleration, instant-rocker-velocity, crank-start"},
    };
}

}  // namespace

std::vector<Explanation> target_explanations() {
    std::vector<Explanation> all;
    for (const auto& part : {of_paths_and_poses(), of_functions(), of_shapes(), of_instants()})
        all.insert(all.end(), part.begin(), part.end());
    return all;
}

}  // namespace mechwright
