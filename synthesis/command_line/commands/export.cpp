// export: a design for other programs.

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/command_line/shown.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/drawing/exported.h"

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

/// The format that is asked for, or that the file's name ends in; empty if it is none.
std::string format_of(const ExportOptions& options) {
    if (!options.format.empty()) return options.format;
    const std::size_t dot = options.out.rfind('.');
    return dot == std::string::npos ? "" : options.out.substr(dot + 1);
}

int run_export(const ExportOptions& options, Console& console) {
    const std::string format = format_of(options);
    if (const std::string fault = format.empty() ? "--out FILE or --format NAME must say what to export to: " +
                                                       reading::listed(export_formats)
                                                 : export_format_fault(format);
        !fault.empty()) {
        complain(console, fault);
        return exit_code::wrong_usage;
    }
    ShownDesign shown;
    if (const int outcome = read_shown(options.file, options.alternative.value_or(0), console, shown)) return outcome;
    const ExportedPart part{options.at, options.fineness,
                            static_cast<int>(options.steps.value_or(default_table_steps))};
    const Exported text = exported(shown.design, format, part);
    if (!text.fault.empty()) {
        complain(console, "--at " + text.fault);
        return exit_code::wrong_usage;
    }
    return hand_over(options.out, text.text, console);
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
