#include "synthesis/command_line/input.h"

#include "synthesis/command_line/exit_code.h"
#include "synthesis/solve/method_fault.h"

namespace mechwright {

namespace {

template <class Read>
int report(const Read& read, bool quiet, Console& console) {
    for (const Message& message : read.messages)
        if (!message.warning || !quiet) console.err << to_string(message) << '\n';
    console.err << std::flush;
    if (read.unreadable) return exit_code::no_access;
    return read.ok() ? exit_code::solved : exit_code::invalid_file;
}

}  // namespace

int read_and_report(const std::string& file, bool quiet, Console& console, ReadProblem& read) {
    read = read_problem(file);
    return report(read, quiet, console);
}

int read_and_report(const std::string& file, bool quiet, Console& console, ReadLinkage& read) {
    read = read_linkage(file);
    return report(read, quiet, console);
}

int report_method_fault(const Problem& problem, Console& console) {
    const auto fault = solver_method_fault(problem);
    if (!fault) return exit_code::solved;
    console.err << to_string(*fault) << std::endl;
    return exit_code::invalid_file;
}

}  // namespace mechwright
