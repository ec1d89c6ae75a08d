#pragma once
/// \file
/// What tables of runs on shapes say: the least error that is known, shares of successes, parts of sorted numbers.

#include <string>
#include <vector>

#include "synthesis/bench/section.h"

namespace mechwright::bench {

/// The least error (path-rms) that is known of a shape: the list's, or that of a row of the sheet where it is less.
double least_error(const Sheet& sheet, const std::string& shape);

/// "92.5 % (87.8 to 95.5 %)", with Wilson's interval.
std::string share_text(double hits, double runs);

/// The number that such a part of them, sorted here, does not exceed. There is one at least.
double quantile(std::vector<double> numbers, double part);

}  // namespace mechwright::bench
