#pragma once
/// \file
/// Objectives that cannot be negative, at zero: no design is better.

#include <memory>

#include "synthesis/program/proof.h"
#include "synthesis/program/result.h"

namespace mechwright {

/// Whether a feasible solution makes zero, but for rounding, what is to be least and cannot be negative.
bool is_at_zero(const Problem& problem, const Solution& solution);

/// Whether it comes as close to zero as designs do of which one that is at zero is likely near: points that a linkage
/// has drawn are met so well by many others, too.
bool is_nearly_at_zero(const Problem& problem, const Solution& solution);

/// That then no other is better.
std::shared_ptr<const Proof> proof_by_zero(const Problem& problem);

}  // namespace mechwright
