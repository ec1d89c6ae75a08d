#pragma once
/// \file
/// Linkages that several tests look at.

#include <string>
#include <utility>
#include <vector>

#include "analysis/four_bar/four_bar.h"
#include "analysis/slider_crank/slider_crank.h"
#include "tests/analysis/made_linkage.h"

namespace mechwright::test {

/// Links: crank 1, coupler 2 with the point P, rocker 3. Pins A, B, C, D.
MadeLinkage four_bar_linkage(const FourBar<double>& m, double along = 0, double across = 0);

/// Links: crank 1, rod 2, slider 3, which has the pin C.
MadeLinkage slider_crank_linkage(const SliderCrank<double>& m);

/// Jansen's leg: its foot is T; Y and U on the right side.
MadeLinkage jansen();

/// Crank, four-bar and dyad of published six-bars: the dyad on the rocker's second arm, or on the coupler point. The
/// output is link 5, its dyad's pin H.
MadeLinkage six_bar(bool watt);

/// For each dyad of a linkage in solving order, by the name of its inner pin.
std::vector<std::int8_t> sides_of(const MadeLinkage& made, const std::vector<std::pair<std::string, int>>& named);

}  // namespace mechwright::test
