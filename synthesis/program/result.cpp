#include "synthesis/program/result.h"

#include <algorithm>

namespace mechwright {

bool all_passed(const std::vector<Check>& checks) {
    return !checks.empty() && std::all_of(checks.begin(), checks.end(), [](const Check& c) { return c.passed; });
}

bool Result::verified() const { return all_passed(verification); }

}  // namespace mechwright
