#pragma once
/// \file
/// The sections that only files of a cam have, with their keys.

#include <array>
#include <string_view>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/schema/key.h"

namespace mechwright::keys {

inline constexpr Words<3> rotations{"ccw", "cw", "either"};

inline constexpr std::array cam{
    Key{"follower", Shape::word, "What touches the cam: a knife edge, a roller or a flat face.", true,
        cam_follower_names},
    Key{"motion", Shape::word, "How the follower is guided. Preset: translating.", false, cam_motion_names},
    Key{"rotation", Shape::word, "Sense of rotation of the cam; either: the better one is chosen. Preset: ccw.", false,
        rotations},
    Key{"contour", Shape::word, "A specified contour, from which the motion follows: without segments.", false,
        cam_contour_names}};

inline constexpr std::array<std::string_view, 4> ends_of_polynomials{"R", "G", "U", "B"};

inline constexpr std::array end_of_polynomial{
    Key{"velocity", Shape::range, "First derivative of the lift with respect to the part of the segment."},
    Key{"acceleration", Shape::range, "Second derivative."}, Key{"jerk", Shape::range, "Third derivative."}};

inline constexpr std::array segment{
    Key{"kind", Shape::word, "What the follower does; cycle: a whole turn by a table of points.", true,
        segment_kind_names},
    Key{"angle", Shape::range, "Angle of the cam that the segment takes, or a range of it."},
    Key{"lift", Shape::range, "Lift of a rise or return, an angle where the follower oscillates, or a range of it."},
    Key{"law", Shape::name, "Law of motion of a rise or return; of a list the best is chosen."},
    Key{"start", Shape::value,
        "Derivatives of a polynomial at its start: a list of numbers or ranges, the first the velocity; or its kind "
        "after "
        "VDI 2143.",
        false, ends_of_polynomials, end_of_polynomial},
    Key{"end", Shape::value, "The same at its end.", false, ends_of_polynomials, end_of_polynomial},
    Key{"shape", Shape::ranges, "Further terms of a polynomial or a spline: numbers or ranges."},
    Key{"points", Shape::pairs, "Table of a cycle: [cam angle, lift]."},
    Key{"points_file", Shape::text, "File with two columns, in place of points."}};

}  // namespace mechwright::keys
