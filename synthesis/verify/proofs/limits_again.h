#pragma once
/// \file
/// Limits on what any mechanism of a kind can do, for verification: in fifty digits, by derivations of its own.

#include <nlohmann/json.hpp>

#include "synthesis/verify/proofs/proof_context.h"

namespace mechwright {

/// That the limit of the certificate {limit, quantity, value} is one that holds, and shows what it is said to: that
/// what is asked for lies beyond it, or that the design comes up to it.
Finding check_limit_again(const ProofContext& c);

}  // namespace mechwright
