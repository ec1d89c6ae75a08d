#pragma once
/// \file
/// Comma-separated values.

#include <string>

namespace mechwright {

/// The shortest number that reads back as the same double, with a decimal point in every locale.
std::string csv_number(double number);

/// A field, quoted where a reader would trip over it otherwise.
std::string csv_field(const std::string& text);

}  // namespace mechwright
