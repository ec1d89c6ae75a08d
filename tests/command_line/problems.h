#pragma once
/// \file
/// Problem files for the tests of the command line.

#include <string>

namespace mechwright::testing {

inline std::string shipped_file(const std::string& name) { return MECHWRIGHT_SOURCE_DIR "/problems/" + name; }

/// Solved in no time.
inline std::string crank_rocker(const std::string& more = "") {
    return R"(schema    = 1
title     = "Crank-rocker of 60 deg swing and time ratio 1.2"
mechanism = "four-bar"

[dimensions]
ground  = 100.0
crank   = { min = 5, max = 60 }
coupler = { min = 20, max = 300 }
rocker  = { min = 20, max = 300 }

[[require]]
quantity = "time-ratio"
equal    = 1.2

[[require]]
quantity = "swing"
equal    = 60

[objective]
maximize = "transmission-angle-worst"
)" + more;
}

/// A crank-rocker of such short crank cannot swing by 90 degrees.
inline const std::string impossible = R"(schema = 1
mechanism = "four-bar"

[dimensions]
ground  = 100.0
crank   = { min = 5, max = 6 }
coupler = { min = 100, max = 120 }
rocker  = { min = 80, max = 100 }

[[require]]
quantity = "swing"
equal    = 90

[solver]
starts = 8
)";

/// Takes as long as it is allowed to.
inline std::string long_search(const std::string& more = "") {
    return R"(schema    = 1
title     = "Coupler path through many points"
mechanism = "four-bar"

[dimensions]
ground  = { min = 10, max = 100 }
crank   = { min = 5, max = 60 }
coupler = { min = 10, max = 100 }
rocker  = { min = 10, max = 100 }
point-along  = { min = -60, max = 60 }
point-across = { min = -60, max = 60 }
origin-x = { min = -60, max = 60 }
origin-y = { min = -60, max = 60 }
tilt     = { min = 0, max = 360 }

[path]
points = [[20, 20], [20, 25], [20, 30], [20, 35], [20, 40], [20, 45], [25, 47], [30, 44], [31, 38], [28, 30]]

[objective]
minimize = "path-rms"

[solver]
starts = 100000
)" + more;
}

/// Everything is given.
inline std::string given(const std::string& more = "") {
    return R"(schema    = 1
title     = "Given"
mechanism = "four-bar"

[dimensions]
ground  = 100
crank   = 40
coupler = 92.4
rocker  = 81.8
)" + more;
}

}  // namespace mechwright::testing
