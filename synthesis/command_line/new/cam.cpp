// The tasks of cams: one for each kind of follower.

#include "synthesis/command_line/new/task.h"

namespace mechwright {

namespace {

Question segments(std::string_view preset) {
    return {"segments", "Segments of the motion, kind and angle in deg", preset, Answer::segments};
}

Question lift(std::string_view text, std::string_view preset, double most) {
    return {"lift", text, preset, Answer::number, 1e-6, most};
}

Question law() {
    return {"law",
            "Law of motion",
            "cycloidal",
            Answer::choice,
            0,
            0,
            {"cycloidal", "3-4-5", "4-5-6-7", "modified-sine", "modified-trapezoid", "harmonic", "parabolic",
             "double-harmonic", "modified-constant-velocity", "constant-velocity", "kloomok-muffley"}};
}

Question pressure(std::string_view preset) {
    return {"pressure-angle", "Greatest pressure angle, deg", preset, Answer::number, 1, 89};
}

Question roller() { return {"roller-radius", "Radius of the roller, mm", "5", Answer::number, 1e-6}; }

Question curvature() {
    return {"profile-radius", "Least radius of curvature of the cam, mm", "5", Answer::number, 1e-6};
}

Task roller_follower() {
    return {"cam",
            "roller",
            "the smallest cam for a roller on a straight guide",
            {segments("rise 120, dwell 60, return 120, dwell 60"), lift("Lift, mm", "20", 1e6), law(), roller(),
             pressure("30")},
            R"toml(# The smallest cam for a roller on a straight guide, within a limit on the pressure angle.
schema    = 1                             # of the file format
title     = "Roller follower, lift @lift@ mm"
mechanism = "cam"

[cam]
follower = "roller"                       # or "knife", "flat"
motion   = "translating"                  # or "oscillating"
rotation = "ccw"                          # or "cw", "either"

# The motion, in order: angles in deg, which add up to 360, lifts in mm.
# Laws: mechwright's README lists them; a list of laws tries each.
@segments@
[dimensions]                              # mm: a number is given, a range is to be designed
prime-radius  = { min = @lift*0.05@, max = @lift*50@ }   # least distance of the roller's centre from the cam's
offset        = { min = -@lift*10@, max = @lift*10@ }    # of the guide, > 0 on the side that relieves the rise
roller-radius = @roller-radius@

[[require]]
quantity = "pressure-angle-rise"          # deg
max      = @pressure-angle@

[[require]]
quantity = "pressure-angle-return"        # more is allowed where a spring alone drives the return
max      = @pressure-angle@

[[require]]
quantity = "undercut-margin"              # 0 is a cusp; 0.3: the roller is 0.7 of the least radius of its way
min      = 0.3

[objective]
minimize = "prime-radius"                 # or cam-size
)toml"};
}

Task knife() {
    return {"cam",
            "knife",
            "the smallest cam for a knife edge on a straight guide",
            {segments("rise 120, dwell 60, return 120, dwell 60"), lift("Lift, mm", "20", 1e6), law(), pressure("30")},
            R"toml(# The smallest cam for a knife edge on a straight guide, within a limit on the pressure angle.
schema    = 1                             # of the file format
title     = "Knife-edge follower, lift @lift@ mm"
mechanism = "cam"

[cam]
follower = "knife"                        # or "roller", "flat"
motion   = "translating"                  # or "oscillating"
rotation = "ccw"                          # or "cw", "either"

# The motion, in order: angles in deg, which add up to 360, lifts in mm.
@segments@
[dimensions]                              # mm: a number is given, a range is to be designed
prime-radius = { min = @lift*0.05@, max = @lift*50@ }    # least radius of the cam
offset       = { min = -@lift*10@, max = @lift*10@ }     # of the guide, > 0 on the side that relieves the rise

[[require]]
quantity = "pressure-angle-rise"          # deg
max      = @pressure-angle@

[[require]]
quantity = "pressure-angle-return"        # more is allowed where a spring alone drives the return
max      = @pressure-angle@

[objective]
minimize = "prime-radius"                 # or cam-size
)toml"};
}

Task flat() {
    return {"cam",
            "flat",
            "the smallest cam for a flat face on a straight guide",
            {segments("rise 120, dwell 60, return 120, dwell 60"), lift("Lift, mm", "20", 1e6), law(), curvature()},
            R"toml(# The smallest cam for a flat face on a straight guide, within a limit on its curvature.
schema    = 1                             # of the file format
title     = "Flat-faced follower, lift @lift@ mm"
mechanism = "cam"

[cam]
follower = "flat"                         # or "roller", "knife"
motion   = "translating"                  # or "oscillating"
rotation = "ccw"                          # or "cw", "either"

# The motion, in order: angles in deg, which add up to 360, lifts in mm.
@segments@
[dimensions]                              # mm: a number is given, a range is to be designed
base-radius = { min = @lift*0.05@, max = @lift*100@ }    # least radius of the cam

[[require]]
quantity = "profile-radius-min"           # mm; a flat face cannot reach into hollows
min      = @profile-radius@

[objective]
minimize = "base-radius"                  # or face-length, cam-size
)toml"};
}

Task oscillating_roller() {
    return {"cam",
            "oscillating-roller",
            "the smallest cam for a roller on an arm",
            {segments("rise 120, dwell 60, return 120, dwell 60"),
             lift("Swing of the arm, deg", "25", 170),
             law(),
             {"arm-length", "Length of the arm, mm", "80", Answer::number, 1e-3},
             roller(),
             pressure("45")},
            R"toml(# The smallest cam for a roller on an arm, within a limit on the pressure angle.
schema    = 1                             # of the file format
title     = "Roller on an arm that swings by @lift@ deg"
mechanism = "cam"

[cam]
follower = "roller"                       # or "knife", "flat"
motion   = "oscillating"                  # or "translating"
rotation = "either"                       # each is tried; or "ccw", "cw"

# The motion, in order: angles in deg, which add up to 360, lifts in deg of the arm.
@segments@
[dimensions]                              # mm: a number is given, a range is to be designed
prime-radius   = { min = @arm-length*0.05@, max = @arm-length*5@ }   # least distance of the roller's centre
pivot-distance = { min = @arm-length*0.2@, max = @arm-length*5@ }    # of the arm's pivot from the cam's centre
arm-length     = @arm-length@
roller-radius  = @roller-radius@

[[require]]
quantity = "pressure-angle-max"           # deg
max      = @pressure-angle@

[objective]
minimize = "prime-radius"                 # or pivot-distance, cam-size
)toml"};
}

Task oscillating_flat() {
    return {"cam",
            "oscillating-flat",
            "the smallest cam for a flat face that swings about a pivot",
            {segments("rise 120, dwell 60, return 120, dwell 60"),
             lift("Swing of the face, deg", "15", 85),
             law(),
             {"start-angle", "Angle of the face to the line of centres at the lowest position, deg", "40",
              Answer::number, 1, 85},
             curvature()},
            R"toml(# The smallest cam for a flat face that swings about a pivot, within a limit on its curvature.
schema    = 1                             # of the file format
title     = "Flat face that swings by @lift@ deg"
mechanism = "cam"

[cam]
follower = "flat"                         # or "roller", "knife"
motion   = "oscillating"                  # or "translating"
rotation = "ccw"                          # or "cw", "either"

# The motion, in order: angles in deg, which add up to 360, lifts in deg of the face.
@segments@
[dimensions]                              # mm: a number is given, a range is to be designed
base-radius    = { min = @profile-radius@, max = @profile-radius*100@ }
pivot-distance = { min = @profile-radius@, max = @profile-radius*100@ }   # of the face's pivot from the cam's centre
face-offset    = 0                        # of the face from its pivot

[[require]]
quantity = "start-angle"                  # deg; at too small an angle there is no cam
equal    = @start-angle@

[[require]]
quantity = "profile-radius-min"           # mm
min      = @profile-radius@

[objective]
minimize = "pivot-distance"               # or cam-size
)toml"};
}

}  // namespace

std::vector<Task> cam_tasks() { return {roller_follower(), knife(), flat(), oscillating_roller(), oscillating_flat()}; }

}  // namespace mechwright
