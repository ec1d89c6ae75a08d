#pragma once
/// \file
/// The members of result documents that say what was given of a cam.

#include <array>

#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/mechanism/cam/motion_program.h"
#include "synthesis/problem/schema/key.h"

namespace mechwright::fields {

inline constexpr std::array segment{Key{"kind", Shape::word, "What the follower does.", true, segment_kind_names},
                                    Key{"laws", Shape::texts, "Laws of motion that were tried."},
                                    Key{"start", Shape::whole_number, "Derivatives of a polynomial at its start."},
                                    Key{"end", Shape::whole_number, "The same at its end."},
                                    Key{"shape", Shape::whole_number, "Further terms of a polynomial or a spline."},
                                    Key{"points", Shape::pairs, "Table of a cycle: [cam angle, lift]."}};

inline constexpr std::array cam{Key{"follower", Shape::word, "What touches the cam.", true, cam_follower_names},
                                Key{"motion", Shape::word, "How the follower is guided.", true, cam_motion_names},
                                Key{"contour", Shape::word, "The specified contour.", false, cam_contour_names},
                                Key{"segments", Shape::tables, "Parts of the motion.", true, {}, segment}};

}  // namespace mechwright::fields
