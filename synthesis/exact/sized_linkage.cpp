#include "synthesis/exact/sized_linkage.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "synthesis/exact/family_size.h"

namespace mechwright {

bool SizedLinkage::has_lengths() const {
    const double sum = ground + crank + coupler + rocker;
    return std::isfinite(sum) && std::min({ground, crank, coupler, rocker}) > 1e-9 * sum;
}

Design design_of(const Problem& problem, const SizedLinkage& linkage) {
    const std::array<UnitDimension, 4> links{
        {{0, linkage.ground}, {1, linkage.crank}, {2, linkage.coupler}, {3, linkage.rocker}}};
    // Where no size fits, one that a fixed length asks for, so that the rest shows what is wrong.
    const auto fixed = std::find_if(links.begin(), links.end(),
                                    [&](const UnitDimension& link) { return problem.dimensions[link.index].fixed(); });
    const double otherwise = fixed == links.end() ? 1 : problem.dimensions[fixed->index].min / fixed->value;
    const double size = size_in_ranges(problem, links).value_or(otherwise);
    Design design;
    for (const DimensionRange& range : problem.dimensions)
        design.dimensions.push_back(range.min);
    for (const UnitDimension& link : links)
        if (!problem.dimensions[link.index].fixed() ||
            std::abs(size * link.value - problem.dimensions[link.index].min) > 1e-12 * size * link.value)
            design.dimensions[link.index] = size * link.value;
    return design;
}

}  // namespace mechwright
