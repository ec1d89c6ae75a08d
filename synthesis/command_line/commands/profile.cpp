#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/shown.h"
#include "synthesis/report/csv/cut_profile.h"

namespace mechwright {

namespace {

struct ProfileOptions {
    std::string file;
    bool dxf = false;
    double cutter = 0;
    double tolerance = 1e-3;
    std::optional<std::uint64_t> steps;
};

int profile(const ProfileOptions& options, Console& console) {
    ShownDesign shown;
    if (const int outcome = read_shown(options.file, 0, console, shown)) return outcome;
    const FinishedDesign& design = shown.design;
    if (!design.mechanism->profile) {
        complain(console, fmt::format("{}: a {} has no profile: only cams have", options.file, design.mechanism->name));
        return exit_code::invalid_file;
    }
    if (const double hollow = least_hollow_radius(design); options.cutter > hollow) {
        complain(console,
                 fmt::format("{}: the cutter is too large by {:.6g}: its radius {:.6g} must be at most {:.6g}, the "
                             "least radius of the profile's hollow parts",
                             options.file, options.cutter - hollow, options.cutter, hollow));
        return exit_code::infeasible;
    }
    print(console, options.dxf ? profile_dxf(design, options.cutter, options.tolerance)
                               : profile_csv(design, options.cutter,
                                             static_cast<int>(options.steps.value_or(default_table_steps))));
    return exit_code::solved;
}

}  // namespace

Command add_profile(CLI::App& program) {
    const auto options = std::make_shared<ProfileOptions>();
    CLI::App* command = program.add_subcommand("profile", "Print the curves of a cam for cutting it");
    command->add_option("FILE", options->file, "Result document, or fully dimensioned problem")
        ->required()
        ->option_text(" ");
    CLI::Option* dxf = command->add_flag("--dxf", options->dxf, "A drawing (DXF R12) instead of a table");
    add_whole_number(*command, "--steps", options->steps, 4, most_table_steps, "Rows of the table (360)")
        ->excludes(dxf);
    command->add_option("--cutter", options->cutter, "Radius of a cutter: its path too")
        ->check(CLI::PositiveNumber)
        ->option_text("RADIUS");
    command->add_option("--tolerance", options->tolerance, "Deviation allowed in the drawing (0.001)")
        ->check(CLI::PositiveNumber)
        ->needs(dxf)
        ->option_text("LENGTH");
    return {command, [options](Console& console) { return profile(*options, console); }};
}

}  // namespace mechwright
