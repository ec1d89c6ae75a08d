#pragma once
/// \file
/// The commands of the program, one file each.

#include <functional>

#include "synthesis/command_line/console.h"

namespace CLI {
class App;
}

namespace mechwright {

/// A command as the command line knows it, and what it does once its options are read; that returns the exit code.
struct Command {
    CLI::App* options;
    std::function<int(Console&)> run;
};

Command add_new(CLI::App& program);
Command add_check(CLI::App& program);
Command add_solve(CLI::App& program);
Command add_compare(CLI::App& program);
Command add_analyse(CLI::App& program);
Command add_profile(CLI::App& program);
Command add_study(CLI::App& program);
Command add_structure(CLI::App& program);
Command add_expand(CLI::App& program);
Command add_verify(CLI::App& program);
Command add_report(CLI::App& program);
Command add_draw(CLI::App& program);
Command add_export(CLI::App& program);
Command add_quantities(CLI::App& program);
Command add_methods(CLI::App& program);
Command add_explain(CLI::App& program);
Command add_schema(CLI::App& program);
Command add_bench(CLI::App& program);
Command add_start_system(CLI::App& program);
Command add_completion(CLI::App& program);
Command add_man_page(CLI::App& program);

}  // namespace mechwright
