#include "synthesis/target/function/text.h"

#include <fmt/format.h>

#include "synthesis/program/error_extremes.h"
#include "synthesis/report/text/error_sections.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/target/function/function_target.h"

namespace mechwright {

std::string function_section(const Problem& problem, const Design& design, bool colour) {
    const FunctionTarget& f = *problem.function;
    const std::string what = f.expression.empty() ? fmt::format("{} samples", f.samples.size())
                                                  : fmt::format("{} from x = {} to {}", f.expression, f.from, f.to);
    return heading("Function: " + what, colour) + extremes_text(problem, design, "error at x =", error_unit(problem));
}

}  // namespace mechwright
