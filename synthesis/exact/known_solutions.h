#pragma once
/// \file
/// How many solutions there are of places that finitely many linkages pass, for whoever checks a count.

#include <cstddef>
#include <optional>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// How many solutions the places of a problem (places.h) have over the complex numbers, one of each orbit, as far as is
/// known; nothing where it is none of these, or has a family of them.
std::optional<std::size_t> known_solutions(const Problem& problem);

}  // namespace mechwright
