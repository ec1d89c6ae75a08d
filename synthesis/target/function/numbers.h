#pragma once
/// \file
/// The scales of a function, as a mechanism's dimensions. Lines and arcs have that of the input, too.

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// input-start and input-range.
void add_input_range(Mechanism& mechanism);

/// output-start and output-range, after the input range.
void add_output_range(Mechanism& mechanism);

}  // namespace mechwright
