#pragma once
/// \file
/// What functions, lines and arcs bring to a mechanism of which a problem asks several, each over an input range of its
/// own: their numbers and quantities, called by the names of the targets.

#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// The numbers of each of Mechanism::over_input: NAME.input-start and NAME.input-range, of a function NAME.output-start
/// and NAME.output-range, of a line or an arc those of the shape; and its quantities, which from then on read them,
/// NAME.function-max.
void add_numbers_over_input(Mechanism& mechanism);

/// The quantities of these targets: those of all functions, all lines and all arcs together, function-max,
/// function-rms, line-deviation and arc-deviation, then those of each. Functions whose outputs are in part angles and
/// in part lengths have none together. Precondition: `add_numbers_over_input`.
std::vector<Quantity> quantities_over_input(const Mechanism& mechanism);

}  // namespace mechwright
