#pragma once
/// \file
/// The segments of a motion: of a cam's follower, and of a drive that moves as one.

#include <array>
#include <string_view>

#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/schema/key.h"

namespace mechwright::keys {

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

inline constexpr std::array drive_segment{
    Key{"kind", Shape::word, "What the input does; cycle: a whole turn by a table of points.", true,
        segment_kind_names},
    Key{"angle", Shape::number, "Angle of the first drive that the segment takes.", false, {}, {}, positive},
    Key{"lift", Shape::number, "By how much the input grows in a rise, or falls in a return.", false, {}, {}, positive},
    Key{"law", Shape::name, "Law of motion of a rise or return."},
    Key{"start", Shape::value,
        "Derivatives of a polynomial at its start: a list of numbers, the first the velocity; or its kind after "
        "VDI 2143.",
        false, ends_of_polynomials, end_of_polynomial},
    Key{"end", Shape::value, "The same at its end.", false, ends_of_polynomials, end_of_polynomial},
    Key{"shape", Shape::numbers, "Further terms of a polynomial or a spline."},
    Key{"points", Shape::pairs, "Table of a cycle: [angle of the first drive, lift]."}};

}  // namespace mechwright::keys
