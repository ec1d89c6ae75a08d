#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/report/names.h"
#include "synthesis/report/signal_words.h"
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

/// What a file can ask for.
int list_of_file(const std::string& file, Console& console) {
    ReadProblem read;
    if (const int code = read_and_report(file, true, console, read); code != exit_code::solved) return code;
    const Mechanism& mechanism = *read.problem.mechanism;
    std::string text = list_of(mechanism, colour_wanted(console));
    if (const LinkageModel* linkage = mechanism.model.as<LinkageModel>())
        text += linkage->signals.empty() ? "\nMore is asked of signals, in [signals]: mechwright explain signals\n"
                                         : "\n" + words_of_signals();
    print(console, text);
    return exit_code::solved;
}

bool is_file(const std::string& name) {
    std::error_code none;
    return name.ends_with(".toml") || std::filesystem::is_regular_file(name, none);
}

int list_quantities(const std::string& name, Console& console) {
    const bool colour = colour_wanted(console);
    if (is_file(name)) return list_of_file(name, console);
    if (name == "linkage") {
        complain(console, "the quantities of a linkage are those of its file: mechwright quantities FILE");
        return exit_code::wrong_usage;
    }
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
    command->add_option("MECHANISM", *name, "Only those of this mechanism, or of a problem file")->option_text(" ");
    return {command, [name](Console& console) { return list_quantities(*name, console); }};
}

}  // namespace mechwright
