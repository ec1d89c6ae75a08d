#pragma once
/// \file
/// The parts that the summaries are made of. Each is a heading and what stands under it, starts with an empty line, and
/// is empty where there is nothing to say.

#include <string>
#include <string_view>

#include "synthesis/program/result.h"

namespace mechwright {

/// The heading of a part.
std::string heading(std::string_view text, bool colour);

/// The problem's title, the mechanism and the file.
std::string title_section(const Problem& problem, bool colour);

/// The dimensions with their units; which were given and which came to lie at a limit of their range.
std::string design_section(const Problem& problem, const Design& design, bool colour);

/// What came before the objective.
std::string wishes_section(const Problem& problem, const Solution& solution, bool colour);
std::string objective_section(const Problem& problem, const Solution& solution, bool colour);

/// One line per limit: what is required, what is reached, and how far apart they are.
std::string requirement_section(const Problem& problem, const Design& design, bool colour);

/// How far the range of use of a problem reaches, and what quantities are over.
std::string words_of_use(const Problem& problem);

/// Every quantity that is defined for the design.
std::string quantity_section(const Problem& problem, const Design& design, bool colour);

/// One line if all checks passed, else the failed ones with what was found.
std::string verification_section(const std::vector<Check>& checks, bool colour);

/// A value of a quantity in the file's unit, with the unit.
std::string value_with_unit(double value, Unit unit, const Units& units);

}  // namespace mechwright
