#pragma once
/// \file
/// Proofs that no design meets the requirements, from what is known without a search.

#include <memory>

#include "synthesis/problem/problem.h"
#include "synthesis/program/proof.h"

namespace mechwright {

/// Why no design meets the requirements, where a known limit, a closed form or the ranges of the dimensions show it;
/// null where none does. What the tolerance lets pass is not excluded.
std::shared_ptr<const Proof> why_infeasible(const Problem& problem);

}  // namespace mechwright
