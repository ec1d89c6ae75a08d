#pragma once
/// \file
/// Numbers for people: as many digits as manufacture asks for, and 0 for what is only rounding. Documents and tables
/// for other programs have all digits.

#include <string>
#include <vector>

#include "synthesis/program/result.h"

namespace mechwright {

/// Significant digits of a quantity where nothing else is asked for, and how many can be asked for. Lengths of a design
/// have one more, counted from the longest of them, so that what is made as shown has the quantities that are shown.
inline constexpr int usual_digits = 4;
inline constexpr int fewest_digits = 2;
inline constexpr int most_digits = 16;

/// How a text is shown.
struct TextStyle {
    bool colour = false;
    int digits = usual_digits;
};

/// A number with this many significant digits; those before the point are never rounded away below ten millions.
std::string rounded_text(double value, int digits);

/// A value of a quantity of this design (angles in radians) in the file's unit, without the unit. What is below 1e-12
/// of the longest length of the design (of areas: of its square; of an angle: of a radian; of a plain number: of 1) is
/// rounding, and is shown as 0.
std::string quantity_text(double value, Unit unit, const Problem& problem, const Design& design, int digits);

/// The same with its unit.
std::string quantity_with_unit(double value, Unit unit, const Problem& problem, const Design& design, int digits);

/// The objective of a design, which is in the file's unit, in the same way; without a unit where it has several terms.
std::string objective_text(const Problem& problem, const Solution& solution, int digits);
std::string objective_with_unit(const Problem& problem, const Solution& solution, int digits);

/// All dimensions of a design in the file's units, in the order of the mechanism: lengths with the same number of
/// digits after the point, and angles, too, but none that are 0 in all of them. A small one has two digits of its own.
std::vector<std::string> dimension_texts(const Problem& problem, const Design& design, int digits);

}  // namespace mechwright
