#include "synthesis/target/followed/text.h"

#include <fmt/format.h>

#include "synthesis/program/error_extremes.h"
#include "synthesis/report/text/error_sections.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

std::string followed_section(const Problem& problem, const InputTask& task, const Design& design,
                             const TextStyle& style) {
    const std::string called = task.asked.name.empty() ? "" : fmt::format(" '{}'", task.asked.name);
    const auto place = [&](double share) { return rounded_text(place_of(problem, task, design, share), style.digits); };
    std::string text = heading(
        fmt::format("{}{} from crank angle {} to {}", task.is_line() ? "Line" : "Arc", called, place(0), place(1)),
        style);
    return text + extremes_text(problem, task, design, "distance at crank angle", style.digits);
}

}  // namespace mechwright
