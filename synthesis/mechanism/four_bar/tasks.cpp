// The tasks of four-bars.

#include "synthesis/mechanism/four_bar/tasks.h"

namespace mechwright {

namespace {

// The problem files, from the folder tasks.
constexpr char four_bar_swing[] = {
#include "task_four-bar-swing.inc"
};
constexpr char four_bar_path[] = {
#include "task_four-bar-path.inc"
};
constexpr char four_bar_poses[] = {
#include "task_four-bar-poses.inc"
};
constexpr char four_bar_function[] = {
#include "task_four-bar-function.inc"
};
constexpr char four_bar_line[] = {
#include "task_four-bar-line.inc"
};
constexpr char four_bar_given[] = {
#include "task_four-bar-given.inc"
};

Task swing() {
    return {"four-bar",
            "swing",
            "a rocker of given swing and time ratio, with the best transmission angle",
            {{"swing", "Swing of the rocker, deg", "60", Answer::number, 1, 175},
             {"time-ratio", "Time of the slow stroke over that of the fast one", "1.1", Answer::number, 1, 5},
             {"ground", "Length of the ground link, mm", "100", Answer::number, 1e-3}},
            four_bar_swing};
}

Task path() {
    return {"four-bar",
            "path",
            "a coupler point through given points",
            {{"points", "Points x y; x y; ... in their order, mm", "0 0; 20 15; 45 22; 70 22; 95 15; 115 0",
              Answer::points},
             {"timing",
              "Met in their order at any crank angle (free), or each by the nearest point of the curve (none)",
              "free",
              Answer::choice,
              0,
              0,
              {"free", "none"}},
             {"closed", "Does the crank go round (true, false)", "true", Answer::choice, 0, 0, {"true", "false"}},
             {"longest", "Longest link, mm", "200", Answer::number, 1e-3}},
            four_bar_path};
}

Task poses() {
    return {"four-bar",
            "poses",
            "a body on the coupler carried through given poses",
            {{"poses",
              "Poses x y angle; x y angle; ... in their order, mm and deg",
              "0 0 0; 40 30 20; 90 40 45; 140 20 70",
              Answer::points,
              0,
              0,
              {},
              3},
             {"length", "Length by which an angle is weighed against a distance, mm", "50", Answer::number, 1e-6},
             {"longest", "Longest link, mm", "300", Answer::number, 1e-3}},
            four_bar_poses};
}

Task function() {
    return {"four-bar",
            "function",
            "a rocker that follows a function of the crank",
            {{"expression", "Function, an expression in x", "x^1.5", Answer::expression},
             {"from", "First x", "1"},
             {"to", "Last x", "4"},
             {"input", "Range of the crank, deg", "90", Answer::number, 1, 360},
             {"output", "Range of the rocker, deg (negative: it turns against the crank)", "90", Answer::number, -360,
              360}},
            four_bar_function};
}

Task line() {
    return {"four-bar",
            "line",
            "a coupler point that runs straight for a while",
            {{"crank", "Length of the crank, mm", "20", Answer::number, 1e-3},
             {"range", "Crank angle of the straight stretch, deg", "120", Answer::number, 1, 300},
             {"length", "Least length of the stretch, mm", "50", Answer::number, 1e-3}},
            four_bar_line};
}

Task given() {
    return {"four-bar",
            "given",
            "all dimensions known: what does it do",
            {{"ground", "Length of the ground link, mm", "100", Answer::number, 1e-9},
             {"crank", "Length of the crank, mm", "30", Answer::number, 1e-9},
             {"coupler", "Length of the coupler, mm", "90", Answer::number, 1e-9},
             {"rocker", "Length of the rocker, mm", "70", Answer::number, 1e-9},
             {"assembly", "Assembly (open, crossed)", "open", Answer::choice, 0, 0, {"open", "crossed"}}},
            four_bar_given};
}

}  // namespace

std::vector<Task> four_bar_tasks() { return {swing(), path(), poses(), function(), line(), given()}; }

}  // namespace mechwright
