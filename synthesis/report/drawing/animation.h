#pragma once
/// \file
/// A mechanism that moves by itself: pictures that browsers, slides and messages show.

#include <string>

#include "synthesis/report/drawing/svg.h"

namespace mechwright {

/// The picture with its bodies going through the motion for ever, once in so many seconds: round where the motion is a
/// full turn, else forth and back. Names of points are left out.
std::string svg_animation(const FinishedDesign& design, const SvgPicture& picture, double seconds);

/// The same as an animated GIF, made by rsvg-convert and gnuplot. Throws ChartFault where one of them is missing or
/// fails.
std::string gif_animation(const FinishedDesign& design, const SvgPicture& picture, double seconds);

}  // namespace mechwright
