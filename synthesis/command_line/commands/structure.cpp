// mechwright structure: how a linkage is made up, and in which order it is placed.

#include "synthesis/report/structure/structure.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/options.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/json_text.h"

namespace mechwright {

namespace {

struct StructureOptions {
    std::string file;
    std::string at;
    bool json = false;
};

int show_structure(const StructureOptions& options, Console& console) {
    std::optional<double> at;
    if (!options.at.empty()) {
        at = decimal(options.at);
        if (!at) {
            complain(console, "--at must be a number, not " + reading::quoted(options.at));
            return exit_code::wrong_usage;
        }
    }
    ReadLinkage read;
    if (const int code = read_and_report(options.file, false, console, read); code != exit_code::solved) return code;
    const Linkage& linkage = read.linkage;
    if (at && linkage.units.degrees && !linkage.structure.drives.front().of_slide) *at *= std::numbers::pi / 180;
    print(console,
          options.json ? json_text(structure_of(linkage, at)) : structure_text(linkage, at, colour_wanted(console)));
    return exit_code::solved;
}

}  // namespace

Command add_structure(CLI::App& program) {
    const auto options = std::make_shared<StructureOptions>();
    CLI::App* command = program.add_subcommand("structure", "Show how a linkage moves: joints, groups, assemblies");
    command->add_option("FILE", options->file, "Problem file of a linkage")->required()->option_text(" ");
    command->add_option("--at", options->at, "Crank angle, or displacement, of the assemblies shown")
        ->option_text("NUMBER");
    command->add_flag("--json", options->json, "For programs");
    return {command, [options](Console& console) { return show_structure(*options, console); }};
}

}  // namespace mechwright
