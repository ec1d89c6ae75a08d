#pragma once
/// \file
/// The figure that shows where the dimensions of a mechanism are, as SVG.

#include <span>
#include <string>

#include "synthesis/mechanism/drawing/figure.h"

namespace mechwright {

inline constexpr double usual_figure_width = 860;

/// The panels side by side with a title above them; not wider than asked for, where one panel is not.
/// Precondition: there are some.
std::string figure_picture(const std::string& title, std::span<const FigurePanel> panels,
                           double most_width = usual_figure_width);

/// The figure of all mechanisms of a name, or of one as a problem has it, with what it is of above it; empty where
/// there is none.
std::string figure_picture(std::string_view mechanism_name, double most_width = usual_figure_width);
std::string figure_picture(const Mechanism& mechanism, double most_width = usual_figure_width);

}  // namespace mechwright
