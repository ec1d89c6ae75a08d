#include "synthesis/verify/verify.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <optional>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/input.h"
#include "synthesis/document/result_file.h"
#include "synthesis/problem/text.h"
#include "synthesis/report/text/table.h"
#include "synthesis/verify/asked.h"

namespace mechwright {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_detail = 2000;

struct VerifyOptions {
    std::vector<std::string> files;
    std::string problem_file;
    bool quiet = false;
    std::optional<Problem> problem;  ///< read from the file
};

/// Prints every check of one document. Returns the exit code.
int verify_document(const Json& json, const std::string& name, const VerifyOptions& options, Console& console) {
    if (const std::string fault = why_not_a_result(json); !fault.empty()) {
        complain(console, name + ": not a result document: " + fault);
        return exit_code::invalid_file;
    }
    std::vector<Check> checks = verify(json);
    if (options.problem) {
        const std::string otherwise = asked_otherwise(json, *options.problem);
        checks.insert(checks.begin(), {"answers " + options.problem_file, otherwise.empty(), otherwise});
    }
    const bool colour = colour_wanted(console);
    const auto failed = std::count_if(checks.begin(), checks.end(), [](const Check& c) { return !c.passed; });
    const bool good = failed == 0 && !checks.empty();

    std::string text = name + ": ";
    if (good)
        text += emphasised("verified", Emphasis::good, colour) +
                fmt::format(", {}\n", checks.size() == 1 ? "the one check passed"
                                                         : fmt::format("all {} checks passed", checks.size()));
    else
        text += emphasised("NOT verified", Emphasis::bad, colour) +
                fmt::format(", {} of {} checks failed\n", failed, checks.size());
    for (const Check& check : checks) {
        if (options.quiet && check.passed) continue;
        const std::string mark =
            check.passed ? emphasised("passed", Emphasis::good, colour) : emphasised("FAILED", Emphasis::bad, colour);
        const std::string found = check.name + (check.detail.empty() ? "" : ": " + check.detail);
        text += folded("  " + mark + "  ", reading::printable(found, longest_detail));
    }
    if (!options.quiet || !good) print(console, text);
    return good ? exit_code::solved : exit_code::unverified;
}

int verify_file(const std::string& file, const VerifyOptions& options, Console& console) {
    const auto [json, fault, unreadable] = read_result_file(file);
    if (!fault.empty()) {
        complain(console, file + ": " + fault);
        return unreadable ? exit_code::no_access : exit_code::invalid_file;
    }
    if (!json.is_array()) return verify_document(json, file, options, console);
    int code = exit_code::solved;
    for (std::size_t i = 0; i < json.size(); ++i) {
        const std::string name = fmt::format("{} ({} of {})", file, i + 1, json.size());
        code = exit_code::worse(code, verify_document(json[i], name, options, console));
    }
    return code;
}

}  // namespace

Command add_verify(CLI::App& program) {
    const auto options = std::make_shared<VerifyOptions>();
    CLI::App* command = program.add_subcommand("verify", "Check results again, independently of the optimiser");
    command->add_option("RESULT", options->files, "Result documents, as solve writes them")
        ->required()
        ->option_text(" ");
    command->add_option("--problem", options->problem_file, "That the results answer this problem file")
        ->option_text("FILE");
    command->add_flag("--quiet", options->quiet, "Only what failed");
    const auto run = [options](Console& console) {
        if (!options->problem_file.empty()) {
            ReadProblem read;
            if (const int outcome = read_and_report(options->problem_file, false, console, read)) return outcome;
            options->problem = std::move(read.problem);
        }
        int code = exit_code::solved;
        for (const std::string& file : options->files)
            code = exit_code::worse(code, verify_file(file, *options, console));
        return code;
    };
    return {command, run};
}

}  // namespace mechwright
