#pragma once
/// \file
/// Cognates of linkages: others of the same structure whose guided point is at the same places at the same inputs.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "synthesis/mechanism/linkage/model.h"

namespace mechwright {

struct LinkageCognate {
    std::vector<double> dimensions;
    std::vector<std::int8_t> sides;  ///< on which its dyads are closed, as LinkageModel::sides
    double crank_angle = 0;          ///< what its input is more than that of the linkage
};

/// Those that follow by moving three pins of a dyad. Of two links E-G and G-F, the first of which carries X, hung on
/// links that turn about each other on a pin Z, X follows the same path on the link of F, at the same turns of the
/// other one, where with k = (X - E)/(G - E) and complex numbers
///
///     Z' = Z + k (F - Z),  E' = Z' + (1 - k) (E - Z),  G' = F + X - G
///
/// (Roberts and Chebyshev; analysis/four_bar/cognates.h). Where Z joins a crank to the frame that is all: of a four-bar
/// with all that hangs on its point X, such as Stephenson's third kind. Where Z joins the coupler to the rocker of a
/// four-bar, which turn as before if it is turned and made larger about the rocker's pivot until Z is Z', that follows:
/// of Watt's first kind.
/// Derived for one pose, at an input of the analysis at which the linkage assembles; dimensions that are not `free`
/// have to stay as they are.
std::vector<LinkageCognate> linkage_cognates(const LinkageModel& model, std::span<const double> dimensions,
                                             std::size_t assembly, const std::vector<bool>& free, double input);

}  // namespace mechwright
