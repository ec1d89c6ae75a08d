#pragma once
/// \file
/// What the section "linkages" measures, each against the built-in four-bar or against its own value.

#include "synthesis/bench/section.h"

namespace mechwright::bench {

/// Rows of one measurement without its name: what, number, unit, compared with what, that number, ratio, aim.
std::vector<Row> measured_one_by_one(const Effort& effort);
std::vector<Row> measured_blocks(const Effort& effort);
std::vector<Row> measured_gradients(const Effort& effort);
std::vector<Row> measured_digits(const Effort& effort);
std::vector<Row> measured_analysis(const Effort& effort);

}  // namespace mechwright::bench
