#include "synthesis/command_line/input.h"

#include "synthesis/command_line/exit_code.h"
#include "synthesis/problem/text.h"
#include "synthesis/search/solve.h"

namespace mechwright {

int read_and_report(const std::string& file, bool quiet, Console& console, ReadProblem& read) {
    read = read_problem(file);
    for (const Message& message : read.messages)
        if (!message.warning || !quiet) console.err << to_string(message) << '\n';
    console.err << std::flush;
    if (read.unreadable) return exit_code::no_access;
    return read.ok() ? exit_code::solved : exit_code::invalid_file;
}

std::string method_name_fault(const std::string& method) {
    std::vector<std::string_view> names;
    for (const MethodDescription& known : all_methods()) {
        if (known.name == method) return {};
        names.push_back(known.name);
    }
    return "unknown method " + reading::quoted(method) + "; known are " + reading::listed(names);
}

std::string method_fault(const std::string& method, const Problem& problem) {
    if (std::string fault = method_name_fault(method); !fault.empty()) return fault;
    const std::string why = why_not_applicable(method, problem);
    return why.empty() ? why : "method " + reading::quoted(method) + " cannot be used here: " + why;
}

int report_method_fault(const Problem& problem, Console& console) {
    const std::string fault = method_fault(problem.solver.method, problem);
    if (fault.empty()) return exit_code::solved;
    console.err << to_string(Message{.file = problem.file, .text = "[solver] method: " + fault}) << std::endl;
    return exit_code::invalid_file;
}

}  // namespace mechwright
