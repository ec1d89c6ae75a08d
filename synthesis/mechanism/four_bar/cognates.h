#pragma once
/// \file
/// Four-bars that draw one curve.

#include <span>

#include "analysis/four_bar/cognates.h"

namespace mechwright::four_bar {

/// The same four-bar driven at the other fixed pivot.
PathLinkage<double> from_other_pivot(const PathLinkage<double>& linkage);

/// Whether the dimensions (links, coupler point, placement) of two different four-bars are those of cognates, driven
/// from either fixed pivot, to a part of 1e-5 of their lengths. Assemblies are not compared: where the crank of a
/// cognate swings, its curve takes both.
bool are_cognates(std::span<const double> a, std::span<const double> b);

}  // namespace mechwright::four_bar
