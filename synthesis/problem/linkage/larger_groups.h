#pragma once
/// \file
/// Which assembly larger groups (linkage::Group::Kind::larger) are in: by a sketch, by an index, or all of them.

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

#include "synthesis/problem/linkage/linkage.h"

namespace mechwright {

/// How files name a larger group: its links, "rod+plate+arm".
std::string name_of_larger(const Linkage& linkage, std::size_t larger);

/// { group, index } as files and documents say it, and as a line of [assembly].
nlohmann::ordered_json larger_document(const Linkage& linkage, std::size_t larger, std::size_t index);
std::string larger_line(const Linkage& linkage, std::size_t larger, std::size_t index);

/// All assemblies of the larger groups of a linkage of these numbers at an input, with its dyads on these sides: those
/// that are found, of triads all there are. Poses are whole where `closed` (those that do not close are left out), else
/// they go as far as the last larger group.
std::vector<LargerAssembly> larger_assemblies(const Linkage& linkage, std::span<const double> numbers,
                                              std::span<const std::int8_t> sides, double input, bool closed);

/// By how much the joints of a larger group miss each other at an input with these sides; infinite where what it hangs
/// on does not close. Of the first larger group that has no assembly.
double larger_missing(const Linkage& linkage, std::span<const double> numbers, std::span<const std::int8_t> sides,
                      double input);

}  // namespace mechwright
