// draw: a design as a picture.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <numbers>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/shown.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/drawing/drawn.h"
#include "synthesis/report/drawing/exported.h"
#include "synthesis/report/drawing/figure/figure.h"
#include "synthesis/report/drawing/figure/problem_figure.h"
#include "synthesis/report/drawing/linkage_sheets.h"
#include "synthesis/report/drawing/raster.h"
#include "synthesis/report/files/gnuplot.h"
#include "synthesis/report/names.h"
#include "synthesis/report/structure/centres.h"

namespace mechwright {

namespace {

constexpr std::uint64_t default_width = 640;

struct DrawOptions {
    std::string file;
    std::string out;
    std::string at;
    bool plots = false;
    bool assemblies = false;
    bool skeleton = false;
    bool figure = false;
    bool centres = false;
    bool animate = false;
    std::string seconds;
    std::optional<std::uint64_t> alternative;
    std::optional<std::uint64_t> width;
};

std::string picture_of(const ShownDesign& shown, const DrawOptions& options, const SvgPicture& with_marks) {
    WantedPicture wanted{with_marks};
    wanted.picture.title = shown.title;
    wanted.picture.width = static_cast<double>(options.width.value_or(default_width));
    if (options.out.ends_with(".pdf")) wanted.title_block_source = options.file;
    wanted.gif = options.out.ends_with(".gif");
    wanted.plots = options.plots;
    if (options.animate) wanted.seconds = options.seconds.empty() ? default_seconds : *decimal(options.seconds);
    return drawn(shown.design, shown.document, std::move(wanted));
}

/// A picture, or the exit code that says why there is none.
struct Drawn {
    std::string picture;
    int outcome = exit_code::solved;
};

/// Marks at the instant centres. Returns the exit code.
int mark_centres(const DrawOptions& options, const FinishedDesign& design, Console& console, SvgPicture& picture) {
    if (!is_of_links(*design.mechanism)) {
        complain(console, fmt::format("{}: a {} has no links and joints, of which instant centres are", options.file,
                                      design.mechanism->name));
        return exit_code::invalid_file;
    }
    const double master = picture.at.value_or(pictured_angle(design));
    const auto centres = centres_of({design.mechanism, design.dimensions, design.motion.assembly}, master);
    if (!centres) {
        complain(console, fmt::format("{}: at {} it does not close, or stands at a dead position: links are infinitely "
                                      "fast there",
                                      options.file, in_file_unit(master, input_unit(*design.mechanism), design.units)));
        return exit_code::infeasible;
    }
    for (const auto& [first, second, centre] : *centres)
        if (centre.kind == linkage::InstantCentre::Kind::place)
            picture.marks.push_back({first + ", " + second, centre.at});
    return exit_code::solved;
}

Drawn draw_design(const DrawOptions& options, Console& console) {
    ShownDesign shown;
    if (const int outcome = read_shown(options.file, options.alternative.value_or(0), console, shown))
        return {{}, outcome};
    SvgPicture picture;
    if (!options.at.empty()) {
        const std::optional<double> at = decimal(options.at);
        if (!at) {
            complain(console, "--at must be a number, not " + reading::quoted(options.at));
            return {{}, exit_code::wrong_usage};
        }
        picture.at = from_file_unit(*at, input_unit(*shown.design.mechanism), shown.design.units);
    }
    if (options.centres)
        if (const int outcome = mark_centres(options, shown.design, console, picture)) return {{}, outcome};
    return {picture_of(shown, options, picture)};
}

Drawn draw_assemblies(const DrawOptions& options, double width, Console& console) {
    std::optional<double> at;
    if (!options.at.empty()) {
        at = decimal(options.at);
        if (!at) {
            complain(console, "--at must be a number, not " + reading::quoted(options.at));
            return {{}, exit_code::wrong_usage};
        }
    }
    ReadLinkage read;
    if (const int outcome = read_and_report(options.file, false, console, read); outcome != exit_code::solved)
        return {{}, outcome};
    const Linkage& linkage = read.linkage;
    if (linkage.structure.drives.empty()) {
        complain(console, options.file + ": nothing drives this linkage; --skeleton draws its links apart");
        return {{}, exit_code::invalid_file};
    }
    if (at && linkage.units.degrees && !linkage.structure.drives.front().of_slide) *at *= std::numbers::pi / 180;
    const auto [master, assemblies] = assembled_at(linkage, at);
    if (assemblies.empty()) {
        complain(console, options.file + ": the linkage does not close " + (at ? "at this input" : "at any input") +
                              "; --skeleton draws its links apart");
        return {{}, exit_code::infeasible};
    }
    if (!options.out.empty())
        for (std::size_t i = 0; i < assemblies.size(); ++i) {
            const std::vector<std::string> lines = assembly_block(linkage, assemblies[i], i + 1);
            print(console, fmt::format("{}[assembly]  {}\n", i == 0 ? "" : "\n", lines[0]));
            for (std::size_t k = 1; k < lines.size(); ++k)
                print(console, lines[k] + '\n');
        }
    return {assemblies_picture(linkage, assemblies, master, width)};
}

/// What is wrong with the file is told, and what could be read is drawn.
Drawn draw_skeleton(const DrawOptions& options, double width, Console& console) {
    ReadLinkage read;
    const int outcome = read_and_report(options.file, false, console, read);
    if (outcome == exit_code::no_access || !has_skeleton(read.linkage)) {
        if (outcome == exit_code::solved) complain(console, options.file + ": there are no links to be drawn");
        return {{}, outcome == exit_code::solved ? exit_code::invalid_file : outcome};
    }
    return {skeleton_picture(read.linkage, width)};
}

/// Where the dimensions of a mechanism are, by its name or by a problem file of it.
Drawn draw_figure(const DrawOptions& options, double width, Console& console) {
    if (std::string picture = figure_picture(options.file, width); !picture.empty()) return {std::move(picture)};
    if (std::error_code ignored; !std::filesystem::exists(options.file, ignored)) {
        const std::vector<std::string_view> known = mechanism_names();
        complain(console, fmt::format("{} is neither a mechanism nor a file; {}", reading::quoted(options.file),
                                      reading::remedy(options.file, known)));
        return {{}, exit_code::wrong_usage};
    }
    ReadProblem read;
    if (const int outcome = read_and_report(options.file, false, console, read); outcome != exit_code::solved)
        return {{}, outcome};
    const std::vector<FigurePanel> panels = figure_of(read.problem);
    if (panels.empty()) {
        complain(console,
                 options.file + ": it does not close with the middles of its ranges; --skeleton draws its links apart");
        return {{}, exit_code::infeasible};
    }
    const std::string& title = read.problem.title;
    return {figure_picture("Dimensions: " + (title.empty() ? options.file : title), panels, width)};
}

/// Why options do not go together; empty if they do.
std::string why_not_together(const DrawOptions& options) {
    if (options.assemblies && options.skeleton) return "either --assemblies or --skeleton";
    if (options.figure && (options.assemblies || options.skeleton || options.centres || options.plots ||
                           options.animate || options.alternative || !options.at.empty()))
        return "--figure is of a mechanism: leave the other kinds of drawings, --at and --alternative out";
    if (!options.at.empty() && !options.assemblies && !options.centres)
        return "--at is for --assemblies and --instant-centres";
    if (options.centres && (options.assemblies || options.skeleton))
        return "--instant-centres are of a design: leave --assemblies and --skeleton out";
    if (options.animate && (options.assemblies || options.skeleton || options.centres || options.plots))
        return "--animate is of a design alone: leave the other kinds of drawings out";
    if (!options.seconds.empty() && !options.animate) return "--seconds is for --animate";
    if (const auto seconds = decimal(options.seconds); !options.seconds.empty() && !(seconds && *seconds > 0))
        return "--seconds must be a number greater than 0, not " + reading::quoted(options.seconds);
    if (options.out.ends_with(".gif") && !options.animate) return "a .gif is for --animate";
    if (options.animate && !options.out.empty() && !options.out.ends_with(".gif") && !options.out.ends_with(".svg"))
        return "--animate makes .svg or .gif";
    if ((options.assemblies || options.skeleton) && (options.plots || options.alternative))
        return "--assemblies and --skeleton are of a problem file: leave --plots and --alternative out";
    return "";
}

int draw(const DrawOptions& options, Console& console) {
    const std::optional<RasterFormat> format = raster_format_of(options.out);
    if (!options.out.empty() && !format && !options.out.ends_with(".svg") && !options.out.ends_with(".gif")) {
        const std::string ending = std::filesystem::path(options.out).extension().string();
        const bool is_exported = !ending.empty() && export_format_fault(ending.substr(1)).empty();
        complain(console, "--out: '" + options.out + "' must end in .svg, .png, .pdf, or .gif for --animate" +
                              (is_exported ? "; mechwright export writes " + ending : ""));
        return exit_code::wrong_usage;
    }
    if (const std::string why = why_not_together(options); !why.empty()) {
        complain(console, why);
        return exit_code::wrong_usage;
    }
    try {
        const auto width = static_cast<double>(
            options.width.value_or(options.figure ? static_cast<std::uint64_t>(usual_figure_width) : default_width));
        auto [picture, outcome] = options.figure       ? draw_figure(options, width, console)
                                  : options.assemblies ? draw_assemblies(options, width, console)
                                  : options.skeleton   ? draw_skeleton(options, width, console)
                                                       : draw_design(options, console);
        if (outcome != exit_code::solved) return outcome;
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
    command->add_option("--out", options->out, "Picture to write: .svg, .png, .pdf or .gif (SVG, printed)")
        ->type_name("FILE")
        ->check(not_empty);
    command->add_flag("--plots", options->plots, "The curves of the motion below it (with gnuplot)");
    command->add_flag("--assemblies", options->assemblies,
                      "All sides on which a linkage closes, with what [assembly] says of them");
    command->add_flag("--instant-centres", options->centres, "With the instant centres of all pairs of links");
    command->add_option("--at", options->at, "Crank angle, or displacement, of these two")->option_text("NUMBER");
    command->add_flag("--animate", options->animate, "Moving for ever: .svg or .gif");
    command->add_option("--seconds", options->seconds, "Of one round of that (4)")->option_text("NUMBER");
    command->add_flag("--skeleton", options->skeleton, "The links of a linkage apart, even where it does not close");
    command->add_flag("--figure", options->figure, "Where the dimensions of a mechanism are: FILE is its name");
    add_whole_number(*command, "--alternative", options->alternative, 1, 1'000'000, "Draw this alternative");
    add_whole_number(*command, "--width", options->width, 100, 10'000, "Width in pixels (640; figures 860)");
    return {command, [options](Console& console) { return draw(*options, console); }};
}

}  // namespace mechwright
