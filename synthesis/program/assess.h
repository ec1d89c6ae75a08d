#pragma once
/// \file
/// What a design is worth, evaluated from the problem alone: no solver and no program has a say in it.

#include "synthesis/program/result.h"

namespace mechwright {

/// Objective and violation of a design. The violation is the greatest relative one of requirements, ranges of
/// dimensions, order and assembly along the path; a quantity without a value violates without limit.
Solution assess(const Problem& problem, Design design);

/// Whether solution a is to be preferred to b: feasible before infeasible; among feasible
/// ones by the objective, among others those that miss inequalities only come first, then by violation.
bool preferred(const Problem& problem, const Solution& a, const Solution& b);

/// Whether a larger objective is the better one.
bool maximizes(const Problem& problem);

/// A design that is given, not sought (every dimension fixed): evaluated, not verified; objective and violation as for
/// any other solution. In the first of the problem's assemblies, or another one.
Solution evaluate_given(const Problem& problem);
Solution evaluate_given(const Problem& problem, std::size_t assembly);

}  // namespace mechwright
