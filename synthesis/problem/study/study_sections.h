#pragma once
/// \file
/// The parts of [study] that are sections of their own.

#include "synthesis/problem/study/study.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright {
struct Problem;
}

namespace mechwright::reading {

/// Whether [study] is about pieces of one design, and not about values that vary.
bool samples_pieces(const toml::table& study);

/// [study.tolerance]: the deviations of dimensions, each { normal = ... }, { uniform = ... } or a grade, "IT7".
void read_tolerance(Section& study_section, Study& study, const Problem& problem, Messages& messages);

/// 'clearance' in [study]: of all pins, or of some by their names; after the deviations of dimensions.
void read_clearance(Section& study_section, Study& study, const Problem& problem, Messages& messages);

/// [study.allocation]: the share of pieces that are to meet all limits, and what tolerances cost; after the deviations.
void read_allocation(Section& study_section, Study& study, const Problem& problem, Messages& messages);

/// [[study.chart]]; after the axes.
void read_charts(Section& study_section, Study& study, Messages& messages);

}  // namespace mechwright::reading
