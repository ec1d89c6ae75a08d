#pragma once
/// \file
/// A design as the page shows it: its drawing, tables and plots, and where its bodies are at every step of the motion.

#include <nlohmann/json.hpp>
#include <string>

#include "synthesis/report/drawing/finished.h"
#include "synthesis/report/drawing/svg.h"

namespace mechwright {

struct DesignToShow {
    std::string name;  ///< "best", "alternative 2"
    FinishedDesign design;
    nlohmann::ordered_json document;
};

/// What the parts of a page about one design are made of, in the order in which they stand in it.
struct ShownParts {
    std::string view_box;   ///< of the drawing
    std::string drawing;    ///< SVG elements
    std::string thumbnail;  ///< an SVG of its own
    std::string tables;     ///< HTML
    nlohmann::ordered_json motion;
};

/// `steps_of_turn` of the motion are shown; without `with_thumbnail` there is none. In `motion`: from, to, unit, closed
/// (the crank turns fully), steps, bodies (names), assemblies [{name, scale, places}], where places are 16-bit integers
/// in base 64: for each body and step x and y in pixels over `scale`, then cosine and sine over 32767, all 0 where the
/// mechanism does not assemble; and plots [{title, unit, levels: [[name, value]], curves: [[name, 32-bit floats in base
/// 64]]}], as motion_plots.h has them.
ShownParts shown_parts(const DesignToShow& shown, int steps_of_turn, bool with_thumbnail);

/// The bytes of numbers in base 64, lowest byte first.
std::string base64(std::string_view bytes);

}  // namespace mechwright
