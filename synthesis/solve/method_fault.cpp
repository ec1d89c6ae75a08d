#include "synthesis/solve/method_fault.h"

#include <string_view>
#include <vector>

#include "synthesis/problem/text.h"
#include "synthesis/solve/solve.h"

namespace mechwright {

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

std::optional<Message> solver_method_fault(const Problem& problem) {
    const std::string fault = method_fault(problem.solver.method, problem);
    if (fault.empty()) return std::nullopt;
    return Message{.file = problem.file, .text = "[solver] method: " + fault};
}

}  // namespace mechwright
