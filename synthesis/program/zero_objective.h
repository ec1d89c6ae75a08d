#pragma once
/// \file
/// Objectives that cannot be negative, at zero: no design is better.

#include <memory>

#include "synthesis/program/proof.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Whether a feasible solution makes zero, but for rounding, what is to be least and cannot be negative.
bool is_at_zero(const Problem& problem, const Solution& solution);

/// Whether it comes as close to zero as designs do where another is likely to be at zero: points that a linkage has
/// drawn are met so well by many others, too. Not where what is left may be the rounding of the points.
bool is_nearly_at_zero(const Problem& problem, const Solution& solution);

/// That then no other is better.
std::shared_ptr<const Proof> proof_by_zero(const Problem& problem);

}  // namespace mechwright
