#pragma once
/// \file
/// Whether the bounds of objectives hold, for verification: by another enclosure in fifty digits where that can be
/// done, else at many places.

#include "synthesis/verify/proofs/proof_context.h"

namespace mechwright {

/// That the bound meets the objective, and that nothing speaks against it.
///
/// Of a function whose scales are given every linkage is covered again: its loop equation is linear in three constants,
/// so the determinant of four of its rows vanishes. The rows of all outputs within the bound of those asked for lie in
/// the convex hull of a few points (of a triangle about an arc), the determinant is linear in each row, and where it
/// has one sign at all corners no linkage errs by less.
///
/// With free scales this is done at places that fill their ranges evenly and around the design; of a timed path the
/// least sum of squares over all linkages of such a place, by linear least squares, must not be below the bound. What
/// lies between the places is not covered again, which the check says.
Finding check_bound_again(const ProofContext& c);

/// The same of a bound that does not meet the objective: that it is not above it, and that nothing speaks against it.
/// That of points at any crank angles is proven again (untimed_path_again.h).
Finding check_bound_below(const ProofContext& c);

}  // namespace mechwright
