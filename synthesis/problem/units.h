#pragma once
/// \file
/// Units at the edge of the program: inside, angles are radians and lengths are the file's; outside, everything is in
/// the file's units.

#include <optional>
#include <string>
#include <string_view>

#include "synthesis/problem/problem.h"

namespace mechwright {

/// The unit of a dimension's values.
Unit unit_of(DimensionKind kind);

/// A value of the given unit as the file would write it. An angle in degrees is rounded to the shortest number that
/// reads back as the same radians, so that 60 deg do not come out as 59.99999999999999; where none does, the radians it
/// reads back as are their neighbours.
double in_file_unit(double value, Unit unit, const Units& units);

/// The value that the file means by a number.
double from_file_unit(double number, Unit unit, const Units& units);

/// What a difference or a derivative of inner values is multiplied by to be in the file's units.
double file_units_per_inner(Unit unit, const Units& units);

/// What a mass is times the one that, times length over second squared, is a force of those units. Absent where a unit
/// is not known.
std::optional<double> times_mass(std::string_view mass, std::string_view force, std::string_view length);

/// What a setting is inside for a number of the file: masses are converted.
double inner_per_file_unit(const Setting& setting, const Units& units);

/// "deg", "rad", "mm", "mm^2", "N mm", "N/mm", or empty for plain numbers and where no unit of forces is known.
std::string unit_label(Unit unit, const Units& units);

}  // namespace mechwright
