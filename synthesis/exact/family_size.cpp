#include "synthesis/exact/family_size.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace mechwright {

std::optional<double> size_in_ranges(const Problem& problem, std::span<const UnitDimension> dimensions) {
    double low = 0;
    double high = std::numeric_limits<double>::infinity();
    double wanted = 0;
    for (const auto& [index, value] : dimensions) {
        const DimensionRange& range = problem.dimensions[index];
        const double first = range.min / value, second = range.max / value;
        low = std::max(low, std::min(first, second));
        high = std::min(high, std::max(first, second));
        if ((range.fixed() || range.start) && wanted == 0) wanted = range.start.value_or(range.min) / value;
    }
    constexpr double same_within = 1e-14;
    if (low > high * (1 + same_within) || !(high > 0)) return std::nullopt;
    const double middle = std::sqrt(std::max(low, 0.01 * high) * high);
    return std::clamp(wanted > 0 ? wanted : middle, std::min(low, high), high);
}

}  // namespace mechwright
