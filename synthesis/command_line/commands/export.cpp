// export: a design for other programs.

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <array>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/shown.h"
#include "synthesis/mechanism/input.h"
#include "synthesis/problem/text.h"
#include "synthesis/problem/units.h"
#include "synthesis/report/csv/motion_table.h"
#include "synthesis/report/drawing/dxf.h"
#include "synthesis/report/drawing/motion_json.h"
#include "synthesis/report/drawing/sketch.h"
#include "synthesis/report/drawing/svg.h"
#include "synthesis/report/json_text.h"

namespace mechwright {

namespace {

struct ExportOptions {
    std::string file;
    std::string out;
    std::string format;
    std::optional<double> at;
    std::optional<double> fineness;
    std::optional<std::uint64_t> alternative;
    std::optional<std::uint64_t> steps;
};

constexpr std::array<std::string_view, 4> formats{"dxf", "slvs", "csv", "json"};

/// The format that is asked for, or that the file's name ends in; empty if it is none.
std::string format_of(const ExportOptions& options) {
    if (!options.format.empty()) return options.format;
    const std::size_t dot = options.out.rfind('.');
    return dot == std::string::npos ? "" : options.out.substr(dot + 1);
}

/// The input at which a drawing shows the mechanism: that asked for, in the file's unit.
double angle_of(const ExportOptions& options, const FinishedDesign& design) {
    return options.at ? from_file_unit(*options.at, input_unit(design), design.units) : pictured_angle(design);
}

std::string exported(const std::string& format, const ExportOptions& options, const FinishedDesign& design) {
    const int steps = static_cast<int>(options.steps.value_or(default_table_steps));
    if (format == "csv") return motion_table(design, steps);
    // A sketch is to be worked on: fewer arcs, each still within a thousandth of the drawing.
    const Scene scene = scene_of(design, options.fineness.value_or(format == "slvs" ? 1e-3 : 1e-6));
    if (format == "json") return json_text(motion_json(design, scene, steps));
    if (format == "dxf") return dxf_of(design, scene, angle_of(options, design));
    return sketch_of(design, scene, angle_of(options, design));
}

int run_export(const ExportOptions& options, Console& console) {
    const std::string format = format_of(options);
    if (std::find(formats.begin(), formats.end(), format) == formats.end()) {
        complain(console,
                 options.format.empty() && options.out.empty()
                     ? "--out FILE or --format NAME must say what to export to: " + reading::listed(formats)
                     : fmt::format("unknown format {}; {}", reading::quoted(format), reading::remedy(format, formats)));
        return exit_code::wrong_usage;
    }
    ShownDesign shown;
    if (const int outcome = read_shown(options.file, options.alternative.value_or(0), console, shown)) return outcome;
    const FinishedDesign& design = shown.design;
    if (!MotionRow(design, angle_of(options, design)).assembled()) {
        complain(console, fmt::format("--at {}: the mechanism does not assemble at this {}; it does from {} to {}",
                                      options.at.value_or(0), input_word(*design.mechanism),
                                      in_file_unit(design.motion.from, input_unit(design), design.units),
                                      in_file_unit(design.motion.to, input_unit(design), design.units)));
        return exit_code::wrong_usage;
    }
    return hand_over(options.out, exported(format, options, design), console);
}

}  // namespace

Command add_export(CLI::App& program) {
    const auto options = std::make_shared<ExportOptions>();
    CLI::App* command = program.add_subcommand("export", "Hand a mechanism to CAD or to scripts");
    command->add_option("FILE", options->file, "Result document, or fully dimensioned problem")
        ->required()
        ->option_text(" ");
    command->add_option("--out", options->out, "File to write; its ending says the format")
        ->type_name("FILE")
        ->check(not_empty);
    command->add_option("--format", options->format, "dxf, slvs (SolveSpace), csv (motion) or json")
        ->type_name("NAME")
        ->check(not_empty);
    command->add_option("--at", options->at, "Crank angle, or displacement, of a drawing, in the file's unit")
        ->option_text("ANGLE");
    add_positive_number(*command, "--fineness", options->fineness, "Deviation of curves over the drawing (1e-6)");
    add_whole_number(*command, "--alternative", options->alternative, 1, 1'000'000, "Export this alternative");
    add_whole_number(*command, "--steps", options->steps, 1, most_table_steps, "Steps over the motion (360)");
    return {command, [options](Console& console) { return run_export(*options, console); }};
}

}  // namespace mechwright
