#include "synthesis/target/followed/text.h"

#include <fmt/format.h>

#include "synthesis/program/error_extremes.h"
#include "synthesis/report/text/error_sections.h"
#include "synthesis/report/text/sections.h"
#include "synthesis/report/text/table.h"

namespace mechwright {

std::string followed_section(const Problem& problem, const Design& design, bool colour) {
    std::string text =
        heading(fmt::format("{} from crank angle {} to {}", problem.followed->shape == Followed::line ? "Line" : "Arc",
                            number_text(place_of(problem, design, 0), 6), number_text(place_of(problem, design, 1), 6)),
                colour);
    return text + extremes_text(problem, design, "distance at crank angle", Unit::length);
}

}  // namespace mechwright
