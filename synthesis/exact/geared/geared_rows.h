#pragma once
/// \file
/// The dimensions of a geared five-bar from where its pins are.

#include <complex>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/exact/chains/link_numbers.h"
#include "synthesis/exact/geared/geared_five_bar.h"
#include "synthesis/exact/poses/dyad_family.h"

namespace mechwright {

/// What the links say: rows of dimensions but for the phase of the gears, and the directions of the cranks' x axes
/// against the frame's, in radians.
struct GearedReading {
    std::vector<ChainRow> rows;  ///< the last one that of the phase, of value 0
    double driving = 0;
    double driven = 0;
};

/// The links of a five-bar whose pins are, in the drawing: the pivot and the pin of the driving crank, the pin and the
/// pivot of the driven one, the guided pin. Nothing where a link's frame cannot be told from its points.
std::optional<GearedReading> reading_of(const Problem& problem, const GearedFiveBar& bars,
                                        std::span<const std::complex<double>, 5> pins);

/// The phases of the gears at which the cranks face so. Where the driven crank is the first of the gear they are not
/// the same after whole turns of the phase, but after whole turns of that crank: some of these on either side.
std::vector<double> phases_at(const Problem& problem, const GearedFiveBar& bars, double driving, double driven);

/// Where the file wants the pivot of a crank, in the frame of displacements from a place.
PivotRanges pivot_ranges(const Problem& problem, const GearedCrank& crank, const DrawingPlace& place);

}  // namespace mechwright
