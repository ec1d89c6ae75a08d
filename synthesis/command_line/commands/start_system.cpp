// mechwright start-system: the solutions that exact methods begin with.

#include "synthesis/command_line/commands/start_system.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <memory>
#include <thread>

#include "synthesis/command_line/commands.h"
#include "synthesis/command_line/exit_code.h"
#include "synthesis/command_line/options.h"
#include "synthesis/problem/bytes.h"
#include "synthesis/problem/text.h"

namespace mechwright {

namespace {

struct StartOptions {
    std::string problem;
    std::optional<std::uint64_t> seed;
    std::optional<std::uint64_t> jobs;
    bool quiet = false;
};

int make(const StartOptions& options, Console& console) {
    constexpr int most_loops = 100;
    const auto system = homotopy::find_system(options.problem);
    if (!system) {
        complain(console, fmt::format("there is no start system for {}; known are {}",
                                      reading::quoted(std::string_view(options.problem)),
                                      fmt::join(start_system_names(), ", ")));
        return exit_code::wrong_usage;
    }
    const std::size_t expected = homotopy::orbits_of(*system);
    const std::uint64_t seed = options.seed.value_or(1);
    const int jobs = static_cast<int>(options.jobs.value_or(std::max(1U, std::thread::hardware_concurrency())));
    const auto tell = [&](std::size_t known, int loops) {
        if (!options.quiet) console.err << fmt::format("loop {}: {} of {} orbits", loops, known, expected) << std::endl;
    };
    const homotopy::StartSystem start = homotopy::make_start_system(*system, seed, jobs, most_loops, expected, tell);
    if (start.solutions.size() != expected) {
        complain(console, fmt::format("{} loops found {} of {} orbits: another --seed may do better", most_loops,
                                      start.solutions.size(), expected));
        return exit_code::limit;
    }
    print(console, homotopy::to_text(start, seed));
    return exit_code::solved;
}

}  // namespace

std::vector<std::string> start_system_names() {
    std::vector<std::string> names;
    for (const homotopy::GuidanceSystem& system : homotopy::every_system())
        names.push_back(homotopy::name_of(system));
    return names;
}

int read_start_system(const std::string& file, Console& console, std::optional<homotopy::StartSystem>& start) {
    constexpr std::size_t most_bytes = 16 << 20;
    const reading::Bytes bytes = reading::read_bytes(file, most_bytes, true);
    if (!bytes.failure.empty()) {
        complain(console, file + ": " + bytes.failure);
        return bytes.unreadable ? exit_code::no_access : exit_code::invalid_file;
    }
    homotopy::ReadStart read = homotopy::parse_start_system(bytes.bytes);
    if (!read.start) {
        complain(console, file + ": " + read.fault + "; mechwright start-system makes one anew");
        return exit_code::invalid_file;
    }
    start = *std::move(read.start);
    return exit_code::solved;
}

Command add_start_system(CLI::App& program) {
    const auto options = std::make_shared<StartOptions>();
    CLI::App* command = program.add_subcommand("start-system", "Make the start system of an exact method anew");
    command->add_option("PROBLEM", options->problem, fmt::format("{}", fmt::join(start_system_names(), ", ")))
        ->required()
        ->option_text(" ");
    add_whole_number(*command, "--seed", options->seed, 0, INT64_MAX, "Seed of the random parameters (1)");
    add_whole_number(*command, "--jobs", options->jobs, 1, 1024, "Threads (all)");
    command->add_flag("--quiet", options->quiet, "Nothing but errors on standard error");
    return {command, [options](Console& console) { return make(*options, console); }};
}

}  // namespace mechwright
