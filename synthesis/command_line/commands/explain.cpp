// explain: what a quantity, a dimension, a mechanism, or a section or key of a problem file is.

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/report/text/explained.h"

namespace mechwright {

namespace {

struct ExplainOptions {
    std::string name;
    std::string mechanism;
};

int explain(const ExplainOptions& options, Console& console) {
    const Explained found = explained(options.name, options.mechanism, colour_wanted(console));
    if (!found.fault.empty()) {
        complain(console, found.fault);
        return exit_code::wrong_usage;
    }
    print(console, found.text);
    return exit_code::solved;
}

}  // namespace

Command add_explain(CLI::App& program) {
    const auto options = std::make_shared<ExplainOptions>();
    CLI::App* command = program.add_subcommand("explain", "Explain a quantity, a dimension, a key of a file");
    command->add_option("QUANTITY", options->name, "Or a dimension, setting, mechanism, signal, section")
        ->required()
        ->option_text(" ");
    command->add_option("MECHANISM", options->mechanism, "Only as this mechanism has it")->option_text(" ");
    return {command, [options](Console& console) { return explain(*options, console); }};
}

}  // namespace mechwright
