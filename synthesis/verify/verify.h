#pragma once
/// \file
/// Verification trusts nobody: from the result document alone it rebuilds the design, measures every requirement again
/// over the whole continuous motion in fifty digits, and checks assembly, circuit, branch and order.

#include <nlohmann/json.hpp>
#include <vector>

#include "synthesis/mechanism/mechanism.h"

namespace mechwright {

/// What a document states of a design: all that there is to state, or the design, its objective and how far it misses
/// the points of a path alone.
enum class Stated { everything, design_alone };

/// The checks of one design, which stands in the document as that of the result does. Never throws for any JSON value.
std::vector<Check> verify_design(const nlohmann::ordered_json& document, Stated parts);

/// The checks of a document: of its design, its problem, its other designs and its verdict, in a fixed order; a
/// document that cannot be understood gives one failed check that says why. Never throws for any JSON value.
std::vector<Check> verify(const nlohmann::ordered_json& document);

}  // namespace mechwright
