#pragma once
/// \file
/// Rooms and regions of the built-in kinds: those of the linkage that each is (Mechanism::as_linkage), whose dimensions
/// have the same names. Nothing else of the kind is measured by that linkage.

#include <memory>
#include <string>

#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// A kind, which has no model yet, with the quantities of the rooms and regions of a model, which is the kind as a
/// linkage: its numbers are sums of the kind's own dimensions, and its sides are in the order of the kind's assemblies.
/// They can be asked for over input ranges that are designed, too, and are drawn. `sections` are those of the file
/// (Mechanism::made_from).
std::shared_ptr<const Mechanism> with_rooms(const std::shared_ptr<const Mechanism>& kind, LinkageModel model,
                                            const std::string& sections);

}  // namespace mechwright
