// Derivatives of programs: cams.

#include <vector>

#include "tests/program/derivatives.h"

namespace mechwright::testing {

namespace {

/// Segments of a cam whose angles and lifts are free, one of them a polynomial with free numbers.
const std::string free_motion = R"([[segment]]
kind = "rise"
angle = { min = 80, max = 100 }
lift = { min = 10, max = 12 }
law = "modified-sine"
[[segment]]
kind = "dwell"
angle = { min = 20, max = 120 }
[[segment]]
kind = "rise"
angle = { min = 50, max = 60 }
lift = { min = 4, max = 5 }
law = "polynomial"
start = [{ min = -0.2, max = 0.2 }, 0]
end = [0, { min = -1, max = 1 }]
shape = [{ min = -0.4, max = 0.4 }]
[[segment]]
kind = "return"
angle = { min = 120, max = 130 }
lift = { min = 14, max = 17 }
law = "spline"
shape = [{ min = 13, max = 14 }, 8, { min = 1, max = 2 }]
)";

/// A limit that every component of a quantity has to keep, far away: from below for what is a least value.
std::string limited(const std::vector<std::string>& quantities) {
    std::string text;
    for (const std::string& quantity : quantities) {
        const bool least = quantity.ends_with("-min") || quantity == "undercut-margin" || quantity == "jump-speed";
        text += "[[require]]\nquantity = \"" + quantity + (least ? "\"\nmin = -1000\n" : "\"\nmax = 1000\n");
    }
    return text;
}

std::string cam(const std::string& kind, const std::string& dimensions, const std::vector<std::string>& quantities) {
    return "schema = 1\nmechanism = \"cam\"\n[cam]\n" + kind + "\n[dimensions]\n" + dimensions + free_motion +
           limited(quantities) + "[objective]\nminimize = \"cam-size\"\n";
}

TEST(Derivatives, OfTranslatingCams) {
    const std::string load = R"(spring-rate = { min = 5, max = 9 }
precompression = { min = 10, max = 20 }
load = { min = 1, max = 3 }
weight = { min = 1, max = 3 }
guide-length = { min = 50, max = 60 }
overhang = { min = 20, max = 30 }
stem-diameter = { min = 10, max = 12 }
[units]
mass = "t"
[dynamics]
mass = 0.01
speed = 100
friction = 0.1
)";
    expect_exact_derivatives(problem_of(cam(
        "follower = \"roller\"",
        "prime-radius = { min = 40, max = 60 }\noffset = { min = 2, max = 9 }\nroller-radius = { min = 3, max = 6 }\n" +
            load,
        {"pressure-angle-rise", "pressure-angle-return", "pressure-angle-max", "pitch-radius-min", "profile-radius-min",
         "undercut-margin", "velocity-max", "acceleration-max", "jerk-max", "velocity-jump", "acceleration-jump",
         "contact-force-min", "contact-force-max", "drive-torque-max", "jump-speed", "jamming-angle", "offset"})));
    expect_exact_derivatives(problem_of(cam(
        "follower = \"flat\"", "base-radius = { min = 60, max = 80 }\n" + load,
        {"profile-radius-min", "undercut-margin", "face-length", "velocity-max", "contact-force-max", "jump-speed"})));
}

TEST(Derivatives, OfOscillatingCams) {
    expect_exact_derivatives(problem_of(
        cam("follower = \"roller\"\nmotion = \"oscillating\"\nrotation = \"either\"",
            "prime-radius = { min = 40, max = 50 }\npivot-distance = { min = 70, max = 80 }\narm-length = { min = 50, "
            "max = "
            "60 }\nroller-radius = { min = 3, max = 6 }\n",
            {"start-angle", "pressure-angle-max", "pitch-radius-min", "undercut-margin", "acceleration-max"})));
    expect_exact_derivatives(problem_of(cam(
        "follower = \"flat\"\nmotion = \"oscillating\"\nrotation = \"either\"",
        "base-radius = { min = 60, max = 70 }\npivot-distance = { min = 110, max = 130 }\nface-offset = { min = 2, max "
        "= 8 }\n",
        {"start-angle", "pressure-angle-max", "profile-radius-min", "face-length"})));
}

}  // namespace

}  // namespace mechwright::testing
