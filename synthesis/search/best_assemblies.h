#pragma once
/// \file
/// In which assemblies searches go on. A linkage of which many dyads may be closed on either side has 2^n of them, most
/// of which are of no use: what screening comes to in each says which.

#include <cstddef>
#include <vector>

#include "synthesis/program/program.h"

namespace mechwright {

/// So many assemblies are searched at most.
inline constexpr std::size_t most_assemblies_searched = 16;

/// How good a start is in an assembly: less is better.
struct AssemblyMerit {
    std::size_t assembly;
    double merit;
};

/// Those of `programs`, by index and in their order, whose assemblies come to the least merits; of equal ones the first
/// given. All of them where there are no more than `most` assemblies, or no merits, as where nothing assembles.
std::vector<std::size_t> in_best_assemblies(const std::vector<Program>& programs, std::vector<AssemblyMerit> merits,
                                            std::size_t most = most_assemblies_searched);

/// Whether programs are of more than `most` assemblies.
bool has_many_assemblies(const std::vector<Program>& programs, std::size_t most = most_assemblies_searched);

}  // namespace mechwright
