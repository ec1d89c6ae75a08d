#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/report/names.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

namespace {

std::string list_of(const Mechanism& mechanism, bool colour) {
    std::string text =
        folded(emphasised(mechanism.name, Emphasis::strong, colour) + ": ", std::string(mechanism.meaning));
    for (const Quantity& quantity : mechanism.quantities)
        text += folded(fmt::format("  {:<24}  {:<6}  ", quantity.name, name_of(quantity.unit)), quantity.meaning);
    return text;
}

int list_quantities(const std::string& name, Console& console) {
    const bool colour = colour_wanted(console);
    if (!name.empty()) {
        std::string text;
        for (const auto& mechanism : mechanisms_named(name))
            text += (text.empty() ? "" : "\n") + list_of(*mechanism, colour);
        if (!text.empty()) {
            print(console, text);
            return exit_code::solved;
        }
        complain(console, unknown_mechanism(name));
        return exit_code::wrong_usage;
    }
    std::string text;
    for (const auto& mechanism : mechanisms())
        text += (text.empty() ? "" : "\n") + list_of(*mechanism, colour);
    print(console, text);
    return exit_code::solved;
}

}  // namespace

Command add_quantities(CLI::App& program) {
    const auto name = std::make_shared<std::string>();
    CLI::App* command = program.add_subcommand("quantities", "List what can be required or optimised");
    command->add_option("MECHANISM", *name, "Only those of this mechanism")->option_text(" ");
    return {command, [name](Console& console) { return list_quantities(*name, console); }};
}

}  // namespace mechwright
