#pragma once
/// \file
/// Ranges of dimensions that hold no linkage of a kind that is asked for.

#include <memory>

#include "synthesis/problem/problem.h"
#include "synthesis/program/proof.h"

namespace mechwright {

/// A proof that no dimensions in the ranges, ties among them, meet the linear conditions of any family of motions that
/// can answer the problem, or close the loop of a four-bar at all; null where some may.
std::shared_ptr<const Proof> proof_by_ranges(const Problem& problem);

}  // namespace mechwright
