// What a run of the whole program takes, from the start of its process to its end.

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "synthesis/bench/pages/markdown.h"
#include "synthesis/bench/sections.h"
#include "synthesis/bench/timing.h"
#include "synthesis/report/files/run_program.h"

namespace mechwright::bench {

namespace {

constexpr std::string_view baseline = "/bin/true";

/// A command line, and what is measured by it. Words that are files of the problems stand after "problems/".
struct CommandLine {
    std::string_view what;
    std::vector<std::string> words;
};

const std::vector<CommandLine>& command_lines() {
    static const std::vector<CommandLine> all{
        {baseline, {"/bin/true"}},
        {"mechwright --version", {"", "--version"}},
        {"mechwright quantities", {"", "quantities"}},
        {"mechwright check crank-rocker.toml", {"", "check", "--quiet", "four-bar/crank-rocker.toml"}},
        {"mechwright solve crank-rocker.toml", {"", "solve", "--quiet", "four-bar/crank-rocker.toml"}},
        {"mechwright solve slider-crank-best-transmission.toml",
         {"", "solve", "--quiet", "quick-return/slider-crank-best-transmission.toml"}},
        {"mechwright solve case-2.toml", {"", "solve", "--quiet", "path/case-2.toml"}},
    };
    return all;
}

std::vector<std::string> command_of(const CommandLine& line, const Effort& effort) {
    std::vector<std::string> words = line.words;
    if (words.front().empty()) words.front() = effort.program.string();
    if (words.back().ends_with(".toml")) words.back() = (effort.problems / words.back()).string();
    return words;
}

std::vector<Row> measured(const CommandLine& line, const Effort& effort) {
    const std::vector<std::string> command = command_of(line, effort);
    if (!run_program(command, "").succeeded()) throw std::runtime_error(fmt::format("{} fails", line.what));
    const Timing t = timed([&] { run_program(command, ""); }, effort.pick(11, 51));
    return {{1e3 * t.median, 1e3 * t.lower, 1e3 * t.upper}};
}

std::vector<Measurement> start_up_measurements(const Effort&) {
    std::vector<Measurement> all;
    for (const CommandLine& line : command_lines())
        all.push_back({std::string(line.what), [&line](const Effort& effort) { return measured(line, effort); }});
    return all;
}

std::string start_up_chapter(const Sheet& sheet) {
    MarkdownTable table{{"command", "median", "quartiles", "ratio to " + std::string(baseline)}, {}};
    const auto first = sheet.where("command", baseline);
    const double nothing = first.empty() ? std::nan("") : sheet.number(first.front(), "ms");
    for (const Row& row : sheet.rows) {
        const double ms = sheet.number(row, "ms");
        table.rows.push_back({"`" + sheet.text(row, "command") + "`", time_text(1e-3 * ms),
                              fmt::format("{} to {}", time_text(1e-3 * sheet.number(row, "ms lower quartile")),
                                          time_text(1e-3 * sheet.number(row, "ms upper quartile"))),
                              ratio_text(ms / nothing)});
    }
    return "From the start of a process to its end, output and verification in fifty digits included; against a "
           "program "
           "that\ndoes nothing.\n\n" +
           to_markdown(table);
}

std::vector<Diagram> start_up_diagrams(const Sheet&) { return {}; }

}  // namespace

Section start_up() {
    return {"start-up",
            "Whole runs of the program",
            {"command", "ms", "ms lower quartile", "ms upper quartile"},
            start_up_measurements,
            start_up_chapter,
            start_up_diagrams};
}

}  // namespace mechwright::bench
