#pragma once
/// \file
/// The design of a claim rebuilt in fifty digits, and what it measures. Inside, angles are radians.

#include <optional>
#include <string>
#include <vector>

#include "synthesis/document/claim.h"

namespace mechwright {

/// A value measured again, with the difference to it that the rounding of a stated value may make.
struct Measured {
    Digits50 value;
    Digits50 slack;
};

/// Where the design really is at the claimed crank angles.
struct RebuiltPath {
    std::vector<Digits50> crank_angles;
    std::vector<Vector<Digits50>> reached;  ///< NaN where the mechanism does not assemble
    std::vector<Digits50> directions;       ///< of a guided body, radians
    std::vector<Digits50> distances;
    std::vector<Digits50> roundings;  ///< how far the rounding of doubles moves each point beside a limit; else 0
    Digits50 size;                    ///< the longest length or coordinate that a point is computed from
    Motion motion{};                  ///< along which the curve of a path in any order is looked at
};

struct Rebuilt {
    const Claim* claim;
    std::vector<Digits50> dimensions;
    std::vector<double> rounded;  ///< the same, rounded
    Motion motion;
    Motion whole;                     ///< the same where all of it is judged
    std::vector<Check> of_motion;     ///< of assembly, circuit and branch over the motion
    Digits50 longest;                 ///< of the lengths
    Digits50 added;                   ///< all lengths of links together, which places are sums of; the longest at least
    Digits50 strongest;               ///< of the forces, those of springs over the longest length among them
    std::optional<RebuiltPath> path;  ///< only with one crank angle for each point
};

Rebuilt rebuilt(const Claim& claim);

/// What counts as much of an input as a radian does: of a driven slide the longest length.
Digits50 unit_of_input(const Rebuilt& design);

/// Whether a place of the motion is beside an end of it where no full turn is made. There points go by the root of the
/// way from a limit, and the rounding of doubles decides where they are.
bool is_beside_end(const Rebuilt& design, const Motion& motion, double input);

/// The motion over which a quantity of the design is measured.
const Motion& motion_of(const Rebuilt& design, const Quantity& quantity);

/// Whether the crank can turn fully, whatever range is asked for.
bool turns_fully(const Rebuilt& design);

/// Every quantity at most once.
struct Measurements {
    const Rebuilt* design;
    std::vector<std::optional<std::optional<Measured>>> known;  ///< by quantity; measured yet, and has a value

    explicit Measurements(const Rebuilt& rebuilt);
    /// Nothing where the quantity is not defined for the design, or has no finite value.
    const std::optional<Measured>& of(std::size_t quantity);
    /// By how much the rounding of the ends of a limited motion can change a value: at a toggle by the root of it.
    Digits50 end_rounding(std::size_t quantity);
};

/// A number of the document as it counts inside, and the other way round. Degrees are multiplied by pi/180 in fifty
/// digits, so that nothing is added to the rounding that the document has.
Digits50 from_document(double number, Unit unit, const Units& units);
Digits50 in_document(const Digits50& value, Unit unit, const Units& units);

/// "39.5 deg": fifteen digits, in the unit of the document.
std::string value_text(const Digits50& value, Unit unit, const Units& units);

/// "3.1e-12": a small number in a message.
std::string size_text(const Digits50& value);

}  // namespace mechwright
