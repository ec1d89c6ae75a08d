#pragma once
/// \file
/// What a finished design does: the values of its quantities on its motion, and its coupler path.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// The motion over which the problem judges a design: the given crank range, else the range of use, or the input range
/// of a function, a line or an arc, or the stretch in which all targets are met, else all of it. from > to if it
/// assembles nowhere, or where that stretch is not known.
Motion motion_of(const Problem& problem, const Design& design);
/// The same for one of its quantities: all of the motion for one that is over the whole of it.
Motion motion_of(const Problem& problem, const Quantity& quantity, const Design& design);
/// The circuit and branch of that motion, as Mechanism::circuit.
std::optional<CircuitAndBranch> circuit_of(const Problem& problem, const Motion& motion, const Design& design);

/// Whether a design assembles at every crank angle of a given range; true where none is given. Toggles at its ends
/// count as assembled in spite of their rounding.
bool assembles_over_range(const Problem& problem, const Design& design);

/// The longest length among dimensions; 0 without any.
double longest_length(const Mechanism& mechanism, std::span<const double> dimensions);

/// The least component of a margin; infinite without components, NaN where one is.
double least_component(const Quantity& margin, const Motion& motion, std::span<const double> dimensions);

/// The value of a quantity of a finished design, or nothing where it is not defined (see Quantity::defined) or the
/// design does not assemble over its motion.
std::optional<double> quantity_value(const Problem& problem, std::size_t quantity, const Design& design);

/// The values of many quantities of one finished design, as quantity_value has each: what they have in common, its
/// motions, is found once.
class QuantityValues {
public:
    /// Problem and design must outlive this.
    QuantityValues(const Problem& problem, const Design& design) : problem_(problem), design_(design) {}

    std::optional<double> operator[](std::size_t quantity);

private:
    struct Judged {
        Motion motion;
        bool assembles;  ///< all over it
    };
    const Judged& judged_over(bool whole);

    const Problem& problem_;
    const Design& design_;
    std::array<std::optional<Judged>, 2> judged_{};  ///< over the motion of the problem, over the whole one
};

/// The value of a dimension or a quantity of a finished design by its name, or nothing where it has none.
std::optional<double> value_named(const Problem& problem, const Design& design, std::string_view name);

/// With weights w and distances d: sum w d^2, sqrt(sum w d^2 / sum w), and the greatest plain distance.
struct PathMeans {
    double sum_of_squares = 0;
    double root_mean_square = 0;
    double greatest = 0;
};

/// Where a design comes to lie at each target point, and where a guided body faces there, with the means over all
/// points. The distance of a body is sqrt(d^2 + (2 length sin(turn / 2))^2), with d that of its place and turn that of
/// its direction.
struct PathValues : PathMeans {
    std::vector<Vector<double>> reached;
    std::vector<double> directions;  ///< radians; only where there are poses, 0 at points of other targets
    std::vector<double> distances;
    std::vector<PathMeans> of_targets;  ///< where these have names
};

/// Nothing without a path target, where the design has no crank angles for it, or where a distance is not finite.
std::optional<PathValues> path_values(const Problem& problem, const Design& design);

}  // namespace mechwright
