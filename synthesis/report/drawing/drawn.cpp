#include "synthesis/report/drawing/drawn.h"

#include <fmt/format.h>

#include "synthesis/document/versions.h"
#include "synthesis/report/drawing/animation.h"
#include "synthesis/report/drawing/motion_plots.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/files/gnuplot.h"

namespace mechwright {

namespace {

std::vector<std::string> title_block(const FinishedDesign& design, const std::string& title,
                                     const std::string& source) {
    return {fmt::format("{}: {}", design.mechanism->name, title),
            fmt::format("lengths in {}, angles in {}; drawn from {}", design.units.length,
                        design.units.degrees ? "deg" : "rad", source),
            fmt::format("mechwright {}", program_version())};
}

void add_plots(const FinishedDesign& design, const nlohmann::ordered_json& document, SvgPicture& picture) {
    constexpr int steps = 360;
    const int width = static_cast<int>(picture.width);
    const MotionPlots plots = motion_plots(design, document, steps);
    const int height = plots_height(plots, width);
    picture.below =
        svg_element(gnuplot_picture(plots_script(plots), {.width = width, .height = height, .fixed = true}));
    picture.below_height = height;
}

}  // namespace

std::string drawn(const FinishedDesign& design, const nlohmann::ordered_json& document, WantedPicture wanted) {
    SvgPicture& picture = wanted.picture;
    if (wanted.title_block_source) picture.title_block = title_block(design, picture.title, *wanted.title_block_source);
    if (wanted.seconds)
        return wanted.gif ? gif_animation(design, picture, *wanted.seconds)
                          : svg_animation(design, picture, *wanted.seconds);
    if (wanted.plots) add_plots(design, document, picture);
    return svg_picture(design, picture);
}

}  // namespace mechwright
