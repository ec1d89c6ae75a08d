// The tasks of mechanisms that drive a ram.

#include "synthesis/command_line/new/task.h"

namespace mechwright {

namespace {

Question stroke() { return {"stroke", "Stroke of the ram, mm", "200", Answer::number, 1e-3}; }

Question time_ratio(std::string_view preset, double least) {
    return {"time-ratio", "Time of the slow stroke over that of the fast one", preset, Answer::number, least, 5};
}

Question length_of(std::string_view name, std::string_view text, std::string_view preset) {
    return {name, text, preset, Answer::number, 1e-9};
}

Task slider_crank() {
    return {"slider-crank",
            "stroke",
            "a ram of given stroke and time ratio, with the best transmission angle",
            {stroke(), time_ratio("1.2", 1)},
            R"toml(# The slider-crank of given stroke and time ratio with the best transmission angle.
schema    = 1                             # of the file format
title     = "Slider-crank with a stroke of @stroke@ mm and time ratio @time-ratio@"
mechanism = "slider-crank"

[dimensions]                              # mm: a number is given, a range is to be designed
crank  = { min = @stroke*0.05@, max = @stroke@ }
rod    = { min = @stroke*0.1@, max = @stroke*4@ }
offset = { min = 0, max = @stroke*2@ }    # of the slide line from the crank pivot; makes the time ratio

[[require]]
quantity = "stroke"                       # mm
equal    = @stroke@

[[require]]
quantity = "time-ratio"                   # slow stroke over fast stroke; 1: both take as long
equal    = @time-ratio@

[objective]                               # or minimize = "ram-acceleration-max"
maximize = "transmission-angle-worst"     # 90 deg is ideal, at least 40 usual
)toml"};
}

Task crank_shaper() {
    return {"crank-shaper",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            R"toml(# The crank shaper of given stroke and time ratio with the most uniform cutting speed.
schema    = 1                             # of the file format
title     = "Crank shaper with a stroke of @stroke@ mm and time ratio @time-ratio@"
mechanism = "crank-shaper"

[dimensions]                              # mm: a number is given, a range is to be designed
centre-distance = @stroke*1.5@            # crank pivot to lever pivot; only crank / centre-distance matters to the ram
crank           = { min = @stroke*0.01@, max = @stroke*1.49@ }
lever           = { min = @stroke*0.3@, max = @stroke*20@ }
rod             = { min = @stroke*0.5@, max = @stroke*3@ }
ram-distance    = { min = @stroke*0.3@, max = @stroke*20@ }   # lever pivot to ram line

[quick-return]
working-share = 0.6                       # the middle part of the slow stroke, over which the speed is judged

[[require]]
quantity = "stroke"                       # mm
equal    = @stroke@

[[require]]
quantity = "time-ratio"                   # slow stroke over fast stroke
equal    = @time-ratio@

[[require]]
quantity = "transmission-angle-worst"     # between lever and ram, deg
min      = 45

[objective]                               # or maximize = "transmission-angle-worst"
minimize = "speed-variation"              # (greatest - least) / mean speed
)toml"};
}

Task whitworth() {
    return {"whitworth",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            R"toml(# The Whitworth drive of given stroke and time ratio with the most uniform cutting speed.
schema    = 1                             # of the file format
title     = "Whitworth drive with a stroke of @stroke@ mm and time ratio @time-ratio@"
mechanism = "whitworth"

[dimensions]                              # mm: a number is given, a range is to be designed
centre-distance = @stroke*0.5@            # crank pivot to driven pivot
crank           = { min = @stroke*0.51@, max = @stroke*50@ }   # longer than the centre distance
arm             = { min = @stroke*0.25@, max = @stroke*1.5@ }  # the stroke is twice as long
rod             = { min = @stroke*0.5@, max = @stroke*3@ }
slide-angle     = { min = 10, max = 170 } # of the slide line to the line of centres, deg; 90: the greatest ratio

[quick-return]
working-share = 0.6                       # the middle part of the slow stroke, over which the speed is judged

[[require]]
quantity = "stroke"                       # mm
equal    = @stroke@

[[require]]
quantity = "time-ratio"                   # slow stroke over fast stroke
equal    = @time-ratio@

[[require]]
quantity = "transmission-angle-worst"     # between arm and ram, deg
min      = 45

[objective]                               # or maximize = "transmission-angle-worst"
minimize = "speed-variation"              # (greatest - least) / mean speed
)toml"};
}

Task drag_link() {
    return {"drag-link",
            "stroke",
            "a ram of given stroke and time ratio, as uniform as possible while it works",
            {stroke(), time_ratio("2", 1.01)},
            R"toml(# The drag link of given stroke and time ratio with the most uniform cutting speed.
schema    = 1                             # of the file format
title     = "Drag link with a stroke of @stroke@ mm and time ratio @time-ratio@"
mechanism = "drag-link"

[dimensions]                              # mm: a number is given, a range is to be designed
ground       = @stroke*0.5@               # the shortest link, so that crank and follower turn fully
crank        = { min = @stroke*0.52@, max = @stroke*2@ }
coupler      = { min = @stroke*0.52@, max = @stroke*2@ }
follower     = { min = @stroke*0.52@, max = @stroke*2@ }
arm          = { min = @stroke*0.25@, max = @stroke*1.5@ }   # on the follower
arm-angle    = 0                          # from follower to arm, deg: like a slide line at the opposite angle
rod          = { min = @stroke*0.5@, max = @stroke*3@ }
slide-angle  = { min = -180, max = 180 }  # of the slide line to the ground link, deg
slide-offset = 0                          # of the slide line from the follower pivot

[quick-return]
working-share = 0.6                       # the middle part of the slow stroke, over which the speed is judged

[[require]]
quantity = "stroke"                       # mm
equal    = @stroke@

[[require]]
quantity = "time-ratio"                   # slow stroke over fast stroke
equal    = @time-ratio@

[[require]]
quantity = "transmission-angle-worst"     # between coupler and follower, and at the ram, deg
min      = 45

[objective]                               # or minimize = "total-length"
minimize = "speed-variation"              # (greatest - least) / mean speed
)toml"};
}

Task given_slider_crank() {
    return {"slider-crank",
            "given",
            "all dimensions known: what does it do",
            {length_of("crank", "Length of the crank, mm", "50"),
             length_of("rod", "Length of the rod, mm", "150"),
             {"offset", "Distance of the slide line from the crank pivot, mm", "20"}},
            R"toml(# A slider-crank to be analysed: mechwright analyse FILE, with --csv for its motion.
schema    = 1                             # of the file format
title     = "Slider-crank"
mechanism = "slider-crank"

[dimensions]                              # mm
crank  = @crank@
rod    = @rod@
offset = @offset@                         # > 0: the slide line passes the crank pivot on its left
)toml"};
}

Task given_crank_shaper() {
    return {"crank-shaper",
            "given",
            "all dimensions known: what does it do",
            {length_of("centre-distance", "Crank pivot to lever pivot, mm", "300"),
             length_of("crank", "Length of the crank, shorter than that, mm", "150"),
             length_of("lever", "Lever pivot to rod pin, mm", "200"), length_of("rod", "Length of the rod, mm", "300"),
             length_of("ram-distance", "Lever pivot to ram line, mm", "187")},
            R"toml(# A crank shaper to be analysed: mechwright analyse FILE, with --csv for its motion.
schema    = 1                             # of the file format
title     = "Crank shaper"
mechanism = "crank-shaper"

[dimensions]                              # mm
centre-distance = @centre-distance@
crank           = @crank@
lever           = @lever@
rod             = @rod@
ram-distance    = @ram-distance@          # the ram line is square to the line of centres
)toml"};
}

Task given_whitworth() {
    return {"whitworth",
            "given",
            "all dimensions known: what does it do",
            {length_of("centre-distance", "Crank pivot to driven pivot, mm", "90"),
             length_of("crank", "Length of the crank, longer than that, mm", "180"),
             length_of("arm", "Driven pivot to rod pin, mm", "96"),
             length_of("rod", "Length of the rod, mm", "490"),
             {"slide-angle", "From the line of centres to the slide line, deg", "90"}},
            R"toml(# A Whitworth drive to be analysed: mechwright analyse FILE, with --csv for its motion.
schema    = 1                             # of the file format
title     = "Whitworth drive"
mechanism = "whitworth"

[dimensions]                              # mm
centre-distance = @centre-distance@
crank           = @crank@
arm             = @arm@                   # opposite the slot
rod             = @rod@
slide-angle     = @slide-angle@           # deg; the slide line passes through the driven pivot
)toml"};
}

Task given_drag_link() {
    return {"drag-link",
            "given",
            "all dimensions known: what does it do",
            {length_of("ground", "Length of the ground link, the shortest, mm", "60"),
             length_of("crank", "Length of the crank, mm", "120"),
             length_of("coupler", "Length of the coupler, mm", "100"),
             length_of("follower", "Length of the follower, mm", "110"),
             length_of("arm", "Follower pivot to rod pin, mm", "100"),
             length_of("rod", "Length of the rod, mm", "300"),
             {"slide-angle", "From the ground link to the slide line, deg", "0"}},
            R"toml(# A drag link to be analysed: mechwright analyse FILE, with --csv for its motion.
schema    = 1                             # of the file format
title     = "Drag link"
mechanism = "drag-link"

[dimensions]                              # mm
ground       = @ground@
crank        = @crank@
coupler      = @coupler@
follower     = @follower@
arm          = @arm@
arm-angle    = 0                          # from follower to arm, deg
rod          = @rod@
slide-angle  = @slide-angle@              # deg
slide-offset = 0                          # of the slide line from the follower pivot
)toml"};
}

}  // namespace

std::vector<Task> quick_return_tasks() {
    return {slider_crank(), given_slider_crank(), crank_shaper(), given_crank_shaper(),
            whitworth(),    given_whitworth(),    drag_link(),    given_drag_link()};
}

}  // namespace mechwright
