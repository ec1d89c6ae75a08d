// The tasks of four-bars.

#include "synthesis/command_line/new/task.h"

namespace mechwright {

namespace {

Task swing() {
    return {"four-bar",
            "swing",
            "a rocker of given swing and time ratio, with the best transmission angle",
            {{"swing", "Swing of the rocker, deg", "60", Answer::number, 1, 175},
             {"time-ratio", "Time of the slow stroke over that of the fast one", "1.1", Answer::number, 1, 5},
             {"ground", "Length of the ground link, mm", "100", Answer::number, 1e-3}},
            R"toml(# The crank-rocker of given swing and time ratio with the best transmission angle.
schema    = 1                             # of the file format
title     = "Crank-rocker with @swing@ deg of swing and time ratio @time-ratio@"
mechanism = "four-bar"

[dimensions]                              # mm: a number is given, a range is to be designed
ground  = @ground@
crank   = { min = @ground*0.01@, max = @ground@ }
coupler = { min = @ground*0.05@, max = @ground*5@ }
rocker  = { min = @ground*0.05@, max = @ground*5@ }

[[require]]
quantity = "swing"                        # of the rocker, deg
equal    = @swing@                        # or min, max, or both

[[require]]
quantity = "time-ratio"                   # slow stroke over fast stroke; 1: both take as long
equal    = @time-ratio@

[objective]                               # or minimize = "total-length" with a [[require]] of the angle
maximize = "transmission-angle-worst"     # 90 deg is ideal, at least 40 usual
)toml"};
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
            R"toml(# A four-bar whose coupler point passes through given points.
schema    = 1                             # of the file format
title     = "Coupler point through points"
mechanism = "four-bar"

[dimensions]                              # mm and deg: ranges are to be designed, numbers given
ground       = { min = @longest*0.02@, max = @longest@ }
crank        = { min = @longest*0.02@, max = @longest@ }
coupler      = { min = @longest*0.02@, max = @longest@ }
rocker       = { min = @longest*0.02@, max = @longest@ }
point-along  = { min = -@longest@, max = @longest@ }   # coupler point, from crank pin towards rocker pin
point-across = { min = -@longest@, max = @longest@ }   # and to the left of that line
origin-x     = { min = -@longest*2@, max = @longest*2@ }   # crank pivot
origin-y     = { min = -@longest*2@, max = @longest*2@ }
tilt         = { min = 0, max = 360 }     # of the ground link
assembly     = "either"                   # or "open", "crossed"

[path]
points = @points@  # or points_file = "points.csv"
timing = "@timing@"                       # "free", "none", or "prescribed" with crank_angles = [...]
closed = @closed@                         # true: the crank turns fully

[[require]]
quantity = "transmission-angle-worst"     # deg; leave this out for the best path of all
min      = 25

[objective]
minimize = "path-rms"                     # mm; or path-max, the greatest distance
)toml"};
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
            R"toml(# A four-bar whose coupler carries a body through given poses.
schema    = 1                             # of the file format
title     = "Body through poses"
mechanism = "four-bar"

[dimensions]                              # mm and deg: ranges are to be designed, numbers given
ground       = { min = @longest*0.02@, max = @longest@ }
crank        = { min = @longest*0.02@, max = @longest@ }
coupler      = { min = @longest*0.02@, max = @longest@ }
rocker       = { min = @longest*0.02@, max = @longest@ }
point-along  = { min = -@longest@, max = @longest@ }   # the body's point, from crank pin towards rocker pin
point-across = { min = -@longest@, max = @longest@ }   # and to the left of that line
origin-x     = { min = -@longest*2@, max = @longest*2@ }   # crank pivot
origin-y     = { min = -@longest*2@, max = @longest*2@ }
tilt         = { min = 0, max = 360 }     # of the ground link
body-angle   = { min = 0, max = 360 }     # of the body to the line of the coupler's pins
assembly     = "either"                   # or "open", "crossed"

[poses]
poses  = @poses@  # [x, y, angle]; of [x, y] any angle will do
length = @length@                         # 10 deg off count as much as 0.174 of this

[objective]
minimize = "pose-rms"                     # mm; or pose-max
)toml"};
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
            R"toml(# A four-bar whose rocker follows a function of the crank.
schema    = 1                             # of the file format
title     = "Generator of @expression@"
mechanism = "four-bar"

[dimensions]                              # only the proportions matter: the ground link is given
ground   = 100
crank    = { min = 5, max = 2000 }
coupler  = { min = 5, max = 2000 }
rocker   = { min = 5, max = 2000 }
assembly = "either"                       # or "open", "crossed"

[function]
expression = "@expression@"               # or samples = [[x, y], ...]
x      = [@from@, @to@]
input  = { start = { min = 0, max = 360 }, range = @input@ }   # crank angle, deg; start and range: given or free
output = { start = { min = 0, max = 360 }, range = @output@ }  # rocker angle, deg

[objective]
minimize = "function-max"                 # greatest error, deg; or function-rms
)toml"};
}

Task line() {
    return {"four-bar",
            "line",
            "a coupler point that runs straight for a while",
            {{"crank", "Length of the crank, mm", "20", Answer::number, 1e-3},
             {"range", "Crank angle of the straight stretch, deg", "120", Answer::number, 1, 300},
             {"length", "Least length of the stretch, mm", "50", Answer::number, 1e-3}},
            R"toml(# A four-bar whose coupler point runs straight over a stretch of its path.
schema    = 1                             # of the file format
title     = "Straight over @range@ deg of the crank"
mechanism = "four-bar"

[dimensions]                              # mm: a number is given, a range is to be designed
ground      = { min = @crank@, max = @crank*10@ }
crank       = @crank@
coupler     = { min = @crank@, max = @crank*10@ }
rocker      = { of = "coupler" }          # as long as the coupler:
point-along = { of = "coupler", times = 2 }   # a symmetric path (lambda linkage)

[line]
start = { min = 0, max = 360 }            # crank angle, deg: given or free
range = @range@

[[require]]
quantity = "line-length"                  # mm
min      = @length@

[objective]
minimize = "line-deviation"               # mm: half the width of the band that holds the stretch
)toml"};
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
            R"toml(# A four-bar to be analysed: mechwright analyse FILE, with --csv for its motion.
schema    = 1                             # of the file format
title     = "Four-bar"
mechanism = "four-bar"

[dimensions]                              # mm
ground   = @ground@
crank    = @crank@
coupler  = @coupler@
rocker   = @rocker@
assembly = "@assembly@"                   # open: rocker pin to the left of the line from crank pin to rocker pivot
)toml"};
}

}  // namespace

std::vector<Task> four_bar_tasks() { return {swing(), path(), poses(), function(), line(), given()}; }

}  // namespace mechwright
