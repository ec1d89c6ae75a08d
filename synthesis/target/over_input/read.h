#pragma once
/// \file
/// What the readers of functions, lines and arcs have in common.

#include <optional>
#include <string_view>
#include <vector>

#include "synthesis/problem/problem.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright::reading {

/// One section of what is asked over an input range, with its place among those that have names.
struct OverInputSection {
    Section section;
    std::size_t number = every_target;  ///< of Mechanism::over_input; where it stands alone none
};

/// The sections [function], [line] or [arc] of a file that follow those which the problem has already. Only linkages
/// have several; says so of others, and of what they cannot have beside a path.
std::vector<OverInputSection> read_over_input_sections(Section& file, std::string_view name, const Problem& problem,
                                                       Messages& messages);

/// Adds a target that was read to the problem.
void add_over_input(const OverInputSection& of, AskedOverInput&& asked, Problem& problem);

}  // namespace mechwright::reading
