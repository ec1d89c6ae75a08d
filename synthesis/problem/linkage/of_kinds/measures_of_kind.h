#pragma once
/// \file
/// [signals], [[room]] and [[region]] of problems of a built-in kind: of the links and points of the linkage that it
/// is, as `expand` writes it.

#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "synthesis/problem/linkage/mechanism.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright {

/// A mechanism of the list with the signals, rooms and regions that a document repeats, its members of these names, and
/// with those of these quantities that are of signals.
MadeAgain with_measures_of(const std::shared_ptr<const Mechanism>& kind, const nlohmann::ordered_json& document,
                           std::span<const std::string> quantities, const Units& units);

}  // namespace mechwright

namespace mechwright::reading {

/// Reads them, and gives the problem's mechanism what is measured of them. After its units and targets.
void read_measures_of_kind(Section& file, Problem& problem, Messages& messages);

}  // namespace mechwright::reading
