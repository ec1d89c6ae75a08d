#pragma once
/// \file
/// The parts that the summaries are made of. Each is a heading and what stands under it, starts with an empty line, and
/// is empty where there is nothing to say.

#include <string>
#include <string_view>

#include "synthesis/program/result.h"
#include "synthesis/report/text/numbers.h"

namespace mechwright {

/// The heading of a part.
std::string heading(std::string_view text, const TextStyle& style);

/// The problem's title, the mechanism and the file.
std::string title_section(const Problem& problem, const TextStyle& style);

/// The dimensions with their units; which were given and which came to lie at a limit of their range.
std::string design_section(const Problem& problem, const Design& design, const TextStyle& style);

/// What came before the objective.
std::string wishes_section(const Problem& problem, const Solution& solution, const TextStyle& style);
std::string objective_section(const Problem& problem, const Solution& solution, const TextStyle& style);

/// One line per limit: what is required, what is reached, and how far apart they are.
std::string requirement_section(const Problem& problem, const Design& design, const TextStyle& style);

/// How far the range of use of a problem reaches, and what quantities are over.
std::string words_of_use(const Problem& problem);

/// Every quantity that is defined for the design.
std::string quantity_section(const Problem& problem, const Design& design, const TextStyle& style);

/// One line if all checks passed, else the failed ones with what was found.
std::string verification_section(const std::vector<Check>& checks, const TextStyle& style);

/// A value that a file gives, in its unit and with it, with six digits.
std::string given_with_unit(double value, Unit unit, const Units& units);

}  // namespace mechwright
