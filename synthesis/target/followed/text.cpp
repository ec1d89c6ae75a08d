#include "synthesis/target/followed/text.h"

#include <fmt/format.h>

#include "synthesis/mechanism/input.h"
#include "synthesis/program/alternation/error_extremes.h"
#include "synthesis/report/text/error_sections.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

std::string followed_section(const Problem& problem, const InputTask& task, const Design& design,
                             const TextStyle& style) {
    const std::string called = task.asked.name.empty() ? "" : fmt::format(" '{}'", task.asked.name);
    const auto place = [&](double share) { return rounded_text(place_of(problem, task, design, share), style.digits); };
    const std::string input(input_word(*problem.mechanism));
    std::string text = heading(
        fmt::format("{}{} from {} {} to {}", task.is_line() ? "Line" : "Arc", called, input, place(0), place(1)),
        style);
    return text + extremes_text(problem, task, design, "distance at " + input, style.digits);
}

}  // namespace mechwright
