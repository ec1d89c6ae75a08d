// draw: a design as a picture.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/shown.h"
#include "synthesis/report/drawing/motion_plots.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/files/gnuplot.h"

namespace mechwright {

namespace {

constexpr int default_width = 640;
constexpr int plot_steps = 360;

struct DrawOptions {
    std::string file;
    std::string out;
    bool plots = false;
    std::optional<std::uint64_t> alternative;
    std::optional<std::uint64_t> width;
};

std::string picture_of(const ShownDesign& shown, const DrawOptions& options) {
    const int width = static_cast<int>(options.width.value_or(default_width));
    SvgPicture picture{.title = shown.title, .width = static_cast<double>(width), .below = {}, .below_height = 0};
    if (options.plots) {
        const MotionPlots plots = motion_plots(shown.design, shown.document, plot_steps);
        const int height = plots_height(plots, width);
        picture.below =
            svg_element(gnuplot_picture(plots_script(plots), {.width = width, .height = height, .fixed = true}));
        picture.below_height = height;
    }
    return svg_picture(shown.design, picture);
}

int draw(const DrawOptions& options, Console& console) {
    const std::optional<RasterFormat> format = raster_format_of(options.out);
    if (!options.out.empty() && !format && !options.out.ends_with(".svg")) {
        complain(console, "--out: '" + options.out + "' must end in .svg, .png or .pdf");
        return exit_code::wrong_usage;
    }
    ShownDesign shown;
    if (const int outcome = read_shown(options.file, options.alternative.value_or(0), console, shown)) return outcome;
    try {
        std::string picture = picture_of(shown, options);
        if (format) picture = rasterised(picture, *format);
        return hand_over(options.out, picture, console);
    } catch (const ChartFault& fault) {
        complain(console, fault.what());
        return exit_code::no_access;
    }
}

}  // namespace

Command add_draw(CLI::App& program) {
    const auto options = std::make_shared<DrawOptions>();
    CLI::App* command = program.add_subcommand("draw", "Draw a mechanism with its curves");
    command->add_option("FILE", options->file, "Result document, or fully dimensioned problem")
        ->required()
        ->option_text(" ");
    command->add_option("--out", options->out, "Picture to write: .svg, .png or .pdf (SVG, printed)")
        ->type_name("FILE")
        ->check(not_empty);
    command->add_flag("--plots", options->plots, "The curves of the motion below it (with gnuplot)");
    add_whole_number(*command, "--alternative", options->alternative, 1, 1'000'000, "Draw this alternative");
    add_whole_number(*command, "--width", options->width, 100, 10'000, "Width in pixels (640)");
    return {command, [options](Console& console) { return draw(*options, console); }};
}

}  // namespace mechwright
