#pragma once
/// \file
/// Signals, rooms and regions of the built-in kinds: those of the linkage that each is (Mechanism::as_linkage), whose
/// dimensions have the same names. Nothing else of the kind is measured by that linkage.

#include <cstddef>
#include <memory>
#include <span>
#include <string>

#include "synthesis/mechanism/linkage/mechanism.h"
#include "synthesis/mechanism/linkage/model.h"
#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// A kind, which has no model yet, with the quantities of the signals, rooms and regions of a model, which is the kind
/// as a linkage: its numbers are sums of the kind's own dimensions, and its sides are in the order of the kind's
/// assemblies. They can be asked for over input ranges that are designed, too; rooms and regions are drawn. Of the
/// first `own_signals`, which the kind has without a file, it has only the quantities that are asked for. `sections`
/// are those of the file (Mechanism::made_from).
std::shared_ptr<const Mechanism> with_measures(const std::shared_ptr<const Mechanism>& kind, LinkageModel model,
                                               std::size_t own_signals, std::span<const NamedMeasure> asked,
                                               std::string sections);

}  // namespace mechwright
