#include "synthesis/exact/poses/dyad_family.h"

#include <cmath>
#include <numbers>

namespace mechwright {

namespace {

using Complex = std::complex<double>;
constexpr double pi = std::numbers::pi;

/// A number of a range: of any size and sign, most of them near 1.
double coordinate_in(double min, double max, double number) {
    if (min == max) return min;
    const double first = std::atan(min), last = std::atan(max);
    return std::tan(first + number * (last - first));
}

/// The same for a distance.
double distance_in(double min, double max, double number) {
    if (min == max) return min;
    const double first = min / (1 + min), last = max / (1 + max);
    const double part = first + number * (last - first);
    return part / (1 - part);
}

Complex fixed_pivot(const PivotRanges& r, double first, double second) {
    if (r.polar)
        return r.origin + std::polar(distance_in(r.first_min, r.first_max, first),
                                     r.second_min + second * (r.second_max - r.second_min));
    return r.origin +
           Complex(coordinate_in(r.first_min, r.first_max, first), coordinate_in(r.second_min, r.second_max, second));
}

/// A line for the fixed pivots of four poses: one that the ranges prescribe, else one of a pencil.
DyadCondition line_of_fixed_pivots(const PivotRanges& r, double number) {
    if (r.polar && r.second_min == r.second_max) return fixed_pivot_on_line(r.origin, std::polar(1.0, r.second_min));
    if (!r.polar && r.second_min == r.second_max) return fixed_pivot_on_line(r.origin + Complex(0, r.second_min), 1);
    if (!r.polar && r.first_min == r.first_max)
        return fixed_pivot_on_line(r.origin + Complex(r.first_min, 0), Complex(0, 1));
    return fixed_pivot_on_line(Complex(0.1, -0.2), std::polar(1.0, pi * number));
}

std::vector<Dyad> real_ones(const DyadSolutions& found) {
    std::vector<Dyad> dyads;
    for (const ComplexDyad& dyad : found.dyads)
        if (const auto real = real_dyad(dyad)) dyads.push_back(*real);
    return dyads;
}

}  // namespace

std::size_t numbers_of_dyad(std::size_t poses) { return 5 - poses; }

std::vector<Dyad> dyads_of(std::span<const Displacement> displacements, std::span<const double> numbers,
                           const PivotRanges& ranges, const std::optional<DyadCondition>& moving_line) {
    if (displacements.size() >= 3) {
        DyadConditions conditions;
        for (std::size_t i = 0; i < displacements.size(); ++i)
            conditions.row(static_cast<Eigen::Index>(i)) = condition_of(displacements[i]);
        if (displacements.size() == 3)
            conditions.row(3) = moving_line ? *moving_line : line_of_fixed_pivots(ranges, numbers[0]);
        return real_ones(dyads_meeting(conditions));
    }
    const Complex fixed = fixed_pivot(ranges, numbers[0], numbers[1]);
    if (displacements.size() == 2) {
        const auto dyad = dyad_with_fixed_pivot(fixed, std::span<const Displacement, 2>(displacements));
        return dyad ? std::vector<Dyad>{*dyad} : std::vector<Dyad>{};
    }
    const auto line = moving_pivots_of(fixed, displacements[0]);
    if (!line) return {};
    return {{fixed, line->point + std::tan(pi * (numbers[2] - 0.5)) * line->direction}};
}

}  // namespace mechwright
