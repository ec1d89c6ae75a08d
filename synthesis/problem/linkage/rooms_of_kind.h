#pragma once
/// \file
/// [[room]] and [[region]] of problems of a built-in kind: of the links and points of the linkage that it is, as
/// `expand` writes it.

#include <memory>
#include <nlohmann/json_fwd.hpp>

#include "synthesis/problem/linkage/mechanism.h"
#include "synthesis/problem/toml/section.h"

namespace mechwright {

/// A mechanism of the list with the rooms and regions that a document repeats: its members of these names.
MadeAgain with_rooms_of(const std::shared_ptr<const Mechanism>& kind, const nlohmann::ordered_json& document,
                        const Units& units);

}  // namespace mechwright

namespace mechwright::reading {

/// Reads them, and gives the problem's mechanism what is measured of them. After its units and targets.
void read_rooms_of_kind(Section& file, Problem& problem, Messages& messages);

}  // namespace mechwright::reading
