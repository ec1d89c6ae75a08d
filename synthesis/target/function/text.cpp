#include "synthesis/target/function/text.h"

#include <fmt/format.h>

#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/report/text/error_sections.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

std::string function_section(const Problem& problem, const InputTask& task, const Design& design,
                             const TextStyle& style) {
    const FunctionTarget& f = *task.asked.function;
    const std::string what = f.expression.empty() ? fmt::format("{} samples", f.samples.size())
                                                  : fmt::format("{} from x = {} to {}", f.expression, f.from, f.to);
    const std::string called = task.asked.name.empty() ? "" : fmt::format(" '{}'", task.asked.name);
    return heading(fmt::format("Function{}: {}", called, what), style) +
           extremes_text(problem, task, design, "error at x =", style.digits);
}

}  // namespace mechwright
