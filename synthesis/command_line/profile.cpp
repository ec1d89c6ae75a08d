#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/options.h"
#include "synthesis/mechanism/cam/cam.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/program/quantity_value.h"
#include "synthesis/report/cam_profile.h"
#include "synthesis/search/solve.h"
#include "synthesis/verify/rebuilt.h"

namespace mechwright {

namespace {

constexpr std::uint64_t default_steps = 360;
constexpr std::uint64_t most_steps = 1'000'000;
constexpr std::size_t largest_document = std::size_t{1} << 30;

struct ProfileOptions {
    std::string file;
    bool dxf = false;
    double cutter = 0;
    double tolerance = 1e-3;
    std::optional<std::uint64_t> steps;
};

bool is_problem_file(const std::string& name) { return name.ends_with(".toml"); }

/// The cam of a result document.
int read_result(const ProfileOptions& options, Console& console, FinishedCam& cam) {
    const reading::Bytes read = reading::read_bytes(options.file, largest_document, true);
    if (!read.failure.empty()) {
        complain(console, options.file + ": " + read.failure);
        return exit_code::no_access;
    }
    const auto json = nlohmann::ordered_json::parse(read.bytes, nullptr, false);
    const ReadClaim claim = read_claim(json);
    if (json.is_discarded() || !claim.defect.empty()) {
        complain(console, options.file + ": not a result document" + (json.is_discarded() ? "" : ": " + claim.defect));
        return exit_code::invalid_file;
    }
    const Rebuilt design = rebuilt(claim.claim);
    cam = {claim.claim.mechanism, claim.claim.program, design.motion, design.rounded, claim.claim.units.length};
    return exit_code::solved;
}

/// The cam of a problem file that leaves nothing open.
int read_given(const ProfileOptions& options, Console& console, FinishedCam& cam) {
    ReadProblem read;
    if (const int outcome = read_and_report(options.file, false, console, read)) return outcome;
    const Problem& problem = read.problem;
    for (std::size_t i = 0; i < problem.dimensions.size(); ++i)
        if (!problem.dimensions[i].fixed() || problem.assemblies.size() > 1) {
            complain(console,
                     options.file +
                         ": this problem leaves something to be designed: solve it with --out DIR, and give the "
                         "result in DIR to this command");
            return exit_code::invalid_file;
        }
    const Solution given = evaluate_given(problem);
    cam = {problem.mechanism, problem.program, motion_of(problem, given.design), given.design.dimensions,
           problem.units.length};
    return exit_code::solved;
}

int profile(const ProfileOptions& options, Console& console) {
    FinishedCam cam;
    const int outcome =
        is_problem_file(options.file) ? read_given(options, console, cam) : read_result(options, console, cam);
    if (outcome != exit_code::solved) return outcome;
    if (!is_cam(*cam.mechanism)) {
        complain(console, fmt::format("{}: a {} has no profile: only cams have", options.file, cam.mechanism->name));
        return exit_code::invalid_file;
    }
    if (const double hollow = least_hollow_radius(cam); options.cutter > hollow) {
        complain(console,
                 fmt::format("{}: the cutter is too large by {:.6g}: its radius {:.6g} must be at most {:.6g}, the "
                             "least radius of the profile's hollow parts",
                             options.file, options.cutter - hollow, options.cutter, hollow));
        return exit_code::infeasible;
    }
    print(console, options.dxf
                       ? profile_dxf(cam, options.cutter, options.tolerance)
                       : profile_csv(cam, options.cutter, static_cast<int>(options.steps.value_or(default_steps))));
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
    add_whole_number(*command, "--steps", options->steps, 4, most_steps, "Rows of the table (360)")->excludes(dxf);
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
