#pragma once
/// \file
/// Which component of a quantity meets a condition that one of them has to meet: a variant of a problem chooses one for
/// each such condition.

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

#include "synthesis/program/program.h"
#include "synthesis/program/variant.h"

namespace mechwright {

/// The choices of one component for each disjunction of a problem in a family and an assembly: all of them, up to 64.
/// Of more those come first in which designs drawn over the ranges of the dimensions have their extreme values, the
/// most frequent ones first; the others are spread evenly over what is left, so that every component of a disjunction
/// has its turn as far as there is room. Always the same ones for a problem.
std::vector<std::vector<std::size_t>> choices_of_components(const Problem& problem, std::size_t family,
                                                            std::size_t assembly);

/// The same variant with no component chosen for any requirement; nothing where it has no such choice.
std::optional<Variant> without_choices(const Problem& problem, const Variant& variant);

/// The variant of a program with the components chosen for requirements that are the extreme ones at x. The program's
/// own where something has no value there.
Variant with_choices_at(const Program& program, const Eigen::VectorXd& x);

}  // namespace mechwright
