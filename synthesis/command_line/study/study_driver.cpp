// study driver: one evaluation for Dakota, and for whatever else speaks its file formats.

#include <fmt/format.h>

#include <memory>

#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/command_line/study/study.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/report/files/write_file.h"
#include "synthesis/study/dakota.h"

namespace mechwright {

namespace {

struct DriverOptions {
    std::string problem;
    std::string parameters;
    std::string results;
};

constexpr std::size_t most_bytes = 64 << 20;

int drive(const DriverOptions& options, Console& console) {
    ReadProblem read;
    if (const int code = read_and_report(options.problem, true, console, read); code != exit_code::solved) return code;
    const reading::Bytes text = reading::read_bytes(options.problem, most_bytes, true);
    const reading::Bytes parameters = reading::read_bytes(options.parameters, most_bytes, true);
    for (const auto& [bytes, name] : {std::pair(&text, &options.problem), std::pair(&parameters, &options.parameters)})
        if (!bytes->failure.empty()) {
            complain(console, *name + ": " + bytes->failure);
            return exit_code::no_access;
        }
    const dakota::ReadEvaluations evaluations = dakota::read_parameters(parameters.bytes);
    if (!evaluations.fault.empty()) {
        complain(console, options.parameters + ": " + evaluations.fault);
        return exit_code::invalid_file;
    }
    const std::string results = dakota::results_of(evaluations.evaluations, text.bytes, options.problem);
    const auto fault = write_atomically(options.results, results);
    if (!fault) return exit_code::solved;
    complain(console, *fault);
    return exit_code::no_access;
}

}  // namespace

Command add_study_driver(CLI::App& study) {
    const auto options = std::make_shared<DriverOptions>();
    CLI::App* command =
        study.add_subcommand("driver", "Evaluate for Dakota: a file of parameters in, a file of results out");
    command->add_option("FILE", options->problem, "Problem file")->required()->option_text(" ");
    command->add_option("PARAMETERS", options->parameters, "Dakota's file of parameters")->required()->option_text(" ");
    command->add_option("RESULTS", options->results, "File to write")->required()->option_text(" ");
    return {command, [options](Console& console) { return drive(*options, console); }};
}

}  // namespace mechwright
