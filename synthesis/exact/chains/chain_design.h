#pragma once
/// \file
/// The dimensions of a linkage from where its guided body hangs: each place on a link that is known says two numbers of
/// the file, which are sums of dimensions.

#include <optional>
#include <span>
#include <string>

#include "synthesis/exact/chains/guided_chains.h"
#include "synthesis/exact/exact_designs.h"
#include "synthesis/exact/guided_parts.h"

namespace mechwright {

/// Why the dimensions of a problem's linkage do not follow from the chains of its guided body; empty if they do.
std::string why_no_chain_design(const Problem& problem, const GuidedChains& chains);

/// Dimensions with ranges that the chains say nothing of: those of what drives them, where that is not their crank.
std::vector<std::size_t> dimensions_beside_chains(const Problem& problem, const GuidedChains& chains);

/// Why not all that a family of chains may choose, so many dimensions, is open; empty if it is.
std::string why_no_chain_family(const Problem& problem, const GuidedChains& chains, std::size_t dimensions);

/// The design of these chains, in the best assembly. Precondition: why_no_chain_design is empty.
ExactDesign chain_design(const Problem& problem, const GuidedChains& chains, const GuidedParts& parts,
                         std::span<const Displacement> displacements, const DrawingPlace& place);

}  // namespace mechwright
