// mechwright expand: a problem of a built-in kind, as the linkage that it is.

#include "synthesis/problem/linkage/of_kinds/expand.h"

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/document/result_file.h"
#include "synthesis/problem/bytes.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

struct ExpandOptions {
    std::string file;
    std::string result;
    bool starts = false;
};

/// The design of a result document. Returns the exit code.
int read_design(const std::string& file, Console& console, Json& design) {
    auto [document, fault, unreadable] = read_result_file(file);
    if (const std::string why = fault.empty() ? why_not_a_result(document) : ""; !why.empty())
        fault = "not a result document: " + why;
    if (fault.empty() && (!document.contains("design") || !document["design"].is_object())) fault = "has no design";
    if (!fault.empty()) {
        complain(console, file + ": " + fault);
        return unreadable ? exit_code::no_access : exit_code::invalid_file;
    }
    design = document["design"];
    return exit_code::solved;
}

int expand(const ExpandOptions& options, Console& console) {
    Json design;
    if (!options.result.empty())
        if (const int outcome = read_design(options.result, console, design)) return outcome;
    constexpr std::size_t most_bytes = 64 << 20;
    const reading::Bytes read = reading::read_bytes(options.file, most_bytes, true);
    if (!read.failure.empty()) {
        console.err << to_string(Message{.file = options.file, .text = read.failure}) << std::endl;
        return read.unreadable ? exit_code::no_access : exit_code::invalid_file;
    }
    const ExpandedProblem expanded =
        expand_problem(read.bytes, options.file, {options.result.empty() ? nullptr : &design, options.starts});
    for (const Message& message : expanded.messages)
        console.err << to_string(message) << '\n';
    console.err << std::flush;
    if (!expanded.ok()) return exit_code::invalid_file;
    print(console, expanded.text);
    return exit_code::solved;
}

}  // namespace

Command add_expand(CLI::App& program) {
    const auto options = std::make_shared<ExpandOptions>();
    CLI::App* command = program.add_subcommand("expand", "Say a built-in linkage by its links and joints");
    command->add_option("FILE", options->file, "Problem file of a built-in linkage")->required()->option_text(" ");
    CLI::Option* result = command->add_option("--result", options->result, "Put in the design of this result document")
                              ->type_name("RESULT")
                              ->check(not_empty);
    command->add_flag("--starts", options->starts, "Its numbers are starts of the ranges, which stay")->needs(result);
    return {command, [options](Console& console) { return expand(*options, console); }};
}

}  // namespace mechwright
