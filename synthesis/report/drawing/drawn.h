#pragma once
/// \file
/// A design as a picture, still or moving, alone or with its curves.

#include <optional>
#include <string>

#include "synthesis/report/drawing/svg.h"

namespace mechwright {

/// Of one round of a moving picture.
inline constexpr double default_seconds = 4;

struct WantedPicture {
    SvgPicture picture;
    std::optional<double> seconds{};                  ///< of one round, where it is to move
    bool gif = false;                                 ///< a moving picture as GIF, not SVG
    bool plots = false;                               ///< the curves of the motion below a still picture (with gnuplot)
    std::optional<std::string> title_block_source{};  ///< on paper: what the title block says it was drawn from
};

/// SVG, or GIF. `document` is that of the result, or of the analysis of a given mechanism. Throws ChartFault where
/// another program is missing or fails. Precondition: the design assembles somewhere.
std::string drawn(const FinishedDesign& design, const nlohmann::ordered_json& document, WantedPicture wanted);

}  // namespace mechwright
