#pragma once
/// \file
/// All dyads through five poses, or through as many points at given crank angles: counted and proven.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "synthesis/exact/exact_designs.h"
#include "synthesis/exact/poses/certified_dyad.h"

namespace mechwright {

/// A real dyad of five poses, rounded from its certificate where there is one.
struct RealDyad {
    Dyad dyad;
    std::optional<CertifiedDyad> proof;
};

/// The real dyads of five poses, and all four added to what has been counted. Those that doubles do not part are parted
/// in fifty digits; without these (`exact` empty) nothing is proven. `complete` stays where all are accounted for.
std::vector<RealDyad> counted_dyads(const std::vector<Displacement>& displacements,
                                    const std::vector<ExactDisplacement>& exact, SolutionCounts& counts,
                                    bool& complete);

/// How many of them are proven.
std::size_t certified_of(const std::vector<RealDyad>& dyads);

/// Why through so many targets, of a name, the method finds no linkages of a name; empty if it does.
std::string why_not_so_many_targets(std::string_view linkages, std::size_t count, std::string_view targets);

/// What has been counted with a note where targets are special, best first.
ExactDesigns with_count_noted(const Problem& problem, ExactDesigns out);

}  // namespace mechwright
